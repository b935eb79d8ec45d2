/* A file that all ranks write side by side, each at places of its own. */
#ifndef FOOTPOINT_SHARED_FILE_H
#define FOOTPOINT_SHARED_FILE_H

#include "team.h"

struct shared_file {
    const char *path; /* not owned: as diagnostics call it */
    MPI_File file;
};

/** To be called before MPI_Init: chooses what can say why a file cannot be written. */
void shared_file_prepare(void);

/** Collective: open a file that is there, of this path on all ranks.  False on all ranks with *d, of name f->path, where
 *  one cannot. */
bool shared_file_open(struct shared_file *f, const struct team *t, const char *path, struct diag *d);
/** Not collective.  False with *d: not all could be written. */
bool shared_file_write(struct shared_file *f, size_t place, const void *data, size_t bytes, struct diag *d);
/** Collective: bring all to the disk, and close.  False with *d on ranks where that failed. */
bool shared_file_close(struct shared_file *f, struct diag *d);

#endif
