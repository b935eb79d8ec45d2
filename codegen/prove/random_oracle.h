/* Random numbers as answers of SHA-256 to questions about a program. The same program gives the same numbers; every
 * gene and every letter of the code changes all of them. */
#ifndef FOOTPOINT_RANDOM_ORACLE_H
#define FOOTPOINT_RANDOM_ORACLE_H

#include "../program/program.h"

#include <stdint.h>

struct oracle {
    uint8_t seed[32];
    unsigned long bits; /* of the prime */
};

/** Returns the oracle of a program. attempt: counts evaluations of the program. */
struct oracle oracle_new(const struct program *p, int attempt, unsigned long bits);

/** Draws a prime of exactly `bits` bits, probable by FLINT's BPSW test, to which no counterexample is known. */
void oracle_prime(const struct oracle *o, fmpz *prime);

/** Sets *x[0] and *x[1] to two numbers modulo the prime, for a question of n words. */
void oracle_draw(const struct oracle *o, fmpz *const x[2], const fmpz *prime, const mp_limb_t *question, size_t n);

#endif
