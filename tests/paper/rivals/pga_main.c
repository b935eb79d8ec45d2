/* footpoint-pga: the paper's genetic algorithm on polynomials, over MPI.  Every process reads the scene and holds the
 * table of monomials; rank 0 breeds, and the polynomials of a generation are fitted and measured by all ranks. */
#include "../../../codegen/base/console.h"
#include "../../../evolve/eval/frame.h"
#include "../../../evolve/input/scene_files.h"
#include "../../../evolve/mpi/team.h"
#include "../../../evolve/samples/samples.h"
#include "pga_terms.h"
#include "pga_write.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HELDOUT_STORED = 200000 }; /* samples of a part at most */

struct pga {
    const struct pga_options *options;
    const struct team *team;
    struct scene *scene;
    const struct tier *tier; /* not owned */
    struct genome_file *program;
    struct columns table;
    struct sample_set heldout[2]; /* on rank 0 */
    struct objective *objective;
    FILE *log; /* not owned; or NULL */
};

static bool choose_tier(struct pga *s, struct diag *d)
{
    const char *name = s->options->tier;
    if (s->scene->tiers == 0)
        return diag_at(d, s->scene->path, 0, 0, "no tiers; this program needs a scene that names them");
    for (size_t i = 0; i < s->scene->tiers && !s->tier; i++)
        if (!name || strcmp(name, s->scene->tier[i].name) == 0)
            s->tier = &s->scene->tier[i];
    return s->tier || diag_at(d, s->scene->path, 0, 0, "no tier '%.64s'", name);
}

/* Checks before the search that files can be written and are not read. */
static bool files_suit(const struct pga *s, struct diag *d)
{
    const struct pga_options *o = s->options;
    const struct file_use file[] = {
        {"--output", o->output, true, 0}, {"--log", o->log, true, 0}, {"--terms", o->terms, false, 0}};
    return s->team->rank > 0 || (scene_files_apart("footpoint-pga", o->root, s->scene, file, 3, d) &&
                                 outfile_probe(o->output, d) && outfile_probe(o->log, d));
}

static bool load(struct pga *s, struct diag *d)
{
    const struct pga_options *o = s->options;
    struct sample_set training = {0};
    s->scene = scene_read(o->root, o->scene, d);
    if (!s->scene || !choose_tier(s, d) || !files_suit(s, d) ||
        !(s->program = frame_program(o->root, s->scene, o->output, d)) ||
        !scene_samples(s->scene, PART_TRAINING, &training, d))
        return false;
    if (s->scene->heldout > HELDOUT_STORED)
        s->scene->heldout = HELDOUT_STORED;
    s->table = frame_columns(s->program, training.s, training.n);
    sample_set_free(&training);
    s->objective = objective_new(s->program, &s->table, o->coefficients == COEFFICIENTS_WORST ? NORM_MAX : NORM_MEAN);
    s->objective->decimal = true;
    return s->team->rank > 0 || (scene_samples(s->scene, PART_HELDOUT, &s->heldout[0], d) &&
                                 scene_samples(s->scene, PART_HELDOUT_RANDOM, &s->heldout[1], d));
}

/* ---- shared evaluation ---- */

struct share {
    const struct team *team;
    const struct polynomials *polynomials;
};

/* Returns a copy of rank `from`'s n numbers on all ranks, owned by the caller. *n and number matter on that rank only.
 * Collective. */
static int *team_pass(const struct team *t, int from, const int *number, size_t *n)
{
    unsigned long long count = *n;
    CHECK(MPI_Bcast(&count, 1, MPI_UNSIGNED_LONG_LONG, from, t->comm));
    int *copy = new_array((size_t)count, sizeof *copy);
    if (t->rank == from && count > 0)
        memcpy(copy, number, (size_t)count * sizeof *copy);
    CHECK(MPI_Bcast(copy, (int)count, MPI_INT, from, t->comm));
    *n = (size_t)count;
    return copy;
}

/* Collects in rank 0's array each number[i], i < n, from rank i mod size. Other ranks' arrays do not change. No number may
 * be -0. Collective. */
static void team_collect(const struct team *t, double *number, size_t n)
{
    double *own = new_array(n, sizeof *own);
    for (size_t i = (size_t)t->rank; i < n; i += (size_t)t->size)
        own[i] = number[i];
    CHECK(MPI_Reduce(own, number, (int)n, MPI_DOUBLE, MPI_SUM, 0, t->comm));
    free(own);
}

/* Evaluates this rank's part of n choices: each size-th. */
static void evaluate_share(const struct share *w, const gene_bit *chosen, size_t n, double *error)
{
    const size_t genes = w->polynomials->count, first = (size_t)w->team->rank, stride = (size_t)w->team->size;
    const size_t own = n > first ? (n - first + stride - 1) / stride : 0;
    gene_bit *part = new_array(own * genes, sizeof *part);
    double *found = new_array(own, sizeof *found);
    for (size_t i = 0; i < own; i++)
        memcpy(part + i * genes, chosen + (first + i * stride) * genes, genes * sizeof *part);
    polynomials_errors(w->polynomials, part, own, found);
    for (size_t i = 0; i < own; i++)
        error[first + i * stride] = found[i];
    free(part);
    free(found);
}

/* Computes errors, on rank 0, called by the algorithm; serve() is the other ranks' side. */
static void server_errors(void *context, const gene_bit *chosen, size_t n, double *error)
{
    const struct share *w = context;
    if (n == 0)
        return;
    size_t genes = n * w->polynomials->count;
    free(team_pass(w->team, 0, chosen, &genes));
    evaluate_share(w, chosen, n, error);
    team_collect(w->team, error, n);
}

/* Serves until rank 0 passes nothing. */
static void serve(const struct share *w, size_t population)
{
    double *error = new_array(population, sizeof *error);
    size_t n;
    for (;;) {
        gene_bit *chosen = team_pass(w->team, 0, NULL, &n);
        if (n > 0) {
            evaluate_share(w, chosen, n / w->polynomials->count, error);
            team_collect(w->team, error, n / w->polynomials->count);
        }
        free(chosen);
        if (n == 0)
            break;
    }
    free(error);
}

static void log_line(const struct pga *s, size_t limit, int k, const struct pga_state *state)
{
    if (s->log)
        fprintf(s->log, "%zu,%s,%zu,%zu,%zu,%zu,%.6e,%.6e\n", limit, frame_output[k], state->generation,
                state->evaluations, state->singular, state->terms, state->error, state->median);
}

/* Takes terms given by hand instead of a search. */
static bool take_terms(const struct pga *s, const struct polynomials *p, int k, struct pga_find *find, struct diag *d)
{
    gene_bit *chosen = new_array(p->count, sizeof *chosen);
    const struct pga_state state = {.best = chosen};
    const bool good = pga_terms_read(s->options->terms, frame_output[k], s->program, p, chosen, d);
    if (good && !pga_find_new(p, &state, s->objective, frame_target(s->program, k), s->options->coefficients, find))
        find->error = INFINITY;
    free(chosen);
    return good;
}

/* Runs a search, on rank 0. */
static void breed(const struct pga *s, size_t limit, struct share *w, int k, struct pga_find *find)
{
    const struct pga_options *o = s->options;
    const size_t count = w->polynomials->count;
    struct pga_plan plan = o->plan;
    plan.stream = (uint64_t)(2 * limit) + (uint64_t)k;
    plan.terms = limit == 0 || limit > count ? count : limit;
    const struct pga_evaluator evaluator = {w, server_errors};
    struct pga *g = pga_new(&plan, w->polynomials, &evaluator);
    struct pga_state state = pga_look(g);
    const double begun = seconds_now();
    for (log_line(s, limit, k, &state); state.generation < o->generations; log_line(s, limit, k, &state)) {
        pga_step(g);
        state = pga_look(g);
    }
    if (!o->quiet)
        fprintf(stderr, "%s: %zu generations of %zu in %.3f s, %zu terms, mean error %.4e\n", frame_output[k],
                o->generations, plan.population, seconds_now() - begun, state.terms, state.error);
    if (!pga_find_new(w->polynomials, &state, s->objective, frame_target(s->program, k), o->coefficients, find))
        find->error = INFINITY;
    pga_free(g);
}

/* Runs the searches for an output, on rank 0. */
static bool search_all(const struct pga *s, struct share *w, int k, struct pga_find (*find)[2], struct diag *d)
{
    const struct pga_options *o = s->options;
    bool good = true;
    for (size_t i = 0; good && i < o->limits; i++) {
        if (o->terms)
            good = take_terms(s, w->polynomials, k, &find[i][k], d);
        else
            breed(s, o->limit[i], w, k, &find[i][k]);
        if (good && !(find[i][k].error < INFINITY))
            good =
                diag_at(d, s->scene->path, 0, 0, "no polynomial in '%s' is independent on the samples", s->tier->name);
    }
    size_t none = 0;
    free(team_pass(w->team, 0, NULL, &none));
    return good;
}

/* Collective. */
static bool search_output(const struct pga *s, int k, struct pga_find (*find)[2], struct diag *d)
{
    const struct pga_options *o = s->options;
    int *symbol = new_array(s->tier->terminals, sizeof *symbol);
    for (size_t i = 0; i < s->tier->terminals; i++)
        symbol[i] = GENE_SYMBOL + (int)genome_find_symbol(s->program, s->tier->terminal[i]);
    struct polynomials *p =
        polynomials_new(symbol, s->tier->terminals, o->order, &s->table, frame_target(s->program, k));
    struct share w = {s->team, p};
    bool good = true;
    if (s->team->rank == 0)
        good = search_all(s, &w, k, find, d);
    else
        serve(&w, o->plan.population);
    polynomials_free(p);
    free(symbol);
    return team_agree(s->team, good, d);
}

static bool open_log(struct pga *s, struct outfile *log, struct diag *d)
{
    if (s->team->rank > 0 || !s->options->log)
        return true;
    if (!outfile_open(log, s->options->log, d))
        return false;
    s->log = log->stream;
    fputs("restrict,output,generation,evaluations,singular,terms,error,median_fitness\n", s->log);
    return true;
}

static void print_finds(const struct pga_options *o, struct pga_find (*find)[2])
{
    for (size_t i = 0; i < o->limits; i++)
        for (int k = 0; k < 2; k++) {
            const struct pga_find *f = &find[i][k];
            printf("restrict %zu %-4s terms %zu error %.4e condition %.1e singular %zu of %zu\n", o->limit[i],
                   frame_output[k], f->terms, f->error, f->condition, f->singular, f->evaluations);
        }
}

/* Collective. */
static bool search_and_write(struct pga *s, struct diag *d)
{
    struct pga_find(*find)[2] = new_array(s->options->limits, sizeof *find);
    struct outfile log;
    bool good = team_agree(s->team, open_log(s, &log, d), d);
    for (int k = 0; good && k < 2; k++)
        good = search_output(s, k, find, d);
    if (good && s->team->rank == 0)
        good = pga_write(s->options, s->scene, s->program, find, s->heldout, d);
    if (s->log && !good)
        outfile_discard(&log);
    else if (s->log)
        good = outfile_commit(&log, d);
    if (good && s->team->rank == 0)
        print_finds(s->options, find);
    for (size_t i = 0; i < s->options->limits; i++)
        for (int k = 0; k < 2; k++)
            pga_find_free(&find[i][k]);
    free(find);
    return good;
}

static bool run(struct pga *s, struct diag *d)
{
    const bool good = team_agree(s->team, load(s, d), d) && search_and_write(s, d);
    for (int k = 0; k < 2; k++)
        sample_set_free(&s->heldout[k]);
    objective_free(s->objective);
    columns_free(&s->table);
    genome_file_free(s->program);
    scene_free(s->scene);
    return good;
}

int main(int argc, char **argv)
{
    struct pga_options o;
    struct diag d = {.code = EXIT_DONE};
    if (MPI_Init(&argc, &argv) != MPI_SUCCESS)
        return EXIT_SYSTEM;
    struct team team = team_new(MPI_COMM_WORLD);
    struct pga pga = {.options = &o, .team = &team};
    const enum options_outcome outcome = pga_options_read(argc, argv, &o, &d);
    bool good = outcome != OPTIONS_WRONG;
    if (outcome == OPTIONS_READ)
        good = run(&pga, &d);
    else if (good && team.rank == 0)
        options_tell(&pga_option_table, outcome);
    good = good && (team.rank > 0 || stdout_written(&d));
    if (team.rank == 0 && !good)
        fprintf(stderr, "%s\n", d.text);
    team_free(&team);
    MPI_Finalize();
    return good ? EXIT_DONE : (int)d.code;
}
