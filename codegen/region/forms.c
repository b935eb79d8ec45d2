/* Memory for enclosures, and the choice of enclosed operations; see forms.h. */
#include "forms.h"

#include <stdlib.h>

enum { MOST_SLOPES = 1 << 22, SHORT = 32 /* operations */ };

/* The operations needed so far, and the values, multiples counted as one, that have such an operation. */
struct choice {
    const struct known *known;
    bool *needed, *value; /* owned: by operation */
    int *stack;           /* owned */
    size_t depth, room;
};

static int value_of(const struct known *x, int op)
{
    return x->twin[op] >= 0 ? x->twin[op] : op;
}

static struct interval ratio_of(const struct known *x, int op)
{
    return x->twin[op] >= 0 ? x->ratio[op] : interval_point(1);
}

static void push(struct choice *c, int op)
{
    if (op < 0 || c->needed[op])
        return;
    c->needed[op] = c->value[value_of(c->known, op)] = true;
    APPEND(c->stack, c->depth, c->room) = op;
}

/* Adds everything on which `op` depends; returns the number of operations added. */
static size_t need(struct choice *c, int op)
{
    size_t added = 0;
    push(c, op);
    for (; c->depth > 0; added++) {
        const int next = c->stack[--c->depth];
        const struct op *o = &c->known->program->op[next];
        push(c, o->a);
        push(c, o->b);
        if (c->known->twin[next] >= 0 && c->known->twin[next] < (int)c->known->shapes)
            push(c, c->known->twin[next]);
    }
    return added;
}

/* Returns true if a require, down to some depth, narrows an operand that is needed. */
static bool tells(const struct choice *c, int op, int depth)
{
    const struct op *o = &c->known->program->op[op];
    return (o->kind > OP_INPUT && c->value[value_of(c->known, op)]) ||
           (depth > 0 && ((o->a >= 0 && tells(c, o->a, depth - 1)) || (o->b >= 0 && tells(c, o->b, depth - 1))));
}

/* Chooses operations; a require that builds on others follows them. */
static void choose_operations(struct forms *w, const int *target, size_t targets)
{
    const struct known *x = w->known;
    const struct program *p = x->program;
    struct choice c = {.known = x};
    c.needed = new_array(p->ops, sizeof *c.needed);
    c.value = new_array(p->ops, sizeof *c.value);
    for (size_t i = 0; i < targets; i++)
        w->needs += need(&c, target[i]);
    for (size_t i = p->outputs; i-- > 0;)
        if (targets == 0 || x->length[p->output[i]] <= SHORT || tells(&c, p->output[i], FORMS_DEPTH)) {
            w->required[p->output[i]] = true;
            w->needs += need(&c, p->output[i]);
        }
    w->needed = arena_array(&w->arena, w->needs, sizeof *w->needed);
    for (size_t i = 0, n = 0; i < p->ops; i++)
        if (c.needed[i])
            w->needed[n++] = (int)i;
    free(c.needed);
    free(c.value);
    free(c.stack);
}

/* Links twins among the needed operations. */
static void choose_twins(struct forms *w)
{
    const struct known *x = w->known;
    int *first = new_array(x->program->ops, sizeof *first);
    for (size_t n = 0; n < w->needs; n++) {
        const int i = w->needed[n], value = value_of(x, i);
        w->twin[i] = first[value] - 1;
        if (w->twin[i] < 0)
            first[value] = i + 1;
        else
            w->ratio[i] = interval_divide(ratio_of(x, i), ratio_of(x, w->twin[i]));
    }
    free(first);
}

struct forms *forms_new(const struct known *x, const int *target, size_t targets)
{
    struct forms *w = new_array(1, sizeof *w);
    const size_t rows = 2 * x->program->ops + FORMS_HANDS;
    *w = (struct forms){.known = x};
    w->required = arena_array(&w->arena, rows, sizeof *w->required);
    w->twin = arena_array(&w->arena, rows, sizeof *w->twin);
    w->ratio = arena_array(&w->arena, rows, sizeof *w->ratio);
    choose_operations(w, target, targets);
    choose_twins(w);
    w->affine = x->variables > 0 && rows <= MOST_SLOPES / x->variables;
    w->range = arena_array(&w->arena, rows, sizeof *w->range);
    w->centre = arena_array(&w->arena, rows, sizeof *w->centre);
    w->radius = arena_array(&w->arena, rows, sizeof *w->radius);
    w->mass = arena_array(&w->arena, rows, sizeof *w->mass);
    w->slope = arena_array(&w->arena, w->affine ? rows * x->variables : 0, sizeof *w->slope);
    w->middle = arena_array(&w->arena, x->variables, sizeof *w->middle);
    w->half = arena_array(&w->arena, x->variables, sizeof *w->half);
    return w;
}

void forms_free(struct forms *w)
{
    if (!w)
        return;
    arena_free(&w->arena);
    free(w);
}
