/* Faces in single precision for tests; see single_cases.h. */
#include "single_cases.h"

#include "../hard/draw.h"

#include <float.h>
#include <math.h>

const char *const single_families[SINGLE_FAMILIES] = {
    "ordinary", "strongly curved", "sliver", "wild", "offset", "tiny", "huge", "far", "mixed"};

/* Draws each coordinate of each point at a scale of its own. */
static void draw_mixed(uint64_t *stream, struct curved_case *f)
{
    for (int k = 0; k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            f->x[k][i] = draw_sign(stream) * draw_power(stream, -8, 0);
}

static void scale(struct curved_case *f, double factor, double shift)
{
    for (int k = 0; k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            f->x[k][i] = factor * (f->x[k][i] + shift);
}

void single_draw(uint64_t *stream, enum single_family family, struct curved_case *f)
{
    curved_draw(stream, family < SINGLE_OFFSET ? (enum curved_group)family : ORDINARY, f);
    if (family == SINGLE_OFFSET)
        scale(f, 1, draw_power(stream, 0, 7));
    if (family == SINGLE_TINY)
        scale(f, draw_power(stream, -45, -8), 0);
    if (family == SINGLE_HUGE)
        scale(f, draw_power(stream, 8, 38), 0);
    if (family == SINGLE_FAR)
        for (int i = 0; i < 3; i++)
            f->x[f->kind->nodes][i] += draw_power(stream, 0, 6) * draw_flat(stream, -1, 1);
    if (family == SINGLE_MIXED)
        draw_mixed(stream, f);
    for (int k = 0; k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            f->x[k][i] = (double)single_round(f->x[k][i]);
}

float single_round(double x)
{
    return fabs(x) <= (double)FLT_MAX ? (float)x : (float)copysign(HUGE_VAL, x);
}
