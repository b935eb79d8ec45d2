/* Checkpoint files: facts as text, sections of bytes, and over both a SHA-256 that a reader checks first.
 *
 *   footpoint-checkpoint 1 <bytes of the facts> <sections>
 *   key value                              any number of lines: the facts
 *   ...                                    each section: its length in 8 bytes, least first, and its bytes
 *   <64 hexadecimal digits>                SHA-256 of all before
 *
 * What the facts and sections mean is the caller's matter. */
#ifndef FOOTPOINT_CHECKPOINT_H
#define FOOTPOINT_CHECKPOINT_H

#include "../../codegen/genome/outfile.h"

#include <sha256.h>

#define CHECKPOINT_FORMAT 1

/** A checkpoint under construction: aside, until it is complete. */
struct checkpoint_writer {
    struct outfile file;
    SHA2_CTX sum;
};

/** False with *d where the file cannot be written; then nothing is to be done. */
bool checkpoint_begin(struct checkpoint_writer *w, const char *path, const char *facts, size_t sections,
                      struct diag *d);
/** Append a section.  Errors of writing show in checkpoint_commit. */
void checkpoint_section(struct checkpoint_writer *w, const void *data, size_t bytes);
/** Seal, and replace the file of before; false with *d, and that file as it was, where something went wrong. */
bool checkpoint_commit(struct checkpoint_writer *w, struct diag *d);

/** A checkpoint that was read. */
struct checkpoint {
    char *text;  /* owned: the file */
    char *facts; /* owned */
    size_t sections;
    struct checkpoint_part {
        const unsigned char *data; /* in text */
        size_t bytes;
    } * section; /* owned */
};

/** False with *d "FILE: error: ...": cannot be read, is none, is cut or damaged, or of another format. */
bool checkpoint_read(struct checkpoint *c, const char *path, struct diag *d);
void checkpoint_free(struct checkpoint *c);

/** Copy the value of a key among facts to value[0..n-1]; false where there is none, or no room. */
bool checkpoint_fact(const char *facts, const char *key, char *value, size_t n);

#endif
