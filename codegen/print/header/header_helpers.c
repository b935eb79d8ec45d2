/* Helpers of checked searches; see header_helpers.h. */
#include "header_helpers.h"

#include "../../base/text.h"
#include "../header_sizes.h"
#include "../templates.h"
#include "header_arrays.h"
#include "header_closest.h"
#include "header_lines.h"
#include "header_promise.h"

#include <stdlib.h>
#include <string.h>

/* Prints the geometry of a kind. */
static void print_kind(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    const struct segment_kind *k = u->file->segment;
    if (!*k->normals)
        templates_print("FOOTPOINT_DETAIL_PRODUCTS", (const char *const[]){"products", NULL}, precision, NULL, out);
    if (!k->bilinear && !*k->normals)
        templates_print("FOOTPOINT_DETAIL_WEIGHTED", (const char *const[]){"weighted", NULL}, precision, NULL, out);
    if (lines_straight(u))
        templates_print("FOOTPOINT_DETAIL_HEIGHT", (const char *const[]){"height", NULL}, precision, NULL, out);
    lines_print_templates(u, "SEARCH",
                          k->bilinear         ? (const char *const[]){k->name, NULL}
                          : lines_straight(u) ? (const char *const[]){k->name, "tri3_over", "gap", NULL}
                                              : (const char *const[]){k->name, "gap", NULL},
                          out);
}

/* Prints the polynomials of patches for single calls. */
static void print_net(const struct unit *u, FILE *out)
{
    struct words w = {NULL, 0, 0};
    templates_print("FOOTPOINT_DETAIL_VECTORS", (const char *const[]){"patch_three", NULL}, PRECISION_DOUBLE, NULL,
                    out);
    words_add_net(&w, "net", "footpoint_detail_pack", "4", "FOOTPOINT_DETAIL_THREE", "footpoint_detail_");
    templates_print("FOOTPOINT_DETAIL_NET", (const char *const[]){"patch_sizes", "patch_net", NULL}, PRECISION_DOUBLE,
                    w.word, out);
    if (!strcmp(u->file->segment->name, "gregory"))
        templates_print("FOOTPOINT_DETAIL_CORNERS_BESIDE", (const char *const[]){"patch_corners", NULL},
                        PRECISION_DOUBLE, NULL, out);
    words_clear(&w);
}

/* Prints proofs, and the answers if the quick way fails. */
static void print_answers(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    const bool bilinear = u->file->segment->bilinear;
    const enum promise_kind promise = promise_kind_of(u);
    const bool curved = promise == PROMISE_CURVED, patch = promise == PROMISE_PATCH;
    const bool single = precision == PRECISION_FLOAT;
    const char *const step = single ? "quad4_vector_step" : "quad4_step";
    char *terms = new_format("patch_%s", u->file->segment->name);
    char *errors = new_format("single_%s", u->file->segment->name);
    if (patch)
        templates_print("FOOTPOINT_DETAIL_PRODUCTS", (const char *const[]){"products", NULL}, precision, NULL, out);
    if (bilinear || curved || patch || promise == PROMISE_LINEAR)
        templates_print("FOOTPOINT_DETAIL_BOUNDS", (const char *const[]){"bounds", NULL}, precision, NULL, out);
    if (curved || patch)
        templates_print("FOOTPOINT_DETAIL_LOCAL", (const char *const[]){"curved_local", NULL}, precision, NULL, out);
    if (curved && single)
        templates_print("FOOTPOINT_DETAIL_NORM", (const char *const[]){"norm", NULL}, precision, NULL, out);
    if (patch)
        print_net(u, out);
    if (curved)
        promise_print_terms(u, precision, out);
    lines_print_templates(
        u, "ANSWER",
        curved && single
            ? (const char *const[]){errors, "curved_single", "curved_proof", "curved_repair", "answer_proved", NULL}
        : curved   ? (const char *const[]){"curved_step", "curved_proof", "curved_repair", "answer_proved", NULL}
        : patch    ? (const char *const[]){terms, "patch_expand", "patch_newton", "patch_proof", "patch_repair", NULL}
        : bilinear ? (const char *const[]){"quad4_proof", step, "quad4_steps", "quad4_repair", "answer_proved", NULL}
        : promise == PROMISE_LINEAR ? (const char *const[]){"tri3_answer", NULL}
                                    : (const char *const[]){"answer", NULL},
        out);
    if (promise == PROMISE_BOX)
        lines_print_kind(u, promise_answers(u), "ANSWER", (const char *const[]){"quad4_box", "answer_proved", NULL},
                         out);
    if (promise_follows(u))
        lines_print_templates(u, "FROM",
                              patch ? (const char *const[]){"patch_from", NULL}
                                    : (const char *const[]){curved ? "curved_from" : "quad4_from", "from", NULL},
                              out);
    free(errors);
    free(terms);
}

void helpers_print(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    templates_print("FOOTPOINT_DETAIL_SCALE", (const char *const[]){"scale", NULL}, precision, NULL, out);
    print_kind(u, out);
    templates_print("FOOTPOINT_DETAIL_AGAIN", (const char *const[]){"again", NULL}, precision, NULL, out);
    print_answers(u, out);
    arrays_print_helpers(u, out);
    if (u->file->order != CORNERS_ANY)
        templates_print("FOOTPOINT_DETAIL_CORNERS", (const char *const[]){"corners", NULL}, precision, NULL, out);
    if (closest_exists(u))
        closest_print_helpers(u, out);
    sizes_print_least(u, out);
}
