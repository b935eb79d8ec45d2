/* Reads genomes and programs from text in tests; a mistake in it fails the test. */
#ifndef FOOTPOINT_GENOME_TEXT_H
#define FOOTPOINT_GENOME_TEXT_H

#include "../../codegen/program/program.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static inline struct genome_file *parse(const char *text)
{
    struct diag d = {0};
    struct genome_file *f = genome_parse("test", text, strlen(text), &d);
    if (!f)
        fail_msg("%s", d.text);
    return f;
}

/* Reads the statements of genome k. */
static inline struct program *read_program(const struct genome_file *f, size_t k, const char *text)
{
    struct diag d = {0};
    struct program *p = program_read(f, &f->genome[k], text, &d);
    if (!p)
        fail_msg("%s", d.text);
    return p;
}

#endif
