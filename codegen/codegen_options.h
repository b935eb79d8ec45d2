/* The command line of footpoint-codegen. */
#ifndef FOOTPOINT_CODEGEN_OPTIONS_H
#define FOOTPOINT_CODEGEN_OPTIONS_H

#include "compile/compiled_file.h"

enum language { LANGUAGE_C, LANGUAGE_FORTRAN, LANGUAGE_INFIX, LANGUAGE_LATEX };

struct codegen_options {
    const char *genomes, *output;    /* files, not owned; output NULL: --count */
    const char *samples, *cost;      /* files, not owned; NULL: none */
    bool precision_given;            /* else the genomes' note `precision` counts */
    char prefix[160], command[1000]; /* the latter without folders */
    enum language language;
    struct unit_options unit; /* its prefix and command are those above; samples are yet to be read */
};

/** Reads the command line.  True to go on; else *status is the exit code: help was printed, or what is wrong was. */
bool codegen_options_read(int argc, char **argv, struct codegen_options *o, int *status);

#endif
