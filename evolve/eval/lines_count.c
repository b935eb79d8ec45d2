/* Counts the operations of programs; see operation_count.h. The lets that the lines need are included, operation by
 * operation, so that a subexpression shared by a function and the frame's values counts once. */
#include "operation_count.h"

#include <stdlib.h>

struct lines_counter {
    const struct genome_file *program; /* not owned */
    struct lines *code;                /* owned */
    struct counter *counter;           /* owned, as are the arrays */
    int *value, *line;                 /* by symbol; by line */
    size_t line_room;
    unsigned *round, now; /* indexed by symbol: the count in which its value was made */
};

struct lines_counter *lines_counter_new(const struct line_rules *t)
{
    struct lines_counter *c = new_array(1, sizeof *c);
    c->program = t->program;
    c->code = lines_new(t);
    c->counter = counter_new();
    c->value = new_array(t->symbols, sizeof *c->value);
    c->round = new_array(t->symbols, sizeof *c->round);
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
    free(c->line);
    free(c);
}

static int value_of_gene(void *counter, int gene, int a, int b);

static int value_of_symbol(struct lines_counter *c, size_t symbol)
{
    if (c->round[symbol] == c->now)
        return c->value[symbol];
    c->round[symbol] = c->now;
    if (symbol < c->program->inputs)
        return c->value[symbol] = counter_leaf(c->counter, GENE_SYMBOL + (int)symbol);
    const struct genome_expr *let = &c->program->let[symbol - c->program->inputs];
    return c->value[symbol] = gene_fold(let->gene, let->length, value_of_gene, c);
}

static int value_of_gene(void *counter, int gene, int a, int b)
{
    struct lines_counter *c = counter;
    if (!gene_is_leaf(gene))
        return counter_operation(c->counter, gene, a, b);
    return gene < 0 ? counter_number(c->counter, c->program->constant[-1 - gene].value)
                    : value_of_symbol(c, (size_t)(gene - GENE_SYMBOL));
}

static void reserve(struct lines_counter *c, size_t lines)
{
    if (lines <= c->line_room)
        return;
    free(c->line);
    c->line_room = 2 * lines;
    c->line = new_array(c->line_room, sizeof *c->line);
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
            c->line[i] = value_of_symbol(c, (size_t)(x->gene - GENE_SYMBOL));
        else if (x->gene < 0)
            c->line[i] = counter_number(c->counter, x->number);
        else
            c->line[i] = counter_operation(c->counter, x->gene, c->line[x->a], x->b >= 0 ? c->line[x->b] : -1);
    }
    const int root[2] = {c->line[code->root[0]], c->line[code->root[1]]};
    return counter_end(c->counter, root, 2);
}
