/* Messages in transit; see mail.h. A rank's messages to itself are sent like all others. */
#include "mail.h"

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
        CHECK(MPI_Test(&in->request, &here, MPI_STATUS_IGNORE)); /* a completed request stays completed */
    return here;
}

void gather_start(struct gather *g, int tag, const int *owner, size_t n)
{
    *g = (struct gather){.active = n > 0, .tag = tag, .owner = owner, .n = n};
}

void *gather_next(const struct team *t, struct gather *g, const size_t *bytes, size_t same, bool wait)
{
    for (; g->posted < g->n && g->posted - g->taken < GATHER_WINDOW; g->posted++)
        inbound_expect(t, &g->in[g->posted % GATHER_WINDOW], bytes ? bytes[g->posted] : same, g->owner[g->posted],
                       g->tag);
    struct inbound *in = &g->in[g->taken % GATHER_WINDOW];
    if (wait)
        CHECK(MPI_Wait(&in->request, MPI_STATUS_IGNORE));
    else if (!inbound_here(in))
        return NULL;
    void *block = in->parcel;
    in->parcel = NULL;
    g->active = ++g->taken < g->n;
    return block;
}
