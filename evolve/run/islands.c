/* Distributes islands over ranks; see islands.h. */
#include "islands.h"

#include <stdlib.h>

size_t islands_count(const struct islands *s)
{
    return s->rings * s->places;
}

/* Assigns ring after ring, most expensive first, each island to the rank with the least load. A heap orders ranks by
 * load and rank, because there may be 100,000 of both and each rank computes this itself. */
struct load {
    double sum;
    int rank;
};

static bool lighter(const struct load *a, const struct load *b)
{
    return a->sum < b->sum || (a->sum == b->sum && a->rank < b->rank);
}

static void sink(struct load *heap, size_t n)
{
    for (size_t at = 0, child; (child = 2 * at + 1) < n; at = child) {
        if (child + 1 < n && lighter(&heap[child + 1], &heap[child]))
            child++;
        if (!lighter(&heap[child], &heap[at]))
            break;
        const struct load moved = heap[at];
        heap[at] = heap[child];
        heap[child] = moved;
    }
}

void islands_share(struct islands *s, int size)
{
    const size_t ranks = (size_t)size;
    struct load *heap = new_array(ranks, sizeof *heap);
    bool *shared = new_array(s->rings, sizeof *shared);
    for (size_t r = 0; r < ranks; r++)
        heap[r].rank = (int)r;
    for (size_t k = 0; k < s->rings; k++) {
        size_t ring = s->rings;
        for (size_t i = 0; i < s->rings; i++)
            if (!shared[i] && (ring == s->rings || s->ring[i].load > s->ring[ring].load))
                ring = i;
        shared[ring] = true;
        for (size_t i = 0; i < s->places; i++) {
            s->owner[ring * s->places + i] = heap[0].rank;
            heap[0].sum += s->ring[ring].load;
            sink(heap, ranks);
        }
    }
    free(shared);
    free(heap);
}

bool islands_can_be_tagged(const struct islands *s, const struct team *t, struct diag *d)
{
    const int last = team_last_tag(t);
    if (islands_count(s) <= (size_t)(last - TAG_MIGRANTS))
        return true;
    diag_at(d, "footpoint-evolve", 0, 0, "%zu islands need more tags than this MPI's %d", islands_count(s), last);
    d->code = EXIT_USAGE;
    return false;
}

void islands_sizes(const struct islands *s, const struct team *t, size_t (*of)(const struct island *), size_t *size)
{
    const size_t n = islands_count(s);
    for (size_t i = 0; i < n; i++)
        size[i] = s->island[i] ? of(s->island[i]) : 0;
    team_sum(t, size, n);
}

static size_t report_bytes(const struct island *is)
{
    return island_report_size(is) * sizeof(int);
}

void islands_reports(const struct islands *s, const struct team *t,
                     void (*take)(void *to, size_t island, const int *report), void *to)
{
    const size_t n = islands_count(s);
    struct mail mail = {0};
    struct gather g;
    size_t *bytes = new_array(n, sizeof *bytes);
    islands_sizes(s, t, report_bytes, bytes);
    for (size_t i = 0; i < n; i++)
        if (s->island[i]) {
            int *report = new_array(island_report_size(s->island[i]), sizeof *report);
            island_report(s->island[i], report);
            mail_send(t, &mail, report, report_bytes(s->island[i]), 0, TAG_REPORT);
        }
    gather_start(&g, TAG_REPORT, s->owner, n);
    for (size_t i = 0; t->rank == 0 && i < n; i++) {
        int *report = gather_next(t, &g, bytes, 0, true);
        take(to, i, report);
        free(report);
    }
    mail_free(&mail);
    free(bytes);
}

void islands_free(struct islands *s)
{
    for (size_t i = 0; i < islands_count(s); i++)
        island_free(s->island[i]);
    free(s->ring);
    free(s->island);
    free(s->owner);
    free(s->seeded);
}
