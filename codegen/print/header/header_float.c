/* Prints float code of segments; see header_float.h.  Products of a dozen and more lengths leave the range of float if
 * edges are 100 long, so coordinates are first made relative to node A and to the size of the segment. */
#include "header_float.h"

#include "../../base/text.h"
#include "../templates.h"

#include <stdlib.h>
#include <string.h>

void single_print_helpers(const struct unit *u, FILE *out)
{
    if (u->file->segment)
        templates_print("FOOTPOINT_DETAIL_RELATIVE", (const char *const[]){"relative", NULL}, PRECISION_FLOAT, NULL,
                        out);
}

/* Prints the scale, from the corners. */
static void print_scale(const struct segment_kind *k, FILE *out)
{
    fprintf(out, "    const float *const corner[%zu] = {", k->corners);
    for (size_t c = 0; c < k->corners; c++)
        fprintf(out, "%sx%c", c ? ", " : "", k->nodes[c]);
    fprintf(out, "};\n    const float scale = footpoint_detail_f_relative(corner, %zu);\n", k->corners);
}

void single_print_inputs(const struct unit *u, const struct function *f, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    const size_t nodes = strlen(k->nodes), vectors = segment_vectors(k);
    bool *reads = program_reads(f->program), scaled = false;
    for (size_t i = 0; f->scaled && i <= vectors; i++) {
        char name[4];
        if ((i >= nodes && i < vectors) || !(reads[3 * i] || reads[3 * i + 1] || reads[3 * i + 2]))
            continue;
        segment_vector_name(k, i, name);
        if (i == 0) {
            fputs("    const float yA[3] = {0.0f, 0.0f, 0.0f};\n", out);
            continue;
        }
        if (!scaled)
            print_scale(k, out);
        scaled = true;
        fprintf(
            out,
            "    const float y%s[3] = {(%s[0] - xA[0]) * scale, (%s[1] - xA[1]) * scale, (%s[2] - xA[2]) * scale};\n",
            name + 1, name, name, name);
    }
    free(reads);
}
