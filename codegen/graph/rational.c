/* The table of rationals and the memo of their sums and products; see rational.h. */
#include "rational.h"

#include "../base/index_table.h"
#include "../base/random.h"

#include <stdint.h>
#include <stdlib.h>

const mp_limb_t rational_prime[PRIMES] = {1152921504606846883UL, 1152921504606846697UL};
nmod_t rational_modulus[PRIMES];

struct known {
    fmpq_t value;
    mp_limb_t residue[PRIMES];
    rational inverse, negative; /* -1: not computed yet */
    int sign;
    double bits; /* of numerator or denominator, whichever is longer */
};

struct result { /* a + b or a * b */
    int a, b;
    rational r;
    bool sum, valid;
};

static struct known *known;
static size_t n_known, known_room;
static struct index_table numbers; /* keyed by residues */
static struct result *memo;        /* keyed by hash of operation and operands; new entries replace old ones */
static bool overflow;
enum { MEMO = 1 << 16, MOST_BITS = 1 << 16 };

/* Frees the tables, and FLINT's caches, at the end of the program. */
static void forget(void)
{
    for (size_t i = 0; i < n_known; i++)
        fmpq_clear(known[i].value);
    free(known);
    index_free(&numbers);
    free(memo);
    flint_cleanup();
}

void rational_start(void)
{
    if (memo)
        return;
    atexit(forget);
    memo = new_array(MEMO, sizeof *memo);
    for (int k = 0; k < PRIMES; k++)
        nmod_init(&rational_modulus[k], rational_prime[k]);
    for (int i = 0; i < 9; i++) /* in the order of the enumeration */
        rational_from_si((long[]){0, 1, -1, 2, -2, 4, -4, 8, -8}[i]);
}

/* Returns the number of a value whose residues are known. */
static rational intern(const fmpq *q, const mp_limb_t residue[PRIMES])
{
    const uint64_t hash = random_mix(residue[0]);
    size_t probe = 0;
    for (int r; (r = index_next(&numbers, hash, &probe)) >= 0;)
        if (fmpq_equal(known[r].value, q))
            return r;
    grow_array(&known, n_known, &known_room, sizeof *known);
    struct known *x = &known[n_known];
    fmpq_init(x->value);
    fmpq_set(x->value, q);
    x->inverse = x->negative = -1;
    x->sign = fmpq_sgn(q);
    x->bits = (double)fmpq_height_bits(q);
    for (int k = 0; k < PRIMES; k++)
        x->residue[k] = residue[k];
    index_add(&numbers, hash, (int)n_known);
    return (rational)n_known++;
}

rational rational_intern(const fmpq *q)
{
    mp_limb_t residue[PRIMES];
    for (int k = 0; k < PRIMES; k++) {
        const nmod_t m = rational_modulus[k];
        residue[k] = nmod_mul(fmpz_fdiv_ui(fmpq_numref(q), rational_prime[k]),
                              nmod_inv(fmpz_fdiv_ui(fmpq_denref(q), rational_prime[k]), m), m);
    }
    return intern(q, residue);
}

rational rational_from_si(long n)
{
    fmpq_t q;
    fmpq_init(q);
    fmpq_set_si(q, n, 1);
    const rational r = rational_intern(q);
    fmpq_clear(q);
    return r;
}

const fmpq *rational_value(rational r)
{
    return known[r].value;
}

/* Returns true if a result may have this many bits. */
static bool fits(double bits)
{
    overflow |= bits > MOST_BITS;
    return bits <= MOST_BITS;
}

static double bits_of(const fmpq *q)
{
    return (double)fmpq_height_bits(q);
}

bool rational_take_overflow(void)
{
    const bool taken = overflow;
    overflow = false;
    return taken;
}

void rational_scale(fmpq *q, const fmpq *by)
{
    if (fits(bits_of(q) + bits_of(by)))
        fmpq_mul(q, q, by);
    else
        fmpq_one(q);
}

static rational combine(rational a, rational b, bool sum)
{
    if (a > b) {
        const rational swap = a;
        a = b;
        b = swap;
    }
    struct result *m = &memo[random_mix((uint64_t)a << 33 ^ (uint64_t)b << 1 ^ sum) & (MEMO - 1)];
    if (m->valid && m->a == a && m->b == b && m->sum == sum)
        return m->r;
    if (!fits(known[a].bits + known[b].bits))
        return ONE;
    fmpq_t q;
    fmpq_init(q);
    (sum ? fmpq_add : fmpq_mul)(q, known[a].value, known[b].value);
    mp_limb_t residue[PRIMES]; /* except the inverse of the denominator */
    for (int k = 0; k < PRIMES; k++)
        residue[k] = sum ? nmod_add(known[a].residue[k], known[b].residue[k], rational_modulus[k])
                         : nmod_mul(known[a].residue[k], known[b].residue[k], rational_modulus[k]);
    const rational r = intern(q, residue);
    fmpq_clear(q);
    *m = (struct result){a, b, r, sum, true};
    return r;
}

rational rational_mul(rational a, rational b)
{
    return a == ZERO || b == ONE ? a : b == ZERO || a == ONE ? b : combine(a, b, false);
}

rational rational_add(rational a, rational b)
{
    return a == ZERO ? b : b == ZERO ? a : combine(a, b, true);
}

rational rational_neg(rational a)
{
    if (known[a].negative < 0) {
        const rational r = rational_mul(a, MINUS_ONE);
        known[a].negative = r;
        known[r].negative = a;
    }
    return known[a].negative;
}

rational rational_inv(rational a)
{
    if (a == ZERO) {
        overflow = true;
        return ONE;
    }
    if (known[a].inverse < 0) {
        fmpq_t q;
        fmpq_init(q);
        fmpq_inv(q, known[a].value);
        const rational r = rational_intern(q);
        fmpq_clear(q);
        known[a].inverse = r;
        known[r].inverse = a;
    }
    return known[a].inverse;
}

rational rational_abs(rational a)
{
    return known[a].sign < 0 ? rational_neg(a) : a;
}

rational rational_pow(rational a, int n)
{
    if (a == ONE || n == 1)
        return a;
    if (!fits(known[a].bits * abs(n)))
        return ONE;
    fmpq_t q;
    fmpq_init(q);
    fmpq_pow_si(q, known[a].value, n);
    const rational r = rational_intern(q);
    fmpq_clear(q);
    return r;
}

double rational_bits(rational a)
{
    return known[a].bits;
}

int rational_sign(rational a)
{
    return known[a].sign;
}

mp_limb_t rational_mod(rational a, int k)
{
    return known[a].residue[k];
}

bool rational_reconstruct(const mp_limb_t residue[PRIMES], rational *a)
{
    enum { SHORT = 58 }; /* of numerator and denominator; the primes have 120 */
    fmpz_t all, product;
    fmpq_t q;
    fmpz_init_set_ui(all, residue[0]);
    fmpz_init_set_ui(product, rational_prime[0]);
    fmpq_init(q);
    fmpz_CRT_ui(all, all, product, residue[1], rational_prime[1], 0);
    fmpz_mul_ui(product, product, rational_prime[1]);
    const bool found =
        fmpq_reconstruct_fmpz(q, all, product) && fmpz_bits(fmpq_numref(q)) + fmpz_bits(fmpq_denref(q)) <= SHORT;
    if (found)
        *a = rational_intern(q);
    fmpz_clear(all);
    fmpz_clear(product);
    fmpq_clear(q);
    return found;
}
