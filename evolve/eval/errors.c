/* Means, 99 % and maxima of errors; see errors.h. */
#include "errors.h"

#include "frame.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

enum { PIECE = 32 * KERNEL_BLOCK };

void errors_absolute(double *value, const double *reference, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const double error = fabs(value[i] - reference[i]);
        value[i] = isnan(error) ? INFINITY : error;
    }
}

double errors_max(const double *absolute, size_t n)
{
    double max = 0;
    for (size_t i = 0; i < n; i++)
        max = absolute[i] > max ? absolute[i] : max;
    return max;
}

double errors_p99(double *absolute, size_t n)
{
    return gsl_stats_select(absolute, 1, n, (99 * n + 99) / 100 - 1);
}

struct errors errors_measure(struct kernel *k, const struct genome_file *program, const struct tree *t, int output,
                             const struct sample_set *set)
{
    struct errors found = {.n = set->n};
    double *error = new_array(set->n, sizeof *error);
    for (size_t first = 0; first < set->n; first += PIECE) {
        const size_t n = set->n - first < PIECE ? set->n - first : PIECE;
        struct columns table = frame_columns(k, program, set->s + first, n);
        const struct kernel_task task = {t->gene, t->length, program->constant, &table};
        kernel_values(k, &task, error + first);
        errors_absolute(error + first, columns_at(&table, frame_target(program, output)), n);
        columns_free(&table);
    }
    for (size_t i = 0; i < set->n; i++)
        found.mean += error[i];
    found.mean /= (double)set->n;
    found.max = errors_max(error, set->n);
    found.p99 = errors_p99(error, set->n);
    free(error);
    return found;
}
