/* Genetic operators on trees (linear genetic programming). Trees are prefix arrays; stack counts delimit a branch
 * (gene_span; section 4.2 of the paper). Crossover exchanges branches. Mutation changes one gene to another of its
 * kind, as in the paper, or grows a new branch. No operator makes a genome longer than its limit. */
#include "tree.h"

#include <stdlib.h>
#include <string.h>

enum {
    CROSS_TRIES = 4,   /* attempts to choose two branches before the child stays a copy */
    BRANCH_DEPTH = 4,  /* of a new branch */
    NEAR_CONSTANTS = 8 /* a small change moves a constant at most this many places in the table */
};
static const double leaf_is_constant = 0.25, branch_ends = 0.4;

static int random_leaf(gsl_rng *rng, const struct gene_set *s)
{
    const bool constant = s->constants > 0 && (s->symbols == 0 || gsl_rng_uniform(rng) < leaf_is_constant);
    return constant ? s->constant[gsl_rng_uniform_int(rng, s->constants)]
                    : s->symbol[gsl_rng_uniform_int(rng, s->symbols)];
}

/* Writes a random tree to gene[]; returns its length. */
static size_t grow(gsl_rng *rng, const struct gene_set *s, int depth, bool full, size_t room, int *gene)
{
    if (depth == 0 || room < 3) {
        gene[0] = random_leaf(rng, s);
        return 1;
    }
    gene[0] = s->operation[gsl_rng_uniform_int(rng, s->operations + s->functions)];
    size_t n = 1;
    for (size_t operands = (size_t)gene_arity(gene[0]); operands-- > 0;) {
        const bool ends = !full && gsl_rng_uniform(rng) < branch_ends;
        n += grow(rng, s, ends ? 0 : depth - 1, full, room - n - operands, gene + n);
    }
    return n;
}

void tree_random(gsl_rng *rng, const struct gene_set *s, int depth, bool full, size_t room, struct genes *t)
{
    t->length = grow(rng, s, depth, full, room, t->gene);
}

/* A branch: its first gene and its length. */
struct branch {
    size_t at, length;
};

static struct branch random_branch(gsl_rng *rng, const struct genes *t)
{
    const size_t at = gsl_rng_uniform_int(rng, t->length);
    return (struct branch){at, gene_span(t->gene + at, t->length - at)};
}

/* Sets child = t with branch `out` replaced by n genes. */
static void splice(const struct genes *t, struct branch out, const int *gene, size_t n, struct genes *child)
{
    const size_t after = out.at + out.length, rest = t->length - after;
    memcpy(child->gene, t->gene, out.at * sizeof *gene);
    memcpy(child->gene + out.at, gene, n * sizeof *gene);
    memcpy(child->gene + out.at + n, t->gene + after, rest * sizeof *gene);
    child->length = out.at + n + rest;
}

void tree_cross(gsl_rng *rng, const struct genes *a, const struct genes *b, size_t max, struct genes *child_a,
                struct genes *child_b)
{
    struct branch p, q;
    bool fits_a, fits_b;
    int tries = CROSS_TRIES;
    do {
        p = random_branch(rng, a);
        q = random_branch(rng, b);
        fits_a = a->length - p.length + q.length <= max;
        fits_b = b->length - q.length + p.length <= max;
    } while (!(fits_a && fits_b) && --tries > 0);
    if (fits_a)
        splice(a, p, b->gene + q.at, q.length, child_a);
    else
        genes_copy(a, child_a);
    if (fits_b)
        splice(b, q, a->gene + p.at, p.length, child_b);
    else
        genes_copy(b, child_b);
}

/* Returns a random constant of the set other than `gene`, half the time with a close value. */
static int other_constant(gsl_rng *rng, const struct gene_set *s, int gene)
{
    size_t at = 0;
    while (at < s->constants && s->constant[at] != gene)
        at++;
    size_t low = 0, high = s->constants - 1;
    if (at < s->constants && gsl_rng_uniform(rng) < 0.5) {
        low = at > NEAR_CONSTANTS ? at - NEAR_CONSTANTS : 0;
        high = at + NEAR_CONSTANTS < high ? at + NEAR_CONSTANTS : high;
    }
    return s->constant[low + gsl_rng_uniform_int(rng, high - low + 1)];
}

void tree_mutate_gene(gsl_rng *rng, const struct gene_set *s, struct genes *t)
{
    int *gene = &t->gene[gsl_rng_uniform_int(rng, t->length)];
    switch (gene_arity(*gene)) {
    case 0:
        if (*gene < 0 && s->constants > 0 && gsl_rng_uniform(rng) < 0.5)
            *gene = other_constant(rng, s, *gene);
        else
            *gene = random_leaf(rng, s);
        break;
    case 2:
        *gene = s->operation[gsl_rng_uniform_int(rng, s->operations)];
        break;
    default: /* a gene from a seed that has no alternatives stays */
        if (s->functions > 0)
            *gene = s->operation[s->operations + gsl_rng_uniform_int(rng, s->functions)];
        break;
    }
}

void tree_mutate_branch(gsl_rng *rng, const struct gene_set *s, const struct genes *t, size_t max, struct genes *child)
{
    int fresh[2 << BRANCH_DEPTH];
    const struct branch out = random_branch(rng, t);
    const size_t kept = t->length - out.length, room = kept < max ? max - kept : 1;
    const int depth = (int)gsl_rng_uniform_int(rng, BRANCH_DEPTH + 1);
    splice(t, out, fresh, grow(rng, s, depth, false, room, fresh), child);
}
