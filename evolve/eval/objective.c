/* Training errors; see objective.h.  The mean comes fused from the kernel; the other norms need all values. */
#include "objective.h"

#include "errors.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Errors of xi and eta, up to about 1 in size, that formulas have which are exact but for rounding. */
static const double rounding[] = {
    [NORM_MEAN] = DBL_EPSILON, [NORM_P99] = 4 * DBL_EPSILON, [NORM_MAX] = 16 * DBL_EPSILON};

double objective_rounding(enum scene_norm norm)
{
    return rounding[norm];
}

struct objective *objective_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm)
{
    struct objective *o = new_array(1, sizeof *o);
    *o = (struct objective){.table = table, .program = program, .norm = norm, .kernel = kernel_new_widest()};
    o->scratch = new_array(2 * table->n, sizeof *o->scratch);
    if (program) {
        o->rules = line_rules_new(program);
        o->lines = lines_run_new(o->rules, table);
    }
    return o;
}

void objective_free(struct objective *o)
{
    if (!o)
        return;
    kernel_free(o->kernel);
    lines_run_free(o->lines);
    line_rules_free(o->rules);
    free(o->scratch);
    free(o);
}

static struct kernel_task task_of(const struct objective *o, const struct genes *t)
{
    return (struct kernel_task){t->gene, t->length, o->decimal ? NULL : o->program->constant, o->table};
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

struct tails objective_tails(struct objective *o, const struct genes *t, int last)
{
    const size_t n = 2 * o->table->n;
    lines_errors(o->lines, t, last, INFINITY, o->scratch);
    const double max = errors_max(o->scratch, n);
    return (struct tails){fmax(errors_p99(o->scratch, n), rounding[NORM_P99]), fmax(max, rounding[NORM_MAX])};
}

static double mean_of(const double *error, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += error[i];
    return n > 0 ? sum / (double)n : 0;
}

/* The errors in o->scratch of one output on one part of the samples, and how many: none, of fewer samples than parts. */
static double *part_of(const struct objective *o, size_t output, size_t part, size_t *n)
{
    const size_t all = o->table->n, from = part * all / OUTPUT_PARTS;
    *n = (part + 1) * all / OUTPUT_PARTS - from;
    return o->scratch + output * all + from;
}

struct outputs objective_outputs(struct objective *o, const struct genes *t, int last)
{
    struct outputs found = {.mean = {{0}}};
    lines_errors(o->lines, t, last, INFINITY, o->scratch);
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < OUTPUT_PARTS; i++) {
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

bool objective_no_worse(struct objective *o, const struct genes *t, int last, const struct outputs *than)
{
    lines_errors(o->lines, t, last, INFINITY, o->scratch);
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < OUTPUT_PARTS; i++) {
            size_t n;
            const double *e = part_of(o, k, i, &n);
            if (n > 0 && (!(errors_max(e, n) <= than->max[k][i]) || !errors_p99_within(e, n, than->p99[k][i]) ||
                          !(mean_of(e, n) <= than->mean[k][i])))
                return false;
        }
    return true;
}

/* An error, charged for how far the 99 % and the largest of o->scratch exceed what they may be; INFINITY beyond the
 * bound, which counting shows where the 99 % would have to be selected. */
static double charged(struct objective *o, double error, const struct tails *tails, double bound)
{
    const size_t n = 2 * o->table->n;
    if (!(tails->max > 0))
        return error;
    error *= fmax(1, errors_max(o->scratch, n) / tails->max);
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
    const struct kernel_task task = task_of(o, t);
    const size_t n = o->table->n;
    if (o->norm == NORM_MEAN)
        return kernel_error_sum(o->kernel, &task, column, bound * (double)n) / (double)n;
    kernel_values(o->kernel, &task, o->scratch);
    errors_absolute(o->scratch, columns_at(o->table, column), n);
    return o->norm == NORM_MAX ? errors_max(o->scratch, n) : errors_p99(o->scratch, n);
}

double objective_work(const struct objective *o)
{
    return kernel_work(o->kernel) + (o->lines ? o->lines->work : 0);
}
