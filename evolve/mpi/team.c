/* Agreement of the ranks before and after a run; see team.h. */
#include "team.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void mpi_check(int code, const char *call)
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

char *team_tell(const struct team *t, const char *text, size_t bytes)
{
    long long size = text ? (long long)bytes : -1;
    CHECK(MPI_Bcast(&size, 1, MPI_LONG_LONG, 0, t->comm));
    if (size < 0)
        return NULL;
    char *copy = new_array((size_t)size + 1, 1);
    if (t->rank == 0)
        memcpy(copy, text, bytes);
    CHECK(MPI_Bcast(copy, (int)size, MPI_BYTE, 0, t->comm));
    return copy;
}

void team_sum(const struct team *t, size_t *number, size_t n)
{
    uint64_t *sum = new_array(n, sizeof *sum);
    for (size_t i = 0; i < n; i++)
        sum[i] = number[i];
    CHECK(MPI_Allreduce(MPI_IN_PLACE, sum, (int)n, MPI_UINT64_T, MPI_SUM, t->comm));
    for (size_t i = 0; i < n; i++)
        number[i] = (size_t)sum[i];
    free(sum);
}

int team_last_tag(const struct team *t)
{
    int *bound, known;
    CHECK(MPI_Comm_get_attr(t->comm, MPI_TAG_UB, &bound, &known));
    return known ? *bound : INT_MAX;
}
