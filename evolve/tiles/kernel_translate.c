/* Translates prefix genomes to code for the register tiles. A single pass over the genome folds operators on constants
 * and gives each branch its Ershov number: 0 for a leaf; otherwise the larger operand's number, plus one if both are
 * equal and not leaves. Then the code is written from its end to its beginning, a node before its operands. If neither
 * operand is a leaf, the operand with the larger number is computed first, in A. The other is computed in B if its
 * number is 1, that is, if it is a chain of operators that each have a leaf as operand; otherwise in A too, after A was
 * stored in a slot. Thus a random genome of hundreds of genes stores few tiles, and no genome of n genes needs more
 * than log2(n) slots. */
#include "kernel_code.h"

#include "../../codegen/genome/gene_value.h"
#include "../common/decimal.h"

#include <stdlib.h>

enum kind { CONSTANT, COLUMN, BRANCH };

struct node {
    enum kind kind;
    int gene, a, b; /* a, b: operands, or -1 */
    int number;
    double constant;
};

/* A branch that is still to be written. */
struct pending {
    int node;
    size_t slot; /* the last slot in use, from 1 */
    bool in_b;
    bool store; /* the value goes to `slot`, which the branch may use meanwhile */
};

struct translator {
    struct node *node; /* owned; operands before their operators */
    int nodes;
    struct pending *pending;   /* owned */
    struct instruction *code;  /* owned: `room` instructions are written from the end */
    size_t room, depth, slots; /* room: for genes */
    struct instruction *begin;
    const struct kernel_task *task;
    const struct kernel_table *table;
};

struct translator *translator_new(void)
{
    return new_array(1, sizeof(struct translator));
}

void translator_free(struct translator *t)
{
    free(t->node);
    free(t->pending);
    free(t->code);
    free(t);
}

/* Reserves an instruction and a store for each gene, the most that it can need. */
static void reserve(struct translator *t, size_t length)
{
    if (length > t->room) {
        free(t->node);
        free(t->pending);
        free(t->code);
        t->room = length;
        t->node = new_array(length, sizeof *t->node);
        t->pending = new_array(length, sizeof *t->pending);
        t->code = new_array(2 * length + 1, sizeof *t->code);
    }
    t->begin = t->code + 2 * t->room + 1;
    t->depth = t->slots = 0;
    t->nodes = 0;
}

static int ershov_number(int gene, const struct node *x, const struct node *y)
{
    const int least = gene_arity(gene) == 2 ? 1 : 2, greater = x->number > y->number ? x->number : y->number;
    const int number = x->number == y->number && x->number > 0 && x != y ? greater + 1 : greater;
    return number > least ? number : least;
}

static struct node leaf(const struct kernel_task *task, int gene)
{
    if (gene >= 0)
        return (struct node){COLUMN, gene, -1, -1, 0, 0};
    const double value = task->constant ? task->constant[-1 - gene].value : decimal_value(gene);
    return (struct node){CONSTANT, gene, -1, -1, 0, value};
}

static struct node operator_of(const struct translator *t, int gene, int a, int b)
{
    const struct node *x = &t->node[a], *y = b < 0 ? x : &t->node[b];
    if (x->kind == CONSTANT && y->kind == CONSTANT)
        return (struct node){CONSTANT, gene, a, b, 0, gene_value(gene, x->constant, y->constant)};
    return (struct node){BRANCH, gene, a, b, ershov_number(gene, x, y), 0};
}

static int add_node(void *translator, int gene, int a, int b)
{
    struct translator *t = translator;
    t->node[t->nodes] = gene_is_leaf(gene) ? leaf(t->task, gene) : operator_of(t, gene, a, b);
    return t->nodes++;
}

static void later(struct translator *t, struct pending p)
{
    t->pending[t->depth++] = p;
    if (p.store && p.slot > t->slots)
        t->slots = p.slot;
}

static struct instruction *emit(struct translator *t, int code)
{
    *--t->begin = (struct instruction){.code = code};
    return t->begin;
}

static size_t column(const struct translator *t, int gene)
{
    return (size_t)(gene - GENE_SYMBOL) * t->table->stride;
}

/* Writes an operator with at least one leaf among its two operands. */
static void write_chain(struct translator *t, const struct pending *p, const struct node *n)
{
    static const int form[3][3] = {
        {-1, CONSTANT_COLUMN, CONSTANT_A}, {COLUMN_CONSTANT, COLUMN_COLUMN, COLUMN_A}, {A_CONSTANT, A_COLUMN, -1}};
    const int operand[] = {n->a, n->b};
    struct instruction *to =
        emit(t, n->gene * FORMS + (p->in_b ? FORMS_OF_ONE : 0) + form[t->node[n->a].kind][t->node[n->b].kind]);
    size_t *place = &to->a;
    for (int i = 0; i < 2; i++)
        switch (t->node[operand[i]].kind) {
        case CONSTANT:
            to->u.number = t->node[operand[i]].constant;
            break;
        case COLUMN:
            *place = column(t, t->node[operand[i]].gene);
            place = &to->u.b;
            break;
        case BRANCH:
            later(t, (struct pending){operand[i], p->slot, p->in_b, false});
        }
}

/* Writes an operator with two branches. */
static void write_fork(struct translator *t, const struct pending *p, const struct node *n)
{
    const bool x_first = t->node[n->a].number > t->node[n->b].number;
    const int first = x_first ? n->a : n->b, second = x_first ? n->b : n->a;
    const bool in_b = t->node[second].number == 1;
    emit(t, n->gene * FORMS + (in_b ? (x_first ? A_B : B_A) : (x_first ? SLOT_A : A_SLOT)));
    if (!in_b)
        t->begin->a = (p->slot + 1) * SLOT;
    later(t, (struct pending){first, p->slot + (in_b ? 0 : 1), false, !in_b});
    later(t, (struct pending){second, p->slot + (in_b ? 0 : 1), in_b, false});
}

static void write_node(struct translator *t, struct pending *p)
{
    const struct node *n = &t->node[p->node];
    if (p->store)
        emit(t, STORE)->a = p->slot-- * SLOT;
    if (n->kind == CONSTANT) {
        emit(t, LOAD_CONSTANT)->u.number = n->constant;
    } else if (n->kind == COLUMN) {
        emit(t, LOAD_COLUMN)->a = column(t, n->gene);
    } else if (n->b < 0) {
        emit(t, SLOW)->gene = n->gene;
        later(t, (struct pending){n->a, p->slot, false, false});
    } else if (t->node[n->a].kind != BRANCH || t->node[n->b].kind != BRANCH) {
        write_chain(t, p, n);
    } else {
        write_fork(t, p, n);
    }
}

const struct instruction *translator_code(struct translator *t, const struct kernel_task *task,
                                          const struct kernel_table *table, size_t *slots)
{
    t->task = task;
    t->table = table;
    reserve(t, task->length);
    const int root = gene_fold(task->gene, task->length, add_node, t);
    emit(t, END);
    later(t, (struct pending){root, 0, false, false});
    while (t->depth > 0) {
        struct pending next = t->pending[--t->depth];
        write_node(t, &next);
    }
    *slots = t->slots;
    return t->begin;
}
