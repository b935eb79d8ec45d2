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

void arrays_print_helpers(const struct unit *u, FILE *out)
{
    const bool patch = promise_kind_of(u) == PROMISE_PATCH;
    lines_print_kind(u, promise_answers(u), "ARRAYS",
                     patch ? (const char *const[]){"arrays", NULL}
                           : (const char *const[]){"arrays", "arrays_checked", "over", NULL},
                     out);
    if (patch)
        lanes_print_helpers(u, out);
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
