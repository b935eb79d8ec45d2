/* Exact rational coefficients, each stored once. A coefficient is an index of its value, so that equal values have
 * equal indices, and earlier products and sums are looked up. They live until the program ends. */
#ifndef FOOTPOINT_RATIONAL_H
#define FOOTPOINT_RATIONAL_H

#include <flint/fmpq.h>
#include <flint/nmod_vec.h>
#include <stdbool.h>

typedef int rational;

enum { ZERO, ONE, MINUS_ONE, TWO, MINUS_TWO, FOUR, MINUS_FOUR, EIGHT, MINUS_EIGHT };

/** Primes below 2^60, modulo which values are compared. */
enum { PRIMES = 2 };
extern const mp_limb_t rational_prime[PRIMES];
/** Moduli of this arithmetic; valid after rational_start(). */
extern nmod_t rational_modulus[PRIMES];

/** Makes the table, once. Must be called before any other function here. */
void rational_start(void);
rational rational_intern(const fmpq *q);
rational rational_from_si(long n);
/** Returns the value, valid until the next rational is made. */
const fmpq *rational_value(rational r);
rational rational_mul(rational a, rational b);
rational rational_add(rational a, rational b);
rational rational_neg(rational a);
rational rational_inv(rational a); /* an inverse of 0 is an overflow */
rational rational_abs(rational a);
rational rational_pow(rational a, int n);
int rational_sign(rational a);
/** Returns the bits of the numerator or the denominator, whichever is longer. */
double rational_bits(rational a);
/** Multiplies: *q *= by. */
void rational_scale(fmpq *q, const fmpq *by);
/** Returns true if, since the last call, a result would have had tens of thousands of bits. It was replaced by 1,
 *  because powers of powers would fill any memory. */
bool rational_take_overflow(void);
/** Returns the residue modulo rational_prime[k]. */
mp_limb_t rational_mod(rational a, int k);
/** Returns true, and sets *a, if the residues belong to a rational so short that another value has them only by a
 *  chance of 2^-60. */
bool rational_reconstruct(const mp_limb_t residue[PRIMES], rational *a);

#endif
