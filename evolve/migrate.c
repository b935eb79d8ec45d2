/* The processes' talk, over MPI; see migrate.h.  Trees travel as parcels of ints (island_pack) and are judged again
 * where they arrive. */
#include "migrate.h"

#include <stdlib.h>

enum tag { TAG_MIGRANTS = 1, TAG_BEST };

/* A failure of the network cannot be agreed on: it ends the job. */
#define CHECK(call) check((call), #call)
static void check(int code, const char *call)
{
    char text[MPI_MAX_ERROR_STRING] = "";
    int length;
    if (code == MPI_SUCCESS)
        return;
    MPI_Error_string(code, text, &length);
    fprintf(stderr, "error: %.60s: %s\n", call, text);
    MPI_Abort(MPI_COMM_WORLD, EXIT_SYSTEM);
}

struct team team_new(MPI_Comm comm)
{
    struct team t;
    CHECK(MPI_Comm_dup(comm, &t.comm));
    CHECK(MPI_Comm_set_errhandler(t.comm, MPI_ERRORS_RETURN));
    CHECK(MPI_Comm_rank(t.comm, &t.rank));
    CHECK(MPI_Comm_size(t.comm, &t.size));
    return t;
}

void team_free(struct team *t)
{
    CHECK(MPI_Comm_free(&t->comm));
}

bool team_agree(const struct team *t, bool good, struct diag *d)
{
    int first = good ? t->size : t->rank;
    CHECK(MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, t->comm));
    if (first == t->size)
        return true;
    CHECK(MPI_Bcast(d, (int)sizeof *d, MPI_BYTE, first, t->comm));
    return false;
}

void team_minimum(const struct team *t, double *value, size_t n)
{
    CHECK(MPI_Allreduce(MPI_IN_PLACE, value, (int)n, MPI_DOUBLE, MPI_MIN, t->comm));
}

double team_sum(const struct team *t, double value)
{
    CHECK(MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, t->comm));
    return value;
}

void team_share(const struct team *t, struct sea *s)
{
    size_t *load = new_array((size_t)t->size, sizeof *load);
    const size_t n = s->rings * s->places;
    for (size_t i = 0; i < n; i++)
        s->owner[i] = -1;
    for (size_t given = 0; given < n; given++) {
        size_t longest = n;
        for (size_t i = 0; i < n; i++)
            if (s->owner[i] < 0 && (longest == n || s->max_length[i / s->places] > s->max_length[longest / s->places]))
                longest = i;
        int idle = 0;
        for (int r = 1; r < t->size; r++)
            if (load[r] < load[idle])
                idle = r;
        load[idle] += s->max_length[longest / s->places];
        s->owner[longest] = idle;
    }
    free(load);
}

/* Parcels of n trees from every island: one buffer each, all on their way at once. */
struct post {
    int **parcel; /* owned, one for each island; NULL where this rank has nothing to do with it */
    MPI_Request *request;
    int requests;
};

static size_t parcel_size(const struct sea *s, size_t island, size_t n)
{
    return n * (1 + s->max_length[island / s->places]);
}

static struct post post_new(const struct sea *s)
{
    const size_t n = s->rings * s->places;
    return (struct post){new_array(n, sizeof(int *)), new_array(n, sizeof(MPI_Request)), 0};
}

/* Parcel of island `from` to the rank `to`.  Called on every rank for all islands in ascending order, so that parcels
 * between two ranks are received in the order in which they are sent. */
static void post_parcel(const struct team *t, const struct sea *s, struct post *p, size_t from, int to, size_t n,
                        int tag)
{
    const int sender = s->owner[from];
    const size_t size = parcel_size(s, from, n);
    if (t->rank != sender && t->rank != to)
        return;
    int *parcel = p->parcel[from] = new_array(size, sizeof *parcel);
    if (t->rank == sender)
        island_pack(s->island[from], n, parcel);
    if (sender == to)
        return;
    MPI_Request *request = &p->request[p->requests++];
    if (t->rank == sender)
        CHECK(MPI_Isend(parcel, (int)size, MPI_INT, to, tag, t->comm, request));
    else
        CHECK(MPI_Irecv(parcel, (int)size, MPI_INT, sender, tag, t->comm, request));
}

static void post_wait(struct post *p)
{
    CHECK(MPI_Waitall(p->requests, p->request, MPI_STATUSES_IGNORE));
}

static void post_free(struct post *p, size_t islands)
{
    for (size_t i = 0; i < islands; i++)
        free(p->parcel[i]);
    free(p->parcel);
    free(p->request);
}

static size_t next_in_ring(const struct sea *s, size_t island)
{
    return island / s->places * s->places + (island + 1) % s->places;
}

void team_migrate(const struct team *t, struct sea *s, size_t migrants)
{
    const size_t n = s->rings * s->places;
    if (s->places < 2 || migrants == 0)
        return;
    struct post p = post_new(s);
    for (size_t i = 0; i < n; i++)
        post_parcel(t, s, &p, i, s->owner[next_in_ring(s, i)], migrants, TAG_MIGRANTS);
    post_wait(&p);
    for (size_t i = 0; i < n; i++)
        if (s->island[next_in_ring(s, i)])
            island_receive(s->island[next_in_ring(s, i)], migrants, p.parcel[i]);
    post_free(&p, n);
}

int **team_gather(const struct team *t, struct sea *s)
{
    const size_t n = s->rings * s->places;
    int **report = new_array(n + 1, sizeof *report);
    for (size_t i = 0; i < n; i++) {
        int size = 0;
        if (s->island[i]) {
            size = (int)island_report_size(s->island[i]);
            report[i] = new_array((size_t)size, sizeof **report);
            island_report(s->island[i], report[i]);
        }
        if (s->owner[i] == 0)
            continue;
        if (t->rank == s->owner[i]) {
            CHECK(MPI_Send(&size, 1, MPI_INT, 0, TAG_BEST, t->comm));
            CHECK(MPI_Send(report[i], size, MPI_INT, 0, TAG_BEST, t->comm));
        } else if (t->rank == 0) {
            CHECK(MPI_Recv(&size, 1, MPI_INT, s->owner[i], TAG_BEST, t->comm, MPI_STATUS_IGNORE));
            report[i] = new_array((size_t)size, sizeof **report);
            CHECK(MPI_Recv(report[i], size, MPI_INT, s->owner[i], TAG_BEST, t->comm, MPI_STATUS_IGNORE));
        }
    }
    if (t->rank == 0)
        return report;
    for (size_t i = 0; i < n; i++)
        free(report[i]);
    free(report);
    return NULL;
}
