/* Checkpoint files: facts as text, and sections of bytes.  The head says where each section stands, so that ranks write
 * and read theirs side by side; a SHA-256 seals the head and each section, which a reader checks first.
 *
 *   footpoint-checkpoint 2 <bytes of the facts> <sections>
 *   key value                              any number of lines: the facts
 *   ...                                    of each section: its length in 8 bytes, least first
 *   <64 hexadecimal digits>                SHA-256 of all before
 *   ...                                    each section: its bytes, and a line of digits, their SHA-256
 *
 * What the facts and sections mean is the caller's matter. */
#ifndef FOOTPOINT_CHECKPOINT_H
#define FOOTPOINT_CHECKPOINT_H

#include "../../codegen/base/base.h"

enum { CHECKPOINT_FORMAT = 2, CHECKPOINT_SEAL = 65 /* bytes: digits and a line feed */ };

/** What stands where in a checkpoint. */
struct checkpoint {
    char *head; /* owned, as are these: all before the first section */
    size_t head_bytes;
    char *facts;
    size_t sections;
    struct checkpoint_part {
        size_t place, bytes; /* in the file; length without the seal */
    } * section;
    size_t size; /* of the file */
};

/** A checkpoint to be written: its sections have so many bytes. */
struct checkpoint checkpoint_new(const char *facts, const size_t *bytes, size_t sections);
/** Seal a section, or a head: the line of digits goes behind its bytes, where there is room for it. */
void checkpoint_seal(unsigned char *data, size_t bytes);

/** Read the head of a file.  False with *d "FILE: error: ...": cannot be read, is none, is cut or damaged, or of another
 *  format. */
bool checkpoint_read(struct checkpoint *c, const char *path, struct diag *d);
/** The same of a head that another rank has read. */
bool checkpoint_take(struct checkpoint *c, const char *path, const char *head, struct diag *d);
/** The bytes of a section, NUL-terminated and owned by the caller; NULL with *d: cannot be read, or damaged. */
unsigned char *checkpoint_section(const struct checkpoint *c, const char *path, size_t i, struct diag *d);
void checkpoint_free(struct checkpoint *c);

/** Copy the value of a key among facts to value[0..n-1]; false where there is none, or no room. */
bool checkpoint_fact(const char *facts, const char *key, char *value, size_t n);

#endif
