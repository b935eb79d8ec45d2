/* Helpers of checked searches; see header_helpers.h. */
#include "header_helpers.h"

#include "../genome/text.h"
#include "../print/templates.h"
#include "header_closest.h"
#include "header_lines.h"
#include "header_sizes.h"

#include <stdlib.h>
#include <string.h>

/* The geometry of a kind. */
static void print_kind(const struct segment_kind *k, enum precision precision, FILE *out)
{
    char *guard = new_format("FOOTPOINT_%s_SEARCH", k->name), *nodes = new_format("%zu", strlen(k->nodes));
    const struct placeholder own[] = {{"KIND", k->name}, {"NODES", nodes}, {NULL, NULL}};
    if (!k->bilinear && !*k->normals)
        templates_print("FOOTPOINT_DETAIL_WEIGHTED", (const char *const[]){"weighted", NULL}, precision, NULL, out);
    if (k->bilinear || strcmp(k->name, "tri3") == 0)
        templates_print("FOOTPOINT_DETAIL_HEIGHT", (const char *const[]){"height", NULL}, precision, NULL, out);
    templates_print(guard, (const char *const[]){k->name, k->bilinear ? NULL : "gap", NULL}, precision, own, out);
    free(nodes);
    free(guard);
}

/* What checked searches of a kind do where the quick way does not tell. */
static void print_again(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    const char *kind = u->file->segment->name;
    char *guard = new_format("FOOTPOINT_%s_CHECKED", kind), *columns = lines_columns(u), *rows = lines_rows(u, "p");
    char *count = new_format("%zu", segment_vectors(u->file->segment) + 1);
    const struct placeholder own[] = {
        {"KIND", kind}, {"VECTORS", count}, {"COLUMNS", columns}, {"ROWS", rows}, {NULL, NULL}};
    templates_print("FOOTPOINT_DETAIL_AGAIN", (const char *const[]){"again", NULL}, precision, NULL, out);
    templates_print(guard, (const char *const[]){"checked_rest", NULL}, precision, own, out);
    free(count);
    free(rows);
    free(columns);
    free(guard);
}

void helpers_print(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    templates_print("FOOTPOINT_DETAIL_SCALE", (const char *const[]){"scale", NULL}, precision, NULL, out);
    print_kind(u->file->segment, precision, out);
    print_again(u, out);
    if (u->file->order != CORNERS_ANY)
        templates_print("FOOTPOINT_DETAIL_CORNERS", (const char *const[]){"corners", NULL}, precision, NULL, out);
    if (closest_exists(u))
        closest_print_helpers(u, out);
    sizes_print_least(u, out);
}

/* ---- projection along a direction ---- */

/* "const double xA[3], const double xB[3], ..." */
static char *parameters_text(const struct unit *u)
{
    struct memory *m = memory_open();
    const struct segment_kind *k = u->file->segment;
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(m->stream, "%sconst %s %s[3]", i ? ", " : "", lines_real(u), name);
    }
    return memory_close(m);
}

void helpers_print_along(const struct unit *u, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    if (!k || !(k->bilinear || strcmp(k->name, "tri3") == 0))
        return;
    const enum precision precision = u->options.precision;
    const size_t n = segment_vectors(k) + 1;
    char *guard = new_format("FOOTPOINT_%s_ALONG", k->name), *method = new_format("%s_along", k->name);
    char *count = new_format("%zu", n), *coordinates = new_format("%zu", 3 * n), *parameters = parameters_text(u);
    char *names = lines_vectors(u), *columns = lines_columns(u), *rows = lines_rows(u, "p");
    const struct placeholder own[] = {{"KIND", k->name},
                                      {"PREFIX", u->options.prefix},
                                      {"VECTORS", count},
                                      {"COORDINATES", coordinates},
                                      {"NODE_PARAMETERS", parameters},
                                      {"NODE_NAMES", names},
                                      {"COLUMNS", columns},
                                      {"ROWS", rows},
                                      {NULL, NULL}};
    templates_print("FOOTPOINT_DETAIL_ALONG", (const char *const[]){"along", NULL}, precision, NULL, out);
    templates_print(guard, (const char *const[]){method, "along_again", NULL}, precision, own, out);
    templates_print(NULL, (const char *const[]){"along_calls", NULL}, precision, own, out);
    free(rows);
    free(columns);
    free(names);
    free(parameters);
    free(coordinates);
    free(count);
    free(method);
    free(guard);
}
