/* Float code of segments; see header_float.h.  Products of a dozen and more lengths leave the range of float where
 * edges are 100 long, so that coordinates are first made relative to node A and to the size of the segment.
 *
 * The check is that of runtime/certain/check.h, which explains it, with two differences.  The radius r within which the Hessian
 * is compared is twice the step that Newton's method would make, not the error allowed, where that is more: the same
 * proof, and coarse functions pass, too, where their answer is good.  And rounding errors, 1e9 times those of double,
 * are counted by the lengths that each product consists of, not by their proved bounds, which are ten times as large
 * and would leave little to be sure of. */
#include "header_float.h"

#include "../../base/text.h"
#include "../templates.h"

#include <stdlib.h>
#include <string.h>

void single_print_helpers(const struct unit *u, FILE *out)
{
    templates_print("FOOTPOINT_DETAIL_RELATIVE", (const char *const[]){"relative", NULL}, PRECISION_FLOAT, NULL, out);
    if (single_checks(u))
        templates_print("FOOTPOINT_DETAIL_QUAD4_SURE", (const char *const[]){"quad4_sure", NULL}, PRECISION_FLOAT, NULL,
                        out);
}

/* The scale, from the corners. */
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

bool single_checks(const struct unit *u)
{
    return u->options.samples && u->file->segment->bilinear;
}

char *single_worst_name(const struct function *f)
{
    char *capitals = new_capitals(f->name), *name = new_format("%s_WORST", capitals);
    free(capitals);
    return name;
}

void single_print_sure(const struct function *f, const char *vectors, FILE *out)
{
    char *worst = single_worst_name(f);
    fprintf(out,
            "{\n    float found[2], g;\n    const int status = %s(%s, found, &g);\n"
            "    return footpoint_detail_f_sure(%s, status, found, g, %s, loc, gap);\n}\n",
            f->name, vectors, vectors, worst);
    free(worst);
}
