/* Takes forward and backward steps by the sweep operator (A. Beaton, 1964) on the products of the monomials, scaled to unit
 * length, and the target.  With the chosen terms swept, entry (j, target) of an outsider is its product with the rest of the
 * target and (j, j) its square; for a chosen term they are its coefficient and minus its entry of the inverse. */
#include "polynomials.h"

#include <math.h>
#include <stdlib.h>

/* The least remaining square of a column, of 1, with which it counts as independent of the chosen columns. */
static const double independent = 1e-9;

struct sweeps {
    double *a; /* owned: n x n, the target last */
    size_t n;
};

static double at(const struct sweeps *s, size_t i, size_t j)
{
    return s->a[i * s->n + j];
}

/* Sweeps a term into the choice with sign 1, out of it with sign -1. */
static void sweep(struct sweeps *s, size_t k, double sign)
{
    const double pivot = at(s, k, k);
    double *row = s->a + k * s->n;
    for (size_t i = 0; i < s->n; i++) {
        double *to = s->a + i * s->n;
        const double factor = to[k] / pivot;
        if (i == k)
            continue;
        for (size_t j = 0; j < s->n; j++)
            if (j != k)
                to[j] -= factor * row[j];
    }
    for (size_t i = 0; i < s->n; i++)
        if (i != k) {
            row[i] *= sign / pivot;
            s->a[i * s->n + k] *= sign / pivot;
        }
    row[k] = -1 / pivot;
}

static struct sweeps sweeps_new(const struct polynomials *p, const gene_bit *chosen)
{
    struct sweeps s = {NULL, p->count + 1};
    s.a = new_array(s.n * s.n, sizeof *s.a);
    for (size_t i = 0; i < s.n; i++)
        for (size_t j = 0; j < s.n; j++) {
            const double scale = sqrt(p->gram[i * s.n + i] * p->gram[j * s.n + j]);
            s.a[i * s.n + j] = scale > 0 ? p->gram[i * s.n + j] / scale : 0;
        }
    for (size_t i = 0; i < p->count; i++)
        if (chosen[i])
            sweep(&s, i, 1);
    return s;
}

/* Returns the decrease of the sum of squares with an outsider, or its increase without a chosen term. */
static double worth(const struct sweeps *s, size_t j)
{
    const double product = at(s, j, s->n - 1);
    return product * product / fabs(at(s, j, j));
}

/* Returns the best outsider, or the least valuable term; s->n - 1 if there is neither. */
static size_t find(const struct sweeps *s, const gene_bit *chosen, bool outsider)
{
    size_t best = s->n - 1;
    for (size_t j = 0; j + 1 < s->n; j++)
        if (outsider != (chosen[j] != 0) && !(outsider && at(s, j, j) < independent) &&
            (best == s->n - 1 || (worth(s, j) > worth(s, best)) == outsider))
            best = j;
    return best;
}

bool polynomials_exchange(const struct polynomials *p, gene_bit *chosen, size_t limit)
{
    static const double progress = 1e-9; /* part of the target's square */
    size_t n = polynomials_terms(p, chosen, NULL);
    bool changed = false;
    struct sweeps s = sweeps_new(p, chosen);
    for (size_t steps = 0; steps < 20 * p->count; steps++) {
        const bool full = n >= limit;
        const size_t out = full ? find(&s, chosen, false) : p->count;
        double gain = 0;
        if (full) {
            gain -= worth(&s, out);
            sweep(&s, out, -1);
            chosen[out] = 0;
        }
        const size_t in = find(&s, chosen, true);
        if (n > limit) {
            n--;
            changed = true;
            continue;
        }
        if (in < p->count)
            gain += worth(&s, in);
        if (!(gain > progress)) {
            if (full)
                chosen[out] = 1;
            break;
        }
        sweep(&s, in, 1);
        chosen[in] = 1;
        changed = true;
        n += full ? 0 : 1;
    }
    free(s.a);
    return changed;
}
