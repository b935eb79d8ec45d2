/* Operations of programs; see operation_count.h.  The lets that the lines need are counted with them, operation by
 * operation, so that what a function has in common with the frame's values is counted once. */
#include "operation_count.h"

#include <stdlib.h>

struct lines_counter {
    const struct genome_file *program; /* not owned */
    struct lines *code;                /* owned, as are these */
    struct counter *counter;
    size_t capacity, symbols, let_genes;
    struct operand *value, *stack, *line; /* by symbol; of the lets on their way; by line */
    size_t line_room;
    unsigned *round, now; /* by symbol: the count in which its value was made */
};

struct lines_counter *lines_counter_new(const struct line_rules *t)
{
    struct lines_counter *c = new_array(1, sizeof *c);
    c->program = t->program;
    c->code = lines_new(t);
    c->symbols = t->symbols;
    for (size_t i = 0; i + t->program->inputs < c->symbols; i++)
        c->let_genes += t->program->let[i].length;
    c->value = new_array(c->symbols, sizeof *c->value);
    c->round = new_array(c->symbols, sizeof *c->round);
    c->stack = new_array(c->let_genes + 1, sizeof *c->stack);
    return c;
}

void lines_counter_free(struct lines_counter *c)
{
    if (!c)
        return;
    lines_free(c->code);
    counter_free(c->counter);
    free(c->value);
    free(c->round);
    free(c->stack);
    free(c->line);
    free(c);
}

static struct operand value_of_symbol(struct lines_counter *c, size_t symbol, struct operand *stack);

static struct operand value_of_leaf(struct lines_counter *c, int gene, struct operand *stack)
{
    return gene < 0 ? counter_number(c->counter, c->program->constant[-1 - gene].value)
                    : value_of_symbol(c, (size_t)(gene - GENE_SYMBOL), stack);
}

/* stack: room for what this let and those that it needs have on their way. */
static struct operand value_of_symbol(struct lines_counter *c, size_t symbol, struct operand *stack)
{
    if (c->round[symbol] == c->now)
        return c->value[symbol];
    struct operand value;
    if (symbol < c->program->inputs) {
        value = counter_leaf(c->counter, GENE_SYMBOL + (int)symbol);
    } else {
        const struct genome_expr *let = &c->program->let[symbol - c->program->inputs];
        struct operand *top = stack;
        for (size_t i = let->length; i-- > 0;) {
            const int arity = gene_arity(let->gene[i]);
            if (arity == 0) {
                const struct operand leaf = value_of_leaf(c, let->gene[i], top);
                *top++ = leaf;
            } else {
                const struct operand a = *--top, b = arity == 2 ? *--top : a;
                *top++ = counter_operation(c->counter, let->gene[i], a, b);
            }
        }
        value = *--top;
    }
    c->round[symbol] = c->now;
    return c->value[symbol] = value;
}

static void reserve(struct lines_counter *c, size_t lines)
{
    if (lines > c->line_room) {
        free(c->line);
        c->line_room = 2 * lines;
        c->line = new_array(c->line_room, sizeof *c->line);
    }
    if (lines + c->symbols + c->let_genes > c->capacity) {
        counter_free(c->counter);
        c->capacity = 2 * lines + c->symbols + c->let_genes;
        c->counter = counter_new(c->capacity);
    }
}

struct operation_count count_lines(struct lines_counter *c, const struct genes *t, int last)
{
    struct lines *code = c->code;
    lines_load(code, t, last, LINES_WHOLE);
    reserve(c, code->lines);
    counter_begin(c->counter);
    c->now++;
    for (size_t i = 0; i < code->lines; i++) {
        const struct line *x = &code->line[i];
        if (!code->needed[i])
            continue;
        if (x->gene >= GENE_SYMBOL)
            c->line[i] = value_of_symbol(c, (size_t)(x->gene - GENE_SYMBOL), c->stack);
        else if (x->gene < 0)
            c->line[i] = counter_number(c->counter, x->number);
        else
            c->line[i] = counter_operation(c->counter, x->gene, c->line[x->a], c->line[x->b >= 0 ? x->b : x->a]);
    }
    const struct operand root[2] = {c->line[code->root[0]], c->line[code->root[1]]};
    return counter_end(c->counter, root, 2);
}
