/* Prints the search: from nodes, numbered as in the mesh, to xi, eta and the gap. A genome NAME of a segment becomes
 *   NAME_at: xi and eta by straight-line code, of patches also with steps, corners in the order that the scene assumes,
 *            unchecked;
 *   NAME: xi, eta and the signed gap (9), corners in any order, segments of any size, with a status.
 *
 * header_arrays.h prints searches over arrays and from the last answer, header_closest.h NAME_closest. */
#include "header_segment.h"

#include "../../base/text.h"
#include "../c_text.h"
#include "../templates.h"
#include "header_arrays.h"
#include "header_closest.h"
#include "header_float.h"
#include "header_gap.h"
#include "header_lanes.h"
#include "header_lines.h"
#include "header_promise.h"
#include "header_vectors.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 117 };

/* Returns the statements of NAME_detail, which set xi and eta. */
static char *statements_text(const struct unit *u, const struct function *f)
{
    struct memory *m = memory_open();
    struct c_code code = c_code_of(u, f);
    bool zero = false;
    for (size_t i = 0; i < code.statements; i++)
        zero = zero || code.statement[i].zero;
    single_print_inputs(u, f, m->stream);
    c_print_packed(&code, NULL, m->stream);
    c_print_unused(u, f, m->stream);
    fputs(zero ? "" : "    (void)zero;\n", m->stream);
    printer_free(c_code_clear(&code));
    return memory_close(m);
}

/* Returns the tests of its denominators. */
static char *denominators_text(const struct unit *u, const struct function *f)
{
    char *flaw = c_flaw(u, f, true), *whole = new_format("%s;", flaw);
    struct memory *m = memory_open();
    print_broken(whole, strlen("    return "), WIDTH, "\n        ", NULL, m->stream);
    free(whole);
    free(flaw);
    char *text = memory_close(m);
    text[strlen(text) - 1] = '\0';
    return text;
}

/* Returns the template that puts corners into the order that the scene assumes; NULL: any order. */
static const char *ordering(const struct unit *u)
{
    return u->file->order == CORNERS_ANY ? NULL : u->file->order == CORNERS_NEAREST ? "nearest" : "nearest_shorter";
}

static char *call_text(const struct unit *u, const struct function *of)
{
    const struct function *f = promise_start(u, of);
    if (ordering(u))
        return new_format("%s_detail_%s(x, zero, xi, eta)", f->name, ordering(u));
    char *vectors = lines_rows(u, "x"), *call = new_format("%s_detail(%s, zero, xi, eta)", f->name, vectors);
    free(vectors);
    return call;
}

/* Prints NAME_sure, a deprecated name that callers use. */
static void print_sure(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    char *head = new_format("FOOTPOINT_FN int %s_sure", f->name);
    fputs("\n/* Deprecated: the same as NAME, whose FOOTPOINT_OK is proved. */\n", out);
    lines_print_head(u, head, "REAL loc[2],REAL *gap", out);
    fprintf(out, "{\n    return %s(%s, loc, gap);\n}\n", f->name, vectors);
    free(head);
}

void search_print_contract(const struct unit *u, FILE *out)
{
    lines_print_templates(u, NULL, (const char *const[]){"contract", NULL}, out);
    if (promise_kind_of(u) == PROMISE_PATCH)
        lines_print_templates(u, NULL, (const char *const[]){"contract_patch", NULL}, out);
    else if (promise_kind_of(u) == PROMISE_BOX)
        lines_print_templates(u, NULL, (const char *const[]){"contract_box", NULL}, out);
    else if (promise_kind_of(u) != PROMISE_NONE)
        lines_print_templates(u, NULL, (const char *const[]){"contract_promise", NULL}, out);
    if (promise_follows(u))
        lines_print_templates(u, NULL, (const char *const[]){"contract_from", NULL}, out);
    if (closest_exists(u))
        closest_print_contract(u, out);
}

/* Prints the search by straight-line code. Takes ownership of the text of the denominators' tests. */
static void print_straight(const struct unit *u, const struct function *f, char *denominators, FILE *out)
{
    struct words w = lines_words(u, f, f);
    words_add(&w, "STATEMENTS", statements_text(u, f));
    words_add(&w, "DENOMINATORS", denominators);
    fputc('\n', out);
    templates_print_blocks("straight", u->options.precision, w.word, NULL, out);
    words_clear(&w);
}

/* Prints the start of loops over arrays of patches, in both precisions. Proofs follow, so nothing is tested. */
static void print_begin(const struct unit *u, const struct function *f, FILE *out)
{
    struct unit single = *u;
    struct function named = lanes_single(f);
    single.options.precision = PRECISION_FLOAT;
    print_straight(&single, &named, new_format("0"), out);
    lanes_print_begin(u, &named, true, out);
    lanes_print_begin(u, f, false, out);
    free(named.name);
}

void search_print_bare(const struct unit *u, const struct function *f, FILE *out)
{
    print_straight(u, f, denominators_text(u, f), out);
    if (promise_kind_of(u) == PROMISE_PATCH && promise_starts(u, f))
        print_begin(u, f, out);
    promise_print(u, f, out);
}

void search_print(const struct unit *u, const struct function *f, FILE *out)
{
    const enum promise_kind promise = promise_kind_of(u);
    const bool steps = promise == PROMISE_BILINEAR || promise == PROMISE_CURVED || promise == PROMISE_PATCH,
               shares = !steps && vectors_shared(u, f);
    const struct block blocks[] = {{"PROMISE", promise == PROMISE_BILINEAR, NULL},
                                   {"CURVED", promise == PROMISE_CURVED, NULL},
                                   {"PATCH", promise == PROMISE_PATCH, NULL},
                                   {"EXACT_PROMISE", promise == PROMISE_LINEAR || promise == PROMISE_BOX, NULL},
                                   {"WALK", promise_walks(u, f), NULL},
                                   {"SHARED_GAP", shares, NULL},
                                   {"OWN_GAP", !steps && !shares, NULL},
                                   {NULL, 0, NULL}};
    char *vectors = lines_vectors(u);
    struct words w = promise_words(u, f);
    words_add(&w, "SEARCH_CALL", call_text(u, f));
    promise_define(u, f, out);
    templates_print_blocks("at", u->options.precision, w.word, blocks, out);
    if (shares)
        gap_print(u, f, out);
    templates_print(NULL, (const char *const[]){ordering(u), NULL}, u->options.precision, w.word, out);
    fputc('\n', out);
    templates_print_blocks("checked", u->options.precision, w.word, blocks, out);
    words_clear(&w);
    if (promise == PROMISE_BILINEAR && u->options.samples)
        print_sure(u, f, vectors, out);
    arrays_print(u, f, out);
    if (closest_exists(u))
        closest_print(u, f, out);
    free(vectors);
}
