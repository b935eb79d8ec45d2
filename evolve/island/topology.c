/* Topologies of migration; see topology.h. All are permutations of the places, so that each island receives a single
 * parcel per migration. */
#include "topology.h"

#include "../common/stream.h"

#include "../../codegen/base/base.h"

#include <stdlib.h>

/* place in a random stream's key that no island has */
static const uint64_t key_of_migration = UINT64_MAX;

/* Returns the next place along the torus' rows or columns; `step` is +1 or -1. */
static size_t along_torus(const struct migration *m, size_t place, int step)
{
    size_t columns = 1;
    for (size_t k = 1; k * k <= m->places; k++)
        columns = m->places % k == 0 ? k : columns;
    const size_t rows = m->places / columns, column = place % columns, row = place / columns;
    const bool along_row = columns > 1 && m->number % 2 == 0;
    if (along_row)
        return row * columns + (column + (step > 0 ? 1 : columns - 1)) % columns;
    return (row + (step > 0 ? 1 : rows - 1)) % rows * columns + column;
}

/* Draws the circle of this migration by Sattolo's algorithm: next[place] is a permutation with a single cycle. */
static size_t *random_circle(const struct migration *m)
{
    size_t *next = new_array(m->places, sizeof *next);
    gsl_rng *rng = stream_new();
    stream_key(rng, m->seed, m->ring, key_of_migration, m->number);
    for (size_t i = 0; i < m->places; i++)
        next[i] = i;
    for (size_t i = m->places; i-- > 1;) {
        const size_t k = gsl_rng_uniform_int(rng, i), other = next[k];
        next[k] = next[i];
        next[i] = other;
    }
    gsl_rng_free(rng);
    return next;
}

size_t topology_target(const struct migration *m, size_t place)
{
    if (m->topology == TOPOLOGY_NONE || m->places < 2)
        return place;
    if (m->topology == TOPOLOGY_RING)
        return (place + 1) % m->places;
    if (m->topology == TOPOLOGY_TORUS)
        return along_torus(m, place, 1);
    size_t *next = random_circle(m);
    const size_t target = next[place];
    free(next);
    return target;
}

size_t topology_source(const struct migration *m, size_t place)
{
    if (m->topology == TOPOLOGY_NONE || m->places < 2)
        return place;
    if (m->topology == TOPOLOGY_RING)
        return (place + m->places - 1) % m->places;
    if (m->topology == TOPOLOGY_TORUS)
        return along_torus(m, place, -1);
    size_t *next = random_circle(m), source = 0;
    while (next[source] != place)
        source++;
    free(next);
    return source;
}
