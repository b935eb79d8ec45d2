/* SplitMix64 as a GSL generator: a counter of odd stride, mixed (G. Steele, D. Lea, C. Flood, "Fast splittable
 * pseudorandom number generators", OOPSLA 2014; mixing constants of S. Vigna's public-domain version).  It is chosen
 * because its 127 bits of state (start and stride) are filled straight from the key: GSL's own small generators take
 * seeds of 32 bits, among which some hundred thousand keys collide. */
#include "stream.h"

struct state {
    uint64_t counter, stride; /* stride odd */
};

static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static uint64_t next(struct state *s)
{
    s->counter += s->stride;
    return mix(s->counter);
}

static void set(void *state, unsigned long seed)
{
    struct state *s = state;
    s->counter = mix(seed);
    s->stride = 0x9e3779b97f4a7c15u;
}

static unsigned long get(void *state)
{
    return (unsigned long)(next(state) >> 32);
}

static double get_double(void *state)
{
    return (double)(next(state) >> 11) * 0x1p-53;
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
    const uint64_t golden = 0x9e3779b97f4a7c15u;
    struct state *s = gsl_rng_state(stream);
    uint64_t h = mix(seed + golden);
    h = mix((h ^ a) + golden);
    h = mix((h ^ b) + 2 * golden);
    h = mix((h ^ c) + 3 * golden);
    s->counter = h;
    s->stride = mix(h + 4 * golden) | 1;
}
