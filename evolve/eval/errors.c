/* Mean, 99 % and largest errors; see errors.h. */
#include "errors.h"

#include "../../codegen/base/simd.h"
#include "frame.h"
#include "lines_run.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PIECE = 8 * SUM_BLOCK };

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

/* Returns a lower bound of the 99 % error, estimated from 512 of the errors; 0 if the estimate fails. */
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

/* ---- running statistics ---- */

void tally_open(struct tally *t, size_t most)
{
    const size_t room = most / 100 + 1;
    *t = (struct tally){.most = room > TALLY_WORST ? room : TALLY_WORST};
    t->largest = new_array(t->most, sizeof *t->largest);
}

/* Sifts an error into the heap, upwards from the free place `at`. */
static void sift(struct tally *t, size_t at, struct largest e)
{
    for (size_t child; (child = 2 * at + 1) < t->kept; at = child) {
        if (child + 1 < t->kept && t->largest[child + 1].error < t->largest[child].error)
            child++;
        if (e.error <= t->largest[child].error)
            break;
        t->largest[at] = t->largest[child];
    }
    t->largest[at] = e;
}

static void keep(struct tally *t, struct largest e)
{
    if (t->kept == t->most) {
        if (e.error > t->largest[0].error)
            sift(t, 0, e);
        return;
    }
    size_t at = t->kept++;
    for (; at > 0 && t->largest[(at - 1) / 2].error > e.error; at = (at - 1) / 2)
        t->largest[at] = t->largest[(at - 1) / 2];
    t->largest[at] = e;
}

void tally_take(struct tally *t, const double *error, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        t->sum += error[i];
        keep(t, (struct largest){error[i], t->n + i});
    }
    t->n += n;
}

static int descending(const void *a, const void *b)
{
    const struct largest *p = a, *q = b;
    return p->error != q->error ? (p->error < q->error) - (p->error > q->error)
                                : (p->sample > q->sample) - (p->sample < q->sample);
}

void tally_sort(struct tally *t)
{
    qsort(t->largest, t->kept, sizeof *t->largest, descending);
}

struct errors tally_close(struct tally *t)
{
    struct errors e = {.n = t->n};
    tally_sort(t);
    if (t->n > 0) {
        e.mean = t->sum / (double)t->n;
        e.max = t->largest[0].error;
        e.p99 = t->largest[t->n - 1 - place_of_p99(t->n)].error;
    }
    for (int b = 0; b < GAP_BANDS; b++)
        e.band[b] = t->in_band[b] > 0 ? t->band[b] / (double)t->in_band[b] : -1;
    free(t->largest);
    return e;
}

static void take_bands(struct tally *t, const double *error, const unsigned char *band, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        t->band[band[i]] += error[i];
        t->in_band[band[i]]++;
    }
}

/* ---- expressions ---- */

struct measurement measurement_open(const struct genome_file *program, const struct genes *t, const int *output,
                                    size_t trees, size_t most)
{
    struct measurement m = {program, t, output, trees, new_array(trees, sizeof *m.tally), false};
    for (size_t i = 0; i < trees; i++)
        tally_open(&m.tally[i], most);
    return m;
}

void measurement_errors(const struct measurement *m, size_t first, size_t last, const struct sample *s, size_t n,
                        double **error)
{
    struct columns table = frame_columns_in(m->program, s, n, m->single);
    for (size_t i = first; i < last; i++) {
        table_values(&table, m->program->constant, m->t[i].gene, m->t[i].length, error[i - first]);
        errors_absolute(error[i - first], columns_at(&table, frame_target(m->program, m->output[i])), n);
    }
    columns_free(&table);
}

static void take_piece(struct measurement *m, const struct sample *s, size_t n, double **error)
{
    const size_t corners = m->program->segment ? m->program->segment->corners : 0;
    unsigned char band[PIECE];
    for (size_t i = 0; i < n; i++)
        band[i] = (unsigned char)sample_gap_band(&s[i], corners);
    measurement_errors(m, 0, m->trees, s, n, error);
    for (size_t i = 0; i < m->trees; i++) {
        tally_take(&m->tally[i], error[i], n);
        take_bands(&m->tally[i], error[i], band, n);
    }
}

void measurement_take(struct measurement *m, const struct sample *s, size_t n)
{
    double **error = new_array(m->trees, sizeof *error);
    for (size_t i = 0; i < m->trees; i++)
        error[i] = new_array(n < PIECE ? n : PIECE, sizeof **error);
    for (size_t at = 0; at < n; at += PIECE)
        take_piece(m, s + at, n - at < PIECE ? n - at : PIECE, error);
    for (size_t i = 0; i < m->trees; i++)
        free(error[i]);
    free(error);
}

void measurement_close(struct measurement *m, struct errors *found)
{
    for (size_t i = 0; i < m->trees; i++)
        found[i] = tally_close(&m->tally[i]);
    free(m->tally);
}
