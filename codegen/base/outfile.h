/* Output files: written whole or not at all, and never over an input. Uses only the C library. */
#ifndef FOOTPOINT_OUTFILE_H
#define FOOTPOINT_OUTFILE_H

#include "base.h"

enum { OUTFILE_PATH = 1024 };

/** A file under construction. It is written under a temporary name, in the folder of the path's final target (links are
 *  followed), and outfile_commit renames it to the target. It keeps the permissions of an existing file. Devices,
 *  pipes, /dev/stdout and /dev/fd/N are written directly. */
struct outfile {
    FILE *stream;
    char path[OUTFILE_PATH];       /* as given */
    char target[OUTFILE_PATH];     /* after following links */
    char aside[OUTFILE_PATH + 16]; /* "": written directly */
};
bool outfile_open(struct outfile *f, const char *path, struct diag *d);
bool outfile_commit(struct outfile *f, struct diag *d); /* flushes, syncs, closes and renames; removes the temporary
                                                         * file on failure */
void outfile_discard(struct outfile *f);

/** Checks whether outfile_open would succeed, before the work for the file starts; leaves nothing behind. NULL: no
 *  file, true. */
bool outfile_probe(const char *path, struct diag *d);

/** A file of a command line: `what` is its role ("--output", "the scene"); path, NULL if not given; whether it is
 *  written. Two files with the same nonzero `group` may be the same file. */
struct file_use {
    const char *what, *path;
    bool written;
    int group;
};

/** Returns false, with *d "PROGRAM: error: ..." (code EXIT_USAGE), if a file that is written is also another file. */
bool files_apart(const char *program, const struct file_use *file, size_t n, struct diag *d);

#endif
