/* Projection along a direction; see header_along.h.  Where the equations are of degree 2 it is in closed form, else by
 * Newton's steps, and where these do not tell by subdivision. */
#include "header_along.h"

#include "../../base/text.h"
#include "../templates.h"
#include "header_lines.h"

#include <stdlib.h>

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
    const char *const curved[] = {k->triangle ? "triangle_powers" : "square_powers",
                                  "curved_along",
                                  "curved_parts",
                                  "curved_along_full",
                                  "along_again",
                                  NULL},
                      *const straight[] = {method, "along_again", NULL};
    lines_print_templates(u, NULL, "ALONG", closed ? straight : curved, out);
    lines_print_templates(u, NULL, NULL, (const char *const[]){"along_calls", NULL}, out);
    free(method);
}
