/* A run of footpoint-evolve; see run.h.  Every process reads the same files and computes the same table of
 * training samples; islands are shared out, and what they find is independent of who computes them. */
#include "run.h"

#include "../common/data_root.h"
#include "../eval/frame.h"
#include "../eval/frame_cost.h"
#include "../input/scene_files.h"
#include "../samples/default_tiers.h"
#include "../samples/samples.h"
#include "generations.h"
#include "progress.h"
#include "seeding.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void genomes_path(const struct run *r, char path[1024])
{
    snprintf(path, 1024, "%.700s/evolve/genomes/%.250s.gen", r->options->root, r->scene->name);
}

static bool choose_paths(struct run *r, struct diag *d)
{
    const struct evolve_options *o = r->options;
    if (root_is_installed(o->root))
        snprintf(r->output, sizeof r->output, "%.250s.gen", r->scene->name);
    else
        genomes_path(r, r->output);
    if (o->output)
        snprintf(r->output, sizeof r->output, "%s", o->output);
    if (r->resume)
        return !*r->resume->start || resume_start_file(r->resume, r->start, sizeof r->start, d);
    if (o->start)
        snprintf(r->start, sizeof r->start, "%s", o->start);
    else if (!o->from_scratch)
        genomes_path(r, r->start);
    if (!o->start && access(r->start, F_OK) != 0)
        r->start[0] = '\0';
    return true;
}

/* The start file as checkpoints hold it. */
static bool keep_start(struct run *r, struct diag *d)
{
    r->start_text = r->start[0] ? read_text(r->start, &r->start_bytes, d) : new_text("", 0);
    return r->start_text != NULL;
}

static bool load_archive(struct run *r, struct diag *d)
{
    struct genome_file *program = frame_program(r->options->root, r->scene, r->output, d);
    r->archive = program ? archive_new(r->scene, program, r->start[0] ? r->start : NULL, d) : NULL;
    return r->archive && (!r->options->seeds || archive_read_seeds(r->archive, r->options->seeds, d));
}

static bool draw_training(struct run *r, struct diag *d)
{
    if (r->training.n > 0)
        return true;
    if (!scene_samples(r->scene, PART_TRAINING, &r->training, d))
        return false;
    r->vary = vary_measure(r->scene->segment, &r->training);
    return true;
}

/* A scene without tiers takes those that suit its segments. */
static bool complete_scene(struct run *r, struct diag *d)
{
    if (r->scene->tiers > 0)
        return true;
    if (!draw_training(r, d) || !scene_follow(r->options->root, r->scene, r->vary.kind, d))
        return false;
    r->follows = true;
    return true;
}

/* A run may go on with its start file and its checkpoint; apart from that, what it writes is nothing that it reads. */
static bool files_suit(const struct run *r, struct diag *d)
{
    enum { NONE, GENOMES, CHECKPOINTS };
    const struct evolve_options *o = r->options;
    const struct file_use file[] = {{"--output", r->output, true, GENOMES},
                                    {"--start", r->resume || !*r->start ? NULL : r->start, false, GENOMES},
                                    {"--checkpoint", o->checkpoint, true, CHECKPOINTS},
                                    {"--resume", o->resume, false, CHECKPOINTS},
                                    {"--front", o->front, true, NONE},
                                    {"--log", o->log, true, NONE},
                                    {"--seeds", o->seeds, false, NONE}};
    return scene_files_apart("footpoint-evolve", o->root, r->scene, file, sizeof file / sizeof *file, d) &&
           outfile_probe(r->output, d) && outfile_probe(o->checkpoint, d) && outfile_probe(o->front, d);
}

/* What is read: the cheap part, in which most mistakes show. */
static bool load(struct run *r, struct diag *d)
{
    const struct evolve_options *o = r->options;
    r->scene = scene_read(o->root, o->scene, d);
    if (!r->scene || (r->resume && !resume_suits(r->resume, r->scene->sha256, o->generations, d)) ||
        !choose_paths(r, d))
        return false;
    const bool first = r->team->rank == 0;
    if (first && r->scene->warnings)
        fputs(r->scene->warnings, stderr);
    const bool good = complete_scene(r, d) && (!first || (files_suit(r, d) && keep_start(r, d))) && load_archive(r, d);
    if (r->resume && r->start[0])
        unlink(r->start);
    return good;
}

/* A value without a number somewhere would make every expression with it hopeless, without a word. */
static bool finite_column(const struct run *r, const char *name, int line, size_t column, struct diag *d)
{
    const double *v = columns_at(&r->table, column);
    size_t bad = 0;
    for (size_t i = 0; i < r->table.n; i++)
        bad += isfinite(v[i]) ? 0 : 1;
    return bad == 0 || diag_at(d, r->scene->path, line, 0, "'%.64s' is not finite on %zu of %zu training samples", name,
                               bad, r->table.n);
}

static bool finite_columns(const struct run *r, struct diag *d)
{
    for (int k = 0; k < 2; k++)
        if (!finite_column(r, frame_output[k], 0, frame_target(r->archive->program, k), d))
            return false;
    for (size_t i = 0; i < r->scene->tiers; i++) {
        const struct tier *t = &r->scene->tier[i];
        for (size_t k = 0; k < t->terminals; k++) {
            const long symbol = genome_find_symbol(r->archive->program, t->terminal[k]);
            if (symbol >= 0 && !finite_column(r, t->terminal[k], t->line, (size_t)symbol, d))
                return false;
        }
    }
    return true;
}

static bool sample(struct run *r, struct diag *d)
{
    if (!draw_training(r, d))
        return false;
    struct kernel *kernel = kernel_new_widest();
    r->table = frame_columns(kernel, r->archive->program, r->training.s, r->training.n);
    kernel_free(kernel);
    sample_set_free(&r->training);
    if (!finite_columns(r, d))
        return false;
    if (r->team->rank > 0)
        return true;
    return scene_heldout(r->scene, &r->heldout, d);
}

/* A front keeps what costs no more than its limit: where a value of a frame is dearer, the limit is raised. */
static size_t front_limit(const struct run *r)
{
    enum { SPARE = 128 };
    const struct genome_file *program = r->archive->program;
    struct frame_cost *f = frame_cost_new(program, &r->plan.prices);
    double dearest = 0;
    for (size_t i = 0; i < r->scene->tiers; i++)
        for (size_t k = 0; k < r->scene->tier[i].terminals; k++) {
            int gene = GENE_SYMBOL + (int)genome_find_symbol(program, r->scene->tier[i].terminal[k]);
            const struct tree t = {&gene, 1};
            dearest = fmax(dearest, frame_cost_of(f, &t));
        }
    frame_cost_free(f);
    return dearest > (double)r->plan.front_limit ? (size_t)dearest + SPARE : r->plan.front_limit;
}

static void make_plan(struct run *r)
{
    const struct evolve_options *o = r->options;
    r->plan = o->breeding == BREED_PAPER ? plan_paper() : plan_default();
    r->plan.seed = o->seed;
    r->plan.population = o->population;
    r->plan.selection = o->selection;
    r->plan.parsimony = o->parsimony;
    r->plan.prices = o->cost == COST_PAPER ? (struct prices){.add = 0, .div = 1} : (struct prices){.add = 1, .div = 8};
    r->plan.migrants = (size_t)(o->migrate_fraction * (double)o->population + 0.5);
    r->plan.front_limit = front_limit(r);
}

/* The tiers whose expressions are chosen, those apart that are exact and named already. */
static void tell_chosen(const struct run *r)
{
    size_t told = 0;
    for (size_t i = 0; i < r->scene->tiers; i++)
        if (run_chooses(r, i) && !archive_is_exact(r->archive, i)) {
            if (told++ == 0)
                printf("%s: nothing to evolve for", r->scene->name);
            printf(" %s", r->scene->tier[i].name);
        }
    if (told > 0)
        printf(": one gene, chosen among the frame's values\n");
}

/* Which inputs the scene varies, and what follows from that.  A run that is resumed has said it before. */
static void tell_segments(const struct run *r)
{
    if (r->team->rank > 0 || r->resume)
        return;
    printf("%s: ", r->scene->name);
    if (r->scene->segment->surface)
        printf("segments are %s", r->scene->segment->name);
    else
        vary_print(&r->vary, stdout);
    if (r->follows)
        printf(", frame %s", r->scene->tier[0].frame);
    archive_print_exact(r->archive, stdout);
    tell_chosen(r);
    fflush(stdout);
}

/* Judge, genes, seeds and the fronts that they found. */
static void judge_champions(struct run *r)
{
    const enum functions f = r->options->functions;
    make_plan(r);
    r->judge = judge_new(r->archive->program, &r->table, r->scene->norm);
    r->judge->decimal = true;
    r->fits = fits_new(r->judge);
    r->hooks = fits_hooks(r->fits);
    r->genes = new_array(r->scene->tiers, sizeof *r->genes);
    for (size_t i = 0; i < r->scene->tiers; i++) {
        const bool rational = f == FUNCTIONS_OF_TIER ? r->scene->tier[i].rational : f == FUNCTIONS_RATIONAL;
        r->genes[i] = archive_genes(r->archive, i, rational);
    }
    archive_find_exact(r->archive, &r->plan, &r->table, r->vary.tolerance);
    tell_segments(r);
    for (size_t i = 0; i < r->scene->tiers; i++)
        if (run_chooses(r, i))
            archive_choose_values(r->archive, i, r->options->generations > 0);
    if (r->options->generations > 0 && r->options->growth == GROWTH_YES && !r->resume)
        evolve_grow(r);
    archive_judge(r->archive, &r->plan, r->judge, r->options->max_length);
}

static bool needs_ring(const struct run *r, size_t tier, const struct champion *c)
{
    return c->exact == 0 && !run_chooses(r, tier) && (r->options->generations > 0 || c->tree.length == 0);
}

/* Rings for all outputs that are neither exact nor chosen; in a run of no generations for those alone that have no
 * champion. */
static void found_rings(struct run *r)
{
    const struct evolve_options *o = r->options;
    struct sea *s = &r->sea;
    const size_t outputs = TIER_OUTPUTS * r->scene->tiers;
    r->quest = new_array(outputs, sizeof *r->quest);
    s->max_length = new_array(outputs, sizeof *s->max_length);
    s->places = o->islands;
    for (size_t i = 0; i < outputs; i++) {
        const struct quest q = {i / TIER_OUTPUTS, (int)(i % TIER_OUTPUTS)};
        const struct tier *t = &r->scene->tier[q.tier];
        if (q.output >= tier_first(t) && q.output <= tier_last(t) &&
            needs_ring(r, q.tier, &r->archive->champion[q.tier][q.output])) {
            r->quest[s->rings] = q;
            s->max_length[s->rings++] = run_max_length(r, q.tier);
        }
    }
    s->owner = new_array(s->rings * s->places, sizeof *s->owner);
    s->island = new_array(s->rings * s->places, sizeof(struct island *));
    r->seeded = new_array(s->rings * s->places, sizeof *r->seeded);
    team_share(r->team, s);
}

/* The last island of a ring of several starts from random trees alone, and in front breeding takes no guests. */
static bool starts_at_random(const struct run *r, size_t place)
{
    return r->sea.places > 1 && place == r->sea.places - 1;
}

size_t run_max_length(const struct run *r, size_t tier)
{
    return r->options->max_length ? r->options->max_length : r->scene->tier[tier].max_length;
}

bool run_chooses(const struct run *r, size_t tier)
{
    return !r->scene->tier[tier].twin && run_max_length(r, tier) == 1;
}

size_t run_ring(const struct run *r, size_t ring)
{
    return 2 * r->quest[ring].tier + (size_t)(r->quest[ring].output % TIER_BOTH);
}

static void found_islands(struct run *r)
{
    struct sea *s = &r->sea;
    for (size_t i = 0; i < sea_islands(s); i++) {
        const size_t ring = i / s->places;
        const struct quest q = r->quest[ring];
        struct tree *seed;
        const size_t seeds = archive_seeds(r->archive, q.tier, q.output, s->max_length[ring], &seed);
        const bool random = starts_at_random(r, i % s->places);
        const struct goal goal = {.target = frame_target(r->archive->program, q.output),
                                  .max_length = s->max_length[ring],
                                  .genes = &r->genes[q.tier],
                                  .ring = run_ring(r, ring),
                                  .place = i % s->places,
                                  .fit = &r->hooks,
                                  .closed = random && r->plan.breeding == BREED_FRONT};
        r->seeded[i] = !random && (seeds > 0 || r->options->growth == GROWTH_YES);
        if (s->owner[i] == r->team->rank) {
            s->island[i] = island_new(&r->plan, &goal, r->judge);
            if (!r->resume)
                island_start(s->island[i], seed, random ? 0 : seeds);
        }
        free(seed);
    }
}

/* A message has at most INT_MAX bytes. */
static bool fits_messages(const struct run *r, struct diag *d)
{
    for (size_t i = 0; i < sea_islands(&r->sea); i++) {
        const struct island *is = r->sea.island[i];
        if (is && (island_parcel_size(is, r->plan.migrants) > INT_MAX / sizeof(int) ||
                   (r->options->checkpoint && island_state_size(is) > INT_MAX))) {
            diag_at(d, "footpoint-evolve", 0, 0, "--population %zu is too large to be sent", r->options->population);
            d->code = EXIT_USAGE;
            return false;
        }
    }
    return true;
}

static bool settle(struct run *r, struct diag *d)
{
    found_rings(r);
    if (!team_agree(r->team, team_can_tag(r->team, sea_islands(&r->sea), d), d))
        return false;
    found_islands(r);
    if (!team_agree(r->team, fits_messages(r, d), d))
        return false;
    r->generation = r->resume ? r->resume->generation : 0;
    return !r->resume || resume_islands(r->resume, r->team, &r->sea, d);
}

static void say(const struct run *r, const char *phase)
{
    progress_phase(r->team->rank == 0 && !r->options->quiet, phase);
}

/* The fronts of all islands, judged and merged in their order, and the champions chosen from them, on rank 0.
 * Collective. */
static void harvest(struct run *r)
{
    struct finds f = team_gather(r->team, &r->sea);
    size_t members = 0;
    double lowest = INFINITY;
    for (size_t i = 0; i < f.finds; i++) {
        const size_t island = f.find[i].island;
        const struct tree *t = &f.find[i].tree;
        const struct quest q = r->quest[island / r->sea.places];
        const double error = judge_error(r->judge, t, frame_target(r->archive->program, q.output), INFINITY);
        archive_offer(r->archive, &r->plan, q.tier, q.output, t, error,
                      r->seeded[island] ? ORIGIN_SEEDED : ORIGIN_RANDOM);
        members++;
        lowest = fmin(lowest, error);
        if (i + 1 < f.finds && f.find[i + 1].island == island)
            continue;
        if (!r->options->quiet)
            fprintf(stderr, "island %zu of %s %s (%s): %zu on its front, lowest error %.3e\n", island % r->sea.places,
                    r->scene->tier[q.tier].name, frame_output[q.output], r->seeded[island] ? "seeded" : "random",
                    members, lowest);
        members = 0;
        lowest = INFINITY;
    }
    if (r->team->rank == 0)
        archive_crown(r->archive, &r->plan);
    finds_free(&f);
}

static bool finish(struct run *r, struct diag *d)
{
    const struct evolve_options *o = r->options;
    const struct run_facts facts = {o->seed, r->generation, o->islands};
    if (r->team->rank > 0)
        return true;
    const bool saved = o->checkpoint && !r->unsaved && r->generation > 0; /* growth has no checkpoints */
    if (r->reason != STOP_DONE)
        fprintf(stderr, "%s: ended at generation %zu of %zu%s%s\n", stop_name(r->reason), r->generation, o->generations,
                saved ? "; go on with --resume " : "", saved ? o->checkpoint : "");
    say(r, "measuring on samples held out ...");
    const bool written = archive_write(r->archive, r->output, &facts, &r->heldout, d);
    const bool fronts = written && (!o->front || archive_write_front(r->archive, o->front, &r->heldout, d));
    say(r, "");
    if (!fronts)
        return false;
    archive_table(r->archive, stdout);
    if (o->generations > 0)
        archive_front_table(r->archive, stdout);
    if (fflush(stdout) != 0)
        return diag_system(d, "standard output", "cannot write");
    *d = (struct diag){.code = r->unsaved ? EXIT_SYSTEM : EXIT_DONE}; /* said already when it happened */
    return !r->unsaved;
}

static void run_free(struct run *r)
{
    for (size_t i = 0; i < sea_islands(&r->sea); i++)
        island_free(r->sea.island[i]);
    for (size_t i = 0; r->genes && i < r->scene->tiers; i++)
        gene_set_free(&r->genes[i]);
    free(r->genes);
    free(r->sea.island);
    free(r->sea.owner);
    free(r->sea.max_length);
    free(r->quest);
    free(r->seeded);
    free(r->start_text);
    fits_free(r->fits);
    judge_free(r->judge);
    columns_free(&r->table);
    sample_set_free(&r->training);
    heldout_free(&r->heldout);
    archive_free(r->archive);
    scene_free(r->scene);
}

bool run_evolution(const struct evolve_options *o, const struct team *team, const struct resume *resume, double begun,
                   int *status, struct diag *d)
{
    struct run r = {.options = o, .team = team, .resume = resume, .begun = begun};
    /* The ranks agree before any of them goes on. */
    bool good = team_agree(team, load(&r, d), d);
    if (good) {
        say(&r, "drawing samples ...");
        good = team_agree(team, sample(&r, d), d);
        say(&r, "");
    }
    if (good) {
        judge_champions(&r);
        good = settle(&r, d) && evolve_islands(&r, d);
    }
    if (good) {
        harvest(&r);
        good = team_agree(team, finish(&r, d), d);
    }
    *status = stop_status(r.reason);
    run_free(&r);
    return good;
}
