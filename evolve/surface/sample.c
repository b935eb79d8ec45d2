/* Growing sets of samples; see sample.h. */
#include "sample.h"

#include "../../codegen/base/base.h"

#include <math.h>
#include <stdlib.h>

void sample_set_add(struct sample_set *set, const struct sample *s)
{
    APPEND(set->s, set->n, set->room) = *s;
}

void sample_set_free(struct sample_set *set)
{
    free(set->s);
    *set = (struct sample_set){0};
}

const char *const gap_band_name[GAP_BANDS] = {"to 1e-3", "to 1e-2", "to 1e-1", "beyond"};

double sample_shortest_edge(const struct sample *s, size_t corners)
{
    double shortest = INFINITY;
    for (size_t i = 0; i < corners; i++) {
        const double *a = s->x[i], *b = s->x[(i + 1) % corners];
        shortest = fmin(shortest, hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]));
    }
    return shortest;
}

int sample_gap_band(const struct sample *s, size_t corners)
{
    static const double most[GAP_BANDS - 1] = {1e-3, 1e-2, 1e-1};
    const double edge = sample_shortest_edge(s, corners);
    int band = 0;
    while (band < GAP_BANDS - 1 && !(fabs(s->gap) <= most[band] * edge))
        band++;
    return band;
}

const struct heldout_part heldout_part[HELDOUT_PARTS] = {
    {PART_HELDOUT, "heldout"}, {PART_HELDOUT_RANDOM, "heldout_random"}, {PART_HELDOUT_EVEN, "heldout_even"}};
