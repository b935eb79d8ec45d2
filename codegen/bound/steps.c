/* Derivatives backwards, as operations of a program; see steps.h. */
#include "steps.h"

#include "../graph/constant_text.h"
#include "../program/genome_program.h"
#include "../prove/prove_points.h"
#include "interval.h"

#include <stdlib.h>

/* ---- derivatives ---- */

/* slope = d to / d from. */
struct step {
    int to, from, slope, most; /* operations */
};

struct step_list {
    struct step *step; /* owned */
    size_t steps, room;
};

/* For one `to`. */
struct sweep {
    struct program *program;
    int *slope; /* owned: by operation, that of `to` by it; < 0: none yet */
    int one;    /* the slope of `to` by itself */
};

static void charge(struct sweep *s, int operand, int part)
{
    int *to = &s->slope[operand];
    *to = *to >= 0 ? program_add(s->program, OP_ADD, *to, part) : part;
}

static int times(struct sweep *s, int slope, int factor)
{
    return slope == s->one ? factor : program_add(s->program, OP_MUL, slope, factor);
}

static int negative(struct sweep *s, int slope)
{
    return program_add(s->program, OP_NEG, slope, -1);
}

static int number(struct program *p, long n, unsigned long d)
{
    fmpq_t q;
    fmpq_init(q);
    fmpq_set_si(q, n, d);
    const int op = program_add_constant(p, q, false);
    fmpq_clear(q);
    return op;
}

/* What operation i owes to its operands, as far as these are wanted; false: it has no derivative. */
static bool charge_operands(struct sweep *s, int i, const bool *wanted)
{
    const struct op op = s->program->op[i];
    const bool a = op.a >= 0 && wanted[op.a], b = op.b >= 0 && wanted[op.b];
    int slope = s->slope[i];
    switch (op.kind) {
    case OP_NEG:
        charge(s, op.a, negative(s, slope));
        return true;
    case OP_ADD:
    case OP_SUB:
        if (a)
            charge(s, op.a, slope);
        if (b)
            charge(s, op.b, op.kind == OP_ADD ? slope : negative(s, slope));
        return true;
    case OP_MUL:
        if (a)
            charge(s, op.a, times(s, slope, op.b));
        if (b)
            charge(s, op.b, times(s, slope, op.a));
        return true;
    case OP_DIV:
        slope = program_add(s->program, OP_DIV, slope, op.b);
        if (a)
            charge(s, op.a, slope);
        if (b)
            charge(s, op.b, negative(s, program_add(s->program, OP_MUL, slope, i)));
        return true;
    case OP_SQRT:
        charge(s, op.a, program_add(s->program, OP_DIV, times(s, slope, number(s->program, 1, 2)), i));
        return true;
    default:
        return false;
    }
}

/* By operation before `to`: it is held, or made of what is. */
static bool *find_wanted(const struct program *p, const bool *held, int to)
{
    bool *wanted = new_array((size_t)to, sizeof *wanted);
    for (int i = 0; i < to; i++) {
        const struct op *op = &p->op[i];
        wanted[i] = held[i] || (op->a >= 0 && wanted[op->a]) || (op->b >= 0 && wanted[op->b]);
    }
    return wanted;
}

/* Appends to the program the derivatives of operation `to` by those that it is made of and that are held; none where a
 * minimum, a magnitude or the like is on the way. */
static void add_steps(struct program *p, const bool *held, int to, struct step_list *list)
{
    bool *wanted = find_wanted(p, held, to), good = true;
    struct sweep s = {.program = p, .slope = new_array((size_t)to + 1, sizeof *s.slope)};
    const struct op op = p->op[to];
    const size_t before = list->steps;
    for (int i = 0; i <= to; i++)
        s.slope[i] = -1;
    if ((op.a >= 0 && wanted[op.a]) || (op.b >= 0 && wanted[op.b])) {
        s.slope[to] = s.one = number(p, 1, 1);
        good = charge_operands(&s, to, wanted);
    }
    for (int i = to - 1; i >= 0 && good; i--) {
        if (s.slope[i] < 0)
            continue;
        if (!held[i]) {
            good = charge_operands(&s, i, wanted);
            continue;
        }
        APPEND(list->step, list->steps, list->room) = (struct step){to, i, s.slope[i], -1};
    }
    list->steps = good ? list->steps : before;
    free(wanted);
    free(s.slope);
}

/* ---- limits ---- */

static int value_of(const int *twin, int op)
{
    return twin[op] >= 0 ? twin[op] : op;
}

/* v of a require W - |v - m|. */
static int held_value(const struct program *p, int require)
{
    return p->op[p->op[p->op[require].b].a].a;
}

/* The derivatives that the requires limit; the program's outputs become K - |dv/dw|. */
static struct step_list add_required(const struct genome_file *f, struct program *p, const bool *pinned,
                                     const int *require)
{
    struct step_list list = {NULL, 0, 0};
    fmpq_t k;
    fmpq_init(k);
    for (size_t i = 0; i < f->requires; i++) {
        if (f->require[i].step == 0)
            continue;
        size_t n = list.steps;
        add_steps(p, pinned, held_value(p, require[i]), &list);
        constant_read(k, f->constant[f->require[i].step - 1].text);
        for (const int most = program_add_constant(p, k, false); n < list.steps; n++)
            list.step[n].most = most;
    }
    fmpq_clear(k);
    free(p->output);
    p->output = new_array(list.steps, sizeof *p->output);
    for (size_t n = 0; n < list.steps; n++) {
        const int size = program_add(p, OP_ABS, list.step[n].slope, -1);
        p->output[p->outputs++] = program_add(p, OP_SUB, list.step[n].most, size);
    }
    return list;
}

static bool alike(const struct step *a, const struct step *b, const int *twin, const int *class)
{
    return value_of(twin, a->to) == value_of(twin, b->to) && value_of(twin, a->from) == value_of(twin, b->from) &&
           class[a->slope] == class[b->slope];
}

static void add_limit(struct step_limits *s, const struct step *a, const fmpq_t most)
{
    APPEND(s->limit, s->limits, s->limit_room) =
        (struct step_limit){a->to, a->from, interval_most(interval_around(most))};
}

/* A step of the program is limited where its derivative is a number, mostly 0, or a multiple of a required one.  That it is
 * does not follow from what they are derivatives of: a program may come by the same values on another way. */
static void find_limits(struct step_limits *s, struct program *p, const struct step_list *own,
                        const struct step_list *required, const int *twin)
{
    int divisor;
    const int one = number(p, 1, 1);
    struct points *points = points_new(p, &divisor);
    int *class = points ? points_classes(points) : NULL;
    fmpq_t ratio;
    fmpq_init(ratio);
    for (size_t i = 0; class && i < own->steps; i++) {
        const struct step *a = &own->step[i];
        if (class[a->slope] < 0 && points_factor(points, a->slope, one, ratio))
            add_limit(s, a, ratio);
        for (size_t k = 0; k < required->steps; k++) {
            const struct step *b = &required->step[k];
            if (!alike(a, b, twin, class) || !points_factor(points, a->slope, b->slope, ratio))
                continue;
            fmpq_mul(ratio, ratio, &p->constant[p->op[b->most].input]);
            add_limit(s, a, ratio);
        }
    }
    fmpq_clear(ratio);
    free(class);
    points_free(points);
}

static bool has_steps(const struct genome_file *f)
{
    for (size_t i = 0; i < f->requires; i++)
        if (f->require[i].step > 0)
            return true;
    return false;
}

/* The first operations of a program, in one of their own. */
static struct program *copy(const struct genome_file *f, const struct program *p, size_t ops)
{
    struct program part = *p, *copy = program_new(f->region, 0);
    part.ops = ops;
    program_append(copy, &part, NULL);
    return copy;
}

struct step_limits step_limits_new(const struct genome_file *f, const struct program *p, size_t first,
                                   const int *require, const int *twin, const bool *pinned)
{
    struct step_limits s = {NULL, NULL, 0, 0};
    if (!has_steps(f))
        return s;
    s.program = copy(f, p, first);
    free(add_required(f, s.program, pinned, require).step);
    struct program *both = copy(f, p, p->ops);
    struct step_list required = add_required(f, both, pinned, require), own = {NULL, 0, 0};
    for (size_t i = first; i < p->ops; i++)
        if (pinned[i])
            add_steps(both, pinned, (int)i, &own);
    find_limits(&s, both, &own, &required, twin);
    program_free(both);
    free(required.step);
    free(own.step);
    return s;
}

void step_limits_free(struct step_limits *s)
{
    program_free(s->program);
    free(s->limit);
}

double step_limits_most(const struct step_limits *s, int to, int from)
{
    double most = INFINITY;
    for (size_t i = 0; i < s->limits; i++)
        if (s->limit[i].to == to && s->limit[i].from == from && s->limit[i].most < most)
            most = s->limit[i].most;
    return most;
}
