/* SHA-256 as an oracle; see oracle.h. */
#include "oracle.h"

#include <stdlib.h>
#include <string.h>

struct oracle oracle_new(const struct program *p, int attempt, unsigned long bits)
{
    struct oracle o = {.bits = bits};
    int *words = new_array(4 * p->ops + 1, sizeof *words);
    for (size_t i = 0; i < p->ops; i++) {
        const struct op *op = &p->op[i];
        memcpy(words + 4 * i, (const int[4]){(int)op->kind, op->a, op->b, op->input}, 4 * sizeof *words);
    }
    words[4 * p->ops] = attempt;
    sha256_hex(words, (4 * p->ops + 1) * sizeof *words, o.seed);
    free(words);
    for (size_t i = 0; i < p->constants; i++) {
        char *value = fmpq_get_str(NULL, 16, &p->constant[i]), *chain = new_array(strlen(value) + 65, 1);
        memcpy(chain, o.seed, 64);
        memcpy(chain + 64, value, strlen(value));
        sha256_hex(chain, strlen(chain), o.seed);
        flint_free(value);
        free(chain);
    }
    return o;
}

/* At least 256 bits more than the prime has, so that remainders are as good as uniform. */
static void answer(const struct oracle *o, fmpz *x, const mp_limb_t *question, size_t n)
{
    const size_t blocks = o->bits / 256 + 2;
    char key[100], *digits = new_array(64 * blocks + 1, 1);
    mp_limb_t *whole = new_array(8 + n, sizeof *whole);
    memcpy(whole, o->seed, 64);
    memcpy(whole + 8, question, n * sizeof *whole);
    sha256_hex(whole, (8 + n) * sizeof *whole, key);
    for (size_t k = 0; k < blocks; k++) {
        snprintf(key + 64, sizeof key - 64, " %zu", k);
        sha256_hex(key, strlen(key), digits + 64 * k);
    }
    fmpz_set_str(x, digits, 16);
    free(whole);
    free(digits);
}

void oracle_draw(const struct oracle *o, fmpz *x, const fmpz *prime, const mp_limb_t *question, size_t n)
{
    answer(o, x, question, n);
    fmpz_mod(x, x, prime);
}

void oracle_prime(const struct oracle *o, fmpz *prime)
{
    mp_limb_t question[2] = {'p', 0};
    do {
        answer(o, prime, question, 2);
        fmpz_fdiv_r_2exp(prime, prime, o->bits - 1);
        fmpz_setbit(prime, o->bits - 1);
        fmpz_setbit(prime, 0);
        question[1]++;
    } while (!fmpz_is_probabprime(prime));
}
