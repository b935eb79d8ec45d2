/* The gap out of the search's own values; see header_gap.h.
 *
 * With r = c0 + xi c1 + eta c2 + xi eta c3 and d = xS - c0 the tangents are u = c1 + eta c3 and v = c2 + xi c3, and as
 * n = u x v is at right angles to both,
 *     (xS - r) . n = (d + xi eta c3) . n,
 * so that the gap takes c1, c2, c3, d and no more; of a flat triangle c3 = 0.  Every search has most of them, each times
 * a number of its own, and the squares of c1, c2, c3.  They are found by exact values at two points. */
#include "header_gap.h"

#include "../../base/text.h"
#include "../../program/dialects.h"
#include "../c_text.h"
#include "../templates.h"
#include "header_lines.h"
#include "header_sizes.h"
#include "header_vectors.h"

#include <stdlib.h>
#include <string.h>

static void print_body(const struct unit *u, const struct function *f, const struct vectors_found *w, FILE *out)
{
    const char *kind = u->file->segment->name;
    const bool twisted = u->file->segment->bilinear;
    struct printer *r = c_print_needed(u, f, w->needed, out);
    struct memory *m = memory_open();
    vectors_print(w, r, m->stream);
    char *size = vectors_size(w, r), *least = sizes_least_name(u),
         *ratio = new_format("ratio = %.17g, ", w->factor[1] / w->factor[0]);
    fprintf(m->stream, "    const REAL size = %s;\n    const REAL %sper = %.17g, unit = %.17g;\n", size,
            twisted ? ratio : "", 1.0 / w->factor[1], (twisted ? 4.0 : 1.0) / (w->factor[0] * w->factor[0]));
    fprintf(m->stream, "    return footpoint_detail_%s_over(a, b, %sd, size, %sper, unit, xi, eta, %s, gap);\n", kind,
            twisted ? "c, " : "", twisted ? "ratio, " : "", least);
    char *text = memory_close(m);
    c_print(text, u->options.precision, out);
    free(text);
    free(ratio);
    free(least);
    free(size);
    printer_free(r);
}

void gap_print(const struct unit *u, const struct function *f, FILE *out)
{
    struct vectors_found w;
    vectors_find(&w, u, f);
    char *head = new_format("%s_detail_gap", f->name);
    c_print("\nFOOTPOINT_PART REAL_BITS\n", u->options.precision, out);
    lines_print_head(u, head, "REAL xi,REAL eta,REAL *gap", out);
    fputs("{\n", out);
    print_body(u, f, &w, out);
    fputs("}\n", out);
    free(head);
    vectors_clear(&w);
}
