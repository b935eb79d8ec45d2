/* Element types and their faces, with the numbering that Abaqus and CalculiX share. The codes list corners of a solid's
 * face so that some normals point inwards; here all point outwards. One table serves all elements of a shape: a linear
 * face uses only the corners. In 27-node elements, the last nodes are the middle of the element and of S1 to S6. */
#include "inp.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

static const struct inp_shape tetrahedron = {
    4, {{3, {1, 3, 2, 7, 6, 5}}, {3, {1, 2, 4, 5, 9, 8}}, {3, {2, 3, 4, 6, 10, 9}}, {3, {3, 1, 4, 7, 8, 10}}}};

static const struct inp_shape wedge = {5,
                                       {{3, {1, 3, 2, 9, 8, 7}},
                                        {3, {4, 5, 6, 10, 11, 12}},
                                        {4, {1, 2, 5, 4, 7, 14, 10, 13}},
                                        {4, {2, 3, 6, 5, 8, 15, 11, 14}},
                                        {4, {3, 1, 4, 6, 9, 13, 12, 15}}}};

static const struct inp_shape hexahedron = {6,
                                            {{4, {1, 4, 3, 2, 12, 11, 10, 9, 22}},
                                             {4, {5, 6, 7, 8, 13, 14, 15, 16, 23}},
                                             {4, {1, 2, 6, 5, 9, 18, 13, 17, 24}},
                                             {4, {2, 3, 7, 6, 10, 19, 14, 18, 25}},
                                             {4, {3, 4, 8, 7, 11, 20, 15, 19, 26}},
                                             {4, {4, 1, 5, 8, 12, 17, 16, 20, 27}}}};

static const struct inp_shape triangle = {2, {{3, {1, 3, 2, 6, 5, 4}}, {3, {1, 2, 3, 4, 5, 6}}}};

static const struct inp_shape quadrilateral = {2, {{4, {1, 4, 3, 2, 8, 7, 6, 5, 9}}, {4, {1, 2, 3, 4, 5, 6, 7, 8, 9}}}};

/* Plane elements, whose faces are edges; the element lies to the left of each. */
static const struct inp_shape plane_triangle = {3, {{2, {1, 2, 4}}, {2, {2, 3, 5}}, {2, {3, 1, 6}}}};

static const struct inp_shape plane_quadrilateral = {4,
                                                     {{2, {1, 2, 5}}, {2, {2, 3, 6}}, {2, {3, 4, 7}}, {2, {4, 1, 8}}}};

#define PLANE(family)                                                                                                  \
    {family "3", 3, false, INP_LINEAR, &plane_triangle}, {family "6", 6, false, INP_QUADRATIC, &plane_triangle},       \
        {family "4", 4, false, INP_LINEAR, &plane_quadrilateral},                                                      \
    {                                                                                                                  \
        family "8", 8, false, INP_QUADRATIC, &plane_quadrilateral                                                      \
    }

/* Names without the letters for integration, coupling or modification: solids for stress, heat, sound and electric
 * currents, cohesive and continuum shell elements; shells, membranes, surface and rigid elements; plane and axisymmetric
 * solids for stress, heat and sound. */
static const struct inp_type types[] = {
    {"C3D4", 4, false, INP_LINEAR, &tetrahedron},
    {"C3D10", 10, false, INP_QUADRATIC, &tetrahedron},
    {"C3D6", 6, false, INP_LINEAR, &wedge},
    {"C3D15", 15, false, INP_QUADRATIC, &wedge},
    {"C3D8", 8, false, INP_LINEAR, &hexahedron},
    {"C3D20", 20, false, INP_QUADRATIC, &hexahedron},
    {"C3D27", 27, false, INP_BIQUADRATIC, &hexahedron},
    {"DC3D4", 4, false, INP_LINEAR, &tetrahedron},
    {"DC3D10", 10, false, INP_QUADRATIC, &tetrahedron},
    {"DC3D6", 6, false, INP_LINEAR, &wedge},
    {"DC3D15", 15, false, INP_QUADRATIC, &wedge},
    {"DC3D8", 8, false, INP_LINEAR, &hexahedron},
    {"DC3D20", 20, false, INP_QUADRATIC, &hexahedron},
    {"AC3D4", 4, false, INP_LINEAR, &tetrahedron},
    {"AC3D10", 10, false, INP_QUADRATIC, &tetrahedron},
    {"AC3D6", 6, false, INP_LINEAR, &wedge},
    {"AC3D15", 15, false, INP_QUADRATIC, &wedge},
    {"AC3D8", 8, false, INP_LINEAR, &hexahedron},
    {"AC3D20", 20, false, INP_QUADRATIC, &hexahedron},
    {"Q3D4", 4, false, INP_LINEAR, &tetrahedron},
    {"Q3D10", 10, false, INP_QUADRATIC, &tetrahedron},
    {"Q3D6", 6, false, INP_LINEAR, &wedge},
    {"Q3D8", 8, false, INP_LINEAR, &hexahedron},
    {"Q3D20", 20, false, INP_QUADRATIC, &hexahedron},
    {"COH3D6", 6, false, INP_LINEAR, &wedge},
    {"COH3D8", 8, false, INP_LINEAR, &hexahedron},
    {"SC6", 6, false, INP_LINEAR, &wedge},
    {"SC8", 8, false, INP_LINEAR, &hexahedron},
    {"CSS8", 8, false, INP_LINEAR, &hexahedron},
    {"EC3D8", 8, false, INP_LINEAR, &hexahedron},
    {"S3", 3, true, INP_LINEAR, &triangle},
    {"S6", 6, true, INP_QUADRATIC, &triangle},
    {"S4", 4, true, INP_LINEAR, &quadrilateral},
    {"S8", 8, true, INP_QUADRATIC, &quadrilateral},
    {"S9", 9, true, INP_BIQUADRATIC, &quadrilateral},
    {"DS3", 3, true, INP_LINEAR, &triangle},
    {"DS6", 6, true, INP_QUADRATIC, &triangle},
    {"DS4", 4, true, INP_LINEAR, &quadrilateral},
    {"DS8", 8, true, INP_QUADRATIC, &quadrilateral},
    {"M3D3", 3, true, INP_LINEAR, &triangle},
    {"M3D6", 6, true, INP_QUADRATIC, &triangle},
    {"M3D4", 4, true, INP_LINEAR, &quadrilateral},
    {"M3D8", 8, true, INP_QUADRATIC, &quadrilateral},
    {"M3D9", 9, true, INP_BIQUADRATIC, &quadrilateral},
    {"SFM3D3", 3, true, INP_LINEAR, &triangle},
    {"SFM3D6", 6, true, INP_QUADRATIC, &triangle},
    {"SFM3D4", 4, true, INP_LINEAR, &quadrilateral},
    {"SFM3D8", 8, true, INP_QUADRATIC, &quadrilateral},
    {"R3D3", 3, true, INP_LINEAR, &triangle},
    {"R3D4", 4, true, INP_LINEAR, &quadrilateral},
    {"STRI3", 3, true, INP_LINEAR, &triangle},
    {"STRI65", 6, true, INP_QUADRATIC, &triangle},
    PLANE("CPE"),
    PLANE("CPS"),
    PLANE("CPEG"),
    PLANE("CAX"),
    PLANE("CGAX"),
    PLANE("DC2D"),
    PLANE("DCAX"),
    PLANE("AC2D"),
    PLANE("ACAX"),
};

const struct inp_type *inp_type_find(struct inp_text name)
{
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        const size_t base = strlen(types[i].name);
        if (name.n < base || strncasecmp(name.s, types[i].name, base) != 0)
            continue;
        const struct inp_text variant = {name.s + base, name.n - base};
        bool known = true;
        for (size_t k = 0; k < variant.n; k++)
            known &= strchr("RIMHTPESW", toupper((unsigned char)variant.s[k])) != NULL;
        if (known || inp_equals(variant, "R5"))
            return &types[i];
    }
    return NULL;
}

static const char *const labels[] = {"S1",   "S2", "S3", "S4", "S5", "S6",   "SNEG",
                                     "SPOS", "E1", "E2", "E3", "E4", "END1", "END2"};

const char *inp_face_name(int label)
{
    return labels[label];
}

bool inp_face_read(struct inp_text t, int *label)
{
    for (int i = 0; i < (int)(sizeof labels / sizeof *labels); i++)
        if (inp_equals(t, labels[i])) {
            *label = i;
            return true;
        }
    return false;
}

/* CalculiX also calls a shell's faces S1 (negative) and S2 (positive), and its edges S3 to S6. A shell without a label
 * exposes its positive face. */
int inp_face_index(const struct inp_type *type, int label)
{
    if (!type->shell)
        return label < type->shape->faces ? label : INP_NO_FACE;
    if (label == INP_FACE_NONE)
        return 1;
    if (label == INP_FACE_SNEG || label == INP_FACE_SPOS)
        return label - INP_FACE_SNEG;
    return label < type->shape->faces ? label : INP_EDGE;
}
