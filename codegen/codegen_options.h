/* The command line of footpoint-codegen. */
#ifndef FOOTPOINT_CODEGEN_OPTIONS_H
#define FOOTPOINT_CODEGEN_OPTIONS_H

#include "base/options.h"
#include "compile/compiled_file.h"

#include <stdint.h>

enum { CODEGEN_PREFIX = 160 };
enum language { LANGUAGE_C, LANGUAGE_GENERIC, LANGUAGE_FORTRAN, LANGUAGE_INFIX, LANGUAGE_LATEX };

struct codegen_options {
    const char *genomes, *output;        /* files, not owned; output NULL: --count */
    const char *points, *samples, *cost; /* files, not owned; NULL: none */
    const char *edge;                    /* not owned: a kind of edge_find; NULL: genomes */
    bool count;
    const char *explain;  /* not owned: a pass, "" for the counts alone; NULL: not asked for */
    bool precision_given; /* else the genomes' note `precision` counts */
    size_t effort;
    uint64_t seed;
    char prefix[CODEGEN_PREFIX], command[1000]; /* the latter without folders */
    enum language language;
    struct unit_options unit; /* its prefix and command are those above; samples are yet to be read */
};

extern const struct option_table codegen_option_table;

/** Reads the command line; OPTIONS_WRONG with *d filled. */
enum options_outcome codegen_options_read(int argc, char **argv, struct codegen_options *o, struct diag *d);

#endif
