/* Text of the search: nodes as a mesh has them to xi, eta and the gap.  For a genome NAME of a segment,
 *   NAME_at:  xi and eta by straight-line code, corners in the order that the scene assumes, nothing checked;
 *   NAME:     xi, eta and the signed gap (9), corners in any order, segments of any size, with a status;
 * over arrays, see header_arrays.h; and of faces that have it NAME_closest, see header_closest.h. */
#include "header_segment.h"

#include "../../base/text.h"
#include "../c_text.h"
#include "../templates.h"
#include "header_arrays.h"
#include "header_closest.h"
#include "header_float.h"
#include "header_gap.h"
#include "header_lines.h"
#include "header_sizes.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The search and NAME_at, which calls it: xi and eta, and whether the denominators are what NAME asks of them. */
static void print_at(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    char *head = new_format("%s_detail", f->name), *flaw = c_flaw(u, f, true);
    c_print("FOOTPOINT_PART REAL_BITS\n", u->options.precision, out);
    lines_print_head(u, head, "REAL zero,REAL *xi,REAL *eta", out);
    fputs("{\n", out);
    single_print_inputs(u, f, out);
    struct c_code code = c_code_of(u, f);
    bool zero = false;
    for (size_t i = 0; i < code.statements; i++)
        zero = zero || code.statement[i].zero;
    c_print_packed(&code, NULL, out);
    printer_free(c_code_clear(&code));
    c_print_unused(u, f, out);
    fputs(zero ? "" : "    (void)zero;\n", out);
    char *last = new_format("    return %s;", flaw);
    c_print_broken(last, out);
    fputs("}\n\n", out);
    free(last);
    free(flaw);
    free(head);
    head = new_format("FOOTPOINT_FN void %s_at", f->name);
    lines_print_head(u, head, "REAL *xi,REAL *eta", out);
    fprintf(out, "{\n    (void)%s_detail(%s, ", f->name, vectors);
    c_print("0.0, xi, eta);\n}\n", u->options.precision, out);
    free(head);
}

/* The search with gap and status, for NAME and its loop; `full` as in the template "again". */
static void print_search(const struct unit *u, const struct function *f, FILE *out)
{
    const enum precision precision = u->options.precision;
    const char *real = lines_real(u), *kind = u->file->segment->name;
    char *name = new_format("%s_detail_checked", f->name), *vectors = lines_rows(u, "x");
    char *least = sizes_least_name(u),
         *full = new_format("footpoint_detail_%s_gap(x, *xi, *eta, %s, gap)", kind, least);
    c_print("\nFOOTPOINT_PART REAL_BITS\n", precision, out);
    fprintf(out, "%s(const %s *const *x, int full, %s zero, %s *xi, %s *eta, %s *gap)\n{\n", name, real, real, real,
            real, real);
    if (u->file->order != CORNERS_ANY)
        fprintf(out, "    const %s *const xS = x[4];\n    %s u, v;\n", real, real);
    lines_print_search(u, f, vectors, "xi, eta", "    ", out);
    if (gap_shares(u, f)) {
        c_print("    if (full)\n        flaw |= ", precision, out);
        c_print(full, precision, out);
        fprintf(out, ";\n    {\n        ");
        c_print("const REAL_BITS doubt = ", precision, out);
        fprintf(out, "%s_detail_gap(%s, *xi, *eta, gap);\n", f->name, vectors);
        c_print("        return flaw | (full ? footpoint_detail_infinite(*gap) : doubt);\n    }\n}\n", precision, out);
    } else {
        c_print("    (void)full;\n    return flaw | ", precision, out);
        c_print(full, precision, out);
        fputs(";\n}\n", out);
    }
    free(full);
    free(least);
    free(vectors);
    free(name);
}

static void print_checked(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    const size_t n = segment_vectors(u->file->segment) + 1;
    char *head = new_format("FOOTPOINT_FN int %s", f->name);
    print_search(u, f, out);
    fputc('\n', out);
    lines_print_head(u, head, "REAL loc[2],REAL *gap", out);
    fprintf(out, "{\n    const %s *const x[%zu] = {%s};\n    %s xi, eta, g;\n", lines_real(u), n, vectors,
            lines_real(u));
    fprintf(out, "    if (%s_detail_checked(x, ", f->name);
    c_print("0, 0.0, &xi, &eta, &g) >> REAL_TOP)\n        return footpoint_detail_again(", u->options.precision, out);
    fprintf(out, "%s_detail_checked, x, %zu, %zu, loc, gap);\n", f->name, lines_scaled_nodes(u, f), n);
    fputs("    loc[0] = xi;\n    loc[1] = eta;\n    *gap = g;\n    return FOOTPOINT_OK;\n}\n", out);
    free(head);
}

/* What NAME_sure vouches for at the finest: nearer, rounding errors of its check leave it unsure too often. */
#define SURE_FINEST 1e-4

/* NAME_sure: NAME, and whether its answer is as good as the banner says. */
static void print_sure(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    char *head = new_format("FOOTPOINT_FN int %s_sure", f->name), *worst = single_worst_name(f);
    fprintf(out,
            "\n/* As %s, but FOOTPOINT_ERR_DOMAIN unless it is sure that a foot point is as near to the answer as the\n"
            " * largest error of xi and eta on the samples held out, %g at least, and that no point of the segment is "
            "nearer\n"
            " * to S. */\n"
            "#define %s %.3ef\n",
            f->name, SURE_FINEST, worst, fmax(f->measured->worst, SURE_FINEST));
    lines_print_head(u, head, "REAL loc[2],REAL *gap", out);
    single_print_sure(f, vectors, out);
    free(worst);
    free(head);
}

void search_print_contract(const struct unit *u, FILE *out)
{
    lines_print_templates(u, NULL, NULL, (const char *const[]){"contract", NULL}, out);
    if (closest_exists(u))
        closest_print_contract(u, out);
}

void search_print(const struct unit *u, const struct function *f, FILE *out)
{
    char *vectors = lines_vectors(u);
    print_at(u, f, vectors, out);
    if (gap_shares(u, f))
        gap_print(u, f, out);
    print_checked(u, f, vectors, out);
    if (single_checks(u) && isfinite(f->measured->worst))
        print_sure(u, f, vectors, out);
    arrays_print(u, f, out);
    if (closest_exists(u))
        closest_print(u, f, out);
    free(vectors);
}
