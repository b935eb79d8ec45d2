/* Projection along a direction; see header_along.h, and the templates for the method. */
#include "header_along.h"

#include "../genome/text.h"
#include "header_lines.h"
#include "templates.h"

#include <stdlib.h>
#include <string.h>

bool along_exists(const struct segment_kind *k)
{
    return k->bilinear || strcmp(k->name, "tri3") == 0;
}

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

void along_print(const struct unit *u, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
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
