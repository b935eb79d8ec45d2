/* Draws the samples of a run; see run.h. */
#include "run.h"

#include "../eval/frame.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HARDEST = 10, VALIDATED = 5 };
static const double EXACT = 16; /* errors below so many roundings are no measure of hardness */

bool run_draw_training(const struct scene *scene, struct run_samples *s, struct diag *d)
{
    if (s->training.n > 0)
        return true;
    if (!scene_samples(scene, PART_TRAINING, &s->training, d) ||
        (scene->lattice.random > 0 && !scene_samples(scene, PART_TRAINING_RANDOM, &s->training, d)))
        return false;
    s->vary = variation_measure(scene->segment, &s->training);
    s->real = s->training.real;
    return true;
}

/* Checks a column: a value that is not finite would spoil every expression with it, silently. */
static bool finite_column(const struct problem *p, const char *name, int line, size_t column, struct diag *d)
{
    const double *v = columns_at(&p->table, column);
    size_t bad = 0;
    for (size_t i = 0; i < p->table.n; i++)
        bad += isfinite(v[i]) ? 0 : 1;
    return bad == 0 || diag_at(d, p->scene->path, line, 0, "'%.64s' is not finite on %zu of %zu training samples", name,
                               bad, p->table.n);
}

static bool finite_columns(const struct problem *p, struct diag *d)
{
    for (int k = 0; k < 2; k++)
        if (!finite_column(p, frame_output[k], 0, frame_target(p->archive->program, k), d))
            return false;
    for (size_t i = 0; i < p->scene->tiers; i++) {
        const struct tier *t = &p->scene->tier[i];
        for (size_t k = 0; k < t->terminals; k++) {
            const long symbol = genome_find_symbol(p->archive->program, t->terminal[k]);
            if (symbol >= 0 && !finite_column(p, t->terminal[k], t->line, (size_t)symbol, d))
                return false;
        }
    }
    return true;
}

static struct columns table_of(const struct problem *p, const struct sample_set *set)
{
    struct columns table = frame_columns(p->archive->program, set->s, set->n);
    if (p->scene->source != SOURCE_MESH)
        return table;
    table.band = new_array(set->n, sizeof *table.band);
    for (size_t i = 0; i < set->n; i++)
        table.band[i] = (unsigned char)sample_gap_band(&set->s[i], p->scene->segment->corners);
    return table;
}

/* Returns the scene with more samples to draw; all that it owns stays the scene's. */
static struct scene larger_scene(const struct scene *scene, size_t times)
{
    struct scene larger = *scene;
    larger.training *= times;
    return larger;
}

/* Computes how hard samples are: the largest error of a shipped function, over its mean. */
static void measure_hardness(const struct problem *p, const struct archive *shipped, const struct sample *s, size_t n,
                             double *hardness)
{
    struct columns table = frame_columns(shipped->program, s, n);
    struct objective *o = objective_new(shipped->program, &table, NORM_MEAN);
    for (size_t i = 0; i < n; i++)
        hardness[i] = 0;
    for (const struct quest *q = shipped->quest; q < shipped->quest + shipped->quests; q++) {
        const struct genes *t = &q->champion.genes;
        const double mean = t->length > 0 ? objective_error(o, t, q->last, INFINITY) : 0;
        for (size_t i = 0; i < n && mean > EXACT * objective_rounding(p->scene->norm); i++)
            hardness[i] = fmax(hardness[i], fmax(o->scratch[i], o->scratch[n + i]) / mean);
    }
    objective_free(o);
    columns_free(&table);
}

/* Adds the hardest tenth of n samples, of which the first `real` are nodes of the mesh. */
static void add_hardest(const struct problem *p, const struct archive *shipped, const struct sample *s, size_t n,
                        size_t real, struct sample_set *set)
{
    double *hardness = new_array(n, sizeof *hardness), *sorted = new_array(n, sizeof *sorted);
    measure_hardness(p, shipped, s, n, hardness);
    memcpy(sorted, hardness, n * sizeof *sorted);
    gsl_sort(sorted, 1, n);
    const double least = sorted[n - 1 - (n - 1) / HARDEST];
    for (size_t i = 0; i < n; i++)
        if (hardness[i] >= least) {
            sample_set_add(set, &s[i]);
            set->real += i < real;
        }
    free(hardness);
    free(sorted);
}

/* Replaces the training samples by the hardest tenth of ten times as many. Tails decide the errors of accurate functions, and few of
 * the samples show them. */
static bool take_hardest(const struct call *call, const struct problem *p, struct run_samples *s, struct diag *d)
{
    struct archive *shipped = run_shipped(call, p);
    const struct scene larger = larger_scene(p->scene, HARDEST);
    struct sampler *sampler = shipped ? sampler_new(&larger, PART_TRAINING, d) : NULL;
    const size_t n = p->scene->training;
    struct sample *piece = new_array(n, sizeof *piece);
    bool good = sampler || !shipped;
    if (sampler)
        sample_set_free(&s->training);
    for (size_t at = 0; sampler && good && at < HARDEST * n; at += n) {
        for (size_t i = 0; i < n && good; i++)
            good = sampler_take(sampler, at + i, &piece[i], d);
        const size_t real = sampler->listed.n > at ? sampler->listed.n - at : 0;
        if (good)
            add_hardest(p, shipped, piece, n, real, &s->training);
    }
    s->real = sampler ? s->training.real : s->real;
    free(piece);
    sampler_free(sampler);
    archive_free(shipped);
    return good;
}

/* Draws samples to choose programs by, if any are bred. */
static bool draw_validation(const struct problem *p, struct columns *validation, struct diag *d)
{
    const struct scene larger = larger_scene(p->scene, p->archive->knees ? VALIDATED : 1);
    struct sample_set set = {0};
    bool programs = false, good = true;
    for (size_t i = 0; i < p->scene->tiers; i++)
        programs = programs || p->scene->tier[i].program;
    if (programs && (good = scene_samples(&larger, PART_VALIDATION, &set, d)))
        *validation = table_of(p, &set);
    sample_set_free(&set);
    return good;
}

/* Computes the table of training samples and, on rank 0, the samples that islands do not see. */
bool run_draw_samples(const struct call *call, struct problem *p, struct run_samples *s, struct diag *d)
{
    if (!run_draw_training(p->scene, s, d) || (p->archive->knees && !take_hardest(call, p, s, d)))
        return false;
    p->table = table_of(p, &s->training);
    sample_set_free(&s->training);
    if (!finite_columns(p, d))
        return false;
    const bool judged = call->options->generations > 0 || call->options->members > 0;
    return call->team->rank > 0 ||
           ((!judged || draw_validation(p, &s->validation, d)) && scene_heldout(p->scene, &s->heldout, d));
}
