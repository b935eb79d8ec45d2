/* Grown seeds; see seeding.h.  Those of twin trees are composed, on every rank alike.  A job grows one kind of tree
 * for one output from one base; its rank tells the others what it found, in the order of the jobs. */
#include "seeding.h"

#include "../../codegen/genome/console.h"
#include "../eval/frame.h"
#include "../fit/grow_greedy.h"
#include "../fit/grow.h"
#include "progress.h"
#include "../fit/compose.h"

#include <math.h>
#include <stdlib.h>

enum {
    GROWN_COST = 128, /* operations of the largest, by the prices of growth */
    GREEDY_DEGREE = 3,
    GREEDY_TERMS = 60
};

/* GREEDY: monomials selected one by one, the plain fit that all else must beat; the others grow terms anywhere. */
enum kind { GREEDY, POLYNOMIALS, QUOTIENTS };

struct job {
    size_t tier;
    int output;
    enum kind kind;
    struct tree base; /* genes not owned; length 0: from nothing */
};

struct jobs {
    struct job *job; /* owned */
    size_t n, room;
};

static bool has_quotients(const struct gene_set *s)
{
    for (size_t i = 0; i < s->operations; i++)
        if (s->operation[i] == GENE_PDIV)
            return true;
    return false;
}

static void add_job(struct jobs *jobs, struct job job)
{
    grow_array(&jobs->job, jobs->n, &jobs->room, sizeof *jobs->job);
    jobs->job[jobs->n++] = job;
}

static struct jobs all_jobs(const struct run *r)
{
    struct jobs jobs = {0};
    for (size_t tier = 0; tier < r->scene->tiers; tier++)
        for (int output = tier_first(&r->scene->tier[tier]); output < TIER_BOTH; output++) {
            struct tree *seed;
            if (r->archive->champion[tier][output].exact || run_chooses(r, tier))
                continue;
            const size_t seeds = archive_seeds(r->archive, tier, output, run_max_length(r, tier), &seed);
            const int last = has_quotients(&r->genes[tier]) ? QUOTIENTS : POLYNOMIALS;
            for (int kind = GREEDY; kind <= last; kind++) {
                add_job(&jobs, (struct job){tier, output, (enum kind)kind, {NULL, 0}});
                if (seeds > 0 && kind != GREEDY)
                    add_job(&jobs, (struct job){tier, output, (enum kind)kind, seed[0]});
            }
            free(seed);
        }
    return jobs;
}

/* What a job finds: for each tree its length and its genes; owned by the caller. */
static int *do_job(const struct run *r, const struct job *job, size_t *numbers)
{
    const struct gene_set *genes = &r->genes[job->tier];
    const size_t longest = run_max_length(r, job->tier);
    const struct grow_plan plan = grow_plan_new(genes->symbol, genes->symbols, GROWN_COST, longest);
    const struct greedy_plan greedy = {genes->symbol, genes->symbols, GREEDY_DEGREE, GREEDY_TERMS, longest};
    const size_t target = frame_target(r->archive->program, job->output);
    const struct tree *base = job->base.length > 0 ? &job->base : NULL;
    struct seeds found = {.prices = r->plan.prices};
    if (job->kind == GREEDY)
        greedy_polynomials(&greedy, r->judge, target, &found);
    else if (job->kind == QUOTIENTS)
        grow_quotients(&plan, r->judge, target, base, &found);
    else
        grow_polynomials(&plan, r->judge, target, base, &found);
    *numbers = 0;
    for (size_t i = 0; i < found.n; i++)
        *numbers += 1 + found.seed[i].tree.length;
    int *number = new_array(*numbers, sizeof *number), *to = number;
    for (size_t i = 0; i < found.n; i++) {
        struct tree copy = {to + 1, 0};
        tree_copy(&found.seed[i].tree, &copy);
        *to = (int)copy.length;
        to += 1 + copy.length;
    }
    seeds_free(&found);
    return number;
}

static void keep(struct run *r, const struct job *job, int *number, size_t numbers)
{
    for (int *at = number; at < number + numbers; at += 1 + at[0]) {
        const struct tree t = {at + 1, (size_t)at[0]};
        if (t.length <= run_max_length(r, job->tier))
            archive_add_seed(r->archive, (long)job->tier, job->output, &t);
    }
}

/* Hand-written methods, composed of the functions of a tier of twin trees, to breed from. */
static void compose_seeds(struct run *r, size_t tier)
{
    struct front *found = front_new(r->plan.front_limit, run_max_length(r, tier));
    twin_seeds(&r->genes[tier], r->judge, &r->plan.prices, found);
    for (size_t k = 0; k < front_count(found); k++)
        archive_add_seed(r->archive, (long)tier, TIER_BOTH, &front_member(found, k)->tree);
    front_free(found);
}

/* Why no other job should begin: a signal, or less time left than one of `job` seconds and the end may take, which is
 * reckoned as long as the beginning until growth `started`. */
static enum stop_reason must_end(const struct run *r, double started, double job)
{
    const double needed = seconds_now() - r->begun + job + (started - r->begun);
    if (stop_noted() != STOP_DONE)
        return stop_noted();
    return r->options->time_limit > 0 && needed >= r->options->time_limit ? STOP_TIME : STOP_DONE;
}

void evolve_grow(struct run *r)
{
    struct jobs jobs = all_jobs(r);
    const size_t ranks = (size_t)r->team->size, rank = (size_t)r->team->rank;
    const double started = seconds_now();
    double longest = 0;
    for (size_t i = 0; i < r->scene->tiers; i++)
        if (r->scene->tier[i].twin)
            compose_seeds(r, i);
    int **found = new_array(jobs.n, sizeof *found);
    size_t *numbers = new_array(jobs.n, sizeof *numbers);
    for (size_t i = rank; i < jobs.n && (r->reason = must_end(r, started, longest)) == STOP_DONE; i += ranks) {
        const double begun = seconds_now();
        char text[64];
        snprintf(text, sizeof text, "growing seeds, %zu of %zu ...", i + 1, jobs.n);
        progress_phase(rank == 0 && !r->options->quiet, text);
        found[i] = do_job(r, &jobs.job[i], &numbers[i]);
        longest = fmax(longest, seconds_now() - begun);
    }
    r->reason = (enum stop_reason)team_most(r->team, (int)r->reason);
    for (size_t i = 0; i < jobs.n; i++) {
        int *number = team_pass(r->team, (int)(i % ranks), found[i], &numbers[i]);
        keep(r, &jobs.job[i], number, numbers[i]);
        free(number);
        free(found[i]);
    }
    progress_phase(rank == 0 && !r->options->quiet, "");
    free(found);
    free(numbers);
    free(jobs.job);
}
