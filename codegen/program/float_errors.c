/* Reads samples and measures errors; see float_errors.h. */
#include "float_errors.h"

#include "../base/text.h"
#include "evaluate_float.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const measure_part[MEASURE_PARTS] = {"heldout", "heldout_random", "heldout_even"};

bool measure_errors_read(const char *text, struct measure_error e[2])
{
    int end = 0, climbed = 0;
    bool good = sscanf(text, "n %zu mean %lf %lf p99 %lf %lf max %lf %lf%n", &e[0].n, &e[0].mean, &e[1].mean, &e[0].p99,
                       &e[1].p99, &e[0].max, &e[1].max, &end) == 7;
    e[0].climbed = e[1].climbed = 0;
    if (good && text[end] != '\0')
        good = sscanf(text + end, " climbing %lf %lf%n", &e[0].climbed, &e[1].climbed, &climbed) == 2 &&
               text[end + climbed] == '\0';
    e[0].n = e[1].n = good ? e[0].n : 0;
    return good;
}

static bool far_apart(double a, double b)
{
    return a > 1.5 * b || b > 1.5 * a;
}

bool measure_differs(const struct measure_error *a, const struct measure_error *b)
{
    return far_apart(a->mean, b->mean) || far_apart(a->p99, b->p99);
}

/* Returns the line with which the file must begin. */
static char *head_of(const struct genome_file *f)
{
    struct growing g = {0};
    growing_add(&g, "part");
    for (size_t i = 0; i < f->inputs; i++) {
        growing_add(&g, ",");
        growing_add(&g, f->input[i]);
    }
    growing_add(&g, ",xi,eta\n");
    return g.text;
}

/* Reads a part's name at the beginning of a line, MEASURE_PARTS more if climbing found its samples.  Returns the rest of the line,
 * or NULL. */
static char *read_part(char *line, int *part)
{
    char *end = strchr(line, ',');
    if (!end)
        return NULL;
    *end = '\0';
    char *climbing = strstr(line, "_climbing");
    if (climbing && strcmp(climbing, "_climbing") == 0)
        *climbing = '\0';
    else
        climbing = NULL;
    *part = 0;
    while (*part < MEASURE_PARTS && strcmp(line, measure_part[*part]) != 0)
        ++*part;
    const bool known = *part < MEASURE_PARTS;
    *part += climbing ? MEASURE_PARTS : 0;
    *end = ',';
    return known ? end : NULL;
}

static bool read_line(char *line, struct measure_samples *s)
{
    int part;
    char *at = read_part(line, &part);
    if (!at)
        return false;
    grow_array(&s->row, s->n, &s->room, s->width * sizeof *s->row);
    double *row = s->row + s->n++ * s->width;
    row[0] = part;
    for (size_t k = 1; k < s->width; k++) {
        char *end;
        if (*at++ != ',')
            return false;
        row[k] = strtod(at, &end);
        if (end == at || !isfinite(row[k]))
            return false;
        at = end;
    }
    return strcmp(at, "\n") == 0;
}

bool measure_read(const char *path, const struct genome_file *f, struct measure_samples *s, struct diag *d)
{
    char *line = NULL, *head = head_of(f);
    size_t room = 0;
    int number = 1;
    FILE *stream = fopen(path, "r");
    *s = (struct measure_samples){.inputs = f->inputs, .width = f->inputs + 3};
    if (!stream) {
        free(head);
        return diag_system(d, path, "cannot open");
    }
    bool good = getline(&line, &room, stream) > 0 && strcmp(line, head) == 0;
    while (good && getline(&line, &room, stream) > 0) {
        number++;
        good = read_line(line, s);
    }
    if (good && s->n == 0)
        good = false;
    if (!good)
        diag_at(d, path, number, 0,
                number == 1 ? "no samples of the genomes' inputs, see footpoint-evolve --samples" : "no sample");
    if (ferror(stream))
        good = diag_system(d, path, "cannot read");
    fclose(stream);
    free(line);
    free(head);
    if (!good)
        measure_samples_free(s);
    return good;
}

void measure_samples_free(struct measure_samples *s)
{
    free(s->row);
    s->row = NULL;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Computes the same statistics as evolution: p99 is the ceil(0.99 n)-th smallest error.  Sorts. */
static struct measure_error error_of(double *error, size_t n)
{
    struct measure_error e = {.n = n};
    if (n == 0)
        return e;
    for (size_t i = 0; i < n; i++)
        e.mean += error[i];
    e.mean /= (double)n;
    qsort(error, n, sizeof *error, compare);
    e.p99 = error[(99 * n + 99) / 100 - 1];
    e.max = error[n - 1];
    return e;
}

struct measured measure_program(const struct genome_file *f, const struct program *p, bool relative,
                                const struct measure_samples *s)
{
    struct measured found;
    float *y = new_array(s->inputs, sizeof *y), *value = new_array(p->ops, sizeof *value);
    float *x = new_array(s->inputs, sizeof *x);
    double *error[2 * MEASURE_PARTS][2];
    size_t n[2 * MEASURE_PARTS] = {0};
    for (int part = 0; part < 2 * MEASURE_PARTS; part++)
        for (int k = 0; k < 2; k++)
            error[part][k] = new_array(s->n, sizeof **error[part]);
    single_constants(p, value);
    for (size_t i = 0; i < s->n; i++) {
        const double *row = s->row + i * s->width;
        const int part = (int)row[0];
        for (size_t k = 0; k < s->inputs; k++)
            x[k] = (float)row[1 + k];
        single_inputs(f->segment, x, y);
        single_values(p, relative ? y : x, value);
        for (int k = 0; k < 2; k++) {
            const double off = fabs((double)value[p->output[k]] - row[1 + s->inputs + (size_t)k]);
            error[part][k][n[part]] = isnan(off) ? INFINITY : off;
        }
        n[part]++;
    }
    for (int part = 0; part < MEASURE_PARTS; part++)
        for (int k = 0; k < 2; k++) {
            const struct measure_error climbed = error_of(error[MEASURE_PARTS + part][k], n[MEASURE_PARTS + part]);
            found.error[part][k] = error_of(error[part][k], n[part]);
            found.error[part][k].climbed = climbed.n > 0 ? fmax(climbed.max, found.error[part][k].max) : 0;
            free(error[part][k]);
            free(error[MEASURE_PARTS + part][k]);
        }
    free(x);
    free(y);
    free(value);
    return found;
}
