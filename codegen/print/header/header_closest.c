/* Prints closest points of closed segments; see header_closest.h. The quick way takes a foot point inside or the nearest
 * point of an edge, with a proof for the whole segment. If it proves nothing, descents and parts of the segment follow;
 * over arrays in a second loop. */
#include "header_closest.h"

#include "../../base/text.h"
#include "../templates.h"
#include "header_lines.h"
#include "header_promise.h"

#include <stdlib.h>

bool closest_exists(const struct unit *u)
{
    return u->file->order == CORNERS_ANY && promise_kind_of(u) != PROMISE_NONE;
}

/* Prints a template that several kinds share. */
static void print_shared(const struct unit *u, const char *guard, const char *name, FILE *out)
{
    templates_print(guard, (const char *const[]){name, NULL}, u->options.precision, NULL, out);
}

/* Prints functions that find and prove the nearest point. */
static void print_proved(const struct unit *u, FILE *out)
{
    const bool single = u->options.precision == PRECISION_FLOAT;
    const char *const bilinear[] = {"inward",
                                    "fan",
                                    "closest_surface",
                                    "quad4_sole",
                                    single ? "quad4_vector_here" : "quad4_here",
                                    "quad4_close",
                                    "quad4_repair_closest",
                                    single ? "closest_alone" : "closest_blocks",
                                    "proved_closest_arrays",
                                    NULL};
    const char *const curved[] = {"inward",
                                  "fan",
                                  "closest_surface",
                                  "curved_anchor",
                                  single ? "single_slopes" : "curved_slopes",
                                  "curved_at",
                                  "curved_grows",
                                  "curved_form",
                                  "curved_sole",
                                  "curved_within",
                                  "curved_ball",
                                  "curved_whole",
                                  "curved_close",
                                  "curved_split",
                                  "curved_seek",
                                  "closest_alone",
                                  "proved_closest_arrays",
                                  NULL};
    static const char *const linear[] = {"inward",    "fan",           "closest_surface",       "tri3_nearest",
                                         "tri3_sure", "closest_alone", "proved_closest_arrays", NULL};
    char *bends = new_format("bends_%s", u->file->segment->name);
    const char *const patch[] = {
        "inward",       "fan",         "closest_surface", bends,           "patch_anchor",          "curved_grows",
        "patch_form",   "curved_sole", "patch_ball",      "curved_whole",  "curved_within",         "patch_needed",
        "curved_split", "curved_seek", "patch_close",     "closest_alone", "proved_closest_arrays", NULL};
    const enum promise_kind kind = promise_kind_of(u);
    if (kind == PROMISE_LINEAR)
        print_shared(u, "FOOTPOINT_DETAIL_EDGE", "edge", out);
    if (kind == PROMISE_CURVED)
        print_shared(u, "FOOTPOINT_DETAIL_CURVE", "curve", out);
    if (kind == PROMISE_CURVED || kind == PROMISE_PATCH)
        print_shared(u, "FOOTPOINT_DETAIL_LIMITS", "curved_limits", out);
    if (kind == PROMISE_PATCH)
        print_shared(u, "FOOTPOINT_DETAIL_PATCH_BENDS", "patch_bends", out);
    lines_print_templates(u, "NEAREST",
                          kind == PROMISE_CURVED   ? curved
                          : kind == PROMISE_PATCH  ? patch
                          : kind == PROMISE_LINEAR ? linear
                                                   : bilinear,
                          out);
    free(bends);
}

void closest_print_helpers(const struct unit *u, FILE *out)
{
    templates_print("FOOTPOINT_DETAIL_CLOSEST", (const char *const[]){"side", "corner", "lesser", "closest", NULL},
                    u->options.precision, NULL, out);
    if (u->file->segment->bilinear)
        lines_print_templates(u, "SURFACE", (const char *const[]){"quad4_surface", NULL}, out);
    print_proved(u, out);
}

void closest_print_contract(const struct unit *u, FILE *out)
{
    const char *name = promise_kind_of(u) == PROMISE_LINEAR ? "contract_closest_linear" : "contract_closest_promise";
    lines_print_templates(u, NULL, (const char *const[]){name, NULL}, out);
}

void closest_print(const struct unit *u, const struct function *f, FILE *out)
{
    static const char *const curved[] = {"curved_nearby", "proved_closest_calls", NULL};
    static const char *const linear[] = {"tri3_nearby", "proved_closest_calls", NULL};
    static const char *const patch[] = {"patch_nearby", "proved_closest_calls", NULL};
    const enum promise_kind kind = promise_kind_of(u);
    struct words w = promise_words(u, f);
    const bool single = u->options.precision == PRECISION_FLOAT;
    const char *const nearby = single ? "quad4_vector_nearby" : "quad4_nearby";
    const char *const bilinear[] = {nearby, "proved_closest_calls", single ? NULL : "quad4_closest_from", NULL};
    words_add(&w, "SCALED_ROWS", lines_rows(u, "y"));
    templates_print(NULL,
                    kind == PROMISE_BILINEAR ? bilinear
                    : kind == PROMISE_CURVED ? curved
                    : kind == PROMISE_PATCH  ? patch
                                             : linear,
                    u->options.precision, w.word, out);
    words_clear(&w);
}
