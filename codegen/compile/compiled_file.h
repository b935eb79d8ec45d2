/* A compiled genome file: the input of every printer (header, Fortran module, plain text). */
#ifndef FOOTPOINT_COMPILED_FILE_H
#define FOOTPOINT_COMPILED_FILE_H

#include "../program/float_errors.h"
#include "../prove/prove.h"
#include "../rounding/evidence.h"
#include "compile.h"

enum precision { PRECISION_DOUBLE, PRECISION_FLOAT };

/** A genome as a function. */
struct function {
    const struct genome *genome; /* not owned */
    char *name;                  /* owned: prefix and genome */
    struct compiled code;        /* owned text */
    struct program *program;     /* not owned: of code */
    struct proof proof;          /* that the program equals the genome */
    struct evidence *evidence;   /* owned; NULL: not requested */
    bool scaled; /* computes with coordinates relative to the segment: there were samples, and place and size do not
                  * matter */
    struct measured *measured; /* owned: errors of the float code; NULL: there were no samples */
    char sha256[65];           /* of the genome by itself, as genome_print would print it */
};

struct unit_options {
    const char *prefix;      /* not owned: begins every name, but see face_prefix */
    const char *face_prefix; /* not owned: begins names of functions at a place of a face; NULL: footpoint_KIND */
    const char *command;     /* not owned: the command line, for the banner */
    enum precision precision;
    bool allow_poles;                      /* functions may divide by 0, and then return a status */
    bool evidence;                         /* find poles and error bounds */
    bool quiet;                            /* no progress output */
    const struct measure_samples *samples; /* not owned: to measure float code; may be NULL */
    struct compile_options compile;
};

struct unit {
    const struct genome_file *file; /* not owned */
    struct unit_options options;
    char sha256[65];           /* of the file's text */
    struct function *function; /* owned: by genome of the file */
};

/** Compiles and proves each genome. Warnings and, unless `quiet`, progress go to stderr. Returns NULL, with *d filled,
 *  if a genome is rejected. */
struct unit *unit_new(const struct genome_file *f, const char sha256[65], const struct unit_options *o, struct diag *d);
void unit_free(struct unit *u);

/** Returns the prefix of functions at a place of the file's face, to be freed. */
char *unit_face_prefix(const struct genome_file *f, const struct unit_options *o);

/** Returns true if a denominator may be 0, or may become 0 or change its sign by rounding: the function returns a
 *  status. */
bool function_is_guarded(const struct function *f);

/** Returns the cancelled operations as "2 divisions and 1 root", or NULL. The caller frees it. */
char *function_cancelled(const struct function *f);

/** Returns the |D| up to which a denominator cannot be separated from 0 in the unit's precision; 0 if unknown.
 *  Otherwise the code tests D's sign, if it is known. */
double unit_threshold(const struct unit *u, const struct denominator *d);

/** Returns the power of |AB| that scales a segment's threshold: ranges have A = (0,0,0), B = (1,0,0), while callers
 *  have segments of any size. Returns 0 for other ranges, or if the denominator has no such power. */
int unit_degree(const struct unit *u, const struct function *f, const struct denominator *d);

#endif
