/* Rank 0's side of a run; see rank0.h.  A checkpoint is begun when the log has all lines up to its generation,
 * so that the two agree after a restart. */
#include "rank0.h"

#include "../../codegen/genome/console.h"
#include "../eval/frame.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool serves(const struct keeper *k)
{
    return k->run->team->rank == 0;
}

bool keeper_open(struct keeper *k, struct run *r, struct diag *d)
{
    const struct evolve_options *o = r->options;
    *k = (struct keeper){.run = r, .logged = r->generation, .saved = seconds_now()};
    if (o->checkpoint)
        k->state_bytes = team_state_sizes(r->team, &r->sea);
    if (!serves(k))
        return true;
    k->progress =
        progress_start(!o->quiet, r->generation, o->generations, o->time_limit > 0 ? r->begun + o->time_limit : 0);
    if (!o->log)
        return true;
    return r->resume && r->resume->mark.bytes > 0 ? run_log_continue(&k->log, o->log, &r->resume->mark, d)
                                                  : run_log_open(&k->log, o->log, d);
}

/* Say once, not each time, that a file cannot be written. */
static void complain(struct keeper *k, bool good, bool *bad, const struct diag *d)
{
    if (!good && !*bad) {
        progress_break(&k->progress);
        fprintf(stderr, "%s\n", d->text);
    }
    *bad = !good;
}

static bool take_row(struct keeper *k, bool wait)
{
    const struct run *r = k->run;
    const size_t island = k->rows.taken, places = r->sea.places;
    struct log_row *row = gather_next(r->team, &r->sea, &k->rows, NULL, sizeof *row, wait);
    if (!row)
        return false;
    const struct quest q = r->quest[island / places];
    run_log_add(&k->log, island, r->scene->tier[q.tier].name, frame_output[q.output], island % places, row);
    free(row);
    return true;
}

/* Lines up to `generation`, as far as they have come in. */
static void take_log(struct keeper *k, size_t generation, bool wait)
{
    const size_t every = k->run->options->log_every;
    while (k->logged < generation) {
        if (!k->rows.active) {
            if (k->log.stream && (k->logged + 1) % every == 0)
                gather_start(&k->rows, TAG_LOG);
        }
        while (k->rows.active)
            if (!take_row(k, wait))
                return;
        k->logged++;
    }
}

static void begin_checkpoint(struct keeper *k)
{
    const struct run *r = k->run;
    struct diag d;
    struct log_mark mark = {.sha256 = "-"};
    char facts[FACTS];
    if (k->log.stream) {
        complain(k, run_log_sync(&k->log, &d), &k->bad_log, &d);
        mark = run_log_mark(&k->log);
    }
    resume_facts(facts, r->scene->sha256, k->saving, &mark);
    evolve_options_facts(r->options, facts, sizeof facts);
    k->writing = checkpoint_begin(&k->writer, r->options->checkpoint, facts, RESUME_ISLANDS + sea_islands(&r->sea), &d);
    if (k->writing)
        checkpoint_section(&k->writer, r->start_text, r->start_bytes);
    else
        complain(k, false, &k->bad_save, &d);
    gather_start(&k->states, TAG_STATE);
}

static void take_states(struct keeper *k, bool wait)
{
    const struct run *r = k->run;
    struct diag d;
    while (k->states.active) {
        const size_t bytes = k->state_bytes[k->states.taken];
        void *state = gather_next(r->team, &r->sea, &k->states, k->state_bytes, 0, wait);
        if (!state)
            return;
        if (k->writing)
            checkpoint_section(&k->writer, state, bytes);
        free(state);
    }
    if (k->writing)
        complain(k, checkpoint_commit(&k->writer, &d), &k->bad_save, &d);
    k->writing = false;
    k->saving = 0;
}

static void take_all(struct keeper *k, size_t generation, bool wait)
{
    if (k->saving > 0) {
        take_log(k, k->saving < generation ? k->saving : generation, wait);
        if (!k->states.active && k->logged >= k->saving)
            begin_checkpoint(k);
        if (k->states.active)
            take_states(k, wait);
    }
    if (k->saving == 0 || k->states.active)
        take_log(k, generation, wait);
}

void keeper_poll(struct keeper *k, size_t generation)
{
    if (serves(k))
        take_all(k, generation, false);
}

bool keeper_wishes_save(const struct keeper *k)
{
    const struct evolve_options *o = k->run->options;
    return serves(k) && o->checkpoint && k->saving == 0 && seconds_now() - k->saved >= o->checkpoint_every;
}

void keeper_save(struct keeper *k, size_t generation)
{
    if (!serves(k))
        return;
    while (k->saving > 0)
        take_all(k, k->saving, true);
    k->saving = generation;
    k->saved = seconds_now();
}

enum { BEST = 200 };

/* Append "  NAME ERROR"; what does not fit is left out. */
static void append(char text[BEST], const char *name, double error)
{
    char number[NUMBER_TEXT];
    const size_t used = strlen(text);
    number_text(error, number);
    snprintf(text + used, BEST - used, "%s%s %s", used > 0 ? "  " : "", name, number);
}

void keeper_show(struct keeper *k, size_t generation, const double *best, double work)
{
    const struct run *r = k->run;
    char text[BEST] = "", brief[BEST] = "";
    if (!serves(k))
        return;
    for (size_t i = 0; i < r->sea.rings; i++) {
        const struct quest q = r->quest[i];
        const bool pair = i + 1 < r->sea.rings && r->quest[i + 1].tier == q.tier;
        const double worse = pair ? fmax(best[i], best[i + 1]) : best[i];
        char name[40];
        snprintf(name, sizeof name, "%.16s %s", r->scene->tier[q.tier].name, frame_output[q.output]);
        append(text, name, best[i]);
        if (pair)
            append(text, frame_output[r->quest[i + 1].output], best[i + 1]);
        snprintf(name, sizeof name, "%.8s", r->scene->tier[q.tier].name);
        append(brief, name, worse);
        i += pair;
    }
    progress_show(&k->progress, generation, text, brief, work);
}

void keeper_close(struct keeper *k)
{
    struct diag d;
    if (serves(k)) {
        take_all(k, k->run->generation, true);
        progress_break(&k->progress);
        complain(k, run_log_sync(&k->log, &d), &k->bad_log, &d);
        run_log_close(&k->log);
        k->run->unsaved = k->bad_log || k->bad_save;
    }
    free(k->state_bytes);
}
