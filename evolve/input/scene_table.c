/* Defines the tables of keys; see scene_table.h. */
#include "scene_table.h"

#include "scene.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static bool turns(const struct segment_kind *k)
{
    return k->turns;
}

static bool has_normals(const struct segment_kind *k)
{
    return *k->normals != '\0';
}

static bool has_no_normals(const struct segment_kind *k)
{
    return !has_normals(k);
}

/* Returns true if segments have taper and warp of their own.  Triangles do not, nor do segments with normals, which come from meshes
 * of smooth bodies (patch_samples.c) and end at their edges. */
static bool bends(const struct segment_kind *k)
{
    return has_no_normals(k) && !k->triangle;
}

static bool has_middles(const struct segment_kind *k)
{
    return has_no_normals(k) && strlen(k->nodes) > k->corners;
}

static bool has_lattice(const struct segment_kind *k)
{
    return k->bilinear || has_normals(k);
}

static const char *const orders[] = {"any", "nearest", "nearest-shorter", NULL};
static const char *const norms[] = {"mean", "p99", "max", NULL};
static const char *const precisions[] = {"double", "float", NULL};

#define AT(member) .at = offsetof(struct shapes, member)
static const struct scene_key shapes_keys[] = {
    {"aspect", KEY_NUMBER, AT(aspect), true, 1, 1000, .strange = 100, .usual = "5.0", .suits = has_no_normals,
     .help = "longest over shortest mid-line"},
    {"skew", KEY_ANGLE, AT(skew), true, 0, 85, .strange = 75, .usual = "\"45 deg\"", .suits = has_no_normals,
     .help = "angle of the mid-lines off the right angle"},
    {"taper", KEY_NUMBER, AT(taper), true, 0, 0.95, .strange = 0.8, .usual = "0.3", .suits = bends,
     .help = "in-plane part of (A - B + C - D)/4 over each half mid-line"},
    {"warp", KEY_ANGLE, AT(warp), true, 0, 90, .strange = 45, .usual = "\"15 deg\"", .suits = bends,
     .help = "angle between the normals at opposite corners"},
    {"curve", KEY_NUMBER, AT(curve), true, 0, 0.2, .strange = 0.15, .usual = "0.05", .suits = has_middles,
     .help = "rise of the longest edge over its length"},
    {"shift", KEY_NUMBER, AT(shift), true, 0, 0.2, .strange = 0.1, .usual = "0.03", .suits = has_middles,
     .help = "mid-side nodes off their place, over the shortest edge"},
    {"gap", KEY_NUMBER, AT(gap), true, 0, 100, .strange = 2, .usual = "0.2", .help = "|gap| over the shortest edge"},
    {"overhang", KEY_NUMBER, AT(overhang), true, 0, 1, .strange = 0.5, .usual = "0.1", .suits = has_no_normals,
     .help = "contact points up to this part of the segment outside it"}};
#undef AT

#define AT(member) .at = offsetof(struct mesh_pairs, member)
static const struct scene_key mesh_keys[] = {
    {"file", KEY_TEXT, AT(file), true, .usual = "\"contact.inp\"",
     .help = "input of Abaqus or CalculiX with *CONTACT PAIR, from the scene's folder"},
    {"distance", KEY_NUMBER, AT(distance), false, 1e-300, 1e300, .usual = "0.2",
     .help = "largest |gap|: penetration and what a step moves; without it 0.2 of the shortest master edge"}};
#undef AT

#define AT(member) .at = offsetof(struct lattice, member)
static const struct scene_key lattice_keys[] = {
    {"xy", KEY_GRID, AT(xy), true, 0, 100, .usual = "[1.0, 0.25]", .help = "largest and step: x, y of C, D and S"},
    {"z", KEY_GRID, AT(z), true, 0, 100, .usual = "[0.3, 0.1]", .help = "largest and step: z of C and S"},
    {"xi", KEY_RANGE, AT(xi), true, -10, 10, .usual = "[-1.0, 0.0]", .help = "contact points kept"},
    {"eta", KEY_RANGE, AT(eta), true, -10, 10, .usual = "[-1.0, 0.0]", .help = "contact points kept"},
    {"normal_sets", KEY_INT, AT(normal_sets), true, 1, 1000, .usual = "10", .suits = has_normals,
     .help = "random sets of normals for each configuration"},
    {"tilt", KEY_NUMBER, AT(tilt), true, 0, 1, .usual = "0.3", .suits = has_normals,
     .help = "tangent of the largest angle of a normal off the facet's own"},
    {"newton", KEY_INT, AT(newton), false, 1, 1000, .usual = "23",
     .help = "kept only if so many of Newton's steps from (0, 0) find it"},
    {"random", KEY_COUNT, AT(random), false, 1, 100000000, .usual = "1000",
     .help = "training samples off the lattice, besides"}};
#undef AT

#define AT(member) .at = offsetof(struct tier, member)
static const struct scene_key tier_keys[] = {
    {"name", KEY_OWN, AT(name), true, .usual = "\"fast\"", .help = "a C identifier"},
    {"frame", KEY_OWN, AT(frame), .usual = "\"parallelogram\"", .shared = true,
     .help = "the values that expressions are made of, evolve/frames/NAME.gen"},
    {"terminals", KEY_OWN, AT(terminal), true, .usual = "[\"p\", \"q\"]", .shared = true,
     .help = "values of the frame that expressions may use"},
    {"max_length", KEY_COUNT, AT(max_length), true, 1, 100000, .usual = "30", .shared = true,
     .help = "operations of the longest program; 1: the best terminal"},
    {"functions", KEY_OWN, AT(function), true, .usual = "\"polynomial\"", .shared = true,
     .help = "\"polynomial\", \"rational\", or a list of operators and functions of the frame"},
    {"reference", KEY_OWN, AT(reference), .low = -1, .high = 1, .usual = "[0.0, 0.0]",
     .help = "point (xi, eta) about which this tier's frame expands"},
    {"starts", KEY_OWN, AT(start), .usual = "([\"p\", \"q\"])", .shared = true,
     .help = "pairs of values that programs begin with"},
    {"last", KEY_OWN, AT(last), .usual = "\"newton\"", .shared = true, .help = "function that programs end in"},
    {"budget", KEY_NUMBER, AT(budget), false, 1, 1e6, .usual = "131", .help = "largest cost of its champion"}};
#undef AT

#define GROUP(name, keys)                                                                                              \
    {                                                                                                                  \
        name, keys, sizeof keys / sizeof *keys                                                                         \
    }
const struct scene_group shapes_group = GROUP("shapes", shapes_keys), mesh_group = GROUP("mesh", mesh_keys),
                         lattice_group = GROUP("lattice", lattice_keys), tier_group = GROUP("tier", tier_keys);

#define AT(member) .at = offsetof(struct scene, member)
static const struct scene_key scene_keys[] = {
    {"segment", KEY_OWN, AT(segment), .usual = "\"quad4\"",
     .help = "kind of face; a mesh needs none if its master faces are of one kind"},
    {"order", KEY_WORD, AT(order), .word = orders, .usual = "\"any\"", .suits = turns,
     .help = "which corner is A; shorter means |AD| <= |AB|"},
    {"reference", KEY_POINT, AT(reference), false, -1, 1, NAN, .usual = "[0.0, 0.0]",
     .help = "point (xi, eta) of the frame's expansion; without it the middle"},
    {"norm", KEY_WORD, AT(norm), .word = norms, .usual = "\"mean\"",
     .help = "error to minimise, of |xi - xi_ref| and |eta - eta_ref|"},
    {"precision", KEY_CHOICE, AT(precision), .word = precisions, .usual = "\"double\"",
     .help = "of the generated code"},
    {"seed", KEY_COUNT, AT(seed), false, 0, (double)LLONG_MAX, 1, .usual = "1", .help = "of the samples"},
    {"training", KEY_COUNT, AT(training), true, 1, 100000000, .usual = "20000", .help = "samples that evolution sees"},
    {"heldout", KEY_COUNT, AT(heldout), true, 1, 100000000, .usual = "50000",
     .help = "samples of the error table, which evolution does not see"},
    {"shapes", KEY_GROUP, .group = &shapes_group, .help = "ordinary segments at random: limits of their shapes"},
    {"mesh", KEY_GROUP, .group = &mesh_group, .suits = has_no_normals, .help = "pairs of a mesh file"},
    {"lattice", KEY_GROUP, .group = &lattice_group, .suits = has_lattice,
     .help = "the paper's lattice, A at the origin, B at (1, 0, 0), D in the x-y plane"},
    {"tiers", KEY_OWN, .group = &tier_group, .help = "the functions of the header"}};
#undef AT
const struct scene_group scene_group = GROUP("scene", scene_keys);

const struct scene_key *group_find(const struct scene_group *g, const char *name)
{
    for (size_t i = 0; i < g->keys; i++)
        if (strcmp(g->key[i].name, name) == 0)
            return &g->key[i];
    return NULL;
}
