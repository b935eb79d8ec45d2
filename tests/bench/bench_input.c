/* See bench_input.h. */
#include "bench_input.h"

#include <math.h>

static const double before_distance = 0.02, turn = 2.399963229728653; /* in xi and eta; the golden angle */

struct bench_input bench_input_of(const struct segment_kind *kind, const struct sample *s, size_t i)
{
    struct bench_input in = {
        .before = {s->xi + before_distance * cos(turn * (double)i), s->eta + before_distance * sin(turn * (double)i)}};
    for (int k = 0; k < 3; k++) {
        for (size_t n = 0; n < segment_vectors(kind); n++)
            in.x[n][k] = s->x[n][k];
        in.x[segment_vectors(kind)][k] = s->xs[k];
    }
    return in;
}
