/* The log of a run: CSV, a line for each logged generation and island, in that order. It contains no times, so its
 * bytes depend only on the run's options. */
#ifndef FOOTPOINT_RUN_LOG_H
#define FOOTPOINT_RUN_LOG_H

#include "../../codegen/base/base.h"

#include <sha256.h>
#include <stdint.h>

/** The log entry of an island for one generation. */
struct log_row {
    uint64_t generation, length, evaluations; /* length: genes of the best individual */
    double best, median;                      /* in the scene's norm */
};

struct run_log {
    FILE *stream; /* owned, or NULL */
    const char *path;
    uint64_t bytes; /* written so far, and their checksum */
    SHA2_CTX sum;
};

/** Length and SHA-256 of a log. */
struct log_mark {
    uint64_t bytes;
    char sha256[65];
};

/** Starts a new log. */
bool run_log_open(struct run_log *l, const char *path, struct diag *d);
/** Continues a log: it must begin with the bytes of `mark`; the rest is cut off. */
bool run_log_continue(struct run_log *l, const char *path, const struct log_mark *mark, struct diag *d);
/** Appends a line; run_log_sync reports write errors. */
void run_log_add(struct run_log *l, size_t island, const char *tier, const char *output, size_t place,
                 const struct log_row *row);
/** Flushes all lines to disk; returns false with *d on failure. */
bool run_log_sync(struct run_log *l, struct diag *d);
struct log_mark run_log_mark(const struct run_log *l);
void run_log_close(struct run_log *l);

#endif
