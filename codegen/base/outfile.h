/* Files that programs write: whole or not at all, and never over what they read.  A leaf: C library only. */
#ifndef FOOTPOINT_OUTFILE_H
#define FOOTPOINT_OUTFILE_H

#include "base.h"

enum { OUTFILE_PATH = 1024 };

/** A file under construction: written aside, in the folder of what the path finally names (links are followed), and
 *  renamed onto it by outfile_commit; it keeps the permissions of what was there.  What is there and is no regular
 * file, a device or a pipe, and what /dev/stdout or /dev/fd/N stand for, is written to directly. */
struct outfile {
    FILE *stream;
    char path[OUTFILE_PATH];       /* as given */
    char target[OUTFILE_PATH];     /* what it finally names */
    char aside[OUTFILE_PATH + 16]; /* "": written to directly */
};
bool outfile_open(struct outfile *f, const char *path, struct diag *d);
bool outfile_commit(struct outfile *f, struct diag *d); /* flush, sync, close, rename; removes the aside on failure */
void outfile_discard(struct outfile *f);

/** Whether outfile_open would do, before the work that the file is for; leaves nothing. NULL: no file, true. */
bool outfile_probe(const char *path, struct diag *d);

/** A file of a command line: `what` it is there ("--output", "the scene"), its path (NULL: not given), whether it is
 *  written.  Two of the same `group`, unless 0, may be one file. */
struct file_use {
    const char *what, *path;
    bool written;
    int group;
};

/** False, with *d "PROGRAM: error: ..." (code EXIT_USAGE), where a file that is written is another one, too. */
bool files_apart(const char *program, const struct file_use *file, size_t n, struct diag *d);

#endif
