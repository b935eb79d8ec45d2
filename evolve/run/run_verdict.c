/* Prints the verdict of a run; see run.h. */
#include "run.h"

#include "../../codegen/base/text.h"
#include "../eval/frame.h"
#include "../write/archive_write.h"

#include <math.h>
#include <stdlib.h>

/* The functions of the kind, as an archive of the same scene, and some of the held-out samples. */
struct beside {
    const struct archive *shipped; /* not owned */
    struct sample *sample;         /* owned */
    struct columns table;          /* the samples, as columns of the bare program */
    struct objective *judge;       /* owned */
};

struct archive *run_shipped(const struct call *call, const struct problem *p)
{
    char path[1024];
    struct diag d = {.code = EXIT_DONE};
    if (!run_files_of_kind(call, p->scene, path))
        return NULL;
    struct genome_file *program = frame_program(call->options->root, p->scene, path, &d);
    return program ? archive_new(p->scene, program, path, true, &d) : NULL;
}

void run_measure_shipped(const struct problem *p, struct archive *shipped)
{
    struct objective *training = objective_new(shipped->program, &p->table, p->scene->norm);
    training->decimal = true;
    archive_measure(shipped, &p->plan, training);
    objective_free(training);
}

static bool measure_beside(struct beside *b, enum scene_norm norm, struct sampler *p, struct diag *d)
{
    enum { MOST = 20000 };
    const size_t stride = (p->count + MOST - 1) / MOST, n = p->count / stride;
    bool good = true;
    b->sample = new_array(n, sizeof *b->sample);
    for (size_t i = 0; i < n && good; i++)
        good = sampler_take(p, i * stride, &b->sample[i], d);
    b->table = frame_columns(b->shipped->program, b->sample, n);
    b->judge = objective_new(b->shipped->program, &b->table, norm);
    b->judge->decimal = true;
    return good;
}

/* ---- the page ---- */

/* Computes means over xi and eta in the bands; negative without a function or without samples. */
static void measure_bands(const struct beside *b, const struct quest *q, const struct quest *last,
                          double mean[GAP_BANDS])
{
    const size_t n = b->table.n, corners = b->shipped->scene->segment->corners;
    size_t count[GAP_BANDS] = {0};
    const bool known = quest_of_programs(q) && q->champion.genes.length > 0;
    for (int k = 0; k < GAP_BANDS; k++)
        mean[k] = 0;
    if (known)
        objective_error(b->judge, &q->champion.genes, last->last, INFINITY);
    for (size_t i = 0; known && i < n; i++) {
        const int band = sample_gap_band(&b->sample[i], corners);
        mean[band] += (b->judge->scratch[i] + b->judge->scratch[n + i]) / 2;
        count[band]++;
    }
    for (int k = 0; k < GAP_BANDS; k++)
        mean[k] = count[k] > 0 ? mean[k] / (double)count[k] : -1;
}

enum { ASPECT, SKEW, TAPER, WARP, GAP, MEASURES };

static double length(const double a[3], const double b[3], const double c[3], const double d[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += pow(a[k] + b[k] - c[k] - d[k], 2);
    return sqrt(sum);
}

/* Measures a sample by its corners, as scenes do; a triangle is half of a parallelogram. */
static void measure_sample(const struct sample *s, bool triangle, struct page_measure *m, size_t i)
{
    const double degrees = 180 / acos(-1);
    struct sample quad = *s;
    for (int k = 0; triangle && k < 3; k++) {
        quad.x[3][k] = s->x[2][k];
        quad.x[2][k] = s->x[1][k] + s->x[2][k] - s->x[0][k];
    }
    const struct variation v = variation_measure(segment_find("quad4"), &(struct sample_set){.s = &quad, .n = 1});
    const double u = length(quad.x[1], quad.x[2], quad.x[0], quad.x[3]),
                 w = length(quad.x[2], quad.x[3], quad.x[0], quad.x[1]);
    m[ASPECT].value[i] = fmin(100, fmax(u, w) / fmin(u, w));
    m[SKEW].value[i] = v.skew * degrees;
    m[TAPER].value[i] = fmin(10, v.taper);
    m[WARP].value[i] = v.warp * degrees;
    m[GAP].value[i] = fmin(100, fabs(s->gap) / sample_shortest_edge(s, triangle ? 3 : 4));
}

/* Sets the limits of the scene of the kind. */
static void set_limits(const struct scene *usual, struct page_measure *m)
{
    const double degrees = 180 / acos(-1);
    const struct shapes *p = &usual->shapes;
    const double limit[MEASURES] = {p->aspect, p->skew * degrees, p->taper, p->warp * degrees, p->gap};
    for (int k = 0; k < MEASURES; k++)
        m[k].limit = usual->source == SOURCE_RANDOM ? limit[k] : -1;
}

static bool write_page(const struct call *call, const struct problem *p, const struct beside *b, char *verdict,
                       struct diag *d)
{
    struct page_measure m[MEASURES] = {{.name = "aspect"},
                                       {.name = "skew, degrees"},
                                       {.name = "taper"},
                                       {.name = "warp, degrees"},
                                       {.name = "|gap| / edge"}};
    struct scene *usual = scene_of_kind(call->options->root, p->scene, d);
    struct arena memory = {NULL};
    struct page_row *row = arena_array(&memory, b->shipped->quests, sizeof *row);
    size_t rows = 0;
    if (usual)
        set_limits(usual, m);
    for (size_t i = 0; i < b->shipped->quests; i++) {
        const struct quest *own = &p->archive->quest[i], *old = &b->shipped->quest[i];
        if (!quest_of_programs(own))
            continue;
        row[rows].tier = own->own->name;
        measure_bands(b, own, old, row[rows].own);
        measure_bands(b, old, old, row[rows++].shipped);
    }
    for (int k = 0; k < MEASURES; k++) {
        m[k].n = b->table.n;
        m[k].value = arena_array(&memory, b->table.n, sizeof *m[k].value);
    }
    for (size_t i = 0; i < b->table.n; i++)
        measure_sample(&b->sample[i], p->scene->segment->triangle, m, i);
    const bool written =
        page_write(call->options->page, p->scene->name, p->scene->segment->name, verdict, row, rows, m, MEASURES, d);
    arena_free(&memory);
    scene_free(usual);
    return written;
}

bool run_verdict(const struct call *call, const struct problem *p, const struct archive *shipped,
                 const struct heldout *heldout, struct diag *d)
{
    struct beside b = {.shipped = shipped};
    if (!shipped)
        return true;
    bool good = measure_beside(&b, p->scene->norm, heldout->part[0], d);
    if (good) {
        struct memory *m = memory_open();
        if (call->options->generations > 0)
            archive_verdict(p->archive, shipped, b.judge, m->stream);
        char *verdict = memory_close(m);
        fputs(verdict, stdout);
        good = !call->options->page || b.table.n == 0 || write_page(call, p, &b, verdict, d);
        free(verdict);
    }
    objective_free(b.judge);
    columns_free(&b.table);
    free(b.sample);
    return good;
}
