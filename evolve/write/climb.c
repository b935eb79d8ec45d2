/* From the worst samples uphill; see climb.h.  All climbers of an expression make a step together, so that the frame's values
 * of their samples are computed at once. */
#include "climb.h"

#include <math.h>
#include <stdlib.h>

#define LARGEST_STEP 0.25 /* of the range of a random number */
#define WIDER 2.0         /* a step that led uphill; */
#define NARROWER 0.85     /* one that did not */

struct climber {
    struct stream_tape tape;
    double error, step;
};

struct climb {
    struct sampler *sampler; /* not owned */
    struct climber *climber; /* owned */
    size_t climbers;
    gsl_rng *stream; /* owned */
};

/* A number a step away at most, as far as there are any. */
static uint64_t moved(gsl_rng *stream, uint64_t number, double step)
{
    const double to = ldexp((double)number, -64) + step * (2 * gsl_rng_uniform(stream) - 1);
    return (uint64_t)ldexp(fmin(fmax(to, 0), 1 - 0x1p-53), 64);
}

/* One number changed or, every other time, all. */
static void change(gsl_rng *stream, double step, struct stream_tape *tape)
{
    const bool all = gsl_rng_uniform_int(stream, 2) == 0;
    const size_t one = gsl_rng_uniform_int(stream, (unsigned long)tape->n);
    for (size_t i = 0; i < tape->n; i++)
        if (all || i == one)
            tape->number[i] = moved(stream, tape->number[i], step);
}

static void take_steps(struct climb *c, const struct measurement *m, size_t which)
{
    struct stream_tape tape[TALLY_WORST];
    struct sample sample[TALLY_WORST] = {{.xi = 0}};
    struct climber *of[TALLY_WORST];
    double value[TALLY_WORST], *error = value;
    size_t n = 0;
    for (size_t i = 0; i < c->climbers; i++) {
        struct climber *k = &c->climber[i];
        tape[n] = k->tape;
        change(c->stream, k->step, &tape[n]);
        k->step *= NARROWER;
        of[n] = k;
        n += sampler_play(c->sampler, &tape[n], &sample[n]);
    }
    if (n > 0)
        measurement_errors(m, which, which + 1, sample, n, &error);
    for (size_t i = 0; i < n; i++)
        if (value[i] > of[i]->error) {
            of[i]->tape = tape[i];
            of[i]->error = value[i];
            of[i]->step = fmin(LARGEST_STEP, of[i]->step * WIDER / NARROWER);
        }
}

bool climb_can(const struct sampler *p)
{
    return p->draw && p->part != PART_HELDOUT_EVEN;
}

double climb(struct sampler *p, struct measurement *m, size_t which)
{
    struct tally *t = &m->tally[which];
    struct climb c = {p, new_array(TALLY_WORST, sizeof *c.climber), 0, stream_new()};
    tally_sort(t);
    double worst = t->kept > 0 ? t->largest[0].error : 0;
    for (size_t i = 0; i < t->kept && i < TALLY_WORST; i++) {
        struct climber *k = &c.climber[c.climbers];
        if (t->largest[i].sample < p->listed.n)
            continue;
        sampler_record(p, t->largest[i].sample, &k->tape);
        k->error = t->largest[i].error;
        k->step = LARGEST_STEP / 4;
        c.climbers++;
    }
    stream_key(c.stream, p->scene->seed, p->scene->run, which, PART_HELDOUT);
    for (int i = 0; i < CLIMB_STEPS && c.climbers > 0; i++)
        take_steps(&c, m, which);
    for (size_t i = 0; i < c.climbers; i++)
        worst = fmax(worst, c.climber[i].error);
    gsl_rng_free(c.stream);
    free(c.climber);
    return worst;
}
