/* Samples for code in single precision. Callers have coordinates in float, so the reference is computed from these. */
#include "../surface/surface.h"
#include "source.h"

/* Rounding may move a foot point by this much, in xi and eta, beyond the edge of the box. */
#define BEYOND 1e-3

/* volatile, because gcc 12 -O3 drops the two conversions when it vectorises. */
static void round_vector(double x[3])
{
    for (int k = 0; k < 3; k++) {
        const volatile float nearest = (float)x[k];
        x[k] = (double)nearest;
    }
}

bool sample_round(const struct scene *scene, struct sample *s)
{
    const struct surface *f = surface_find(scene->segment);
    double lo[2], hi[2];
    scene_box(scene, lo, hi);
    for (int k = 0; k < 2; k++) {
        lo[k] -= BEYOND;
        hi[k] += BEYOND;
    }
    for (size_t k = 0; k < segment_vectors(scene->segment); k++)
        round_vector(s->x[k]);
    round_vector(s->xs);
    if (!f->foot(f, s, lo, hi, (double[]){s->xi, s->eta}))
        return false;
    sample_order(s, scene->order);
    return true;
}
