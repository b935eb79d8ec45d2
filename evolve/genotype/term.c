/* Adding and dropping terms; see term.h. */
#include "term.h"

#include "../common/decimal.h"

#include <string.h>

void term_insert(const struct tree *t, const struct term *x, struct tree *to)
{
    const size_t span = gene_span(t->gene + x->at, t->length - x->at), after = x->at + span;
    int *g = to->gene;
    memcpy(g, t->gene, x->at * sizeof *g);
    g += x->at;
    *g++ = x->unit && x->coefficient < 0 ? GENE_SUB : GENE_ADD;
    memcpy(g, t->gene + x->at, span * sizeof *g);
    g += span;
    for (size_t i = x->unit ? 1 : 0; i < x->symbols; i++)
        *g++ = GENE_MUL;
    if (!x->unit)
        *g++ = decimal_gene(x->coefficient);
    for (size_t i = 0; i < x->symbols; i++)
        *g++ = x->symbol[i];
    memcpy(g, t->gene + after, (t->length - after) * sizeof *g);
    to->length = (size_t)(g - to->gene) + t->length - after;
}

static bool is_product(const int *gene, const struct term *x)
{
    if (x->symbols == 1)
        return gene[0] == x->symbol[0];
    return gene[0] == GENE_MUL && ((gene[1] == x->symbol[0] && gene[2] == x->symbol[1]) ||
                                   (gene[1] == x->symbol[1] && gene[2] == x->symbol[0]));
}

static bool sum_has(const int *gene, size_t n, const struct term *x)
{
    if (gene[0] != GENE_ADD && gene[0] != GENE_SUB)
        return is_product(gene, x);
    const size_t second = 1 + gene_span(gene + 1, n - 1);
    return sum_has(gene + 1, n - 1, x) || sum_has(gene + second, n - second, x);
}

bool term_repeats(const struct tree *t, const struct term *x)
{
    return x->unit && sum_has(t->gene + x->at, t->length - x->at, x);
}

/* Copy a branch without the zeros in it; returns the genes read and adds to *written. */
static size_t copy_branch(const int *from, size_t n, int *to, size_t *written)
{
    const int gene = from[0], zero = decimal_gene(0);
    const size_t start = *written;
    to[(*written)++] = gene;
    const int arity = gene_arity(gene);
    if (arity == 0)
        return 1;
    size_t read = 1 + copy_branch(from + 1, n - 1, to, written);
    if (arity == 1)
        return read;
    const size_t second = *written;
    read += copy_branch(from + read, n - read, to, written);
    const bool a = to[start + 1] == zero, b = to[second] == zero;
    if (gene == GENE_MUL && (a || b)) {
        to[start] = zero;
        *written = start + 1;
    } else if ((gene == GENE_ADD || gene == GENE_SUB) && b) {
        memmove(to + start, to + start + 1, (second - start - 1) * sizeof *to);
        *written = second - 1;
    } else if (gene == GENE_ADD && a) {
        memmove(to + start, to + second, (*written - second) * sizeof *to);
        *written -= second - start;
    } else if (gene == GENE_DIV && a) {
        to[start] = zero;
        *written = start + 1;
    }
    return read;
}

void terms_drop_zeros(const struct tree *t, struct tree *to)
{
    to->length = 0;
    copy_branch(t->gene, t->length, to->gene, &to->length);
}
