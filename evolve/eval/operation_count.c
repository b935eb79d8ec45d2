/* Counts operations by hash-consing: a hash table maps each value to a node. A node stands for a value up to its sign,
 * which its user carries. Finally the nodes that the root needs are marked. */
#include "operation_count.h"

#include "../../codegen/base/index_table.h"
#include "../../codegen/genome/gene_value.h"
#include "../common/decimal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum kind { LEAF, CONSTANT, SUM, PRODUCT, QUOTIENT, OTHER };

struct node {
    uint64_t hash;
    double value; /* for CONSTANT: >= 0 or NaN */
    int a, b;     /* operands, or -1 */
    enum kind kind;
    bool needed;
    double path; /* for needed nodes: the longest chain that ends here */
};

struct counter {
    struct node *node; /* owned; operands precede their users */
    int nodes;
    size_t room;
    struct index_table known; /* nodes by hash */
};

/* A value: a node or its negative. The counter's callers hold it as the number 2 node + negative. */
struct operand {
    int node;
    bool negative;
};

static int packed(struct operand x)
{
    return 2 * x.node + x.negative;
}

static struct operand unpacked(int x)
{
    return (struct operand){x / 2, x % 2 == 1};
}

double operations_price(const struct operation_count *o, const struct prices *m)
{
    return o->mul + m->add * (o->add + o->other) + m->div * o->div + m->path * o->path;
}

struct counter *counter_new(void)
{
    return new_array(1, sizeof(struct counter));
}

void counter_free(struct counter *c)
{
    if (!c)
        return;
    free(c->node);
    index_free(&c->known);
    free(c);
}

static uint64_t mix(uint64_t a, uint64_t b)
{
    uint64_t h = (a ^ (b + 0x9e3779b97f4a7c15u + (a << 6) + (a >> 2))) * 0xbf58476d1ce4e5b9u;
    h ^= h >> 29;
    h *= 0x94d049bb133111ebu;
    return h ^ (h >> 32);
}

/* Returns the equal node, or adds this node. */
static int node_of(struct counter *c, struct node n)
{
    size_t probe = 0;
    const int known = index_next(&c->known, n.hash, &probe);
    if (known >= 0)
        return known;
    index_add(&c->known, n.hash, c->nodes);
    grow_array(&c->node, (size_t)c->nodes, &c->room, sizeof *c->node);
    c->node[c->nodes] = n;
    return c->nodes++;
}

static struct operand constant_of(struct counter *c, double value)
{
    const double size = fabs(value);
    uint64_t bits;
    memcpy(&bits, &size, sizeof bits);
    return (struct operand){node_of(c, (struct node){mix(CONSTANT, bits), size, -1, -1, CONSTANT, false, 0}),
                            value < 0};
}

static bool is_constant(const struct counter *c, struct operand x)
{
    return c->node[x.node].kind == CONSTANT;
}

static bool is_size(const struct counter *c, struct operand x, double size)
{
    return is_constant(c, x) && c->node[x.node].value == size;
}

static double signed_value(const struct counter *c, struct operand x)
{
    return x.negative ? -c->node[x.node].value : c->node[x.node].value;
}

static void sort_operands(const struct counter *c, struct operand *a, struct operand *b)
{
    if (c->node[a->node].hash > c->node[b->node].hash) {
        const struct operand first = *b;
        *b = *a;
        *a = first;
    }
}

/* Returns the value of an operation on two nodes. `tag` distinguishes operations whose values differ. */
static struct operand value_of(struct counter *c, enum kind kind, unsigned tag, struct operand a, struct operand b,
                               bool negative)
{
    const uint64_t hash = mix(mix(tag, c->node[a.node].hash), c->node[b.node].hash);
    return (struct operand){node_of(c, (struct node){hash, 0, a.node, b.node, kind, false, 0}), negative};
}

static struct operand sum(struct counter *c, struct operand a, struct operand b)
{
    if (is_size(c, a, 0))
        return b;
    if (is_size(c, b, 0))
        return a;
    if (a.node == b.node && a.negative != b.negative)
        return constant_of(c, 0);
    sort_operands(c, &a, &b);
    return value_of(c, SUM, SUM + (a.negative != b.negative ? 16u : 0u), a, b, a.negative);
}

static struct operand product(struct counter *c, struct operand a, struct operand b)
{
    const bool negative = a.negative != b.negative;
    if (is_size(c, a, 0) || is_size(c, b, 0))
        return constant_of(c, 0);
    if (is_size(c, a, 1))
        return (struct operand){b.node, negative};
    if (is_size(c, b, 1))
        return (struct operand){a.node, negative};
    sort_operands(c, &a, &b);
    return value_of(c, PRODUCT, PRODUCT, a, b, negative);
}

/* Adds a protected quotient. It is 1 where its divisor is 0, so its sign cannot be factored out. */
static struct operand quotient(struct counter *c, int gene, struct operand a, struct operand b)
{
    const bool plain = gene == GENE_DIV || (is_constant(c, b) && !is_size(c, b, 0));
    if (gene == GENE_PDIV && ((a.node == b.node && a.negative == b.negative) || is_size(c, b, 0)))
        return constant_of(c, 1);
    const bool negative = plain && a.negative != b.negative;
    if (plain && is_size(c, b, 1))
        return (struct operand){a.node, negative};
    const unsigned sign = plain ? 0u : (a.negative ? 16u : 0u) + (b.negative ? 32u : 0u) + 64u;
    return value_of(c, is_constant(c, b) ? PRODUCT : QUOTIENT, QUOTIENT + sign, a, b, negative);
}

static struct operand other(struct counter *c, int gene, struct operand a, struct operand b)
{
    if (gene == GENE_ABS)
        a.negative = false;
    if (gene_arity(gene) == 1)
        b = a;
    else
        sort_operands(c, &a, &b);
    const unsigned sign = (a.negative ? 64u : 0u) + (b.negative ? 128u : 0u);
    return value_of(c, OTHER, OTHER + sign + 256u * (unsigned)gene, a, b, false);
}

static struct operand operation(struct counter *c, int gene, struct operand a, struct operand b)
{
    if (is_constant(c, a) && is_constant(c, b))
        return constant_of(c, gene_value(gene, signed_value(c, a), signed_value(c, b)));
    switch (gene) {
    case GENE_NEG:
        return (struct operand){a.node, !a.negative};
    case GENE_ADD:
        return sum(c, a, b);
    case GENE_SUB:
        return sum(c, a, (struct operand){b.node, !b.negative});
    case GENE_MUL:
        return product(c, a, b);
    case GENE_DIV:
    case GENE_PDIV:
        return quotient(c, gene, a, b);
    default:
        return other(c, gene, a, b);
    }
}

int counter_operation(struct counter *c, int gene, int a, int b)
{
    return packed(operation(c, gene, unpacked(a), unpacked(b < 0 ? a : b)));
}

void counter_begin(struct counter *c)
{
    c->nodes = 0;
    index_clear(&c->known);
}

int counter_number(struct counter *c, double value)
{
    return packed(constant_of(c, value));
}

int counter_leaf(struct counter *c, int gene)
{
    return 2 * node_of(c, (struct node){mix(LEAF, (uint64_t)gene), 0, -1, -1, LEAF, false, 0});
}

/* Returns the longest chain to a needed node; operands precede their users. */
static double longest_chain(struct counter *c, const int *root, size_t roots)
{
    static const double length[] = {[SUM] = 1, [PRODUCT] = 1, [QUOTIENT] = 3.25, [OTHER] = 1};
    double longest = 0;
    for (int i = 0; i < c->nodes; i++) {
        struct node *n = &c->node[i];
        n->path = n->needed && n->a >= 0 ? length[n->kind] + fmax(c->node[n->a].path, c->node[n->b].path) : 0;
    }
    for (size_t i = 0; i < roots; i++)
        longest = fmax(longest, c->node[root[i] / 2].path);
    return longest;
}

/* Counts the operations of all values that the roots need; users follow their operands. */
struct operation_count counter_end(struct counter *c, const int *root, size_t roots)
{
    struct operation_count o = {.hash = 0};
    for (size_t i = 0; i < roots; i++) {
        const struct operand x = unpacked(root[i]);
        const uint64_t hash = mix(c->node[x.node].hash, x.negative);
        o.hash = i == 0 ? hash : mix(o.hash, hash);
        c->node[x.node].needed = true;
    }
    for (int i = c->nodes - 1; i >= 0; i--) {
        const struct node *n = &c->node[i];
        if (!n->needed)
            continue;
        if (n->a >= 0)
            c->node[n->a].needed = c->node[n->b].needed = true;
        o.mul += n->kind == PRODUCT;
        o.add += n->kind == SUM;
        o.div += n->kind == QUOTIENT;
        o.other += n->kind == OTHER;
    }
    o.path = longest_chain(c, root, roots);
    return o;
}

struct tree {
    struct counter *counter;
    const struct genome_constant *constant;
};

static int value_of_gene(void *tree, int gene, int a, int b)
{
    const struct tree *t = tree;
    if (!gene_is_leaf(gene))
        return counter_operation(t->counter, gene, a, b);
    if (gene >= GENE_SYMBOL)
        return counter_leaf(t->counter, gene);
    return counter_number(t->counter, t->constant ? t->constant[-1 - gene].value : decimal_value(gene));
}

struct operation_count count_operations(struct counter *c, const struct genes *t,
                                        const struct genome_constant *constant)
{
    counter_begin(c);
    const int root = gene_fold(t->gene, t->length, value_of_gene, &(struct tree){c, constant});
    return counter_end(c, &root, 1);
}
