/* Genetic operators beyond the paper's: grafts of like size, small growth, shrinking, whole terms of the root's sum,
 * and changes of constants to any decimal number.  Each makes a copy that is at most as long as it may be. */
#include "../common/decimal.h"
#include "tree.h"

#include <gsl/gsl_randist.h>
#include <math.h>

enum {
    GRAFT_TRIES = 8,
    TWIG_DEPTH = 2,
    TWIG = 2 << TWIG_DEPTH, /* genes of a small new branch, at most */
    TERM = 25               /* genes of a term taken over, at most */
};
static const double sign_change = 0.05, new_constant = 0.1, taken_over = 0.5;

static size_t below(gsl_rng *rng, size_t n)
{
    return gsl_rng_uniform_int(rng, n);
}

/* A new branch of at most `room` and TWIG genes. */
static struct tree twig(gsl_rng *rng, const struct gene_set *s, size_t room, int gene[TWIG])
{
    struct tree t = {gene, 0};
    tree_random(rng, s, (int)below(rng, TWIG_DEPTH + 1), false, room < TWIG ? room : TWIG, &t);
    return t;
}

bool tree_graft(gsl_rng *rng, const struct tree *a, const struct tree *b, size_t max, struct tree *child)
{
    const struct branch out = tree_random_branch(rng, a);
    for (int tries = 0; tries < GRAFT_TRIES; tries++) {
        const struct branch in = tree_random_branch(rng, b);
        if (in.length > 2 * out.length + 1 || a->length - out.length + in.length > max)
            continue;
        tree_splice(a, out, b->gene + in.at, in.length, child);
        return true;
    }
    return false;
}

bool tree_mutate_twig(gsl_rng *rng, const struct gene_set *s, const struct tree *t, size_t max, struct tree *child)
{
    int gene[TWIG];
    const struct branch out = tree_random_branch(rng, t);
    const struct tree in = twig(rng, s, max - (t->length - out.length), gene);
    tree_splice(t, out, in.gene, in.length, child);
    return true;
}

bool tree_wrap(gsl_rng *rng, const struct gene_set *s, const struct tree *t, size_t max, struct tree *child)
{
    if (t->length + 2 > max)
        return false;
    int gene[TWIG], head[1 + TWIG];
    const struct branch x = tree_random_branch(rng, t);
    const struct tree in = twig(rng, s, max - t->length - 1, gene);
    const bool first = below(rng, 2) == 0; /* the new branch is the first operand */
    head[0] = s->operation[below(rng, s->operations + s->functions)];
    if (gene_arity(head[0]) == 1) {
        tree_splice(t, (struct branch){x.at, 0}, head, 1, child);
        return true;
    }
    for (size_t i = 0; i < in.length; i++)
        head[1 + i] = in.gene[i];
    if (first) {
        tree_splice(t, (struct branch){x.at, 0}, head, 1 + in.length, child);
    } else {
        tree_splice(t, (struct branch){x.at + x.length, 0}, in.gene, in.length, child);
        for (size_t i = child->length++; i > x.at; i--)
            child->gene[i] = child->gene[i - 1];
        child->gene[x.at] = head[0];
    }
    return true;
}

bool tree_hoist(gsl_rng *rng, const struct tree *t, struct tree *child)
{
    if (t->length == 1)
        return false;
    const size_t at = 1 + below(rng, t->length - 1);
    const struct branch b = tree_branch(t, at);
    tree_splice(t, (struct branch){0, t->length}, t->gene + b.at, b.length, child);
    return true;
}

/* Copy with the operation at `at` replaced by one of its operands. */
static void replace_by_operand(const struct tree *t, size_t at, bool second, struct tree *child)
{
    struct branch operand = tree_branch(t, at + 1);
    if (second)
        operand = tree_branch(t, operand.at + operand.length);
    tree_splice(t, tree_branch(t, at), t->gene + operand.at, operand.length, child);
}

bool tree_shrink(gsl_rng *rng, const struct tree *t, struct tree *child)
{
    if (t->length == 1)
        return false;
    size_t at = below(rng, t->length);
    while (gene_arity(t->gene[at]) == 0) /* not the first gene: it is an operation */
        at--;
    replace_by_operand(t, at, gene_arity(t->gene[at]) == 2 && below(rng, 2) == 1, child);
    return true;
}

static bool adds(int gene)
{
    return gene == GENE_ADD || gene == GENE_SUB;
}

bool tree_add_term(gsl_rng *rng, const struct gene_set *s, const struct tree *t, const struct tree *mate, size_t max,
                   struct tree *child)
{
    int gene[TWIG], head[3 + TERM];
    if (t->length + 4 > max)
        return false;
    struct tree term = {gene, 0};
    const struct branch b = tree_random_branch(rng, mate);
    if (gsl_rng_uniform(rng) < taken_over && b.length <= TERM && t->length + 3 + b.length <= max)
        term = (struct tree){mate->gene + b.at, b.length};
    else
        term = twig(rng, s, max - t->length - 3, gene);
    head[0] = GENE_ADD;
    head[1] = GENE_MUL;
    head[2] = decimal_gene(gsl_ran_gaussian_ziggurat(rng, pow(10, -2 * gsl_rng_uniform(rng))));
    for (size_t i = 0; i < term.length; i++)
        head[3 + i] = term.gene[i];
    tree_splice(t, (struct branch){0, 0}, head, 3 + term.length, child);
    return true;
}

/* The k-th of the sums that the root is made of, in prefix order, or how many there are. */
static size_t root_sums(const struct tree *t, size_t at, size_t k, size_t *found)
{
    if (!adds(t->gene[at]))
        return 0;
    const struct branch first = tree_branch(t, at + 1);
    if (k == 0)
        *found = at;
    size_t n = 1;
    n += root_sums(t, first.at, k - n, found); /* k - n wraps where the sum was found: no later one has that number */
    n += root_sums(t, first.at + first.length, k - n, found);
    return n;
}

bool tree_drop_term(gsl_rng *rng, const struct tree *t, struct tree *child)
{
    size_t at = 0;
    const size_t n = root_sums(t, 0, SIZE_MAX / 2, &at);
    if (n == 0)
        return false;
    root_sums(t, 0, below(rng, n), &at);
    replace_by_operand(t, at, t->gene[at] == GENE_ADD && below(rng, 2) == 1, child);
    return true;
}

bool tree_shift_constant(gsl_rng *rng, const struct tree *t, struct tree *child)
{
    size_t constants = 0, chosen = 0;
    for (size_t i = 0; i < t->length; i++)
        if (t->gene[i] < 0 && below(rng, ++constants) == 0)
            chosen = i;
    if (constants == 0)
        return false;
    tree_copy(t, child);
    const double old = decimal_value(t->gene[chosen]), spread = pow(10, -3 * gsl_rng_uniform(rng));
    double value = old * (1 + gsl_ran_gaussian_ziggurat(rng, spread));
    if (old == 0 || gsl_rng_uniform(rng) < new_constant)
        value = gsl_ran_gaussian_ziggurat(rng, 10 * spread);
    else if (gsl_rng_uniform(rng) < sign_change)
        value = -old;
    child->gene[chosen] = decimal_gene(value);
    return true;
}

void tree_bind(struct genome_file *program, const struct tree *t, struct tree *bound)
{
    tree_copy(t, bound);
    for (size_t i = 0; i < t->length; i++)
        if (t->gene[i] < 0) {
            char text[DECIMAL_TEXT];
            decimal_text(t->gene[i], text);
            bound->gene[i] = -1 - (int)genome_add_constant(program, text);
        }
}
