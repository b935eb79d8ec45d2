/* From prefix genomes to code for the register tiles.  The genome is read from the back once, which finds where
 * branches end, folds operators of constants and gives each branch its Ershov number: 0 for a leaf; as of its greater
 * operand, but one more where both are equal and not leaves.  Then the code is written from its end to its beginning, a
 * node before its operands.  Of two operands that are no leaves, the one of the greater number is computed first, in A.
 * The other one is computed in B if its number is 1, that is, if it is a chain of operators that each have a leaf among
 * their operands; or else in A too, after A was stored in a slot.  Thus a random genome of hundreds of genes stores few
 * tiles, and no genome of n genes needs more than log2(n) slots. */
#include "kernel_code.h"

#include "../../codegen/genome/gene_value.h"
#include "../common/decimal.h"

#include <stdlib.h>

enum kind { CONSTANT, COLUMN, BRANCH };

struct node {
    enum kind kind;
    int number;
    size_t end; /* one past the branch */
    double constant;
};

/* A branch that is still to be written. */
struct pending {
    size_t node, slot; /* slot: the last one in use, from 1 */
    bool in_b;
    bool store; /* its value goes to `slot`, which it may use itself */
};

struct translator {
    struct node *node;         /* owned */
    struct pending *pending;   /* owned */
    struct instruction *code;  /* owned: `room` instructions are written from the end */
    size_t room, depth, slots; /* room: for genes */
    struct instruction *begin;
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

/* A gene is at most one instruction and one store. */
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
}

static struct node leaf(const struct kernel_task *task, size_t i)
{
    const int gene = task->gene[i];
    struct node leaf = {COLUMN, 0, i + 1, 0};
    if (gene < 0) {
        leaf.kind = CONSTANT;
        leaf.constant = task->constant ? task->constant[-1 - gene].value : decimal_value(gene);
    }
    return leaf;
}

static int ershov_number(int gene, const struct node *x, const struct node *y)
{
    const int least = gene_arity(gene) == 2 ? 1 : 2, greater = x->number > y->number ? x->number : y->number;
    const int number = x->number == y->number && x->number > 0 && x != y ? greater + 1 : greater;
    return number > least ? number : least;
}

static struct node operator_of(const struct translator *t, const struct kernel_task *task, size_t i)
{
    const int gene = task->gene[i];
    const struct node *x = &t->node[i + 1], *y = gene_arity(gene) == 2 ? &t->node[x->end] : x;
    struct node n = {BRANCH, 0, y->end, 0};
    if (x->kind == CONSTANT && y->kind == CONSTANT) {
        n.kind = CONSTANT;
        n.constant = gene_value(gene, x->constant, y->constant);
    } else {
        n.number = ershov_number(gene, x, y);
    }
    return n;
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

/* The two operands of an operator, at least one of them a leaf. */
static void write_chain(struct translator *t, const struct kernel_task *task, const struct pending *p, size_t x,
                        size_t y)
{
    static const int form[3][3] = {
        {-1, CONSTANT_COLUMN, CONSTANT_A}, {COLUMN_CONSTANT, COLUMN_COLUMN, COLUMN_A}, {A_CONSTANT, A_COLUMN, -1}};
    const size_t operand[] = {x, y};
    struct instruction *to =
        emit(t, task->gene[p->node] * FORMS + (p->in_b ? FORMS_OF_ONE : 0) + form[t->node[x].kind][t->node[y].kind]);
    size_t *place = &to->a;
    for (int i = 0; i < 2; i++)
        switch (t->node[operand[i]].kind) {
        case CONSTANT:
            to->u.number = t->node[operand[i]].constant;
            break;
        case COLUMN:
            *place = column(t, task->gene[operand[i]]);
            place = &to->u.b;
            break;
        case BRANCH:
            later(t, (struct pending){operand[i], p->slot, p->in_b, false});
        }
}

/* An operator of two branches. */
static void write_fork(struct translator *t, const struct kernel_task *task, const struct pending *p, size_t x,
                       size_t y)
{
    const int gene = task->gene[p->node];
    const bool x_first = t->node[x].number > t->node[y].number;
    const size_t first = x_first ? x : y, second = x_first ? y : x;
    const bool in_b = t->node[second].number == 1;
    emit(t, gene * FORMS + (in_b ? (x_first ? A_B : B_A) : (x_first ? SLOT_A : A_SLOT)));
    if (!in_b)
        t->begin->a = (p->slot + 1) * SLOT;
    later(t, (struct pending){first, p->slot + (in_b ? 0 : 1), false, !in_b});
    later(t, (struct pending){second, p->slot + (in_b ? 0 : 1), in_b, false});
}

static void write_node(struct translator *t, const struct kernel_task *task, struct pending *p)
{
    const struct node *n = &t->node[p->node];
    const int gene = task->gene[p->node];
    if (p->store)
        emit(t, STORE)->a = p->slot-- * SLOT;
    if (n->kind == CONSTANT) {
        emit(t, LOAD_CONSTANT)->u.number = n->constant;
    } else if (n->kind == COLUMN) {
        emit(t, LOAD_COLUMN)->a = column(t, gene);
    } else if (gene_arity(gene) == 1) {
        emit(t, SLOW)->gene = gene;
        later(t, (struct pending){p->node + 1, p->slot, false, false});
    } else {
        const size_t x = p->node + 1, y = t->node[x].end;
        if (t->node[x].kind != BRANCH || t->node[y].kind != BRANCH)
            write_chain(t, task, p, x, y);
        else
            write_fork(t, task, p, x, y);
    }
}

const struct instruction *translator_code(struct translator *t, const struct kernel_task *task,
                                          const struct kernel_table *table, size_t *slots)
{
    t->table = table;
    reserve(t, task->length);
    for (size_t i = task->length; i-- > 0;)
        t->node[i] = gene_arity(task->gene[i]) == 0 ? leaf(task, i) : operator_of(t, task, i);
    emit(t, END);
    later(t, (struct pending){0, 0, false, false});
    while (t->depth > 0) {
        struct pending next = t->pending[--t->depth];
        write_node(t, task, &next);
    }
    *slots = t->slots;
    return t->begin;
}
