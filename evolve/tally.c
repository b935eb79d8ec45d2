/* Operations of a tree; see tally.h.  Each branch gets the number of the first branch that equals it, the operands of
 * sums and products in any order. */
#include "tally.h"

#include <stdlib.h>

struct branch {
    int gene;
    size_t a, b; /* numbers of the operands */
};

static struct branch branch_of(const struct tree *t, size_t i, const size_t *number)
{
    struct branch x = {t->gene[i], 0, 0};
    const int arity = gene_arity(x.gene);
    if (arity > 0)
        x.a = number[i + 1];
    if (arity == 2)
        x.b = number[i + 1 + gene_span(t->gene + i + 1, t->length - i - 1)];
    if ((x.gene == GENE_ADD || x.gene == GENE_MUL) && x.b < x.a)
        x = (struct branch){x.gene, x.b, x.a};
    return x;
}

static void count(int gene, struct tally *n)
{
    switch (gene) {
    case GENE_ADD:
    case GENE_SUB:
        n->add++;
        break;
    case GENE_MUL:
        n->mul++;
        break;
    case GENE_DIV:
    case GENE_PDIV:
        n->div++;
        break;
    default:
        n->other += gene_arity(gene) > 0;
    }
}

struct tally tally_tree(const struct tree *t)
{
    struct tally n = {0};
    size_t *number = new_array(t->length, sizeof *number), branches = 0;
    struct branch *branch = new_array(t->length, sizeof *branch);
    for (size_t i = t->length; i-- > 0;) {
        const struct branch x = branch_of(t, i, number);
        size_t k = 0;
        while (k < branches && !(branch[k].gene == x.gene && branch[k].a == x.a && branch[k].b == x.b))
            k++;
        number[i] = k;
        if (k == branches) {
            branch[branches++] = x;
            count(x.gene, &n);
        }
    }
    free(number);
    free(branch);
    return n;
}
