/* The log of a run: CSV, a line for each island and logged generation, in that order; without times, so that its bytes
 * depend on nothing but the run's options. */
#ifndef FOOTPOINT_RUN_LOG_H
#define FOOTPOINT_RUN_LOG_H

#include "../../codegen/base/base.h"

#include <sha256.h>
#include <stdint.h>

/** What an island says of one generation. */
struct log_row {
    uint64_t generation, length, evaluations; /* length: genes of the best */
    double best, median;                      /* errors in the scene's norm */
};

struct run_log {
    FILE *stream; /* owned; NULL: none */
    const char *path;
    uint64_t bytes; /* written so far, and the sum over them */
    SHA2_CTX sum;
};

/** Length and SHA-256 of a log. */
struct log_mark {
    uint64_t bytes;
    char sha256[65];
};

/** Start a log anew. */
bool run_log_open(struct run_log *l, const char *path, struct diag *d);
/** Go on with a log: it must begin with what `mark` tells, and loses all behind. */
bool run_log_continue(struct run_log *l, const char *path, const struct log_mark *mark, struct diag *d);
/** Append a line; errors of writing show in run_log_sync. */
void run_log_add(struct run_log *l, size_t island, const char *tier, const char *output, size_t place,
                 const struct log_row *row);
/** Bring all lines to the disk; false with *d where that failed. */
bool run_log_sync(struct run_log *l, struct diag *d);
struct log_mark run_log_mark(const struct run_log *l);
void run_log_close(struct run_log *l);

#endif
