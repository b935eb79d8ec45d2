/* Defaults that depend on the segments' kind; see default_tiers.h. */
#include "default_tiers.h"

#include "../../codegen/base/text.h"

#include <math.h>

enum { OFFERS = 3 };

/* Frames, and tiers of one gene each: their names, and their values' names without _xi and _eta. */
static const struct {
    const char *frame;
    bool from_corner;
    const char *offer[OFFERS][2];
} follows[] = {[VARY_RECTANGLES] = {"affine", true, {{"exact", "rectangle"}}},
               [VARY_PARALLELOGRAMS] = {"affine", true, {{"exact", "parallelogram"}}},
               [VARY_PLANE] = {"plane", false, {{"fast", "fast"}, {"coarse", "coarse"}, {"exact", "exact"}}}};

static void add_tier(struct scene *s, const char *frame, const char *const offer[2])
{
    struct tier *t = &s->tier[s->tiers++];
    *t = (struct tier){.name = new_format("%s", offer[0]),
                       .frame = new_format("%s", frame),
                       .terminals = 2,
                       .terminal = new_array(2, sizeof *t->terminal),
                       .max_length = 1};
    t->terminal[0] = new_format("%s_xi", offer[1]);
    t->terminal[1] = new_format("%s_eta", offer[1]);
}

/* Copies the tiers of the kind's own scene. */
static bool take_tiers(const char *root, struct scene *s, struct diag *d)
{
    struct scene *usual = scene_of_kind(root, s, d);
    if (!usual)
        return false;
    s->tier = usual->tier;
    s->tiers = usual->tiers;
    usual->tier = NULL;
    usual->tiers = 0;
    scene_free(usual);
    for (size_t i = 0; i < s->tiers; i++)
        s->tier[i].line = s->tier[i].frame_line = s->tier[i].frame_column = 0;
    return true;
}

bool scene_default_tiers(const char *root, struct scene *s, enum variation_kind kind, struct diag *d)
{
    const bool own = s->segment->bilinear && kind < VARY_WARPED;
    if (!own && !take_tiers(root, s, d))
        return false;
    if (own)
        s->tier = new_array(OFFERS, sizeof *s->tier);
    for (int i = 0; own && i < OFFERS && follows[kind].offer[i][0]; i++)
        add_tier(s, follows[kind].frame, follows[kind].offer[i]);
    if (isnan(s->reference[0]))
        scene_choose_reference(s, own && follows[kind].from_corner);
    return true;
}
