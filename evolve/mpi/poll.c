/* Polls by nonblocking reductions; see poll.h. A rank joins a poll after each generation and reads the result some
 * generations later. A slow rank delays the others only after that many generations. */
#include "poll.h"

#include <string.h>

struct poll poll_new(const struct team *t, size_t sums, size_t minima)
{
    struct poll p = {.sums = sums, .minima = minima, .lag = 1};
    for (int ranks = 1; ranks < t->size && ranks < 1 << 30; ranks *= 2)
        p.lag += 2;
    p.slot = arena_array(&p.memory, p.lag, sizeof *p.slot);
    for (size_t i = 0; i < p.lag; i++)
        for (int k = 0; k < 2; k++) {
            p.slot[i].sum[k] = arena_array(&p.memory, sums, sizeof(double));
            p.slot[i].least[k] = arena_array(&p.memory, minima, sizeof(double));
        }
    return p;
}

void poll_cast(const struct team *t, struct poll *p, const double *sum, const double *least)
{
    struct poll_slot *s = &p->slot[p->cast++ % p->lag];
    memcpy(s->sum[0], sum, p->sums * sizeof *sum);
    memcpy(s->least[0], least, p->minima * sizeof *least);
    CHECK(MPI_Iallreduce(s->sum[0], s->sum[1], (int)p->sums, MPI_DOUBLE, MPI_SUM, t->comm, &s->request[0]));
    CHECK(MPI_Ireduce(s->least[0], s->least[1], (int)p->minima, MPI_DOUBLE, MPI_MIN, 0, t->comm, &s->request[1]));
}

const struct poll_slot *poll_count(struct poll *p)
{
    int done;
    struct poll_slot *s = &p->slot[p->counted % p->lag];
    if (p->counted == p->cast)
        return NULL;
    CHECK(MPI_Testall(2, s->request, &done, MPI_STATUSES_IGNORE));
    if (!done)
        return NULL;
    p->counted++;
    return s;
}
