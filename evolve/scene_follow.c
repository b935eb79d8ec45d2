/* What follows from the segments' kind; see scene_follow.h. */
#include "scene_follow.h"

#include <math.h>
#include <string.h>

/* A tier of two terminals, one for each output. */
struct offer {
    const char *tier, *terminal[2];
    size_t max_length;
};

enum { OFFERS = 9 };

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
                                {"exact", {"exact_xi", "exact_eta"}, 1}}},
               [VARY_WARPED] = {"parallelogram",
                                false,
                                {{"fast", {"p", "q"}, 1},
                                 {"coarse", {"u2", "v2"}, 1},
                                 {"gauss2", {"uq", "vq"}, 1},
                                 {"medium", {"ug", "vg"}, 1},
                                 {"balanced", {"u3", "v3"}, 1},
                                 {"fine", {"u3h", "v3h"}, 1},
                                 {"precise", {"u4", "v4"}, 1},
                                 {"accurate", {"u5", "v5"}, 1},
                                 {"full", {"u6", "v6"}, 1}}}};

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

static void choose_reference(struct scene *s, bool from_corner)
{
    double lo[2], hi[2];
    scene_box(s, lo, hi);
    for (int k = 0; k < 2; k++)
        s->reference[k] = from_corner ? -1 : (lo[k] + hi[k]) / 2;
}

void scene_follow(struct scene *s, enum vary_kind kind)
{
    s->tier = new_array(OFFERS, sizeof *s->tier);
    for (int i = 0; i < OFFERS && follows[kind].offer[i].tier; i++)
        add_tier(s, follows[kind].frame, &follows[kind].offer[i]);
    if (isnan(s->reference[0]))
        choose_reference(s, follows[kind].from_corner);
}
