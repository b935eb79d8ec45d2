/* Checkpoint files: facts as text, and sections of bytes. The head locates each section, so that ranks write and read
 * theirs side by side. A SHA-256 seals the head and each section; a reader checks it first.
 *
 *   footpoint-checkpoint 2 <bytes of the facts> <sections>
 *   key value                              any number of lines: the facts
 *   ...                                    for each section: its length in 8 bytes, least significant first
 *   <64 hexadecimal digits>                SHA-256 of all the above
 *   ...                                    for each section: its bytes, then a line with their SHA-256
 *
 * The caller defines the facts and the sections. */
#ifndef FOOTPOINT_CHECKPOINT_H
#define FOOTPOINT_CHECKPOINT_H

#include "../../codegen/base/base.h"

enum { CHECKPOINT_FORMAT = 2, CHECKPOINT_SEAL = 65 /* bytes: digits and a line feed */ };

/** The layout of a checkpoint. */
struct checkpoint {
    char *head; /* owned: everything before the first section */
    size_t head_bytes;
    char *facts;
    size_t sections;
    struct checkpoint_part {
        size_t place, bytes; /* in the file; length without the seal */
    } * section;
    size_t size; /* of the file */
};

/** Lays out a checkpoint whose sections have these numbers of bytes. */
struct checkpoint checkpoint_new(const char *facts, const size_t *bytes, size_t sections);
/** Seals a section or a head: writes the line of digits after its bytes, where there must be room. */
void checkpoint_seal(unsigned char *data, size_t bytes);

/** Reads the head of a file. Returns false with *d "FILE: error: ..." if it cannot be read, is not a checkpoint, is
 *  damaged, or has another format. */
bool checkpoint_read(struct checkpoint *c, const char *path, struct diag *d);
/** Parses a head that another rank has read. */
bool checkpoint_take(struct checkpoint *c, const char *path, const char *head, struct diag *d);
/** Returns the bytes of a section, NUL-terminated and owned by the caller, or NULL with *d if it cannot be read or is
 *  damaged. */
unsigned char *checkpoint_section(const struct checkpoint *c, const char *path, size_t i, struct diag *d);
void checkpoint_free(struct checkpoint *c);

/** Copies the value of a key to value[0..n-1]. Returns false if the key is missing or there is no room. */
bool checkpoint_fact(const char *facts, const char *key, char *value, size_t n);

#endif
