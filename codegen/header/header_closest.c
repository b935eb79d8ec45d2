/* Closest points of closed segments; see header_closest.h.
 *
 * The closest point is a foot point inside, or it is the nearest point of an edge.  The latter is right to rounding; so
 * the nearer of the search's point, where that is inside, and of those of all edges is as good as the search, and where
 * the search has left the segment it is not asked any further.  No branch depends on the data but for nodes in need of
 * another unit of length, so that loops over arrays vectorise: theirs are done once more in a second loop. */
#include "header_closest.h"

#include "../genome/text.h"
#include "../print/c_text.h"
#include "../print/templates.h"
#include "header_lines.h"
#include "header_sizes.h"

#include <stdlib.h>
#include <string.h>

bool closest_exists(const struct unit *u)
{
    const struct segment_kind *k = u->file->segment;
    return u->file->order == CORNERS_ANY && (k->bilinear || strcmp(k->name, "tri3") == 0);
}

void closest_print_helpers(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    const struct segment_kind *k = u->file->segment;
    const size_t n = segment_vectors(k) + 1;
    char *guard = new_format("FOOTPOINT_%s_NEAREST", k->name), *nearest = new_format("%s_nearest", k->name);
    char *count = new_format("%zu", n), *column = lines_columns(u), *row = lines_rows(u, "p");
    const struct placeholder own[] = {
        {"KIND", k->name}, {"VECTORS", count}, {"COLUMNS", column}, {"ROWS", row}, {NULL, NULL}};
    templates_print("FOOTPOINT_DETAIL_CLOSEST", (const char *const[]){"closest", NULL}, precision, NULL, out);
    templates_print(guard, (const char *const[]){nearest, "closest_rest", NULL}, precision, own, out);
    free(row);
    free(column);
    free(count);
    free(nearest);
    free(guard);
}

void closest_print_contract(const struct unit *u, FILE *out)
{
    const bool bilinear = u->file->segment->bilinear;
    const struct placeholder own[] = {{"EDGES", bilinear ? "1 to 4 edge AB, BC, CD, DA, 5 to 8 corner A, B, C, D"
                                                         : "1 to 3 edge AB, BC, CA, 4 to 6 corner A, B, C"},
                                      {"NORMAL", bilinear ? "AC x BD" : "AB x AC"},
                                      {NULL, NULL}};
    templates_print(NULL, (const char *const[]){"contract_closest", NULL}, u->options.precision, own, out);
}

/* The search and what is nearest. */
static void print_nearest(const struct unit *u, const struct function *f, const char *name, FILE *out)
{
    const enum precision precision = u->options.precision;
    char *vectors = lines_rows(u, "x"), *least = sizes_least_name(u);
    char *nearest = new_format("    return footpoint_detail_%s_nearest(x, flaw, ", u->file->segment->name);
    fprintf(out, "\nFOOTPOINT_PART int %s(const %s *const *x, %s at[3],\n%*sint *region)\n{\n", name, lines_real(u),
            lines_real(u), (int)strlen(name) + 20, "");
    fprintf(out, "    %s xi, eta;\n", lines_real(u));
    lines_print_search(u, f, vectors, "&xi, &eta", "    ", out);
    c_print(nearest, precision, out);
    fprintf(out, "%s, xi, eta, at, region);\n}\n", least);
    free(nearest);
    free(least);
    free(vectors);
}

static void print_checked(const struct unit *u, const struct function *f, const char *name, const char *vectors,
                          FILE *out)
{
    char *head = new_format("FOOTPOINT_FN int %s_closest", f->name);
    fputc('\n', out);
    lines_print_head(u, head, "REAL loc[2],REAL *dist,int *region", out);
    fprintf(out, "{\n    const %s *const x[%zu] = {%s};\n", lines_real(u), segment_vectors(u->file->segment) + 1,
            vectors);
    c_print("    return footpoint_detail_closest(", u->options.precision, out);
    fprintf(out, "%s,\n                                    x, %zu, %zu, loc, dist, region);\n}\n", name,
            lines_scaled_nodes(u, f), segment_vectors(u->file->segment) + 1);
    free(head);
}

/* The loop stands here, as compilers forget what FOOTPOINT_RESTRICT says in functions that they inline. */
static void print_loop(const struct unit *u, const struct function *f, const char *name, FILE *out)
{
    const char *real = lines_real(u);
    const size_t n = segment_vectors(u->file->segment) + 1;
    char *column = lines_columns(u), *row = lines_rows(u, "p");
    char *rest = new_format("    footpoint_detail_%s_closest_rest(", u->file->segment->name);
    fputc('\n', out);
    const int begin = fprintf(out, "FOOTPOINT_LOOP void %s_closest_n(", f->name);
    fprintf(out,
            "size_t n, const %s *const x[%zu],\n%*s%s *FOOTPOINT_RESTRICT xi, %s *FOOTPOINT_RESTRICT eta,\n"
            "%*s%s *FOOTPOINT_RESTRICT dist, int *FOOTPOINT_RESTRICT region,\n%*sint *FOOTPOINT_RESTRICT status)\n",
            real, 3 * n, begin, "", real, real, begin, "", real, begin, "");
    fprintf(out,
            "{\n    size_t i;\n    FOOTPOINT_EACH\n    for (i = 0; i < n; i++) {\n        const %s p[%zu][3] = {%s};\n"
            "        const %s *const row[%zu] = {%s};\n        %s at[3];\n"
            "        status[i] = %s(row, at, &region[i]);\n"
            "        xi[i] = at[0];\n        eta[i] = at[1];\n        dist[i] = at[2];\n    }\n",
            real, n, column, real, n, row, real, name);
    c_print(rest, u->options.precision, out);
    fprintf(out, "%s, n, x, %zu,\n        xi, eta, dist, region, status);\n}\n", name, lines_scaled_nodes(u, f));
    free(rest);
    free(row);
    free(column);
}

void closest_print(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    char *name = new_format("footpoint_detail_closest_%s", f->name);
    print_nearest(u, f, name, out);
    print_checked(u, f, name, vectors, out);
    print_loop(u, f, name, out);
    free(name);
}
