/* Training errors; see objective.h. The mean is summed during evaluation; the other norms need all values. */
#include "objective.h"

#include "errors.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Rounding errors of xi and eta, up to about 1 in size, in formulas that are otherwise exact. */
static const double rounding[] = {
    [NORM_MEAN] = DBL_EPSILON, [NORM_P99] = 4 * DBL_EPSILON, [NORM_MAX] = 16 * DBL_EPSILON};

double objective_rounding(enum scene_norm norm)
{
    return rounding[norm];
}

struct objective *objective_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm)
{
    struct objective *o = new_array(1, sizeof *o);
    *o = (struct objective){.table = table, .program = program, .norm = norm};
    o->scratch = new_array(2 * table->n, sizeof *o->scratch);
    o->picked = new_array(table->n, sizeof *o->picked);
    o->rules = program ? line_rules_new(program) : NULL;
    o->lines = lines_run_new(o->rules, table);
    return o;
}

void objective_free(struct objective *o)
{
    if (!o)
        return;
    lines_run_free(o->lines);
    line_rules_free(o->rules);
    free(o->scratch);
    free(o->picked);
    free(o);
}

/* Leaves all errors, of xi and then of eta, in o->scratch. */
double objective_error(struct objective *o, const struct genes *t, int last, double bound)
{
    const size_t n = 2 * o->table->n;
    const double most = o->norm == NORM_MEAN ? bound * (double)n : INFINITY;
    const double sum = lines_errors(o->lines, t, last, most, o->scratch);
    if (o->norm == NORM_MEAN)
        return sum / (double)n;
    return o->norm == NORM_MAX ? errors_max(o->scratch, n) : errors_p99(o->scratch, n);
}

/* Computes mean errors in the bands of |gap|; 0 in an empty band. */
static void band_means(const struct objective *o, double mean[GAP_BANDS])
{
    const size_t n = o->table->n;
    size_t count[GAP_BANDS] = {0};
    for (int b = 0; b < GAP_BANDS; b++)
        mean[b] = 0;
    for (size_t i = 0; i < n; i++) {
        mean[o->table->band[i]] += o->scratch[i] + o->scratch[n + i];
        count[o->table->band[i]] += 2;
    }
    for (int b = 0; b < GAP_BANDS; b++)
        mean[b] /= (double)(count[b] > 0 ? count[b] : 1);
}

struct tails objective_tails(struct objective *o, const struct genes *t, int last)
{
    const size_t n = 2 * o->table->n;
    struct tails tails = {.p99 = 0};
    lines_errors(o->lines, t, last, INFINITY, o->scratch);
    if (o->table->band)
        band_means(o, tails.band);
    for (int b = 0; b < GAP_BANDS && o->table->band; b++)
        tails.band[b] = fmax(tails.band[b], rounding[NORM_MEAN]);
    tails.max = fmax(errors_max(o->scratch, n), rounding[NORM_MAX]);
    tails.p99 = fmax(errors_p99(o->scratch, n), rounding[NORM_P99]);
    return tails;
}

static double mean_of(const double *error, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += error[i];
    return n > 0 ? sum / (double)n : 0;
}

static size_t parts_of(const struct objective *o)
{
    return o->table->band ? 2 * GAP_BANDS : 4;
}

/* Finds the errors in o->scratch of an output on a part of the samples, and their number: 0 if there are fewer samples
 * than parts. */
static double *part_of(const struct objective *o, size_t output, size_t part, size_t *n)
{
    const size_t all = o->table->n, pieces = o->table->band ? 2 : 4, piece = part % pieces;
    const size_t from = piece * all / pieces, to = (piece + 1) * all / pieces;
    double *error = o->scratch + output * all;
    *n = 0;
    for (size_t i = from; i < to; i++)
        if (!o->table->band || o->table->band[i] == part / pieces)
            o->picked[(*n)++] = error[i];
    return o->picked;
}

struct outputs objective_outputs(struct objective *o, const struct genes *t, int last)
{
    struct outputs found = {.mean = {{0}}};
    lines_errors(o->lines, t, last, INFINITY, o->scratch);
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < parts_of(o); i++) {
            size_t n;
            double *e = part_of(o, k, i, &n);
            if (n == 0)
                continue;
            found.mean[k][i] = fmax(mean_of(e, n), rounding[NORM_MEAN]);
            found.max[k][i] = fmax(errors_max(e, n), rounding[NORM_MAX]);
            found.p99[k][i] = fmax(errors_p99(e, n), rounding[NORM_P99]);
        }
    return found;
}

enum { WORSE_MEAN = 1, WORSE_P99 = 2, WORSE_MAX = 4, WORSE_UNKNOWN = 8 };

/* Returns a bit mask of the figures of an output that are larger on a part; on an empty part, all. */
static int worse_in(const struct objective *o, size_t k, size_t part, const struct outputs *than)
{
    size_t n;
    const double *e = part_of(o, k, part, &n);
    if (n == 0)
        return WORSE_MEAN | WORSE_P99 | WORSE_MAX | WORSE_UNKNOWN;
    return (mean_of(e, n) <= than->mean[k][part] ? 0 : WORSE_MEAN) |
           (errors_p99_within(e, n, than->p99[k][part]) ? 0 : WORSE_P99) |
           (errors_max(e, n) <= than->max[k][part] ? 0 : WORSE_MAX);
}

bool objective_no_worse(struct objective *o, const struct genes *t, int last, const struct outputs *than)
{
    const size_t parts = parts_of(o), halves = o->table->band ? 2 : 1;
    lines_errors(o->lines, t, last, INFINITY, o->scratch);
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < parts; i += halves) {
            int worse = worse_in(o, k, i, than);
            if (worse && halves == 2)
                worse &= worse_in(o, k, i + 1, than);
            if (worse && !(worse & WORSE_UNKNOWN))
                return false;
        }
    return true;
}

/* Returns the factor, at least 1, by which the mean in the worst band exceeds its limit. */
static double excess_in_bands(const struct objective *o, const struct tails *tails)
{
    double mean[GAP_BANDS], excess = 1;
    if (!o->table->band)
        return 1;
    band_means(o, mean);
    for (int b = 0; b < GAP_BANDS; b++)
        if (tails->band[b] > 0)
            excess = fmax(excess, mean[b] / tails->band[b]);
    return excess;
}

/* Returns an error charged for exceeding the limits on means in bands, 99 % and largest error of o->scratch. Returns
 * INFINITY beyond the bound; counting errors above the limit shows this without selecting the 99 %. */
static double charged(struct objective *o, double error, const struct tails *tails, double bound)
{
    const size_t n = 2 * o->table->n;
    if (!(tails->max > 0))
        return error;
    error *= excess_in_bands(o, tails) * fmax(1, errors_max(o->scratch, n) / tails->max);
    const double room = bound / error;
    if (room < INFINITY && (room < 1 || !errors_p99_within(o->scratch, n, room * tails->p99)))
        return INFINITY;
    return error * fmax(1, errors_p99_above(o->scratch, n, tails->p99) / tails->p99);
}

double objective_error_in_tails(struct objective *o, const struct genes *t, int last, const struct tails *tails,
                                double bound)
{
    const double error = objective_error(o, t, last, bound);
    if (!(error < INFINITY))
        return error;
    return lines_keep_signs(o->lines) ? charged(o, error, tails, bound) : INFINITY;
}

double objective_tree_error(struct objective *o, const struct genes *t, size_t column, double bound)
{
    const struct genome_constant *constant = o->decimal ? NULL : o->program->constant;
    const size_t n = o->table->n;
    if (o->norm == NORM_MEAN)
        return lines_tree_error(o->lines, t->gene, t->length, constant, column, bound * (double)n) / (double)n;
    lines_tree_values(o->lines, t->gene, t->length, constant, o->scratch);
    errors_absolute(o->scratch, columns_at(o->table, column), n);
    return o->norm == NORM_MAX ? errors_max(o->scratch, n) : errors_p99(o->scratch, n);
}
