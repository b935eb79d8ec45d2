/* The generations of a run; see generations.h.  There is no barrier: an island goes on as soon as the parcel of its own
 * migration is there, and a rank works on whichever of its islands is ready and furthest behind.  Each generation that
 * all islands of a rank have done is a vote in a poll; what a poll decides (a checkpoint, the end) takes place `lag`
 * generations later, which no island can have passed, since none goes on more than that before the polls are counted.
 * So all ranks save, and end, at the same generation, and what the islands find does not depend on time. */
#include "generations.h"

#include "../../codegen/genome/console.h"
#include "rank0.h"

#include <math.h>
#include <sched.h>
#include <stdlib.h>
#include <time.h>

/* What the loop knows of an island of this rank. */
struct berth {
    size_t island, generation;
    struct inbound guests; /* of the migration after this generation */
    unsigned char *saved;  /* owned: the state for the checkpoint under way */
    struct log_row *row;   /* owned: of the last generations */
};

struct loop {
    struct run *run;
    struct keeper keeper;
    struct berth *berth; /* owned: by island */
    size_t berths;
    size_t base, done, end; /* first generation; done by all islands of this rank; the last */
    size_t save_at;         /* generation of the next checkpoint; 0: none */
    struct poll poll;       /* number k is on generation base + k */
    struct mail mail;
    size_t rows;
    double started;
};

static struct island *island_of(const struct loop *l, const struct berth *b)
{
    return l->run->sea.island[b->island];
}

static size_t counted(const struct loop *l)
{
    return l->base + l->poll.counted;
}

/* No island may be further than this. */
static size_t horizon(const struct loop *l)
{
    const size_t last = counted(l) + l->poll.lag;
    return last < l->end ? last : l->end;
}

static size_t furthest_behind(const struct loop *l)
{
    size_t least = horizon(l);
    for (size_t i = 0; i < l->berths; i++)
        least = l->berth[i].generation < least ? l->berth[i].generation : least;
    return least;
}

/* Send the emigrants of this generation, and expect the guests. */
static void depart(struct loop *l, struct berth *b)
{
    const struct run *r = l->run;
    const struct evolve_options *o = r->options;
    const size_t places = r->sea.places, ring = b->island / places, place = b->island % places;
    if (b->generation == 0 || b->generation % o->migrate_every != 0 || b->generation >= l->end || r->plan.migrants == 0)
        return;
    const struct migration m = {o->topology, o->seed, run_ring(r, ring), places, b->generation / o->migrate_every};
    const size_t target = topology_target(&m, place), source = topology_source(&m, place);
    if (target == place)
        return;
    const size_t ints = island_parcel_size(island_of(l, b), r->plan.migrants), bytes = ints * sizeof(int);
    int *parcel = new_array(ints, sizeof *parcel);
    island_pack(island_of(l, b), r->plan.migrants, parcel);
    mail_send(r->team, &l->mail, parcel, bytes, r->sea.owner[ring * places + target],
              TAG_MIGRANTS + (int)(ring * places + target));
    inbound_expect(r->team, &b->guests, bytes, r->sea.owner[ring * places + source], TAG_MIGRANTS + (int)b->island);
}

static void advance(struct loop *l, struct berth *b)
{
    struct island *is = island_of(l, b);
    if (b->guests.parcel) {
        island_receive(is, l->run->plan.migrants, b->guests.parcel);
        free(b->guests.parcel);
        b->guests.parcel = NULL;
    }
    island_step(is);
    b->generation++;
    const struct individual *best = island_best(is);
    b->row[b->generation % l->rows] =
        (struct log_row){b->generation, best->tree.length, island_evaluations(is), best->error, island_median(is)};
    if (b->generation == l->save_at) {
        b->saved = new_array(island_state_size(is), 1);
        island_save(is, b->saved);
    }
    depart(l, b);
}

/* Let the island go on that is ready and furthest behind; false if none is.  None is a migration ahead of another of
 * this rank, so that parcels between two ranks keep their order. */
static bool advance_one(struct loop *l)
{
    const size_t close = furthest_behind(l) + l->run->options->migrate_every, far = horizon(l);
    struct berth *chosen = NULL;
    for (size_t i = 0; i < l->berths; i++) {
        struct berth *b = &l->berth[i];
        if (b->generation < far && b->generation < close && (!chosen || b->generation < chosen->generation) &&
            inbound_here(&b->guests))
            chosen = b;
    }
    if (chosen)
        advance(l, chosen);
    return chosen != NULL;
}

static void send_rows(struct loop *l, size_t generation)
{
    for (size_t i = 0; i < l->berths; i++) {
        struct log_row *row = new_array(1, sizeof *row);
        *row = l->berth[i].row[generation % l->rows];
        mail_send(l->run->team, &l->mail, row, sizeof *row, 0, TAG_LOG);
    }
}

static void send_states(struct loop *l)
{
    for (size_t i = 0; i < l->berths; i++) {
        struct berth *b = &l->berth[i];
        const size_t bytes = island_state_size(island_of(l, b));
        if (!b->saved) { /* at the end islands rest */
            b->saved = new_array(bytes, 1);
            island_save(island_of(l, b), b->saved);
        }
        mail_send(l->run->team, &l->mail, b->saved, bytes, 0, TAG_STATE);
        b->saved = NULL;
    }
}

/* True when the time left may not suffice for the generations to come until all can end, and for the end itself, which
 * is reckoned to take as long as the beginning did. */
static bool time_is_up(const struct loop *l)
{
    const struct run *r = l->run;
    const double now = seconds_now(), generations = (double)(l->done - l->base) + 1;
    const double coming = (now - l->started) / generations * (double)(l->poll.lag + 1);
    return r->team->rank == 0 && r->options->time_limit > 0 &&
           now - r->begun + coming + (l->started - r->begun) >= r->options->time_limit;
}

static void vote(struct loop *l)
{
    const struct run *r = l->run;
    double sum[POLL_SUMS] = {0}, *best = new_array(r->sea.rings, sizeof *best);
    sum[POLL_WORK] = judge_work(r->judge);
    sum[POLL_SAVE] = keeper_wishes_save(&l->keeper) ? 1 : 0;
    sum[POLL_STOP + stop_noted()] = 1;
    if (time_is_up(l))
        sum[POLL_STOP + STOP_TIME] = 1;
    for (size_t i = 0; i < r->sea.rings; i++) {
        const struct champion *c = &r->archive->champion[r->quest[i].tier][r->quest[i].output];
        best[i] = c->tree.length > 0 ? c->error : INFINITY;
    }
    for (size_t i = 0; i < l->berths; i++) {
        double *least = &best[l->berth[i].island / r->sea.places];
        *least = fmin(*least, island_best(island_of(l, &l->berth[i]))->error);
    }
    poll_cast(r->team, &l->poll, sum, best);
    free(best);
}

/* All islands of this rank have done one generation more. */
static void pass(struct loop *l)
{
    const struct evolve_options *o = l->run->options;
    const size_t k = ++l->done;
    if (o->log && k % o->log_every == 0)
        send_rows(l, k);
    if (o->checkpoint && (k == l->save_at || k == l->end)) {
        send_states(l);
        keeper_save(&l->keeper, k);
    }
    vote(l);
}

/* What a poll decided; it holds for all ranks alike. */
static void decide(struct loop *l, const struct poll_slot *s)
{
    struct run *r = l->run;
    const size_t then = counted(l) + l->poll.lag;
    for (int reason = STOP_REASONS - 1; reason > STOP_DONE; reason--)
        if (s->sum[1][POLL_STOP + reason] > 0 && then < l->end) {
            l->end = then;
            r->reason = (enum stop_reason)reason;
        }
    if (s->sum[1][POLL_SAVE] > 0 && l->save_at < counted(l))
        l->save_at = then;
    keeper_show(&l->keeper, counted(l), s->best[1], s->sum[1][POLL_WORK]);
}

static bool count_polls(struct loop *l)
{
    const struct poll_slot *s = poll_count(&l->poll);
    if (s)
        decide(l, s);
    return s != NULL;
}

/* Nothing to do until others have sent something. */
static void rest(unsigned *idle)
{
    const struct timespec moment = {0, 50000};
    if (++*idle < 200)
        sched_yield();
    else
        nanosleep(&moment, NULL);
}

static void board(struct loop *l)
{
    const struct run *r = l->run;
    const size_t n = sea_islands(&r->sea);
    l->berth = new_array(n, sizeof *l->berth);
    for (size_t i = 0; i < n; i++) {
        if (!r->sea.island[i])
            continue;
        struct berth *b = &l->berth[l->berths++];
        *b = (struct berth){.island = i, .generation = r->generation, .row = new_array(l->rows, sizeof *b->row)};
    }
}

bool evolve_islands(struct run *r, struct diag *d)
{
    const bool over = r->reason != STOP_DONE || r->sea.rings == 0;
    const size_t end = over ? r->generation : r->options->generations;
    struct loop l = {.run = r, .base = r->generation, .done = r->generation, .end = end};
    const bool good = keeper_open(&l.keeper, r, d);
    if (!team_agree(r->team, good, d)) {
        run_log_close(&l.keeper.log);
        free(l.keeper.state_bytes);
        return false;
    }
    l.poll = poll_new(r->team, r->sea.rings);
    l.rows = l.poll.lag + 1;
    l.started = seconds_now();
    board(&l);
    for (size_t i = 0; i < l.berths; i++)
        depart(&l, &l.berth[i]);
    for (unsigned idle = 0; l.done < l.end || l.poll.counted < l.poll.cast;) {
        bool busy = advance_one(&l);
        while (l.done < furthest_behind(&l)) {
            pass(&l);
            busy = true;
        }
        busy = count_polls(&l) || busy;
        keeper_poll(&l.keeper, l.done);
        mail_sweep(&l.mail);
        idle = busy ? 0 : idle;
        if (!busy)
            rest(&idle);
    }
    r->generation = l.end;
    keeper_close(&l.keeper);
    mail_free(&l.mail);
    poll_free(&l.poll);
    for (size_t i = 0; i < l.berths; i++)
        free(l.berth[i].row);
    free(l.berth);
    return true;
}
