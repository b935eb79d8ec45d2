/* A file that all ranks write side by side, each at its own places. */
#ifndef FOOTPOINT_SHARED_FILE_H
#define FOOTPOINT_SHARED_FILE_H

#include "team.h"

struct shared_file {
    const char *path; /* not owned: the name in diagnostics */
    MPI_File file;
};

/** Chooses an I/O component that reports why a file cannot be written. Must be called before MPI_Init. */
void shared_file_prepare(void);

/** Opens an existing file; `path` must be the same on all ranks. Collective. Returns false on all ranks, with *d naming
 *  f->path, if any rank fails. */
bool shared_file_open(struct shared_file *f, const struct team *t, const char *path, struct diag *d);
/** Writes `bytes` bytes at `place`. Not collective. Returns false, with *d filled, if not all were written. */
bool shared_file_write(struct shared_file *f, size_t place, const void *data, size_t bytes, struct diag *d);
/** Flushes the file to disk and closes it. Collective. Returns false, with *d filled, on the ranks that failed. */
bool shared_file_close(struct shared_file *f, struct diag *d);

#endif
