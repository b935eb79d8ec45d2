/* Defaults that depend on the segments' kind; see default_tiers.h. */
#include "default_tiers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A tier with two terminals, one per output. */
struct offer {
    const char *tier, *terminal[2];
    size_t max_length;
};

enum { OFFERS = 3 };

static const struct {
    const char *frame;
    bool from_corner;
    struct offer offer[OFFERS];
} follows[] = {[VARY_RECTANGLES] = {"affine", true, {{"exact", {"rectangle_xi", "rectangle_eta"}, 1}}},
               [VARY_PARALLELOGRAMS] = {"affine", true, {{"exact", {"parallelogram_xi", "parallelogram_eta"}, 1}}},
               [VARY_PLANE] = {"plane",
                               false,
                               {{"fast", {"fast_xi", "fast_eta"}, 1},
                                {"coarse", {"coarse_xi", "coarse_eta"}, 1},
                                {"exact", {"exact_xi", "exact_eta"}, 1}}}};

static char *copy(const char *text)
{
    return new_text(text, strlen(text));
}

static void add_tier(struct scene *s, const char *frame, const struct offer *o)
{
    struct tier *t = &s->tier[s->tiers++];
    *t = (struct tier){.name = copy(o->tier), .frame = copy(frame), .terminals = 2, .max_length = o->max_length};
    t->terminal = new_array(t->terminals, sizeof *t->terminal);
    for (int k = 0; k < 2; k++)
        t->terminal[k] = copy(o->terminal[k]);
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
    for (int i = 0; own && i < OFFERS && follows[kind].offer[i].tier; i++)
        add_tier(s, follows[kind].frame, &follows[kind].offer[i]);
    if (isnan(s->reference[0]))
        scene_choose_reference(s, own && follows[kind].from_corner);
    return true;
}
