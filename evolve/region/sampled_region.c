/* Ranges of the samples' coordinates, widened to two decimals, and of the frames' `least` values; see
 * sampled_region.h. */
#include "sampled_region.h"

#include "../common/vec3.h"
#include "../eval/frame.h"
#include "../eval/lines_run.h"
#include "region_values.h"
#include "shape_region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PIECE = 4096 };

/* Computes the sample in coordinates with A at 0, B = (1,0,0) and the last corner in the x-y plane. Normals are only
 * turned. */
static void similar(const struct segment_kind *kind, const struct sample *s, struct sample *to)
{
    const size_t vectors = segment_vectors(kind), nodes = strlen(kind->nodes);
    const double *third = s->x[kind->corners - 1];
    double e[3][3];
    for (int i = 0; i < 3; i++) {
        e[0][i] = s->x[1][i] - s->x[0][i];
        e[1][i] = third[i] - s->x[0][i];
    }
    const double length = vector_length(e[0]), along = vector_dot(e[0], e[1]);
    for (int i = 0; i < 3; i++)
        e[1][i] -= along / (length * length) * e[0][i];
    const double height = vector_length(e[1]);
    for (int i = 0; i < 3; i++) {
        e[0][i] /= length;
        e[1][i] /= height;
    }
    vector_cross(e[0], e[1], e[2]);
    *to = (struct sample){.xi = s->xi, .eta = s->eta};
    for (size_t n = 0; n <= vectors; n++)
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++)
                *(n < vectors ? &to->x[n][k] : &to->xs[k]) +=
                    n < nodes || n == vectors ? ((n < vectors ? s->x[n][i] : s->xs[i]) - s->x[0][i]) * e[k][i] / length
                                              : s->x[n][i] * e[k][i];
}

/* ---- extremes ---- */

/* Extremes of a table's columns (inputs and lets), then of the genomes' outputs, then of the frames' `least` values. */
struct extremes {
    double *lo, *hi; /* owned */
    bool *sized;     /* owned, indexed by column of the table: the value changes with the segment's size */
};

struct region_survey {
    struct genome_file *file;    /* not owned */
    struct shape_survey *shapes; /* owned until it is added; NULL: coordinates are measured */
    struct extremes e;
    bool begun; /* samples have been added */
};

static void take_in_expressions(struct extremes *e, size_t j, const struct genome_file *f, const struct genome_expr *x,
                                size_t n, const struct columns *table)
{
    double *value = new_array(table->n, sizeof *value);
    for (size_t k = 0; k < n; k++) {
        table_values(table, f->constant, x[k].gene, x[k].length, value);
        extend_range(value, table->n, &e->lo[j + k], &e->hi[j + k]);
    }
    free(value);
}

/* Finds values that change with the size. Doubling is exact, so values that do not depend on the size keep every
 * bit. */
static void find_sized(struct extremes *e, const struct genome_file *f, struct sample *moved,
                       const struct columns *table)
{
    const size_t nodes = strlen(f->segment->nodes);
    for (size_t i = 0; i < table->n; i++)
        for (int k = 0; k < 3; k++) {
            for (size_t n = 0; n < nodes; n++)
                moved[i].x[n][k] *= 2;
            moved[i].xs[k] *= 2;
        }
    struct columns twice = frame_columns(f, moved, table->n);
    for (size_t j = 0; j < table->count; j++)
        for (size_t i = 0; i < table->n && !e->sized[j]; i++)
            e->sized[j] = columns_at(table, j)[i] != columns_at(&twice, j)[i];
    columns_free(&twice);
}

/* Returns the index of the first extreme of a `least` value. */
static size_t first_least(const struct genome_file *f)
{
    size_t j = frame_target(f, 2);
    for (size_t g = 0; g < f->genomes; g++)
        j += f->genome[g].outs;
    return j;
}

struct region_survey *region_survey_new(struct genome_file *f)
{
    struct region_survey *s = new_array(1, sizeof *s);
    *s = (struct region_survey){.file = f};
    /* if the order of corners depends on the slave node, samples fill a box of coordinates */
    if (!f->segment || (f->order == CORNERS_ANY && (s->shapes = shape_survey_new(f))))
        return s;
    const size_t count = first_least(f) + f->leasts;
    s->e = (struct extremes){new_array(count, sizeof *s->e.lo), new_array(count, sizeof *s->e.hi),
                             new_array(count, sizeof *s->e.sized)};
    for (size_t j = 0; j < count; j++)
        s->e.hi[j] = -(s->e.lo[j] = INFINITY);
    return s;
}

static void take_piece(struct region_survey *s, const struct sample *sample, size_t n)
{
    const struct genome_file *f = s->file;
    struct sample *moved = new_array(n, sizeof *moved);
    for (size_t i = 0; i < n; i++)
        similar(f->segment, &sample[i], &moved[i]);
    struct columns table = frame_columns(f, moved, n);
    size_t j = 0;
    for (; j < table.count; j++)
        extend_range(columns_at(&table, j), n, &s->e.lo[j], &s->e.hi[j]);
    for (size_t g = 0; g < f->genomes; j += f->genome[g++].outs)
        take_in_expressions(&s->e, j, f, f->genome[g].out, f->genome[g].outs, &table);
    take_in_expressions(&s->e, first_least(f), f, f->least, f->leasts, &table);
    if (!s->begun)
        find_sized(&s->e, f, moved, &table);
    s->begun = true;
    columns_free(&table);
    free(moved);
}

void region_survey_take(struct region_survey *s, const struct sample *sample, size_t n)
{
    for (size_t first = 0; s->file->segment && first < n; first += PIECE) {
        const size_t piece = n - first < PIECE ? n - first : PIECE;
        if (s->shapes)
            shape_survey_take(s->shapes, sample + first, piece);
        else
            take_piece(s, sample + first, piece);
    }
}

/* ---- requires ---- */

/* Requires |expression| < 2 `most`, where `most` is its largest modulus on the samples. */
static void require_below(struct genome_file *f, const int *gene, size_t length, double most)
{
    if (most > 0 && isfinite(most))
        require_magnitude(f, gene, length, 2 * most);
}

/* Bounds quotients that do not depend on the size: lets that the genomes use, and outputs unless they equal such a
 * let. */
static void require_coordinates(struct genome_file *f, const struct extremes *e, const bool *used)
{
    bool *named = named_quotients(f, used);
    for (size_t i = 0; i < f->lets; i++) {
        const size_t j = f->inputs + i;
        const int gene = GENE_SYMBOL + (int)j;
        if (named[i] && !e->sized[j])
            require_below(f, &gene, 1, fmax(-e->lo[j], e->hi[j]));
    }
    size_t j = frame_target(f, 2);
    for (size_t g = 0; g < f->genomes; g++)
        for (size_t k = 0; k < f->genome[g].outs; k++, j++) {
            const struct genome_expr *out = &f->genome[g].out[k];
            if (output_is_quotient(f, out))
                require_below(f, out->gene, out->length, fmax(-e->lo[j], e->hi[j]));
        }
    free(named);
}

/* Returns true if the genomes use all lets of the expression. */
static bool is_used(const struct genome_file *f, const struct genome_expr *e, const bool *used)
{
    bool all = true;
    for (size_t i = 0; i < e->length && all; i++)
        all = e->gene[i] < GENE_SYMBOL + (int)f->inputs || used[e->gene[i] - GENE_SYMBOL - (int)f->inputs];
    return all;
}

static void add_coordinates(const struct region_survey *s)
{
    struct genome_file *f = s->file;
    const struct extremes *e = &s->e;
    const size_t flat = 3 * f->segment->corners - 1;
    bool *used = used_lets(f);
    for (size_t j = 0; j < f->inputs && e->lo[j] <= e->hi[j]; j++) {
        const bool fixed = j < 6 || j == flat; /* A, B, and z of the last corner vary only by rounding */
        const double at = j == 3 ? 1 : 0;
        add_range(f, j, fixed ? at : e->lo[j], fixed ? at : e->hi[j]);
    }
    const double *lo = e->lo + first_least(f);
    for (size_t i = 0; i < f->leasts; i++)
        if (lo[i] > 0 && isfinite(lo[i]) && is_used(f, &f->least[i], used))
            require_sign(f, f->least[i].gene, f->least[i].length, 0.5 * lo[i]);
    require_coordinates(f, e, used);
    free(used);
}

void region_survey_add(struct region_survey *s)
{
    if (s->shapes)
        shape_survey_add(s->shapes);
    else if (s->file->segment)
        add_coordinates(s);
    free(s->e.lo);
    free(s->e.hi);
    free(s->e.sized);
    free(s);
}
