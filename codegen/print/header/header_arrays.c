/* Searches over arrays; see header_arrays.h. The loops are templates that call the search passed to them.
 * FOOTPOINT_LOOP inlines both, so they vectorise like hand-written loops. */
#include "header_arrays.h"

#include "../../base/text.h"
#include "../templates.h"
#include "header_lanes.h"
#include "header_promise.h"

#include <stdlib.h>

/* Returns true if some values depend only on the segment: if the search accepts corners in any order. */
static bool prepares(const struct unit *u)
{
    return u->file->order == CORNERS_ANY;
}

/* Returns true if loops search pairs side by side, partly in single precision. */
static bool is_side_by_side(const struct unit *u)
{
    const enum promise_kind kind = promise_kind_of(u);
    return (kind == PROMISE_BILINEAR || kind == PROMISE_CURVED) && u->options.precision == PRECISION_DOUBLE;
}

/* Prints a template of such loops. */
static void print_part(const char *kind, const char *name, enum precision precision, const struct words *w, FILE *out)
{
    char *guard = new_format("FOOTPOINT_%s_%s", kind, name);
    templates_print(guard, (const char *const[]){name, NULL}, precision, w->word, out);
    free(guard);
}

/* Prints the parts of loops that search pairs side by side. */
static void print_side_by_side(const struct unit *u, FILE *out)
{
    static const char *const common[][2] = {
        {"BITS", "bits"}, {"PRODUCTS", "products"}, {"BOUNDS", "bounds"}, {"LOCAL", "curved_local"}};
    static const char *const parts[2][4] = {{"quad4_block", "quad4_side", "quad4_pass"},
                                            {"curved_block", "curved_side", "curved_pass"}};
    const bool curved = promise_kind_of(u) == PROMISE_CURVED;
    const char *const kind = u->file->segment->name, *const *part = parts[curved];
    struct words w = lines_words(u, NULL, NULL);
    words_add(&w, "BLOCK", new_format("footpoint_detail_%s_block", kind));
    words_add(&w, "SIDE", new_format("footpoint_detail_%s_side", kind));
    words_add(&w, "LANES", new_format("f"));
    words_add(&w, "LANE", new_format("float"));
    words_add(&w, "LANE_BITS", new_format("unsigned int"));
    words_add(&w, "LANE_TOP", new_format("31"));
    for (size_t i = 0; i < 3 + (size_t)curved; i++) {
        char *guard = new_format("FOOTPOINT_DETAIL_%s", common[i][0]);
        templates_print(guard, (const char *const[]){common[i][1], NULL}, PRECISION_FLOAT, NULL, out);
        free(guard);
    }
    if (curved)
        promise_print_terms(u, PRECISION_FLOAT, out);
    print_part(kind, "side_root", PRECISION_DOUBLE, &w, out);
    print_part(kind, part[0], PRECISION_DOUBLE, &w, out);
    print_part(kind, "side_correct", PRECISION_FLOAT, &w, out);
    print_part(kind, part[1], PRECISION_FLOAT, &w, out);
    if (!curved)
        print_part(kind, "quad4_rein", PRECISION_FLOAT, &w, out);
    print_part(kind, "side_last", PRECISION_DOUBLE, &w, out);
    print_part(kind, part[2], PRECISION_DOUBLE, &w, out);
    print_part(kind, "side_run", PRECISION_DOUBLE, &w, out);
    words_clear(&w);
}

void arrays_print_helpers(const struct unit *u, FILE *out)
{
    const bool patch = promise_kind_of(u) == PROMISE_PATCH;
    lines_print_kind(u, promise_answers(u), "ARRAYS",
                     patch                ? (const char *const[]){"arrays", NULL}
                     : is_side_by_side(u) ? (const char *const[]){"arrays", NULL}
                                          : (const char *const[]){"arrays", "arrays_checked", "over", NULL},
                     out);
    if (patch)
        lanes_print_helpers(u, out);
    if (is_side_by_side(u))
        print_side_by_side(u, out);
}

void arrays_print(const struct unit *u, const struct function *f, FILE *out)
{
    const char *const calls[] = {"arrays_calls", prepares(u) ? "over_calls" : NULL, NULL};
    if (promise_kind_of(u) == PROMISE_PATCH) {
        lanes_print_calls(u, f, out);
        return;
    }
    struct words w = promise_words(u, f);
    templates_print(NULL, calls, u->options.precision, w.word, out);
    if (promise_follows(u))
        templates_print(NULL, (const char *const[]){"from_calls", NULL}, u->options.precision, w.word, out);
    words_clear(&w);
}
