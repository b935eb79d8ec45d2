/* Rank 0's duties in a run; see rank0.h. */
#include "rank0.h"

#include "../../codegen/base/console.h"
#include "../eval/frame.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool serves(const struct rank0 *k)
{
    return k->call->team->rank == 0;
}

bool rank0_open(struct rank0 *k, size_t generation, struct diag *d)
{
    const struct evolve_options *o = k->call->options;
    const struct resume *resume = k->call->resume;
    k->logged = generation;
    k->saved = seconds_now();
    if (!serves(k))
        return true;
    k->progress =
        progress_start(!o->quiet, generation, o->generations, o->time_limit > 0 ? k->call->begun + o->time_limit : 0);
    if (!o->log)
        return true;
    return resume && resume->mark.bytes > 0 && access(o->log, F_OK) == 0
               ? run_log_continue(&k->log, o->log, &resume->mark, d)
               : run_log_open(&k->log, o->log, d);
}

/* Reports a file that cannot be written, only the first time. */
static void complain(struct rank0 *k, bool good, bool *bad, const struct diag *d)
{
    if (!good && !*bad) {
        progress_break(&k->progress);
        fprintf(stderr, "%s\n", d->text);
    }
    *bad = !good;
}

static bool take_row(struct rank0 *k, bool wait)
{
    const size_t island = k->rows.taken, places = k->islands->places;
    struct log_row *row = gather_next(k->call->team, &k->rows, NULL, sizeof *row, wait);
    if (!row)
        return false;
    const struct ring *ring = &k->islands->ring[island / places];
    run_log_add(&k->log, island, ring->quest->own->name, frame_output[ring->quest->output], island % places, row);
    free(row);
    return true;
}

/* Writes the log lines up to `generation` that have arrived. */
static void take_log(struct rank0 *k, size_t generation, bool wait)
{
    const size_t every = k->call->options->log_every;
    while (k->logged < generation) {
        if (!k->rows.active && k->log.stream && (k->logged + 1) % every == 0)
            gather_start(&k->rows, TAG_LOG, k->islands->owner, islands_count(k->islands));
        while (k->rows.active)
            if (!take_row(k, wait))
                return;
        k->logged++;
    }
}

void rank0_poll(struct rank0 *k, size_t generation)
{
    if (serves(k))
        take_log(k, generation, false);
}

bool rank0_wishes_save(const struct rank0 *k)
{
    const struct evolve_options *o = k->call->options;
    return serves(k) && o->checkpoint && seconds_now() - k->saved >= o->checkpoint_every;
}

void rank0_facts(struct rank0 *k, size_t generation, char facts[FACTS])
{
    struct diag d;
    struct log_mark mark = {.sha256 = "-"};
    if (!serves(k))
        return;
    take_log(k, generation, true);
    if (k->log.stream) {
        complain(k, run_log_sync(&k->log, &d), &k->bad_log, &d);
        mark = run_log_mark(&k->log);
    }
    resume_facts(facts, k->scene->sha256, k->frames_sha256, generation, &mark);
    evolve_options_facts(k->call->options, facts, FACTS);
}

void rank0_saved(struct rank0 *k, bool good, const struct diag *d)
{
    k->saved = seconds_now();
    if (serves(k))
        complain(k, good, &k->bad_save, d);
}

enum { BEST = 200 };

/* Appends "  NAME ERROR" if it fits. */
static void append(char text[BEST], const char *name, double error)
{
    char number[NUMBER_TEXT];
    const size_t used = strlen(text);
    number_text(error, number);
    snprintf(text + used, BEST - used, "%s%s %s", used > 0 ? "  " : "", name, number);
}

void rank0_show(struct rank0 *k, size_t generation, const double *best, double work)
{
    const struct islands *s = k->islands;
    char text[BEST] = "", brief[BEST] = "";
    if (!serves(k))
        return;
    for (size_t i = 0; i < s->rings; i++) {
        const struct ring *ring = &s->ring[i];
        const char *tier = ring->quest->own->name;
        const bool pair = i + 1 < s->rings && s->ring[i + 1].quest->tier == ring->quest->tier;
        const double worse = pair ? fmax(best[i], best[i + 1]) : best[i];
        char name[40];
        snprintf(name, sizeof name, "%.16s %s", tier, frame_output[ring->quest->output]);
        append(text, name, best[i]);
        if (pair)
            append(text, frame_output[s->ring[i + 1].quest->output], best[i + 1]);
        snprintf(name, sizeof name, "%.8s", tier);
        append(brief, name, worse);
        i += pair;
    }
    progress_show(&k->progress, generation, text, brief, work);
}

bool rank0_close(struct rank0 *k, size_t generation)
{
    struct diag d;
    if (serves(k)) {
        take_log(k, generation, true);
        progress_break(&k->progress);
        complain(k, run_log_sync(&k->log, &d), &k->bad_log, &d);
        run_log_close(&k->log);
    }
    return !(k->bad_log || k->bad_save);
}
