/* A local search for the worst errors; see measure.h.  All climbers of a function step together, so that one table holds the
 * frame's values of all their samples. */
#include "measure.h"

#include <math.h>
#include <stdlib.h>

enum { STEPS = 60, STEPS_CURVED = 30 /* certain foot points of curved faces are slow */, OUTS = 2 };
#define LARGEST_STEP 0.25 /* over the range of a random number */
#define WIDER 2.0         /* factor of the step after one uphill */
#define NARROWER 0.85     /* and after any other */

struct climber {
    struct stream_tape tape;
    double error, step;
};

struct climb {
    struct sampler *sampler; /* not owned, as is: */
    const struct climb_goal *goal;
    struct climber *climber; /* owned */
    size_t climbers;
    gsl_rng *stream; /* owned */
    double *worst;   /* not owned; indexed by output */
};

/* Returns a random number within a step of `number`, clamped to the range. */
static uint64_t moved(gsl_rng *stream, uint64_t number, double step)
{
    const double to = ldexp((double)number, -64) + step * (2 * gsl_rng_uniform(stream) - 1);
    return (uint64_t)ldexp(fmin(fmax(to, 0), 1 - 0x1p-53), 64);
}

/* Changes one number or, every other time, all numbers. */
static void change(gsl_rng *stream, double step, struct stream_tape *tape)
{
    const bool all = gsl_rng_uniform_int(stream, 2) == 0;
    const size_t one = gsl_rng_uniform_int(stream, (unsigned long)tape->n);
    for (size_t i = 0; i < tape->n; i++)
        if (all || i == one)
            tape->number[i] = moved(stream, tape->number[i], step);
}

/* Computes the larger error of each of n samples. */
static void measure(struct climb *c, const struct sample *s, size_t n, double *larger)
{
    double value[OUTS][TALLY_WORST], *error[OUTS] = {value[0], value[1]};
    c->goal->errors(c->goal->of, s, n, error);
    for (size_t i = 0; i < n; i++) {
        larger[i] = 0;
        for (size_t k = 0; k < c->goal->outs; k++) {
            larger[i] = fmax(larger[i], value[k][i]);
            c->worst[k] = fmax(c->worst[k], value[k][i]);
        }
    }
}

static void take_steps(struct climb *c)
{
    struct stream_tape tape[TALLY_WORST];
    struct sample sample[TALLY_WORST] = {{.xi = 0}};
    struct climber *of[TALLY_WORST];
    double larger[TALLY_WORST];
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
        measure(c, sample, n, larger);
    for (size_t i = 0; i < n; i++)
        if (larger[i] > of[i]->error) {
            of[i]->tape = tape[i];
            of[i]->error = larger[i];
            of[i]->step = fmin(LARGEST_STEP, of[i]->step * WIDER / NARROWER);
        }
}

bool climb_can(const struct sampler *p)
{
    return p->draw && p->part != PART_HELDOUT_EVEN;
}

void climb_from(struct sampler *p, const struct climb_goal *goal, uint64_t key, const struct largest *start, size_t n,
                double *worst)
{
    struct climb c = {p, goal, new_array(TALLY_WORST, sizeof *c.climber), 0, stream_new(), worst};
    for (size_t i = 0; i < n && c.climbers < TALLY_WORST; i++)
        if (start[i].sample >= p->listed.n) {
            struct climber *k = &c.climber[c.climbers++];
            sampler_record(p, start[i].sample, &k->tape);
            k->error = start[i].error;
            k->step = LARGEST_STEP / 4;
        }
    stream_key(c.stream, p->scene->seed, p->scene->run, key, PART_HELDOUT);
    for (int i = p->scene->segment->bilinear ? STEPS : STEPS_CURVED; i > 0 && c.climbers > 0; i--)
        take_steps(&c);
    for (size_t i = 0; i < c.climbers && goal->found; i++) {
        struct sample s;
        if (sampler_play(p, &c.climber[i].tape, &s))
            goal->found(goal->to, &s);
    }
    gsl_rng_free(c.stream);
    free(c.climber);
}

/* Outputs of a measurement. */
struct outputs {
    const struct measurement *m; /* not owned */
    size_t first, outs;
};

static void errors_of_outputs(const void *of, const struct sample *s, size_t n, double **error)
{
    const struct outputs *o = of;
    measurement_errors(o->m, o->first, o->first + o->outs, s, n, error);
}

void climb(struct sampler *p, struct measurement *m, size_t first, size_t outs, double *worst,
           void (*found)(void *to, const struct sample *s), void *to)
{
    const struct outputs of = {m, first, outs};
    struct largest start[TALLY_WORST];
    size_t n = 0;
    for (size_t k = 0; k < outs; k++) {
        struct tally *t = &m->tally[first + k];
        tally_sort(t);
        worst[k] = t->kept > 0 ? t->largest[0].error : 0;
        for (size_t i = 0; i < t->kept && i < TALLY_WORST / outs; i++)
            start[n++] = t->largest[i];
    }
    climb_from(p, &(struct climb_goal){errors_of_outputs, &of, outs, found, to}, first, start, n, worst);
}
