/* The kinds of segments; see segment_kind.h. A new kind needs a row in this table, a row in evolve/surface/surface.c,
 * its geometry in runtime/, and a template in codegen/print/templates/. */
#include "segment_kind.h"

#include <stdio.h>
#include <string.h>

static const struct segment_kind kinds[] = {
    {.name = "quad4", .nodes = "ABCD", .normals = "", .corners = 4, .bilinear = true, .turns = true, .growth = 1},
    {.name = "tri3", .nodes = "ABC", .normals = "", .corners = 3, .triangle = true, .growth = 1},
    {.name = "tri6", .nodes = "ABCDEF", .normals = "", .corners = 3, .triangle = true, .growth = 1},
    {.name = "quad8", .nodes = "ABCDEFGH", .normals = "", .corners = 4, .growth = 2},
    {.name = "quad9", .nodes = "ABCDEFGHI", .normals = "", .corners = 4, .growth = 3},
    {.name = "bezier", .nodes = "ABCD", .normals = "ABCD", .corners = 4, .growth = 5},
    {.name = "gregory", .nodes = "ABCD", .normals = "ABCD", .corners = 4, .growth = 5},
};

const struct segment_kind *segment_find(const char *name)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(kinds[i].name, name) == 0)
            return &kinds[i];
    return NULL;
}

const struct segment_kind *segment_of_face(size_t nodes)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (!*kinds[i].normals && strlen(kinds[i].nodes) == nodes)
            return &kinds[i];
    return NULL;
}

size_t segment_vectors(const struct segment_kind *k)
{
    return strlen(k->nodes) + strlen(k->normals);
}

size_t segment_inputs(const struct segment_kind *k)
{
    return 3 * (segment_vectors(k) + 1);
}

void segment_vector_name(const struct segment_kind *k, size_t vector, char name[4])
{
    const size_t nodes = strlen(k->nodes);
    if (vector < nodes)
        snprintf(name, 4, "x%c", k->nodes[vector]);
    else if (vector < segment_vectors(k))
        snprintf(name, 4, "n%c", k->normals[vector - nodes]);
    else
        snprintf(name, 4, "xS");
}

void segment_input_name(const struct segment_kind *k, size_t input, char name[5])
{
    char vector[4];
    segment_vector_name(k, input / 3, vector);
    snprintf(name, 5, "%c%s", "xyz"[input % 3], vector[0] == 'x' ? vector + 1 : vector);
}
