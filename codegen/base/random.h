/* SplitMix64: random numbers from a counter with an odd stride (G. Steele, D. Lea, C. Flood, "Fast splittable
 * pseudorandom number generators", OOPSLA 2014; mixing constants of S. Vigna's public-domain version). */
#ifndef FOOTPOINT_RANDOM_H
#define FOOTPOINT_RANDOM_H

#include <stdint.h>

#define RANDOM_STRIDE 0x9e3779b97f4a7c15u

/** Mixes the bits of any number; 0 stays 0. */
static inline uint64_t random_mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/** Returns the first number of the sequence that starts at a seed. */
static inline uint64_t random_of(uint64_t seed)
{
    return random_mix(seed + RANDOM_STRIDE);
}

/** Returns the next number of a sequence. */
static inline uint64_t random_next(uint64_t *seed)
{
    return random_mix(*seed += RANDOM_STRIDE);
}

/** Returns a number in [0,1) from random bits. */
static inline double random_fraction(uint64_t bits)
{
    return (double)(bits >> 11) * 0x1p-53;
}

#endif
