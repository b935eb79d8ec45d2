/* What twin trees mean, and their translation to lines; see twin.h.  A function of the frame is compiled once: the lets
 * of its body become lines. */
#include "twin.h"

#include "../common/decimal.h"

#include <stdlib.h>
#include <string.h>

enum { NUMBER = -1, PARAMETER = -2 }; /* genes of leaves; a parameter's half is its operand a */

struct twin_body {
    struct twin_line *line; /* owned */
    size_t lines, room;
    int to[2];
};

struct twin_slot {
    unsigned round;
    int line;
};

/* ---- functions ---- */

/* What compiles one function. */
struct compiler {
    const struct genome_file *program;
    const struct genome_function *function;
    struct twin_body *body;
    int *symbol, *local; /* owned: lines of symbols, and of the function's parameters and lets; -1: none yet */
};

static int add_body_line(struct twin_body *b, struct twin_line line)
{
    grow_array(&b->line, b->lines, &b->room, sizeof *b->line);
    b->line[b->lines] = line;
    return (int)b->lines++;
}

static int line_of_gene(struct compiler *c, int gene);

static int line_of_let(struct compiler *c, const struct genome_expr *let)
{
    int *stack = new_array(let->length, sizeof *stack), *top = stack;
    for (size_t i = let->length; i-- > 0;) {
        const int arity = gene_arity(let->gene[i]);
        if (arity == 0) {
            *top++ = line_of_gene(c, let->gene[i]);
        } else {
            const int a = *--top, b = arity == 2 ? *--top : -1;
            *top++ = add_body_line(c->body, (struct twin_line){let->gene[i], a, b, 0});
        }
    }
    const int root = *--top;
    free(stack);
    return root;
}

static int line_of_local(struct compiler *c, int local)
{
    const int lets = c->function->first_let - GENE_LOCAL;
    if (local < lets)
        return add_body_line(c->body, (struct twin_line){PARAMETER, local, -1, 0});
    return line_of_let(c, &c->function->let[local - lets]);
}

static int line_of_gene(struct compiler *c, int gene)
{
    if (gene < 0)
        return add_body_line(c->body, (struct twin_line){NUMBER, -1, -1, c->program->constant[-1 - gene].value});
    int *line = gene >= GENE_LOCAL ? &c->local[gene - GENE_LOCAL] : &c->symbol[gene - GENE_SYMBOL];
    if (*line < 0)
        *line = gene >= GENE_LOCAL ? line_of_local(c, gene - GENE_LOCAL)
                                   : add_body_line(c->body, (struct twin_line){gene, -1, -1, 0});
    return *line;
}

static int *no_lines(size_t n)
{
    int *line = new_array(n, sizeof *line);
    for (size_t i = 0; i < n; i++)
        line[i] = -1;
    return line;
}

/* Functions that are not of a pair stay without a body. */
static struct twin_body compile(const struct genome_file *f, const struct genome_function *function)
{
    struct twin_body b = {0};
    if (!genome_function_of_pair(function))
        return b;
    const size_t locals = (size_t)(function->first_let - GENE_LOCAL) + function->lets;
    struct compiler c = {f, function, &b, no_lines(f->inputs + f->lets), no_lines(locals)};
    for (int k = 0; k < 2; k++)
        b.to[k] = line_of_gene(&c, function->result[k].gene);
    free(c.symbol);
    free(c.local);
    return b;
}

struct twins *twins_new(const struct genome_file *program)
{
    struct twins *t = new_array(1, sizeof *t);
    *t = (struct twins){.program = program, .symbols = program->inputs + program->lets};
    t->partner = new_array(t->symbols, sizeof *t->partner);
    for (size_t i = 0; i < t->symbols; i++)
        t->partner[i] = i;
    for (size_t i = 0; i < program->exchanges; i++)
        for (int k = 0; k < 2; k++)
            t->partner[program->exchange[i][k]] = program->exchange[i][1 - k];
    t->body = new_array(program->functions, sizeof *t->body);
    for (size_t i = 0; i < program->functions; i++)
        t->body[i] = compile(program, &program->function[i]);
    return t;
}

void twins_free(struct twins *t)
{
    if (!t)
        return;
    for (size_t i = 0; i < t->program->functions; i++)
        free(t->body[i].line);
    free(t->body);
    free(t->partner);
    free(t);
}

/* ---- trees ---- */

struct twin_code *twin_code_new(const struct twins *t)
{
    struct twin_code *c = new_array(1, sizeof *c);
    c->twins = t;
    return c;
}

void twin_code_free(struct twin_code *c)
{
    if (!c)
        return;
    free(c->line);
    free(c->needed);
    free(c->number);
    free(c->slot);
    free(c->stack);
    free(c->map);
    free(c);
}

static size_t place_of(const struct twin_code *c, const struct twin_line *x)
{
    uint64_t bits, h;
    memcpy(&bits, &x->number, sizeof bits);
    h = ((uint64_t)(unsigned)x->gene * 0x9e3779b97f4a7c15u) ^ ((uint64_t)(unsigned)x->a * 0xbf58476d1ce4e5b9u) ^
        ((uint64_t)(unsigned)x->b * 0x94d049bb133111ebu) ^ bits;
    h = (h ^ h >> 31) * 0x9e3779b97f4a7c15u;
    return (size_t)(h >> 32) & (c->slots - 1);
}

static bool same(const struct twin_line *x, const struct twin_line *y)
{
    return x->gene == y->gene && x->a == y->a && x->b == y->b && memcmp(&x->number, &y->number, sizeof x->number) == 0;
}

static void enlarge(struct twin_code *c)
{
    free(c->slot);
    c->slots = c->slots ? 2 * c->slots : 256;
    c->slot = new_array(c->slots, sizeof *c->slot);
    c->round = 1;
    for (size_t i = 0; i < c->lines; i++) {
        size_t at = place_of(c, &c->line[i]);
        while (c->slot[at].round == c->round)
            at = (at + 1) & (c->slots - 1);
        c->slot[at] = (struct twin_slot){c->round, (int)i};
    }
}

/* The line that is equal, or a new one. */
static int line_of(struct twin_code *c, struct twin_line x)
{
    if ((x.gene == GENE_ADD || x.gene == GENE_MUL) && x.a > x.b) {
        const int a = x.a;
        x.a = x.b;
        x.b = a;
    }
    if (2 * (c->lines + 1) > c->slots)
        enlarge(c);
    size_t at = place_of(c, &x);
    for (; c->slot[at].round == c->round; at = (at + 1) & (c->slots - 1))
        if (same(&c->line[c->slot[at].line], &x))
            return c->slot[at].line;
    c->slot[at] = (struct twin_slot){c->round, (int)c->lines};
    grow_array(&c->line, c->lines, &c->room, sizeof *c->line);
    c->line[c->lines] = x;
    return (int)c->lines++;
}

static int leaf(struct twin_code *c, int gene)
{
    return line_of(c, (struct twin_line){gene, -1, -1, 0});
}

static void call(struct twin_code *c, const struct twin_body *b, int x[2])
{
    if (c->map_room < b->lines) {
        free(c->map);
        c->map_room = b->lines;
        c->map = new_array(c->map_room, sizeof *c->map);
    }
    for (size_t i = 0; i < b->lines; i++) {
        struct twin_line line = b->line[i];
        if (line.gene == PARAMETER) {
            c->map[i] = x[line.a];
            continue;
        }
        line.a = line.a >= 0 ? c->map[line.a] : -1;
        line.b = line.b >= 0 ? c->map[line.b] : -1;
        c->map[i] = line_of(c, line);
    }
    x[0] = c->map[b->to[0]];
    x[1] = c->map[b->to[1]];
}

/* A leaf of the tree; a number that is kept apart has the place of its gene as a mark. */
static void push_leaf(struct twin_code *c, int gene, size_t i, bool apart, int top[2])
{
    if (gene >= GENE_SYMBOL) {
        top[0] = leaf(c, gene);
        top[1] = leaf(c, GENE_SYMBOL + (int)c->twins->partner[gene - GENE_SYMBOL]);
        return;
    }
    top[0] = top[1] = line_of(c, (struct twin_line){NUMBER, -1, apart ? -2 - (int)i : -1, decimal_value(gene)});
    if (apart) {
        grow_array(&c->number, c->numbers, &c->number_room, sizeof *c->number);
        c->number[c->numbers++] = (size_t)top[0];
    }
}

static void operate(struct twin_code *c, int gene, int x[2], const int y[2])
{
    const int a = x[0], b = x[1];
    if (gene >= GENE_FUNCTION) {
        call(c, &c->twins->body[gene - GENE_FUNCTION], x);
    } else if (gene == GENE_EXCHANGE) {
        x[0] = b;
        x[1] = a;
    } else if (gene == GENE_HALVES) {
        x[1] = y[1];
    } else {
        x[0] = line_of(c, (struct twin_line){gene, a, y ? y[0] : -1, 0});
        x[1] = line_of(c, (struct twin_line){gene, b, y ? y[1] : -1, 0});
    }
}

static void mark_needed(struct twin_code *c)
{
    free(c->needed);
    c->needed = new_array(c->lines, sizeof *c->needed);
    c->needed[c->root[0]] = c->needed[c->root[1]] = true;
    for (size_t i = c->lines; i-- > 0;)
        if (c->needed[i]) {
            const struct twin_line *x = &c->line[i];
            if (x->a >= 0)
                c->needed[x->a] = true;
            if (x->b >= 0)
                c->needed[x->b] = true;
        }
}

void twin_translate(struct twin_code *c, const struct tree *t, bool apart)
{
    if (c->stack_room < t->length) {
        free(c->stack);
        c->stack_room = t->length;
        c->stack = new_array(c->stack_room, sizeof *c->stack);
    }
    int(*top)[2] = c->stack; /* one past the top */
    c->lines = c->numbers = 0;
    c->round++;
    for (size_t i = t->length; i-- > 0;) {
        const int arity = gene_arity(t->gene[i]);
        if (arity == 0) {
            push_leaf(c, t->gene[i], i, apart, *top++);
        } else {
            int x[2] = {top[-1][0], top[-1][1]};
            operate(c, t->gene[i], x, arity == 2 ? top[-2] : NULL);
            top -= arity - 1;
            top[-1][0] = x[0];
            top[-1][1] = x[1];
        }
    }
    memcpy(c->root, c->stack[0], sizeof c->root);
    for (size_t i = 0; i < c->numbers / 2; i++) { /* read from the back */
        const size_t first = c->number[i];
        c->number[i] = c->number[c->numbers - 1 - i];
        c->number[c->numbers - 1 - i] = first;
    }
    mark_needed(c);
}
