/* Projection along a direction; see header_along.h. Equations of degree 2 are solved in closed form. Others take
 * Newton's steps and, if these decide nothing, subdivision. */
#include "header_along.h"

#include "../../base/text.h"
#include "../templates.h"
#include "header_lines.h"

#include <stdlib.h>
#include <string.h>

/* Returns the template of the face in powers of xi and eta; NULL if it does not exist. */
static const char *powers_of(const struct segment_kind *k)
{
    const size_t nodes = strlen(k->nodes);
    return k->triangle ? (nodes == 6 ? "triangle_powers" : NULL) : nodes == 8 || nodes == 9 ? "square_powers" : NULL;
}

bool along_check(const struct unit *u, struct diag *d)
{
    const struct segment_kind *k = u->file->segment;
    if (!k || *k->normals || lines_straight(u) || powers_of(k))
        return true;
    return diag_at(d, u->file->path, 0, 0,
                   "segment %s has %zu nodes; headers project along a direction onto faces of 3, 4, 6, 8 and 9 nodes",
                   k->name, strlen(k->nodes));
}

void along_print(const struct unit *u, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    if (!k || *k->normals)
        return;
    const enum precision precision = u->options.precision;
    const bool closed = lines_straight(u);
    char *method = new_format("%s_along", k->name);
    templates_print("FOOTPOINT_DETAIL_ALONG", (const char *const[]){"along", NULL}, precision, NULL, out);
    if (!closed)
        templates_print("FOOTPOINT_DETAIL_DOMAINS", (const char *const[]){"curved_domain", NULL}, precision, NULL, out);
    const char *const curved[] = {powers_of(k),        "curved_along", "curved_parts",
                                  "curved_along_full", "along_again",  NULL},
                      *const straight[] = {method, "along_again", NULL};
    lines_print_templates(u, "ALONG", closed ? straight : curved, out);
    lines_print_templates(u, NULL, (const char *const[]){"along_calls", NULL}, out);
    free(method);
}
