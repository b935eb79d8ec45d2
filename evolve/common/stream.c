/* SplitMix64 (random.h) as a GSL generator.  Its 127 bits of state (start and stride) are filled straight from the key.  GSL's own
 * small generators take seeds of 32 bits, with which some hundred thousand keys collide. */
#include "stream.h"

#include "../../codegen/base/random.h"

struct state {
    uint64_t counter, stride; /* stride odd */
    struct stream_tape *tape; /* not owned; or NULL */
    size_t at;                /* numbers returned since the tape began to play */
};

static uint64_t next(struct state *s)
{
    struct stream_tape *tape = s->tape;
    const size_t at = s->at++;
    if (tape && at < tape->n)
        return tape->number[at];
    const uint64_t drawn = random_mix(s->counter += s->stride);
    if (tape && at < TAPE_NUMBERS)
        tape->number[tape->n++] = drawn;
    return drawn;
}

static void set(void *state, unsigned long seed)
{
    struct state *s = state;
    s->counter = random_mix(seed);
    s->stride = RANDOM_STRIDE;
    s->tape = NULL;
}

static unsigned long get(void *state)
{
    return (unsigned long)(next(state) >> 32);
}

static double get_double(void *state)
{
    return random_fraction(next(state));
}

static const gsl_rng_type splitmix64 = {.name = "splitmix64",
                                        .max = 0xffffffff,
                                        .min = 0,
                                        .size = sizeof(struct state),
                                        .set = set,
                                        .get = get,
                                        .get_double = get_double};

gsl_rng *stream_new(void)
{
    return gsl_rng_alloc(&splitmix64);
}

void stream_key(gsl_rng *stream, uint64_t seed, uint64_t a, uint64_t b, uint64_t c)
{
    const uint64_t golden = RANDOM_STRIDE;
    struct state *s = gsl_rng_state(stream);
    uint64_t h = random_mix(seed + golden);
    h = random_mix((h ^ a) + golden);
    h = random_mix((h ^ b) + 2 * golden);
    h = random_mix((h ^ c) + 3 * golden);
    s->counter = h;
    s->stride = random_mix(h + 4 * golden) | 1;
}

void stream_play(gsl_rng *stream, struct stream_tape *tape)
{
    struct state *s = gsl_rng_state(stream);
    s->tape = tape;
    s->at = 0;
}
