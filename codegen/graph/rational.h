/* Exact rational coefficients, each stored once: a coefficient is the number of its value, so that equality is equality
 * of numbers, and products and sums that were formed before are looked up.  They live until the program ends. */
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
/** Arithmetic modulo these, from rational_start() on. */
extern nmod_t rational_modulus[PRIMES];

/** Makes the table, once; to be called before anything else here. */
void rational_start(void);
rational rational_intern(const fmpq *q);
rational rational_from_si(long n);
/** The value; valid until the next rational is made. */
const fmpq *rational_value(rational r);
rational rational_mul(rational a, rational b);
rational rational_add(rational a, rational b);
rational rational_neg(rational a);
rational rational_inv(rational a); /* of 0: an overflow */
rational rational_abs(rational a);
rational rational_pow(rational a, int n);
int rational_sign(rational a);
/** Bits of the numerator or of the denominator, of the longer one. */
double rational_bits(rational a);
/** *q *= by */
void rational_scale(fmpq *q, const fmpq *by);
/** Whether, since the last call, there was a result of tens of thousands of bits: it was not made, and 1 took its
 * place. Powers of powers would otherwise fill any memory. */
bool rational_take_overflow(void);
/** Residue modulo rational_prime[k]. */
mp_limb_t rational_mod(rational a, int k);
/** True, and *a set, if the residues are those of a rational so short that no other value has them but by a chance of 2^-60. */
bool rational_reconstruct(const mp_limb_t residue[PRIMES], rational *a);

#endif
