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
    const char *points, *samples, *cost; /* files, not owned; NULL if not given */
    const char *edge;                    /* not owned: a kind for edge_find; NULL: genomes */
    bool count;
    const char *explain;  /* not owned: a pass, or "" for only the counts; NULL: nothing is explained */
    bool precision_given; /* otherwise the genomes' note `precision` decides */
    size_t effort;
    uint64_t seed;
    char prefix[CODEGEN_PREFIX], command[1000]; /* the command's files are without folders */
    enum language language;
    struct unit_options unit; /* contains prefix and command; samples are read later */
};

extern const struct option_table codegen_option_table;

/** Reads the command line. Returns OPTIONS_WRONG with *d filled on errors. */
enum options_outcome codegen_options_read(int argc, char **argv, struct codegen_options *o, struct diag *d);

#endif
