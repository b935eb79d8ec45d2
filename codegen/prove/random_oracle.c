/* SHA-256 as a random oracle; see random_oracle.h. */
#include "random_oracle.h"

#include <sha256.h>
#include <stdlib.h>
#include <string.h>

enum { DIGEST = SHA256_DIGEST_LENGTH };

static void hash(const void *first, size_t size, const void *second, size_t more, uint8_t digest[DIGEST])
{
    SHA2_CTX context;
    SHA256Init(&context);
    SHA256Update(&context, first, size);
    SHA256Update(&context, second, more);
    SHA256Final(digest, &context);
}

struct oracle oracle_new(const struct program *p, int attempt, unsigned long bits)
{
    struct oracle o = {.bits = bits};
    int *words = new_array(4 * p->ops + 1, sizeof *words);
    for (size_t i = 0; i < p->ops; i++) {
        const struct op *op = &p->op[i];
        memcpy(words + 4 * i, (const int[4]){(int)op->kind, op->a, op->b, op->input}, 4 * sizeof *words);
    }
    words[4 * p->ops] = attempt;
    hash(words, (4 * p->ops + 1) * sizeof *words, NULL, 0, o.seed);
    free(words);
    for (size_t i = 0; i < p->constants; i++) {
        char *value = fmpq_get_str(NULL, 16, &p->constant[i]);
        hash(o.seed, sizeof o.seed, value, strlen(value), o.seed);
        flint_free(value);
    }
    return o;
}

/* Computes `count` numbers of at least 256 bits more than the prime has, so that remainders are nearly uniform. */
static void answer(const struct oracle *o, fmpz *const *x, size_t count, const mp_limb_t *question, size_t n)
{
    const size_t blocks = (o->bits + 8 * DIGEST - 1) / (8 * DIGEST) + 1, limbs = blocks * DIGEST / sizeof(mp_limb_t);
    uint8_t key[DIGEST];
    mp_limb_t *number = new_array(limbs, sizeof *number);
    hash(o->seed, sizeof o->seed, question, n * sizeof *question, key);
    for (size_t k = 0; k < count; k++) {
        for (size_t i = 0; i < blocks; i++)
            hash(key, sizeof key, (const uint64_t[2]){k, i}, 16, (uint8_t *)number + DIGEST * i);
        fmpz_set_ui_array(x[k], number, (slong)limbs);
    }
    free(number);
}

void oracle_draw(const struct oracle *o, fmpz *const x[2], const fmpz *prime, const mp_limb_t *question, size_t n)
{
    answer(o, x, 2, question, n);
    for (int k = 0; k < 2; k++)
        fmpz_mod(x[k], x[k], prime);
}

void oracle_prime(const struct oracle *o, fmpz *prime)
{
    mp_limb_t question[2] = {'p', 0};
    do {
        answer(o, &prime, 1, question, 2);
        fmpz_fdiv_r_2exp(prime, prime, o->bits - 1);
        fmpz_setbit(prime, o->bits - 1);
        fmpz_setbit(prime, 0);
        question[1]++;
    } while (!fmpz_is_probabprime(prime));
}
