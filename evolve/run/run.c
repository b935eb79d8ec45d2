/* Runs footpoint-evolve; see run.h.  Every process reads the same files and computes the same table of training samples.  Islands are
 * shared among the processes, and their results do not depend on this. */
#include "run.h"

#include "../../codegen/base/text.h"
#include "../eval/frame.h"
#include "../eval/frame_cost.h"
#include "../fit/compose.h"
#include "../samples/default_tiers.h"
#include "../write/archive_write.h"
#include "progress.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct run {
    struct call call;
    struct run_files files;
    struct problem problem;
    struct run_samples samples;
    struct islands islands;
    struct outcome outcome;
};

/* Computes the digest of the values to which genes refer, and of the tiers, which may come from another scene. */
static void digest_frames(const struct problem *p, char sha256[65])
{
    struct memory *m = memory_open();
    fputs(p->archive->bare, m->stream);
    for (size_t i = 0; i < p->scene->tiers; i++) {
        const struct tier *t = &p->scene->tier[i];
        fprintf(m->stream, "%s %s %zu %.17g %d %s\n", t->name, t->frame, t->max_length, t->budget, t->rational,
                t->last ? t->last : "-");
        for (size_t k = 0; k < t->terminals; k++)
            fprintf(m->stream, " %s", t->terminal[k]);
        for (size_t k = 0; k < t->functions; k++)
            fprintf(m->stream, " %s", t->function[k]);
        for (size_t k = 0; k < t->starts; k++)
            fprintf(m->stream, " %s %s", t->start[k][0], t->start[k][1]);
    }
    char *text = memory_close(m);
    sha256_hex(text, strlen(text), sha256);
    free(text);
}

static bool load_archive(const struct evolve_options *o, const struct run_files *f, struct problem *p, struct diag *d)
{
    struct genome_file *program = frame_program(o->root, p->scene, f->output, d);
    p->archive = program ? archive_new(p->scene, program, f->start[0] ? f->start : NULL, f->shipped, d) : NULL;
    return p->archive && archive_check_starts(p->archive, d) &&
           (!o->seeds || archive_read_seeds(p->archive, o->seeds, d));
}

/* Completes a scene without tiers by those that suit its segments. */
static bool complete_scene(const char *root, struct scene *scene, struct run_samples *s, struct diag *d)
{
    if (scene->tiers > 0)
        return true;
    if (!run_draw_training(scene, s, d) || !scene_default_tiers(root, scene, s->vary.kind, d))
        return false;
    s->follows = true;
    return true;
}

/* Returns true if all tiers are programs of one language, so that each may have any member of the fronts. */
static bool tiers_are_alike(const struct scene *s)
{
    for (size_t i = 0; i < s->tiers; i++)
        if (!compose_alike(&s->tier[0], &s->tier[i]))
            return false;
    return true;
}

/* Reads all files: the cheap part, which shows most mistakes. */
static bool load(struct run *r, struct diag *d)
{
    const struct evolve_options *o = r->call.options;
    const struct resume *resume = r->call.resume;
    struct scene *scene = r->problem.scene = scene_read(o->root, o->scene, d);
    if (scene)
        scene->run = o->seed;
    if (!scene || (resume && !resume_suits(resume, scene->sha256, o->generations, d)) ||
        !run_files_choose(&r->call, scene, &r->files, d))
        return false;
    const bool first = r->call.team->rank == 0;
    if (first && scene->warnings)
        fputs(scene->warnings, stderr);
    if (!complete_scene(o->root, scene, &r->samples, d))
        return false;
    if (o->max_length) {
        scene_set_lengths(scene, o->max_length);
        if (!scene_check_last(scene, d))
            return false;
    }
    if (o->breeding == BREED_PAPER && !scene_take_trees(scene, d))
        return false;
    run_files_start_from_shipped(&r->call, scene, &r->files);
    const bool good =
        (!first || (run_files_suit(&r->call, scene, &r->files, d) && run_files_keep_start(&r->files, d))) &&
        load_archive(o, &r->files, &r->problem, d);
    if (resume && r->files.start[0])
        unlink(r->files.start);
    if (!good)
        return false;
    r->problem.archive->knees = r->samples.follows && tiers_are_alike(scene);
    digest_frames(&r->problem, r->files.frames_sha256);
    return !resume || resume_suits_frames(resume, r->files.frames_sha256, d);
}

/* Returns the largest cost that a front must hold: the plan's limit, or the cost of the dearest terminal if that is higher. */
static size_t front_limit(const struct problem *p)
{
    enum { SPARE = 128 };
    const struct genome_file *program = p->archive->program;
    struct frame_cost *f = frame_cost_new(program, &p->plan.prices);
    double dearest = 0;
    for (size_t i = 0; i < p->scene->tiers; i++)
        if (p->scene->tier[i].program)
            dearest = fmax(dearest, p->scene->tier[i].budget);
    for (size_t i = 0; i < p->scene->tiers; i++)
        for (size_t k = 0; k < p->scene->tier[i].terminals && !p->scene->tier[i].program; k++) {
            int gene = GENE_SYMBOL + (int)genome_find_symbol(program, p->scene->tier[i].terminal[k]);
            const struct genes t = {&gene, 1};
            dearest = fmax(dearest, frame_cost_of(f, &t));
        }
    frame_cost_free(f);
    return dearest > (double)p->plan.front_limit ? (size_t)dearest + SPARE : p->plan.front_limit;
}

static void make_plan(const struct evolve_options *o, struct problem *p)
{
    struct plan *plan = &p->plan;
    *plan = plan_default();
    plan->breeding = o->breeding;
    plan->seed = o->seed;
    plan->population = o->population;
    plan->selection = o->selection;
    plan->parsimony = o->parsimony;
    plan->prices = o->cost == COST_PAPER ? (struct prices){.add = 0, .div = 1} : (struct prices){.add = 1, .div = 8};
    plan->migrants = (size_t)(o->migrate_fraction * (double)o->population + 0.5);
    plan->front_limit = front_limit(p);
}

/* Prints the tiers whose expressions are chosen, except exact tiers, which are already named. */
static void tell_chosen(const struct problem *p)
{
    size_t told = 0;
    for (size_t i = 0; i < p->scene->tiers; i++)
        if (tier_is_chosen(&p->scene->tier[i]) && !archive_is_exact(p->archive, i)) {
            if (told++ == 0)
                printf("%s: nothing to evolve for", p->scene->name);
            printf(" %s", p->scene->tier[i].name);
        }
    if (told > 0)
        printf(": one gene, chosen among the frame's values\n");
}

/* Prints the inputs that the scene varies, and the consequences.  A resumed run has printed them before. */
static void tell_segments(const struct problem *p, const struct run_samples *s)
{
    printf("%s: ", p->scene->name);
    if (!p->scene->segment->bilinear)
        printf("segments are %s", p->scene->segment->name);
    else
        variation_print(&s->vary, stdout);
    if (s->follows)
        printf(", frame %s", p->scene->tier[0].frame);
    archive_print_exact(p->archive, stdout);
    if (p->scene->source == SOURCE_MESH)
        printf("%s: %zu training samples are slave nodes of the mesh%s\n", p->scene->name, s->real,
               s->real < MESH_FEW ? ", too few to go by: errors are of random nodes over the same faces" : "");
    tell_chosen(p);
    fflush(stdout);
}

/* Makes the tools that measure, compose and fit trees. */
static void make_tools(const struct evolve_options *o, struct problem *p)
{
    const enum functions f = o->functions;
    make_plan(o, p);
    p->objective = objective_new(p->archive->program, &p->table, p->scene->norm);
    p->objective->decimal = true;
    p->fits = fits_new(p->objective);
    p->hooks = fits_hooks(p->fits);
    p->genes = new_array(p->scene->tiers, sizeof *p->genes);
    for (size_t i = 0; i < p->scene->tiers; i++) {
        const bool rational = f == FUNCTIONS_OF_TIER ? p->scene->tier[i].rational : f == FUNCTIONS_RATIONAL;
        p->genes[i] = archive_genes(p->archive, i, rational);
    }
}

/* Composes hand-written methods, from functions of tiers of programs, to breed from.  All ranks find the same. */
static void compose_seeds(const struct problem *p)
{
    const size_t n = p->scene->tiers;
    struct front **found = new_array(n, sizeof *found); /* NULL if an earlier tier has the same front */
    for (size_t i = 0; i < n; i++) {
        const struct tier *t = &p->scene->tier[i];
        size_t first = 0;
        while (first < i && !compose_alike(&p->scene->tier[first], t))
            first++;
        if (!t->program)
            continue;
        if (first == i) {
            found[i] = front_new(p->plan.front_limit, tier_genes(t));
            size_t quests;
            const int last = archive_quests(p->archive, i, &quests)->last;
            compose_programs(t, &p->genes[i], p->objective, last, &p->plan.times, found[i]);
        }
        for (size_t k = 0; k < front_count(found[first]); k++)
            archive_add_seed(p->archive, (long)i, TIER_BOTH, &front_member(found[first], k)->genes);
    }
    for (size_t i = 0; i < n; i++)
        if (found[i])
            front_free(found[i]);
    free(found);
}

/* Prepares exact values, seeds and their fronts, before islands breed. */
static void prepare(const struct call *call, struct problem *p, const struct run_samples *s)
{
    const struct evolve_options *o = call->options;
    make_tools(o, p);
    archive_find_exact(p->archive, &p->plan, &p->table, s->vary.tolerance);
    if (call->team->rank == 0 && !call->resume)
        tell_segments(p, s);
    for (size_t i = 0; i < p->scene->tiers; i++)
        if (tier_is_chosen(&p->scene->tier[i]))
            archive_choose_values(p->archive, i, o->generations > 0);
    if (o->generations > 0)
        compose_seeds(p);
    archive_measure(p->archive, &p->plan, p->objective);
}

/* Returns false for outputs that are exact or chosen; in a run of 0 generations, true only for those that lack a champion. */
static bool needs_ring(const struct archive *a, const struct quest *q, size_t generations)
{
    const bool lacking = q->champion.genes.length == 0 && !(a->knees && a->start);
    return q->champion.exact == 0 && !tier_is_chosen(q->own) && (generations > 0 || lacking);
}

static void make_rings(const struct evolve_options *o, const struct problem *p, struct islands *s)
{
    const struct archive *a = p->archive;
    s->ring = new_array(a->quests, sizeof *s->ring);
    s->places = o->islands;
    for (struct quest *q = a->quest; q < a->quest + a->quests; q++)
        if (needs_ring(a, q, o->generations))
            s->ring[s->rings++] = (struct ring){q, tier_genes(q->own), /* most programs are near their tier's budget: */
                                                q->own->budget > 0 ? q->own->budget : (double)q->own->max_length};
    s->owner = new_array(islands_count(s), sizeof *s->owner);
    s->island = new_array(islands_count(s), sizeof(struct island *));
    s->seeded = new_array(islands_count(s), sizeof *s->seeded);
}

/* Returns the largest cost on islands.  A program above its tier's budget serves only as an ancestor, far above it hardly so. */
static size_t islands_limit(const struct problem *p, const struct tier *t)
{
    const size_t limit = (size_t)(1.06 * t->budget);
    return t->program && limit > 0 && limit < p->plan.front_limit ? limit : p->plan.front_limit;
}

/* Makes the islands of this rank; a resumed run has yet to load them. */
static void make_islands(const struct call *call, const struct problem *p, struct islands *s)
{
    for (size_t i = 0; i < islands_count(s); i++) {
        const struct ring *ring = &s->ring[i / s->places];
        struct genes *seed;
        const struct quest *q = ring->quest;
        const size_t seeds = archive_seeds(p->archive, q, &seed);
        /* The paper's last island of a ring of several starts only from random trees. */
        const bool random = s->places > 1 && i % s->places == s->places - 1 && !quest_of_programs(q);
        const struct goal goal = {.program = quest_of_programs(q),
                                  .column = frame_target(p->archive->program, q->output),
                                  .last = q->last,
                                  .tails = q->tails,
                                  .limit = islands_limit(p, q->own),
                                  .max_length = ring->max_length,
                                  .genes = &p->genes[q->tier],
                                  .ring = ring_key(ring),
                                  .place = i % s->places,
                                  .fit = &p->hooks};
        s->seeded[i] = !random && seeds > 0;
        if (s->owner[i] == call->team->rank) {
            s->island[i] = island_new(&p->plan, &goal, p->objective);
            if (!call->resume)
                island_start(s->island[i], seed, random ? 0 : seeds);
        }
        free(seed);
    }
}

/* Returns true if all messages have at most INT_MAX bytes. */
static bool fits_messages(const struct evolve_options *o, const struct plan *plan, const struct islands *s,
                          struct diag *d)
{
    for (size_t i = 0; i < islands_count(s); i++) {
        const struct island *is = s->island[i];
        if (is && island_parcel_size(is, plan->migrants) > INT_MAX / sizeof(int))
            return options_refuse(&evolve_option_table, d, "error: --population %zu is too large to be sent",
                                  o->population);
    }
    return true;
}

/* Collective. */
static bool start_islands(const struct call *call, const struct problem *p, struct islands *s, struct diag *d)
{
    make_rings(call->options, p, s);
    islands_share(s, call->team->size);
    if (!team_agree(call->team, islands_can_be_tagged(s, call->team, d), d))
        return false;
    make_islands(call, p, s);
    if (!team_agree(call->team, fits_messages(call->options, &p->plan, s, d), d))
        return false;
    return !call->resume || resume_islands(call->resume, call->team, s, d);
}

static void say(const struct call *call, const char *phase)
{
    progress_phase(call->team->rank == 0 && !call->options->quiet, phase);
}

/* Merges the front of an island. */
static void take_front(void *to, size_t island, const int *report)
{
    const struct run *r = to;
    const struct ring *ring = &r->islands.ring[island / r->islands.places];
    const bool seeded = r->islands.seeded[island];
    const int *at = report + 1;
    double lowest = INFINITY;
    for (int k = 0; k < report[0]; k++) {
        struct genes t;
        double error;
        at = island_reported(at, &t, &error);
        archive_offer(r->problem.archive, &r->problem.plan, ring->quest, &t, error,
                      seeded ? ORIGIN_SEEDED : ORIGIN_RANDOM);
        lowest = fmin(lowest, error);
    }
    if (report[0] > 0 && !r->call.options->quiet)
        fprintf(stderr, "island %zu of %s %s (%s): %d on its front, lowest error %.3e\n", island % r->islands.places,
                ring->quest->own->name, frame_output[ring->quest->output], seeded ? "seeded" : "random", report[0],
                lowest);
}

/* Returns false with *d filled if a tier has no expression, with `all`, or if no tier has any. */
static bool found(const struct archive *a, bool all, struct diag *d)
{
    size_t lacking = 0, first = 0;
    for (size_t i = a->scene->tiers; i-- > 0;)
        if (!archive_has(a, i)) {
            lacking++;
            first = i;
        }
    return lacking == 0 || (!(all && !a->knees) && lacking < a->scene->tiers) ||
           diag_at(d, a->scene->path, 0, 0, "tier '%s': no expression has a finite error on every sample",
                   a->scene->tier[first].name);
}

/* Number of samples for errors if a run ends early: its time is up, or the sender of the signal may not wait. */
enum { HURRIED = 10000 };

/* Writes the results, on rank 0, to the files and in a table. */
static bool write_found(const struct call *call, const struct problem *p, const char *output,
                        const struct archive *shipped, const struct heldout *heldout, struct objective *judge,
                        const struct outcome *out, struct diag *d)
{
    struct archive *a = p->archive;
    const struct evolve_options *o = call->options;
    const struct run_facts facts = {o->seed, out->generation, o->islands};
    const bool saved = o->checkpoint && !out->unsaved && out->generation > 0;
    const size_t samples = out->reason == STOP_DONE ? SIZE_MAX : HURRIED;
    if (out->reason != STOP_DONE)
        fprintf(stderr, "%s: ended at generation %zu of %zu%s%s\n", stop_name(out->reason), out->generation,
                o->generations, saved ? "; go on with --resume " : "", saved ? o->checkpoint : "");
    if (!found(a, false, d))
        return false;
    say(call, "measuring on samples held out ...");
    struct diag other;
    const bool fronts = !o->front || archive_write_front(a, o->front, heldout, samples, judge, o->members, &other);
    const bool written =
        archive_write(a, output, &facts, heldout, samples, d); /* adds programs to the frame's values */
    say(call, "");
    if (written && !fronts)
        *d = other;
    if (!written || !fronts)
        return false;
    archive_table(a, stdout);
    if (o->front && o->generations > 0)
        archive_front_table(a, stdout);
    if (!run_verdict(call, p, shipped, heldout, d))
        return false;
    if (fflush(stdout) != 0)
        return diag_system(d, "standard output", "cannot write");
    *d = (struct diag){.code = out->unsaved ? EXIT_SYSTEM : EXIT_DONE}; /* reported when it happened */
    return !out->unsaved && found(a, true, d);
}

/* Chooses the champions and writes them, on rank 0. */
static bool conclude(const struct run *r, struct diag *d)
{
    const struct problem *p = &r->problem;
    const struct columns *validation = &r->samples.validation;
    struct objective *judge = validation->n > 0 ? objective_new(p->archive->program, validation, p->scene->norm) : NULL;
    if (judge)
        judge->decimal = true;
    const bool compared = r->call.options->generations > 0 || r->call.options->page;
    struct archive *shipped = compared ? run_shipped(&r->call, p) : NULL;
    if (shipped)
        run_measure_shipped(p, shipped);
    if (p->archive->knees && shipped && judge && r->call.options->generations > 0)
        archive_choose_knees(p->archive, shipped, p->objective, judge);
    else
        archive_choose_champions(p->archive, &p->plan, p->objective, judge);
    const bool written = write_found(&r->call, p, r->files.output, shipped, &r->samples.heldout, judge, &r->outcome, d);
    archive_free(shipped);
    objective_free(judge);
    return written;
}

static void run_free(struct run *r)
{
    struct problem *p = &r->problem;
    islands_free(&r->islands);
    free(r->files.start_text);
    sample_set_free(&r->samples.training);
    columns_free(&r->samples.validation);
    heldout_free(&r->samples.heldout);
    for (size_t i = 0; p->genes && i < p->scene->tiers; i++)
        gene_set_free(&p->genes[i]);
    free(p->genes);
    fits_free(p->fits);
    objective_free(p->objective);
    columns_free(&p->table);
    archive_free(p->archive);
    scene_free(p->scene);
}

bool run_evolution(const struct evolve_options *o, const struct team *team, const struct resume *resume, double begun,
                   int *status, struct diag *d)
{
    struct run r = {.call = {o, team, resume, begun}};
    struct problem *p = &r.problem;
    /* The ranks agree before any rank continues. */
    bool good = team_agree(team, load(&r, d), d);
    if (good) {
        say(&r.call, "drawing samples ...");
        good = team_agree(team, run_draw_samples(&r.call, p, &r.samples, d), d);
        say(&r.call, "");
    }
    if (good) {
        prepare(&r.call, p, &r.samples);
        r.outcome.generation = resume ? resume->generation : 0;
        good =
            start_islands(&r.call, p, &r.islands, d) && evolve_islands(&r.call, p, &r.islands, &r.files, &r.outcome, d);
    }
    if (good) {
        islands_reports(&r.islands, team, take_front, &r);
        good = team_agree(team, team->rank > 0 || conclude(&r, d), d);
    }
    *status = stop_status(r.outcome.reason);
    run_free(&r);
    return good;
}
