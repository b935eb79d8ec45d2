/* Trees of operations, and the width of their text; see operation_tree.h. */
#include "operation_tree.h"

#include "../base/text.h"
#include "../graph/constant_text.h"
#include "../program/dialects.h"

#include <stdlib.h>
#include <string.h>

struct forest forest_new(const struct genome_file *f, size_t outputs)
{
    struct forest x = {.file = f, .program = program_new(f, outputs)};
    APPEND(x.tree, x.trees, x.tree_room) = (struct tree){OP_CONSTANT, .level = LEVEL_NAME};
    return x;
}

struct program *forest_take(struct forest *x)
{
    free(x->tree);
    free(x->waiting);
    return x->program;
}

static int add(struct forest *x, struct tree t)
{
    APPEND(x->tree, x->trees, x->tree_room) = t;
    return (int)x->trees - 1;
}

static int name_tree(struct forest *x, int op, size_t width)
{
    return add(x, (struct tree){.kind = OP_INPUT, .a = op, .level = LEVEL_NAME, .width = width});
}

int forest_input(struct forest *x, int input)
{
    char *text = c_double.input(x->file, (size_t)input);
    const size_t width = strlen(text);
    free(text);
    return name_tree(x, input, width);
}

int forest_constant(struct forest *x, rational c)
{
    const rational size = rational_abs(c);
    char *text = constant_text(rational_value(size));
    struct tree t = {OP_CONSTANT, .constant = size, .level = LEVEL_NAME, .width = strlen(text)};
    t.quotient = text[0] == '(';
    free(text);
    const int constant = add(x, t);
    return rational_sign(c) < 0 ? forest_unary(x, OP_NEG, constant) : constant;
}

/* Returns the width as an operand with at least this level, including parentheses if needed. */
static size_t operand_width(const struct forest *x, int tree, enum level least)
{
    return x->tree[tree].width + (x->tree[tree].level < least ? 2 : 0);
}

int forest_unary(struct forest *x, enum op_kind kind, int a)
{
    if (kind == OP_NEG)
        return add(x, (struct tree){kind, a, .level = LEVEL_MINUS, .width = 1 + operand_width(x, a, LEVEL_ATOM)});
    const size_t name = strlen(op_unary(kind)->c);
    return add(x, (struct tree){kind, a, .level = LEVEL_NAME, .width = name + strlen("()") + x->tree[a].width});
}

int forest_binary(struct forest *x, enum op_kind kind, int a, int b)
{
    const bool product = kind == OP_MUL || kind == OP_DIV, sum = kind == OP_ADD || kind == OP_SUB;
    struct tree t = {kind, a, b, .level = LEVEL_NAME};
    if (product) {
        t.level = x->tree[a].level == LEVEL_MINUS ? LEVEL_MINUS : LEVEL_PRODUCT;
        t.width = operand_width(x, a, LEVEL_MINUS) + operand_width(x, b, LEVEL_ATOM) + 3;
    } else if (sum) {
        t.level = LEVEL_SUM;
        t.width = x->tree[a].width + operand_width(x, b, LEVEL_PRODUCT) + 3;
    } else
        t.width = 2 * (x->tree[a].width + x->tree[b].width) + strlen("( <  ?  : )");
    return add(x, t);
}

int forest_multiply(struct forest *x, int a, int b, bool flat)
{
    if (!flat || x->tree[b].kind != OP_MUL)
        return forest_binary(x, OP_MUL, a, b);
    const int left = x->tree[b].a, right = x->tree[b].b;
    return forest_binary(x, OP_MUL, forest_multiply(x, a, left, true), right);
}

int forest_negate(struct forest *x, int a)
{
    int parent = NO_TREE, first = a;
    while (x->tree[first].kind == OP_MUL || x->tree[first].kind == OP_DIV) {
        x->tree[first].width++;
        x->tree[first].level = LEVEL_MINUS;
        parent = first;
        first = x->tree[first].a;
    }
    const int negative = forest_unary(x, OP_NEG, first);
    if (parent == NO_TREE)
        return negative;
    x->tree[parent].a = negative;
    return a;
}

bool forest_is_name(const struct forest *x, int tree)
{
    return x->tree[tree].kind == OP_INPUT;
}

bool forest_is_plain(const struct forest *x, int tree)
{
    const struct tree *t = &x->tree[tree];
    return t->kind == OP_INPUT || (t->kind == OP_CONSTANT && !t->quotient);
}

size_t forest_width(const struct forest *x, int tree)
{
    return x->tree[tree].width;
}

/* ---- statements ---- */

static void wait_for(struct forest *x, int tree)
{
    APPEND(x->waiting, x->waits, x->wait_room) = tree;
}

/* Appends a tree's operations, operands first. Sums of any length lean to the left, which needs no recursion. */
static int append(struct forest *x, int tree)
{
    const size_t before = x->waits;
    for (; x->tree[tree].kind != OP_INPUT && x->tree[tree].kind != OP_CONSTANT; tree = x->tree[tree].a)
        wait_for(x, tree);
    const struct tree *first = &x->tree[tree];
    int op = first->kind == OP_INPUT
                 ? first->a
                 : program_add_constant(x->program, rational_value(first->constant), first->quotient);
    while (x->waits > before) {
        const struct tree t = x->tree[x->waiting[--x->waits]];
        op = program_add(x->program, t.kind, op, t.b == NO_TREE ? -1 : append(x, t.b));
    }
    return op;
}

int forest_name(struct forest *x, char letter, long number, int tree)
{
    char name[32];
    const size_t first = x->program->ops;
    snprintf(name, sizeof name, "%c%ld", letter, number);
    const int op = append(x, tree);
    program_add_statement(x->program, name, op, first, -1);
    return name_tree(x, op, strlen(name));
}

void forest_output(struct forest *x, const char *name, int tree)
{
    const size_t first = x->program->ops;
    const int op = append(x, tree);
    program_add_statement(x->program, name, op, first, (long)x->program->outputs);
    x->program->output[x->program->outputs++] = op;
}
