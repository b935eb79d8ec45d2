/* Closest points of closed segments; see header_closest.h.
 *
 * The closest point is a foot point inside, or it is the nearest point of an edge.  The latter is right to rounding; so
 * the nearer of the search's point, where that is inside, and of those of all edges is as good as the search, and where
 * the search has left the segment it is not asked any further.  No branch depends on the data but for nodes in need of
 * another unit of length, so that loops over arrays vectorise: theirs are done once more in a second loop. */
#include "header_closest.h"

#include "../../base/text.h"
#include "../templates.h"
#include "header_lines.h"

#include <stdlib.h>

bool closest_exists(const struct unit *u)
{
    return u->file->order == CORNERS_ANY && !*u->file->segment->normals;
}

void closest_print_helpers(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    const struct segment_kind *k = u->file->segment;
    const bool straight = lines_straight(u);
    char *own_nearest = new_format("%s_nearest", k->name);
    const char *nearest = straight ? own_nearest : k->triangle ? "curved_triangle_nearest" : "curved_quad_nearest";
    const char *const names[] = {"inward", nearest, "fan", "closest_again", "closest_arrays", NULL};
    templates_print("FOOTPOINT_DETAIL_CLOSEST", (const char *const[]){"side", "corner", "closest", NULL}, precision,
                    NULL, out);
    templates_print(straight ? "FOOTPOINT_DETAIL_EDGE" : "FOOTPOINT_DETAIL_CURVE",
                    (const char *const[]){straight ? "edge" : "curve", NULL}, precision, NULL, out);
    if (k->bilinear)
        lines_print_templates(u, NULL, "SURFACE", (const char *const[]){"quad4_surface", NULL}, out);
    lines_print_templates(u, NULL, "NEAREST", names, out);
    free(own_nearest);
}

void closest_print_contract(const struct unit *u, FILE *out)
{
    lines_print_templates(u, NULL, NULL, (const char *const[]){"contract_closest", NULL}, out);
}

void closest_print(const struct unit *u, const struct function *f, FILE *out)
{
    lines_print_templates(u, f, NULL, (const char *const[]){"closest_calls", NULL}, out);
}
