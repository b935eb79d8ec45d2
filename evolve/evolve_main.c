/* footpoint-evolve: expressions for the foot point, bred on islands over MPI (the paper's pd-LinearGP).  A scene gives
 * samples and tiers, frames give the values that expressions are made of, the start file gives the champions to beat.
 * Each output of each tier has a ring of islands.  Every process reads the same files and computes the same table of
 * training samples; islands are shared out, and what they find is independent of who computes them. */
#include "archive.h"
#include "evolve_benchmark.h"
#include "evolve_options.h"
#include "frame.h"
#include "migrate.h"
#include "progress.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The output that a ring of islands searches. */
struct quest {
    size_t tier;
    int output;
};

struct run {
    const struct evolve_options *options; /* not owned */
    const struct team *team;              /* not owned */
    char start[1024], output[1024];       /* paths; start is empty where there is none */
    struct scene *scene;
    struct archive *archive;
    struct gene_set *genes;       /* one for each tier */
    struct sample_set heldout[2]; /* on rank 0 */
    struct columns table;
    struct judge *judge;
    struct plan plan;
    struct quest *quest; /* one for each ring */
    bool *seeded;        /* one for each island: started from a champion */
    struct sea sea;
};

static void genomes_path(const struct run *r, char path[1024])
{
    snprintf(path, 1024, "%.700s/evolve/genomes/%.250s.gen", r->options->root, r->scene->name);
}

static bool choose_paths(struct run *r, struct diag *d)
{
    const struct evolve_options *o = r->options;
    struct outfile probe;
    genomes_path(r, r->output);
    if (o->output)
        snprintf(r->output, sizeof r->output, "%s", o->output);
    if (o->start)
        snprintf(r->start, sizeof r->start, "%s", o->start);
    else if (!o->from_scratch)
        genomes_path(r, r->start);
    if (!o->start && access(r->start, F_OK) != 0)
        r->start[0] = '\0';
    if (r->team->rank == 0) { /* better now than after an hour */
        if (!outfile_open(&probe, r->output, d))
            return false;
        outfile_discard(&probe);
    }
    return true;
}

/* What is read: the cheap part, in which most mistakes show. */
static bool load(struct run *r, struct diag *d)
{
    r->scene = scene_read(r->options->root, r->options->scene, d);
    if (!r->scene || !choose_paths(r, d))
        return false;
    struct genome_file *program = frame_program(r->options->root, r->scene, r->output, d);
    r->archive = program ? archive_new(r->scene, program, r->start[0] ? r->start : NULL, d) : NULL;
    return r->archive != NULL;
}

static bool sample(struct run *r, struct diag *d)
{
    struct sample_set training = {0};
    if (!scene_samples(r->scene, PART_TRAINING, &training, d))
        return false;
    struct kernel *kernel = kernel_new_widest();
    r->table = frame_columns(kernel, r->archive->program, training.s, training.n);
    kernel_free(kernel);
    sample_set_free(&training);
    if (r->team->rank > 0)
        return true;
    return scene_samples(r->scene, PART_HELDOUT, &r->heldout[0], d) &&
           scene_samples(r->scene, PART_HELDOUT_RANDOM, &r->heldout[1], d);
}

static void make_plan(struct run *r)
{
    const struct evolve_options *o = r->options;
    r->plan = o->paper ? plan_paper() : plan_default();
    r->plan.seed = o->seed;
    r->plan.population = o->population;
    r->plan.selection = o->selection;
    r->plan.parsimony = o->parsimony;
    r->plan.migrants = (size_t)(o->migrate_fraction * (double)o->population + 0.5);
}

static void judge_champions(struct run *r)
{
    const enum functions f = r->options->functions;
    make_plan(r);
    r->judge = judge_new(r->archive->program, &r->table, r->scene->norm);
    r->judge->decimal = true;
    archive_judge(r->archive, &r->plan, r->judge, r->options->max_length);
    r->genes = new_array(r->scene->tiers, sizeof *r->genes);
    for (size_t i = 0; i < r->scene->tiers; i++) {
        const bool rational = f == FUNCTIONS_OF_TIER ? r->scene->tier[i].rational : f == FUNCTIONS_RATIONAL;
        r->genes[i] = archive_genes(r->archive, i, rational);
    }
}

/* Rings for all outputs; in a run of no generations for those alone that have no champion. */
static void found_islands(struct run *r)
{
    const struct evolve_options *o = r->options;
    struct sea *s = &r->sea;
    const size_t outputs = 2 * r->scene->tiers;
    r->quest = new_array(outputs, sizeof *r->quest);
    s->max_length = new_array(outputs, sizeof *s->max_length);
    s->places = o->islands;
    for (size_t i = 0; i < outputs; i++)
        if (o->generations > 0 || r->archive->champion[i / 2][i % 2].tree.length == 0) {
            r->quest[s->rings] = (struct quest){i / 2, (int)(i % 2)};
            s->max_length[s->rings++] = o->max_length ? o->max_length : r->scene->tier[i / 2].max_length;
        }
    s->owner = new_array(s->rings * s->places, sizeof *s->owner);
    s->island = new_array(s->rings * s->places, sizeof(struct island *));
    r->seeded = new_array(s->rings * s->places, sizeof *r->seeded);
    team_share(r->team, s);
}

/* The last island of a ring of several starts from random trees alone; where others have seeds, it takes no guests. */
static bool starts_at_random(const struct run *r, size_t place)
{
    return r->sea.places > 1 && place == r->sea.places - 1;
}

static void start_islands(struct run *r)
{
    struct sea *s = &r->sea;
    for (size_t i = 0; i < s->rings * s->places; i++) {
        const size_t ring = i / s->places;
        const struct quest q = r->quest[ring];
        struct tree *seed;
        const size_t seeds = archive_seeds(r->archive, q.tier, q.output, s->max_length[ring], &seed);
        const bool random = starts_at_random(r, i % s->places);
        const struct goal goal = {.target = frame_target(r->archive->program, q.output),
                                  .max_length = s->max_length[ring],
                                  .genes = &r->genes[q.tier],
                                  .ring = 2 * q.tier + (size_t)q.output,
                                  .place = i % s->places,
                                  .closed = random && seeds > 0};
        r->seeded[i] = !random && seeds > 0;
        if (s->owner[i] == r->team->rank) {
            s->island[i] = island_new(&r->plan, &goal, r->judge);
            island_start(s->island[i], seed, random ? 0 : seeds);
        }
        free(seed);
    }
}

/* "fast xi 1.2e-03 eta 1.3e-03  ..." as far as it fits.  Collective. */
static void best_so_far(const struct run *r, char text[80])
{
    const struct sea *s = &r->sea;
    double *best = new_array(s->rings, sizeof *best);
    size_t used = 0;
    for (size_t i = 0; i < s->rings; i++) {
        const struct champion *c = &r->archive->champion[r->quest[i].tier][r->quest[i].output];
        best[i] = c->tree.length > 0 ? c->error : INFINITY;
        for (size_t k = 0; k < s->places; k++)
            if (s->island[i * s->places + k])
                best[i] = fmin(best[i], island_best(s->island[i * s->places + k])->error);
    }
    team_minimum(r->team, best, s->rings);
    text[0] = '\0';
    for (size_t i = 0; i < s->rings && used < 60; i++) {
        const struct quest q = r->quest[i];
        const bool first = i == 0 || q.tier != r->quest[i - 1].tier;
        used += (size_t)snprintf(text + used, 80 - used, "%s%.8s %s %.1e", first && i > 0 ? "  " : "",
                                 first ? r->scene->tier[q.tier].name : "", frame_output[q.output], best[i]);
    }
    free(best);
}

static void evolve(struct run *r)
{
    const struct evolve_options *o = r->options;
    const struct sea *s = &r->sea;
    struct progress progress = progress_start(r->team->rank == 0 && !o->quiet, o->generations);
    char best[80];
    for (size_t generation = 0; generation < o->generations;) {
        const size_t left = o->generations - generation, steps = left < o->migrate_every ? left : o->migrate_every;
        for (size_t i = 0; i < s->rings * s->places; i++)
            for (size_t k = 0; s->island[i] && k < steps; k++)
                island_step(s->island[i]);
        generation += steps;
        if (generation < o->generations)
            team_migrate(r->team, &r->sea, r->plan.migrants);
        best_so_far(r, best);
        progress_show(&progress, generation, best, team_sum(r->team, kernel_work(r->judge->kernel)));
    }
}

/* The fronts of all islands, judged and merged in their order, and the champions chosen from them, on rank 0.
 * Collective. */
static void harvest(struct run *r)
{
    int **report = team_gather(r->team, &r->sea);
    for (size_t i = 0; report && i < r->sea.rings * r->sea.places; i++) {
        const struct quest q = r->quest[i / r->sea.places];
        const int *at = report[i] + 1;
        double lowest = INFINITY;
        for (int k = 0; k < report[i][0]; k++, at += 1 + at[0]) {
            const struct tree t = {(int *)at + 1, (size_t)at[0]};
            const double error = judge_error(r->judge, &t, frame_target(r->archive->program, q.output), INFINITY);
            archive_offer(r->archive, &r->plan, q.tier, q.output, &t, error,
                          r->seeded[i] ? ORIGIN_SEEDED : ORIGIN_RANDOM);
            lowest = fmin(lowest, error);
        }
        if (!r->options->quiet)
            fprintf(stderr, "island %zu of %s %s (%s): %d on the front, lowest error %.3e\n", i % r->sea.places,
                    r->scene->tier[q.tier].name, frame_output[q.output], r->seeded[i] ? "seeded" : "random",
                    report[i][0], lowest);
        free(report[i]);
    }
    if (report)
        archive_crown(r->archive, &r->plan);
    free(report);
}

static bool finish(struct run *r, struct diag *d)
{
    const struct evolve_options *o = r->options;
    const struct run_facts facts = {o->seed, o->generations, o->islands};
    if (r->team->rank > 0)
        return true;
    if (!archive_write(r->archive, r->output, &facts, r->heldout, d))
        return false;
    archive_table(r->archive, stdout);
    if (o->generations > 0)
        archive_front_table(r->archive, stdout);
    return fflush(stdout) == 0 || diag_system(d, "standard output", "cannot write");
}

static void run_free(struct run *r)
{
    for (size_t i = 0; i < r->sea.rings * r->sea.places; i++)
        island_free(r->sea.island[i]);
    for (size_t i = 0; r->genes && i < r->scene->tiers; i++)
        gene_set_free(&r->genes[i]);
    free(r->genes);
    free(r->sea.island);
    free(r->sea.owner);
    free(r->sea.max_length);
    free(r->quest);
    free(r->seeded);
    judge_free(r->judge);
    columns_free(&r->table);
    sample_set_free(&r->heldout[0]);
    sample_set_free(&r->heldout[1]);
    archive_free(r->archive);
    scene_free(r->scene);
}

/* Collective, as all its steps are: the ranks agree before any of them goes on. */
static bool run_evolution(const struct evolve_options *o, const struct team *team, struct diag *d)
{
    struct run r = {.options = o, .team = team};
    bool good = team_agree(team, load(&r, d), d) && team_agree(team, sample(&r, d), d);
    if (good) {
        judge_champions(&r);
        found_islands(&r);
        start_islands(&r);
        evolve(&r);
        harvest(&r);
        good = team_agree(team, finish(&r, d), d);
    }
    run_free(&r);
    return good;
}

int main(int argc, char **argv)
{
    struct evolve_options o;
    struct diag d = {.code = EXIT_DONE};
    if (MPI_Init(&argc, &argv) != MPI_SUCCESS)
        return EXIT_SYSTEM;
    struct team team = team_new(MPI_COMM_WORLD);
    if (evolve_options_read(argc, argv, &o, &d)) {
        if (o.action == ACTION_EVOLVE)
            run_evolution(&o, &team, &d);
        else if (team.rank == 0 && o.action == ACTION_BENCHMARK)
            evolve_benchmark(stdout);
        else if (team.rank == 0 && o.action == ACTION_HELP)
            fputs(evolve_help, stdout);
        else if (team.rank == 0)
            printf("footpoint-evolve %s\n", FOOTPOINT_VERSION);
    }
    if (team.rank == 0 && d.code != EXIT_DONE)
        fprintf(stderr, "%s\n", d.text);
    team_free(&team);
    MPI_Finalize();
    return (int)d.code;
}
