/* Messages on their way; see team.h.  A rank's messages to itself go the same way as all others. */
#include "team.h"
#include "mpi_check.h"

#include <stdlib.h>

void mail_send(const struct team *t, struct mail *m, void *parcel, size_t bytes, int to, int tag)
{
    grow_array(&m->request, m->n, &m->request_room, sizeof *m->request);
    grow_array(&m->parcel, m->n, &m->parcel_room, sizeof *m->parcel);
    m->parcel[m->n] = parcel;
    CHECK(MPI_Isend(parcel, (int)bytes, MPI_BYTE, to, tag, t->comm, &m->request[m->n]));
    m->n++;
}

void mail_sweep(struct mail *m)
{
    size_t kept = 0;
    for (size_t i = 0; i < m->n; i++) {
        int gone;
        CHECK(MPI_Test(&m->request[i], &gone, MPI_STATUS_IGNORE));
        if (gone) {
            free(m->parcel[i]);
            continue;
        }
        m->request[kept] = m->request[i];
        m->parcel[kept++] = m->parcel[i];
    }
    m->n = kept;
}

void mail_free(struct mail *m)
{
    CHECK(MPI_Waitall((int)m->n, m->request, MPI_STATUSES_IGNORE));
    for (size_t i = 0; i < m->n; i++)
        free(m->parcel[i]);
    free(m->parcel);
    free(m->request);
    *m = (struct mail){0};
}

void inbound_expect(const struct team *t, struct inbound *in, size_t bytes, int from, int tag)
{
    in->parcel = new_array(bytes, 1);
    CHECK(MPI_Irecv(in->parcel, (int)bytes, MPI_BYTE, from, tag, t->comm, &in->request));
}

bool inbound_here(struct inbound *in)
{
    int here = 1;
    if (in->parcel)
        CHECK(MPI_Test(&in->request, &here, MPI_STATUS_IGNORE)); /* a request that is done stays done */
    return here;
}

void *team_receive(const struct team *t, int from, int tag, size_t *bytes)
{
    MPI_Status status;
    int count;
    CHECK(MPI_Probe(from, tag, t->comm, &status));
    CHECK(MPI_Get_count(&status, MPI_BYTE, &count));
    void *parcel = new_array((size_t)count, 1);
    CHECK(MPI_Recv(parcel, count, MPI_BYTE, from, tag, t->comm, MPI_STATUS_IGNORE));
    *bytes = (size_t)count;
    return parcel;
}

void gather_start(struct gather *g, int tag)
{
    *g = (struct gather){.active = true, .tag = tag};
}

void *gather_next(const struct team *t, const struct sea *s, struct gather *g, const size_t *bytes, size_t same,
                  bool wait)
{
    const size_t n = sea_islands(s);
    for (; g->posted < n && g->posted - g->taken < GATHER_WINDOW; g->posted++)
        inbound_expect(t, &g->in[g->posted % GATHER_WINDOW], bytes ? bytes[g->posted] : same, s->owner[g->posted],
                       g->tag);
    struct inbound *in = &g->in[g->taken % GATHER_WINDOW];
    if (wait)
        CHECK(MPI_Wait(&in->request, MPI_STATUS_IGNORE));
    else if (!inbound_here(in))
        return NULL;
    void *block = in->parcel;
    in->parcel = NULL;
    g->active = ++g->taken < n;
    return block;
}

/* The sizes that own[] gives for the islands of this rank, of all islands, on rank 0; NULL on the others. */
static size_t *gather_sizes(const struct team *t, const struct sea *s, size_t (*size)(const struct island *))
{
    const size_t n = sea_islands(s);
    struct mail mail = {0};
    struct gather g;
    for (size_t i = 0; i < n; i++)
        if (s->island[i]) {
            size_t *own = new_array(1, sizeof *own);
            *own = size(s->island[i]);
            mail_send(t, &mail, own, sizeof *own, 0, TAG_SIZE);
        }
    size_t *all = t->rank == 0 ? new_array(n, sizeof *all) : NULL;
    gather_start(&g, TAG_SIZE);
    for (size_t i = 0; all && i < n; i++) {
        size_t *one = gather_next(t, s, &g, NULL, sizeof *one, true);
        all[i] = *one;
        free(one);
    }
    mail_free(&mail);
    return all;
}

size_t *team_state_sizes(const struct team *t, const struct sea *s)
{
    return gather_sizes(t, s, island_state_size);
}

static size_t report_bytes(const struct island *is)
{
    return island_report_size(is) * sizeof(int);
}

static void take_report(struct finds *f, size_t island, int *report)
{
    int *at = report + 1;
    f->memory[island] = report;
    for (int k = 0; k < report[0]; k++) {
        const size_t length = (size_t)at[0];
        grow_array(&f->find, f->finds, &f->room, sizeof *f->find);
        f->find[f->finds++] = (struct find){island, {at + 1, length}};
        at += 1 + length;
    }
}

struct finds team_gather(const struct team *t, const struct sea *s)
{
    const size_t n = sea_islands(s);
    struct finds f = {.islands = t->rank == 0 ? n : 0, .memory = new_array(n, sizeof(int *))};
    struct mail mail = {0};
    struct gather g;
    size_t *bytes = gather_sizes(t, s, report_bytes);
    for (size_t i = 0; i < n; i++)
        if (s->island[i]) {
            int *report = new_array(island_report_size(s->island[i]), sizeof *report);
            island_report(s->island[i], report);
            mail_send(t, &mail, report, report_bytes(s->island[i]), 0, TAG_REPORT);
        }
    gather_start(&g, TAG_REPORT);
    for (size_t i = 0; i < f.islands; i++)
        take_report(&f, i, gather_next(t, s, &g, bytes, 0, true));
    mail_free(&mail);
    free(bytes);
    return f;
}

void finds_free(struct finds *f)
{
    for (size_t i = 0; i < f->islands; i++)
        free(f->memory[i]);
    free(f->memory);
    free(f->find);
    *f = (struct finds){0};
}
