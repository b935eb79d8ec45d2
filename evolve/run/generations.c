/* The generations of a run; see run.h. An island continues as soon as the parcel of its own migration has
 * arrived. A rank works on the ready island that is furthest behind; ranks synchronise only at checkpoints. Whenever
 * all islands of a rank have completed a generation, the rank votes in a poll. A poll's decision (a checkpoint, the
 * end) takes effect `lag` generations later. No island can have passed that generation, because no island runs further
 * ahead before the polls are counted. So all ranks save and end at the same generation, and islands' results do not
 * depend on time. */
#include "run.h"

#include "../../codegen/base/console.h"
#include "../mpi/poll.h"
#include "rank0.h"

#include <math.h>
#include <sched.h>
#include <stdlib.h>
#include <time.h>

/* Sums of a poll over the ranks: genes times samples evaluated, ranks that want a checkpoint, and ranks that want to
 * end, by reason. */
enum { POLL_WORK, POLL_SAVE, POLL_STOP, POLL_SUMS = POLL_STOP + STOP_REASONS };

/* State of an island of this rank. */
struct local {
    size_t island, generation;
    struct inbound migrants; /* of the migration after this generation */
    struct log_row *row;     /* owned: the last generations */
};

struct loop {
    const struct call *call; /* not owned */
    const struct problem *problem;
    const struct islands *islands;
    struct outcome *out;
    struct rank0 rank0;
    struct saving saving;
    struct local *local; /* owned: by island */
    size_t locals;
    size_t base, done, end; /* first generation; completed by all islands of this rank; last generation */
    size_t save_at;         /* generation of the next checkpoint; 0: not decided */
    struct poll poll;       /* poll k is about generation base + k */
    struct mail mail;
    size_t rows;
    double started;
};

static struct island *island_of(const struct loop *l, const struct local *b)
{
    return l->islands->island[b->island];
}

static size_t counted(const struct loop *l)
{
    return l->base + l->poll.counted;
}

/* Returns the generation that no island may pass: limited by uncounted polls and by a pending checkpoint. */
static size_t horizon(const struct loop *l)
{
    const size_t last = counted(l) + l->poll.lag,
                 end = l->save_at > l->done && l->save_at < l->end ? l->save_at : l->end;
    return last < end ? last : end;
}

static size_t furthest_behind(const struct loop *l)
{
    size_t least = horizon(l);
    for (size_t i = 0; i < l->locals; i++)
        least = l->local[i].generation < least ? l->local[i].generation : least;
    return least;
}

/* Sends the migrants of this generation and expects another island's. */
static void migrate(struct loop *l, struct local *b)
{
    const struct evolve_options *o = l->call->options;
    const struct team *team = l->call->team;
    const struct islands *s = l->islands;
    const size_t places = s->places, ring = b->island / places, place = b->island % places;
    const size_t migrants = l->problem->plan.migrants;
    if (b->generation == 0 || b->generation % o->migrate_every != 0 || b->generation >= l->end || migrants == 0)
        return;
    const struct migration m = {o->topology, o->seed, ring_key(&s->ring[ring]), places,
                                b->generation / o->migrate_every};
    const size_t target = topology_target(&m, place), source = topology_source(&m, place);
    if (target == place)
        return;
    const size_t ints = island_parcel_size(island_of(l, b), migrants), bytes = ints * sizeof(int);
    int *parcel = new_array(ints, sizeof *parcel);
    island_pack(island_of(l, b), migrants, parcel);
    mail_send(team, &l->mail, parcel, bytes, s->owner[ring * places + target],
              TAG_MIGRANTS + (int)(ring * places + target));
    inbound_expect(team, &b->migrants, bytes, s->owner[ring * places + source], TAG_MIGRANTS + (int)b->island);
}

static void advance(struct loop *l, struct local *b)
{
    struct island *is = island_of(l, b);
    if (b->migrants.parcel) {
        island_receive(is, l->problem->plan.migrants, b->migrants.parcel);
        free(b->migrants.parcel);
        b->migrants.parcel = NULL;
    }
    island_step(is);
    b->generation++;
    const struct individual *best = island_best(is);
    b->row[b->generation % l->rows] =
        (struct log_row){b->generation, best->genes.length, island_evaluations(is), best->error, island_median(is)};
    migrate(l, b);
}

/* Advances the ready island that is furthest behind; returns false if no island is ready. No island is a migration
 * ahead of another of this rank, so parcels between two ranks keep their order. */
static bool advance_one(struct loop *l)
{
    const size_t close = furthest_behind(l) + l->call->options->migrate_every, far = horizon(l);
    struct local *chosen = NULL;
    for (size_t i = 0; i < l->locals; i++) {
        struct local *b = &l->local[i];
        if (b->generation < far && b->generation < close && (!chosen || b->generation < chosen->generation) &&
            inbound_here(&b->migrants))
            chosen = b;
    }
    if (chosen)
        advance(l, chosen);
    return chosen != NULL;
}

static void send_rows(struct loop *l, size_t generation)
{
    for (size_t i = 0; i < l->locals; i++) {
        struct log_row *row = new_array(1, sizeof *row);
        *row = l->local[i].row[generation % l->rows];
        mail_send(l->call->team, &l->mail, row, sizeof *row, 0, TAG_LOG);
    }
}

/* Saves a checkpoint. All ranks synchronise here, with their islands at this generation. */
static void save(struct loop *l, size_t generation)
{
    char facts[FACTS];
    struct diag d;
    rank0_facts(&l->rank0, generation, facts);
    rank0_saved(&l->rank0, saving_write(&l->saving, facts, &d), &d);
}

/* Returns true if the time left may not suffice for the generations until all ranks can end and for the end itself,
 * which is assumed to take as long as the start did. */
static bool time_is_up(const struct loop *l)
{
    const struct call *c = l->call;
    const double now = seconds_now(), generations = (double)(l->done - l->base) + 1;
    const double coming = (now - l->started) / generations * (double)(l->poll.lag + 1);
    return c->team->rank == 0 && c->options->time_limit > 0 &&
           now - c->begun + coming + (l->started - c->begun) >= c->options->time_limit;
}

static void vote(struct loop *l)
{
    const struct islands *s = l->islands;
    double sum[POLL_SUMS] = {0}, *best = new_array(s->rings, sizeof *best);
    sum[POLL_WORK] = l->problem->objective->lines->work;
    sum[POLL_SAVE] = rank0_wishes_save(&l->rank0) ? 1 : 0;
    sum[POLL_STOP + stop_noted()] = 1;
    if (time_is_up(l))
        sum[POLL_STOP + STOP_TIME] = 1;
    for (size_t i = 0; i < s->rings; i++) {
        const struct champion *c = &s->ring[i].quest->champion;
        best[i] = c->genes.length > 0 ? c->error : INFINITY;
    }
    for (size_t i = 0; i < l->locals; i++) {
        double *least = &best[l->local[i].island / s->places];
        *least = fmin(*least, island_best(island_of(l, &l->local[i]))->error);
    }
    poll_cast(l->call->team, &l->poll, sum, best);
    free(best);
}

/* Records that all islands of this rank have completed another generation. */
static void pass(struct loop *l)
{
    const struct evolve_options *o = l->call->options;
    const size_t k = ++l->done;
    if (o->log && k % o->log_every == 0)
        send_rows(l, k);
    if (o->checkpoint && (k == l->save_at || k == l->end))
        save(l, k);
    vote(l);
}

/* Acts on the result of a poll, which is the same on all ranks. */
static void decide(struct loop *l, const struct poll_slot *s)
{
    const size_t then = counted(l) + l->poll.lag;
    for (int reason = STOP_REASONS - 1; reason > STOP_DONE; reason--)
        if (s->sum[1][POLL_STOP + reason] > 0 && then < l->end) {
            l->end = then;
            l->out->reason = (enum stop_reason)reason;
        }
    if (s->sum[1][POLL_SAVE] > 0 && l->save_at < counted(l))
        l->save_at = then;
    rank0_show(&l->rank0, counted(l), s->least[1], s->sum[1][POLL_WORK]);
}

/* Waits for messages of other ranks. */
static void rest(unsigned *idle)
{
    const struct timespec moment = {0, 50000};
    if (++*idle < 200)
        sched_yield();
    else
        nanosleep(&moment, NULL);
}

/* Finds the islands of this rank. */
static void find_locals(struct loop *l)
{
    const size_t n = islands_count(l->islands);
    l->local = new_array(n, sizeof *l->local);
    for (size_t i = 0; i < n; i++) {
        if (!l->islands->island[i])
            continue;
        struct local *b = &l->local[l->locals++];
        *b = (struct local){.island = i, .generation = l->base, .row = new_array(l->rows, sizeof *b->row)};
    }
}

bool evolve_islands(const struct call *call, const struct problem *p, const struct islands *islands,
                    const struct run_files *files, struct outcome *out, struct diag *d)
{
    const bool over = out->reason != STOP_DONE || islands->rings == 0;
    const size_t end = over ? out->generation : call->options->generations;
    struct loop l = {
        .call = call,
        .problem = p,
        .islands = islands,
        .out = out,
        .rank0 = {.call = call, .scene = p->scene, .frames_sha256 = files->frames_sha256, .islands = islands},
        .saving = {call->team, islands, call->options->checkpoint, files->start_text, NULL},
        .base = out->generation,
        .done = out->generation,
        .end = end};
    const bool good = rank0_open(&l.rank0, out->generation, d);
    if (!team_agree(call->team, good, d)) {
        run_log_close(&l.rank0.log);
        return false;
    }
    if (call->options->checkpoint)
        saving_prepare(&l.saving, files->start_bytes);
    l.poll = poll_new(call->team, POLL_SUMS, islands->rings);
    l.rows = l.poll.lag + 1;
    l.started = seconds_now();
    find_locals(&l);
    for (size_t i = 0; i < l.locals; i++)
        migrate(&l, &l.local[i]);
    for (unsigned idle = 0; l.done < l.end || l.poll.counted < l.poll.cast;) {
        bool busy = advance_one(&l);
        while (l.done < furthest_behind(&l)) {
            pass(&l);
            busy = true;
        }
        const struct poll_slot *result = poll_count(&l.poll);
        if (result)
            decide(&l, result);
        rank0_poll(&l.rank0, l.done);
        mail_sweep(&l.mail);
        if (busy || result)
            idle = 0;
        else
            rest(&idle);
    }
    out->generation = l.end;
    out->unsaved = !rank0_close(&l.rank0, l.end);
    mail_free(&l.mail);
    arena_free(&l.poll.memory);
    free(l.saving.bytes);
    for (size_t i = 0; i < l.locals; i++)
        free(l.local[i].row);
    free(l.local);
    return true;
}
