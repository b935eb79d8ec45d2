/* Computes monomials; see monomials.h. */
#include "monomials.h"

#include "../../../evolve/common/decimal.h"

#include <stdlib.h>
#include <string.h>

/* Appends m times symbols from `first` on, up to `degree` more; returns the new number of monomials. */
static size_t extend(struct monomial m, const int *symbol, size_t n, size_t first, size_t degree, struct monomial *all,
                     size_t count)
{
    if (all)
        all[count] = m;
    count++;
    for (size_t i = first; degree > 0 && i < n; i++) {
        struct monomial next = m;
        next.symbol[next.degree++] = symbol[i];
        count = extend(next, symbol, n, i, degree - 1, all, count);
    }
    return count;
}

struct monomial *monomials_new(const int *symbol, size_t n, size_t degree, size_t *count)
{
    const struct monomial one = {.degree = 0};
    *count = extend(one, symbol, n, 0, degree, NULL, 0);
    struct monomial *all = new_array(*count, sizeof *all);
    extend(one, symbol, n, 0, degree, all, 0);
    return all;
}

/* A monomial after factors have been taken out, and its coefficient. */
struct part {
    struct monomial m;
    double coefficient;
};

static size_t find(const struct monomial *m, int symbol)
{
    size_t i = 0;
    while (i < m->degree && m->symbol[i] != symbol)
        i++;
    return i;
}

/* Returns the symbol that most parts contain, the first among equals. */
static int commonest(const struct part *p, size_t n)
{
    int best = 0;
    size_t most = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < p[i].m.degree; j++) {
            size_t with = 0;
            for (size_t k = 0; k < n; k++)
                with += find(&p[k].m, p[i].m.symbol[j]) < p[k].m.degree;
            if (with > most) {
                most = with;
                best = p[i].m.symbol[j];
            }
        }
    return best;
}

static int *write_product(const struct part *p, int *gene)
{
    for (size_t i = 0; i < p->m.degree; i++) {
        *gene++ = GENE_MUL;
        *gene++ = p->m.symbol[i];
    }
    *gene++ = decimal_gene(p->coefficient);
    return gene;
}

/* Writes the sum of n >= 1 parts, which are reordered; returns its end. */
static int *write_sum(struct part *p, size_t n, int *gene)
{
    if (n == 1)
        return write_product(p, gene);
    const int symbol = commonest(p, n);
    size_t with = 0;
    for (size_t i = 0; i < n; i++) {
        const size_t at = find(&p[i].m, symbol);
        if (at == p[i].m.degree)
            continue;
        struct part left = p[i];
        memmove(left.m.symbol + at, left.m.symbol + at + 1, (left.m.degree - at - 1) * sizeof *left.m.symbol);
        left.m.degree--;
        p[i] = p[with];
        p[with++] = left;
    }
    if (with < n)
        *gene++ = GENE_ADD;
    *gene++ = GENE_MUL;
    *gene++ = symbol;
    gene = write_sum(p, with, gene);
    return with < n ? write_sum(p + with, n - with, gene) : gene;
}

size_t monomials_room(size_t n)
{
    return n * (2 + 2 * MONOMIAL_DEGREE);
}

void monomials_tree(const struct monomial *term, const double *coefficient, size_t n, struct genes *t)
{
    struct part *p = new_array(n, sizeof *p);
    for (size_t i = 0; i < n; i++)
        p[i] = (struct part){term[i], coefficient[i]};
    t->length = (size_t)(write_sum(p, n, t->gene) - t->gene);
    free(p);
}
