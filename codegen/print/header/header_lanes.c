/* Loops over arrays of patches; see header_lanes.h.  One set of templates serves both precisions.  Edges and normals are rounded to
 * single precision once, and lanes are twice as wide; promises below ROUGH need double. */
#include "header_lanes.h"

#include "../../base/text.h"
#include "../templates.h"
#include "header_promise.h"

#include <stdlib.h>

/* Promises below this need double. */
#define ROUGH 0.99e-3

static bool is_single(const struct unit *u, const struct function *f)
{
    return promise_of(u, f) > ROUGH;
}

/* Returns the words of a precision. */
static struct words lanes_words(const struct unit *u, bool single)
{
    const char *const kind = u->file->segment->name, *const f = single ? "f_" : "";
    struct words w = {NULL, 0, 0};
    words_add(&w, "KIND", new_format("%s_lanes", kind));
    words_add(&w, "ALONE_SEARCH", new_format("footpoint_detail_search"));
    words_add(&w, "ALONE_ANSWER", new_format("footpoint_detail_%s_answer", kind));
    words_add(&w, "ALONE_FURTHER", new_format("footpoint_detail_%s_further", kind));
    words_add(&w, "LANE", new_format(single ? "float" : "double"));
    words_add(&w, "LANE_BITS", new_format(single ? "unsigned int" : "unsigned long long"));
    words_add(&w, "BLOCK", new_format("footpoint_detail_%sblock", f));
    words_add(&w, "NARROW", new_format("footpoint_detail_%snarrow", f));
    words_add(&w, "VECTOR_ROWS", lines_rows(u, "x"));
    words_add_net(&w, "lane_net", single ? "float" : "double", "3", "3", NULL);
    return w;
}

static void print_precision(const struct unit *u, bool single, FILE *out)
{
    static const char *const common[][2] = {
        {"BITS", "bits"}, {"PRODUCTS", "products"}, {"BOUNDS", "bounds"}, {"LOCAL", "curved_local"}};
    const enum precision precision = single ? PRECISION_FLOAT : PRECISION_DOUBLE;
    struct words w = lanes_words(u, single);
    char *guard = new_format("FOOTPOINT_DETAIL_%sBLOCK", single ? "F_" : ""),
         *terms = new_format("lanes_%s", u->file->segment->name);
    char *lanes = new_format("FOOTPOINT_%s_LANES", u->file->segment->name);
    for (size_t i = 0; single && i < sizeof common / sizeof *common; i++) {
        char *other = new_format("FOOTPOINT_DETAIL_%s", common[i][0]);
        templates_print(other, (const char *const[]){common[i][1], NULL}, precision, NULL, out);
        free(other);
    }
    templates_print("FOOTPOINT_DETAIL_LANE_NET", (const char *const[]){"lanes_sizes", "patch_net", NULL}, precision,
                    w.word, out);
    templates_print(guard, (const char *const[]){"patch_block", NULL}, PRECISION_DOUBLE, w.word, out);
    templates_print(lanes, (const char *const[]){terms, "patch_newton", "patch_lane", "patch_lanes", NULL}, precision,
                    w.word, out);
    words_clear(&w);
    free(lanes);
    free(terms);
    free(guard);
}

void lanes_print_helpers(const struct unit *u, FILE *out)
{
    templates_print("FOOTPOINT_DETAIL_POWERS", (const char *const[]){"patch_powers", NULL}, PRECISION_DOUBLE, NULL,
                    out);
    print_precision(u, true, out);
    print_precision(u, false, out);
}

struct function lanes_single(const struct function *f)
{
    struct function named = *f;
    named.name = new_format("%s_single", f->name);
    return named;
}

void lanes_print_begin(const struct unit *u, const struct function *f, bool single, FILE *out)
{
    struct words w = lanes_words(u, single);
    words_add(&w, "NAME", new_format("%s", f->name));
    templates_print(NULL, (const char *const[]){"patch_begin", NULL}, PRECISION_DOUBLE, w.word, out);
    words_clear(&w);
}

void lanes_print_calls(const struct unit *u, const struct function *f, FILE *out)
{
    const bool single = is_single(u, f);
    struct words w = promise_words(u, f);
    words_add(&w, "RUN", new_format("footpoint_detail_%s%s_lanes_run", single ? "f_" : "", u->file->segment->name));
    words_add(&w, "BEGIN", new_format(single ? "single_begin" : "begin"));
    templates_print(NULL, (const char *const[]){"patch_calls", "patch_from_calls", NULL}, u->options.precision, w.word,
                    out);
    words_clear(&w);
}
