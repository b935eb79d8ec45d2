/* Grown seeds; see seeding.h.  Those of programs are composed, on every rank alike, and again where a run is resumed.  A job grows one kind of tree
 * for one output from one base; its rank tells the others what it found, in the order of the jobs. */
#include "seeding.h"

#include "../../codegen/genome/console.h"
#include "../eval/frame.h"
#include "../fit/compose.h"
#include "../fit/grow.h"
#include "../fit/grow_greedy.h"
#include "progress.h"

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

static struct jobs all_jobs(const struct problem *p)
{
    struct jobs jobs = {0};
    for (size_t tier = 0; tier < p->scene->tiers; tier++)
        for (int output = tier_first(&p->scene->tier[tier]); output < TIER_BOTH; output++) {
            struct tree *seed;
            if (p->archive->champion[tier][output].exact || problem_chooses(p, tier))
                continue;
            const size_t seeds = archive_seeds(p->archive, tier, output, problem_longest(p, tier), &seed);
            const int last = has_quotients(&p->genes[tier]) ? QUOTIENTS : POLYNOMIALS;
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
static int *do_job(const struct problem *p, const struct job *job, size_t *numbers)
{
    const struct gene_set *genes = &p->genes[job->tier];
    const size_t longest = problem_longest(p, job->tier);
    const struct grow_plan plan = grow_plan_new(genes->symbol, genes->symbols, GROWN_COST, longest);
    const struct greedy_plan greedy = {genes->symbol, genes->symbols, GREEDY_DEGREE, GREEDY_TERMS, longest};
    const size_t target = frame_target(p->archive->program, job->output);
    const struct tree *base = job->base.length > 0 ? &job->base : NULL;
    struct pareto found = {.prices = p->plan.prices};
    if (job->kind == GREEDY)
        greedy_polynomials(&greedy, p->objective, target, &found);
    else if (job->kind == QUOTIENTS)
        grow_quotients(&plan, p->objective, target, base, &found);
    else
        grow_polynomials(&plan, p->objective, target, base, &found);
    *numbers = 0;
    for (size_t i = 0; i < found.n; i++)
        *numbers += 1 + found.member[i].tree.length;
    int *number = new_array(*numbers, sizeof *number), *to = number;
    for (size_t i = 0; i < found.n; i++) {
        struct tree copy = {to + 1, 0};
        tree_copy(&found.member[i].tree, &copy);
        *to = (int)copy.length;
        to += 1 + copy.length;
    }
    pareto_free(&found);
    return number;
}

static void keep(const struct problem *p, const struct job *job, int *number, size_t numbers)
{
    for (int *at = number; at < number + numbers; at += 1 + at[0]) {
        const struct tree t = {at + 1, (size_t)at[0]};
        if (t.length <= problem_longest(p, job->tier))
            archive_add_seed(p->archive, (long)job->tier, job->output, &t);
    }
}

/* Hand-written methods, composed of the functions of a tier of programs, to breed from. */
static void compose_seeds(const struct problem *p, size_t tier)
{
    struct front *found = front_new(p->plan.front_limit, problem_longest(p, tier));
    compose_programs(&p->scene->tier[tier], &p->genes[tier], p->objective, archive_target(p->archive, tier, TIER_BOTH),
                     &p->plan.times, found);
    for (size_t k = 0; k < front_count(found); k++)
        archive_add_seed(p->archive, (long)tier, TIER_BOTH, &front_member(found, k)->tree);
    front_free(found);
}

void compose_all_seeds(const struct problem *p)
{
    for (size_t i = 0; i < p->scene->tiers; i++)
        if (p->scene->tier[i].program)
            compose_seeds(p, i);
}

/* Why no other job should begin: a signal, or less time left than one of `job` seconds and the end may take, which is
 * reckoned as long as the beginning until growth `started`. */
static enum stop_reason must_end(const struct call *call, double started, double job)
{
    const double needed = seconds_now() - call->begun + job + (started - call->begun);
    if (stop_noted() != STOP_DONE)
        return stop_noted();
    return call->options->time_limit > 0 && needed >= call->options->time_limit ? STOP_TIME : STOP_DONE;
}

enum stop_reason grow_seeds(const struct call *call, const struct problem *p)
{
    struct jobs jobs = all_jobs(p);
    const size_t ranks = (size_t)call->team->size, rank = (size_t)call->team->rank;
    const double started = seconds_now();
    double longest = 0;
    enum stop_reason reason = STOP_DONE;
    int **found = new_array(jobs.n, sizeof *found);
    size_t *numbers = new_array(jobs.n, sizeof *numbers);
    for (size_t i = rank; i < jobs.n && (reason = must_end(call, started, longest)) == STOP_DONE; i += ranks) {
        const double begun = seconds_now();
        char text[64];
        snprintf(text, sizeof text, "growing seeds, %zu of %zu ...", i + 1, jobs.n);
        progress_phase(rank == 0 && !call->options->quiet, text);
        found[i] = do_job(p, &jobs.job[i], &numbers[i]);
        longest = fmax(longest, seconds_now() - begun);
    }
    reason = (enum stop_reason)team_most(call->team, (int)reason);
    for (size_t i = 0; i < jobs.n; i++) {
        int *number = team_pass(call->team, (int)(i % ranks), found[i], &numbers[i]);
        keep(p, &jobs.job[i], number, numbers[i]);
        free(number);
        free(found[i]);
    }
    progress_phase(rank == 0 && !call->options->quiet, "");
    free(found);
    free(numbers);
    free(jobs.job);
    return reason;
}
