/* A genome file compiled: what every printer (header, Fortran module, plain text) prints. */
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
    struct evidence *evidence;   /* owned; NULL: not asked for */
    bool scaled; /* computes with coordinates relative to the segment: there were samples, and neither place
                  * nor size matters */
    struct measured *measured; /* owned: errors of the float code; NULL: there were no samples */
    char sha256[65];           /* of the genome alone, as genome_print would print it */
};

struct unit_options {
    const char *prefix;      /* not owned: begins every name, but see face_prefix */
    const char *face_prefix; /* not owned: begins names of functions at a place of a face; NULL: footpoint_KIND */
    const char *command;     /* not owned: how it was called, for the banner */
    enum precision precision;
    bool allow_poles;                      /* functions may divide by 0, and have a status then */
    bool evidence;                         /* find poles and error bounds */
    bool quiet;                            /* say nothing while working */
    const struct measure_samples *samples; /* not owned: to measure float code on; NULL: there are none */
    struct compile_options compile;
};

struct unit {
    const struct genome_file *file; /* not owned */
    struct unit_options options;
    char sha256[65];           /* of the file's text */
    struct function *function; /* owned: by genome of the file */
};

/** Compiles and proves each genome; warnings go to stderr, and unless quiet what is being done.  NULL with *d filled
 *  when a genome is refused. */
struct unit *unit_new(const struct genome_file *f, const char sha256[65], const struct unit_options *o, struct diag *d);
void unit_free(struct unit *u);

/** Returns what begins the names of functions at a place of the file's face, to be freed. */
char *unit_face_prefix(const struct genome_file *f, const struct unit_options *o);

/** True if the function has a denominator that may be 0, or that rounding may make 0 or turn round: it has a status. */
bool function_is_guarded(const struct function *f);

/** What cancelled, as "2 divisions and 1 root"; NULL if nothing did.  Caller frees. */
char *function_cancelled(const struct function *f);

/** |D| at or below which a denominator cannot be told from 0 in the unit's precision; 0 if unknown.  Where it is, D is tested
 *  for its sign, if it has one. */
double unit_threshold(const struct unit *u, const struct denominator *d);

/** The power of |AB| that goes with a segment's threshold: the ranges are those of segments with A = (0,0,0), B =
 *  (1,0,0), callers have segments of any size.  0 if the ranges are others, or if the denominator has no power. */
int unit_degree(const struct unit *u, const struct function *f, const struct denominator *d);

#endif
