/* Means, 99 % and maxima of errors; see errors.h. */
#include "errors.h"

#include "../../codegen/base/simd.h"
#include "frame.h"
#include "lines_run.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PIECE = 32 * KERNEL_BLOCK };

void errors_absolute(double *value, const double *reference, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const double error = fabs(value[i] - reference[i]);
        value[i] = isnan(error) ? INFINITY : error;
    }
}

WIDE double errors_max(const double *absolute, size_t n)
{
    double lane[WIDE_LANES] = {0}, max = 0;
    size_t i = 0;
    for (; i + WIDE_LANES <= n; i += WIDE_LANES)
        for (size_t j = 0; j < WIDE_LANES; j++)
            lane[j] = absolute[i + j] > lane[j] ? absolute[i + j] : lane[j];
    for (; i < n; i++)
        max = absolute[i] > max ? absolute[i] : max;
    for (size_t j = 0; j < WIDE_LANES; j++)
        max = lane[j] > max ? lane[j] : max;
    return max;
}

static size_t place_of_p99(size_t n)
{
    return (99 * n + 99) / 100 - 1;
}

WIDE bool errors_p99_within(const double *absolute, size_t n, double most)
{
    size_t within = 0;
    for (size_t i = 0; i < n; i++)
        within += absolute[i] <= most;
    return within > place_of_p99(n);
}

/* What the 99 % is not below, as a few of the errors show; 0 where they mislead. */
static double below_p99(const double *absolute, size_t n)
{
    enum { FEW = 512 };
    double few[FEW];
    if (n < 8 * FEW)
        return 0;
    for (size_t i = 0; i < FEW; i++)
        few[i] = absolute[i * (n / FEW)];
    const double guess = gsl_stats_select(few, 1, FEW, 96 * FEW / 100);
    return errors_p99_within(absolute, n, guess) ? 0 : guess;
}

double errors_p99_above(double *absolute, size_t n, double least)
{
    const double cut = fmax(least, below_p99(absolute, n));
    size_t above = 0;
    for (size_t i = 0; i < n; i++) {
        const double error = absolute[i];
        absolute[above] = error;
        above += error > cut;
    }
    const size_t below = n - above, place = place_of_p99(n);
    return place < below ? least : gsl_stats_select(absolute, 1, above, place - below);
}

double errors_p99(double *absolute, size_t n)
{
    return errors_p99_above(absolute, n, 0);
}

/* Absolute errors of all trees on a piece of the samples, to error[i][0..n-1]. */
static void measure_piece(const struct genome_file *program, const struct genes *t, const int *output, size_t trees,
                          const struct sample *s, size_t n, size_t at, double **error)
{
    struct columns table = frame_columns(program, s, n);
    for (size_t i = 0; i < trees; i++) {
        table_values(&table, program->constant, t[i].gene, t[i].length, error[i] + at);
        errors_absolute(error[i] + at, columns_at(&table, frame_target(program, output[i])), n);
    }
    columns_free(&table);
}

static void measure_bands(const double *error, const struct sample_set *set, size_t corners, double mean[GAP_BANDS])
{
    size_t count[GAP_BANDS] = {0};
    for (int b = 0; b < GAP_BANDS; b++)
        mean[b] = 0;
    for (size_t i = 0; i < set->n; i++) {
        const int b = sample_gap_band(&set->s[i], corners);
        mean[b] += error[i];
        count[b]++;
    }
    for (int b = 0; b < GAP_BANDS; b++)
        mean[b] = count[b] > 0 ? mean[b] / (double)count[b] : -1;
}

static struct errors errors_of(double *error, size_t n)
{
    struct errors found = {.n = n};
    for (size_t i = 0; i < n; i++)
        found.mean += error[i];
    found.mean /= (double)n;
    found.max = errors_max(error, n);
    found.p99 = errors_p99(error, n);
    return found;
}

void errors_measure(const struct genome_file *program, const struct genes *t, const int *output, size_t trees,
                    const struct sample_set *set, struct errors *found)
{
    double **error = new_array(trees, sizeof *error);
    for (size_t i = 0; i < trees; i++)
        error[i] = new_array(set->n, sizeof **error);
    for (size_t at = 0; at < set->n; at += PIECE) {
        const size_t n = set->n - at < PIECE ? set->n - at : PIECE;
        measure_piece(program, t, output, trees, set->s + at, n, at, error);
    }
    for (size_t i = 0; i < trees; i++) {
        double band[GAP_BANDS];
        measure_bands(error[i], set, program->segment ? program->segment->corners : 0, band);
        found[i] = errors_of(error[i], set->n);
        memcpy(found[i].band, band, sizeof band);
        free(error[i]);
    }
    free(error);
}
