/* Prints the gap from the search's own values; see header_gap.h.
 *
 * With r = c0 + xi c1 + eta c2 + xi eta c3 and d = xS - c0 the tangents are u = c1 + eta c3 and v = c2 + xi c3, and as
 * n = u x v is at right angles to both,
 *     (xS - r) . n = (d + xi eta c3) . n.
 * So the gap needs only c1, c2, c3 and d; on a flat triangle c3 = 0.  Every search has most of them, each times
 * a number of its own, and the squares of c1, c2, c3.  They are found by exact values at two points. */
#include "header_gap.h"

#include "../../base/text.h"
#include "../c_text.h"
#include "../templates.h"

#include <stdlib.h>

/* Returns a text with the words of a precision; takes ownership of it. */
static char *worded(const struct unit *u, char *text)
{
    struct memory *m = memory_open();
    c_print(text, u->options.precision, m->stream);
    free(text);
    return memory_close(m);
}

/* Returns the statements of the vectors and of their operands. */
static char *statements_text(const struct unit *u, const struct function *f, const struct vectors_found *v,
                             struct printer **r)
{
    struct memory *m = memory_open();
    *r = c_print_needed(u, f, v->needed, m->stream);
    vectors_print(v, *r, m->stream);
    return worded(u, memory_close(m));
}

struct printer *gap_add_words(struct words *w, const struct unit *u, const struct function *f,
                              const struct vectors_found *v)
{
    struct printer *r;
    words_add(w, "VECTOR_STATEMENTS", statements_text(u, f, v, &r));
    words_add(w, "SIZE", worded(u, vectors_size(v, r)));
    words_add(w, "RATIO", new_format("%.17g", v->factor[1] / v->factor[0]));
    words_add(w, "PER", new_format("%.17g", 1.0 / v->factor[1]));
    words_add(w, "UNIT", new_format("%.17g", (u->file->segment->bilinear ? 4.0 : 1.0) / (v->factor[0] * v->factor[0])));
    return r;
}

void gap_print(const struct unit *u, const struct function *f, FILE *out)
{
    struct words w = lines_words(u, f, NULL);
    struct vectors_found v;
    vectors_find(&v, u, f);
    printer_free(gap_add_words(&w, u, f, &v));
    fputc('\n', out);
    templates_print_blocks(u->file->segment->bilinear ? "quad4_vectors_gap" : "tri3_vectors_gap", u->options.precision,
                           w.word, NULL, out);
    words_clear(&w);
    vectors_clear(&v);
}
