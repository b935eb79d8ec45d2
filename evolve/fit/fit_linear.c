/* Linear coefficients of root terms; see fit_linear.h.  One pass over the samples gives the products of all terms. */
#include "fit_linear.h"

#include "../common/decimal.h"

#include <math.h>
#include <string.h>

enum { COLUMNS = ROOT_TERMS + 2 }; /* the terms, 1 and the goal */

struct sum {
    size_t at[ROOT_TERMS]; /* first genes of the terms, without constant factors */
    size_t terms;
};

/* Branches at `at` that are terms; `reserved` places are needed for others. */
static void split(const struct tape *t, size_t at, size_t reserved, struct sum *s)
{
    const int gene = t->gene[at];
    const bool pair = gene == GENE_ADD || gene == GENE_SUB;
    if (pair && s->terms + reserved + 2 <= ROOT_TERMS) {
        split(t, at + 1, reserved + 1, s);
        split(t, t->operand[at], reserved, s);
    } else if (gene == GENE_NEG) {
        split(t, at + 1, reserved, s);
    } else if (gene == GENE_MUL && t->gene[at + 1] < 0) {
        split(t, t->operand[at], reserved + ROOT_TERMS, s);
    } else if (gene == GENE_MUL && t->gene[t->operand[at]] < 0) {
        split(t, at + 1, reserved + ROOT_TERMS, s);
    } else if (gene >= 0) {
        s->at[s->terms++] = at;
    }
}

/* Products of the terms, 1 and the goal, in this order. */
static void multiply(struct fitter *f, const struct sum *s, size_t target, double *gram)
{
    const size_t count = s->terms + 2;
    const double *goal = columns_at(f->table, target);
    double panel[COLUMNS * TAPE_BLOCK];
    struct products p = products_new(count, count);
    for (size_t row = 0; row < f->table->n; row += TAPE_BLOCK) {
        const size_t left = f->table->n - row, n = left < TAPE_BLOCK ? left : TAPE_BLOCK;
        tape_values(f->tape, row);
        memset(panel, 0, sizeof panel);
        for (size_t j = 0; j < s->terms; j++)
            memcpy(panel + j * TAPE_BLOCK, f->tape->value[s->at[j]], n * sizeof *panel);
        for (size_t k = 0; k < n; k++)
            panel[s->terms * TAPE_BLOCK + k] = 1;
        memcpy(panel + (s->terms + 1) * TAPE_BLOCK, goal + row, n * sizeof *panel);
        products_add(&p, (struct panel){panel, TAPE_BLOCK}, (struct panel){panel, TAPE_BLOCK}, TAPE_BLOCK, true);
    }
    products_sum(&p, true, gram);
    products_free(&p);
}

/* Fit the independent columns: 1 and, as far as they add something, the terms. */
static size_t choose(const double *gram, size_t terms, size_t chosen[COLUMNS], double coefficient[COLUMNS])
{
    double work[COLUMNS * COLUMNS];
    const size_t count = terms + 2;
    size_t k = 0;
    chosen[k++] = terms;
    for (size_t j = 0; j < terms; j++) {
        chosen[k] = j;
        k += products_fit(gram, count, chosen, k + 1, terms + 1, coefficient, work) >= 0;
    }
    products_fit(gram, count, chosen, k, terms + 1, coefficient, work);
    return k;
}

bool fit_root_terms(struct fitter *f, const struct tree *in, size_t target, size_t max_length, struct tree *out)
{
    double gram[COLUMNS * COLUMNS], coefficient[COLUMNS];
    size_t chosen[COLUMNS], length = 0;
    const int one = decimal_gene(1), minus_one = decimal_gene(-1);
    struct sum s = {.terms = 0};
    tape_load(f->tape, in);
    split(f->tape, 0, 0, &s);
    const size_t count = s.terms + 2;
    multiply(f, &s, target, gram);
    for (size_t i = 0; i < count * count; i++)
        if (!isfinite(gram[i]))
            return false;
    const size_t k = choose(gram, s.terms, chosen, coefficient);
    const int intercept = decimal_gene(coefficient[0]), none = decimal_gene(0);
    bool open = intercept != none; /* something to add to */
    if (open) {
        if (max_length == 0)
            return false;
        out->gene[length++] = intercept;
    }
    for (size_t i = 1; i < k; i++) {
        const int factor = decimal_gene(coefficient[i]);
        const int *term = in->gene + s.at[chosen[i]];
        const size_t span = gene_span(term, in->length - s.at[chosen[i]]);
        const bool minus = open && factor == minus_one, plain = minus || factor == one;
        const size_t head = (open ? 1u : 0u), factors = plain ? 0 : 2;
        if (factor == none)
            continue;
        if (length + head + factors + span > max_length)
            return false;
        memmove(out->gene + head, out->gene, length * sizeof *out->gene);
        if (open)
            out->gene[0] = minus ? GENE_SUB : GENE_ADD;
        length += head;
        if (!plain) {
            out->gene[length++] = GENE_MUL;
            out->gene[length++] = factor;
        }
        memcpy(out->gene + length, term, span * sizeof *term);
        length += span;
        open = true;
    }
    if (length == 0)
        out->gene[length++] = none;
    out->length = length;
    return max_length > 0;
}
