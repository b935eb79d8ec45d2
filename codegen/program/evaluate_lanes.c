/* Evaluation at several points side by side; see evaluate_lanes.h. Sums and products of pairs use Knuth's and Dekker's
 * exact transformations (T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math.
 * 18, 1971). */
#include "evaluate_lanes.h"

#include "../base/simd.h"
#include "evaluate.h"

#include <math.h>
#include <stdlib.h>

#define SPLITTER 0x1.0000002p27

/* ---- places ---- */

/* The inputs of a step: its operands and, for a sum, the factors of operands that are products, which fma() may use. */
enum { A, B, LEFT, RIGHT = LEFT + 2, OPERANDS = RIGHT + 2 };

struct lanes_step {
    enum op_kind kind;
    int input, to, of[OPERANDS]; /* places; LEFT and RIGHT are -1 without a product */
};

/* Finds the inputs of operation i, or -1. */
static void find_operands(const struct program *p, size_t i, int operand[OPERANDS])
{
    const struct op *op = &p->op[i];
    const int own[2] = {op->a, op->b};
    for (int k = 0; k < 2; k++) {
        const bool product = own[k] >= 0 && (op->kind == OP_ADD || op->kind == OP_SUB) && p->op[own[k]].kind == OP_MUL;
        operand[k] = own[k];
        operand[LEFT + 2 * k] = product ? p->op[own[k]].a : -1;
        operand[LEFT + 2 * k + 1] = product ? p->op[own[k]].b : -1;
    }
}

/* Returns, for each operation, its last user, or itself if it has no user; `ops` for values kept to the end. The caller
 * frees it. */
static size_t *find_last_uses(const struct program *p, size_t ops, const bool *kept)
{
    size_t *last = new_array(ops, sizeof *last);
    int operand[OPERANDS];
    for (size_t i = 0; i < ops; i++) {
        last[i] = i;
        find_operands(p, i, operand);
        for (int k = 0; k < OPERANDS; k++)
            if (operand[k] >= 0)
                last[operand[k]] = i;
    }
    for (size_t i = 0; i < ops; i++)
        if (kept[i] || p->op[i].kind == OP_CONSTANT)
            last[i] = ops;
    return last;
}

/* Returns the place of operation i: new or free. A constant has its place from the beginning. */
static int take_place(struct lanes_plan *plan, size_t i, const int *vacant, size_t *vacancies)
{
    const bool own = plan->program->op[i].kind == OP_CONSTANT || *vacancies == 0;
    return plan->slot[i] = own ? (int)plan->slots++ : vacant[--*vacancies];
}

static void add_step(struct lanes_plan *plan, size_t i, const int operand[OPERANDS])
{
    const struct op *op = &plan->program->op[i];
    struct lanes_step *s = &plan->step[plan->steps++];
    *s = (struct lanes_step){.kind = op->kind, .input = op->input, .to = plan->slot[i]};
    for (int k = 0; k < OPERANDS; k++)
        s->of[k] = operand[k] >= 0 ? plan->slot[operand[k]] : k < LEFT ? 0 : -1;
}

struct lanes_plan lanes_plan_new(const struct program *p, size_t ops, const bool *kept)
{
    struct lanes_plan plan = {.program = p, .ops = ops, .slot = new_array(ops, sizeof *plan.slot)};
    size_t *last = find_last_uses(p, ops, kept), vacancies = 0;
    int *vacant = new_array(ops, sizeof *vacant), operand[OPERANDS + 1];
    plan.step = new_array(ops, sizeof *plan.step);
    for (size_t i = 0; i < ops; i++) {
        take_place(&plan, i, vacant, &vacancies);
        find_operands(p, i, operand);
        if (p->op[i].kind != OP_CONSTANT)
            add_step(&plan, i, operand);
        operand[OPERANDS] = (int)i;
        for (int k = 0; k <= OPERANDS; k++)
            if (operand[k] >= 0 && last[operand[k]] == i) {
                vacant[vacancies++] = plan.slot[operand[k]];
                last[operand[k]] = ops; /* frees it only once */
            }
    }
    free(last);
    free(vacant);
    return plan;
}

void lanes_plan_free(struct lanes_plan *plan)
{
    free(plan->slot);
    free(plan->step);
}

static double low_constant(const fmpq *q, double high)
{
    fmpq_t rest, rounded;
    fmpq_init(rest);
    fmpq_init(rounded);
    double_rational(rounded, high);
    fmpq_sub(rest, q, rounded);
    const double low = double_nearest(rest);
    fmpq_clear(rest);
    fmpq_clear(rounded);
    return low;
}

static void fill(struct lanes *to, double x)
{
    for (int l = 0; l < LANES; l++)
        to->at[l] = x;
}

struct lanes *lanes_new(const struct lanes_plan *plan, struct lanes **low)
{
    const struct program *p = plan->program;
    struct lanes *high = new_array(plan->slots, sizeof *high);
    if (low)
        *low = new_array(plan->slots, sizeof **low);
    for (size_t i = 0; i < plan->ops; i++) {
        if (p->op[i].kind != OP_CONSTANT)
            continue;
        double error;
        const fmpq *q = &p->constant[p->op[i].input];
        const double x = low ? double_nearest(q) : point_constant(p, &p->op[i], &error);
        fill(&high[plan->slot[i]], x);
        if (low)
            fill(&(*low)[plan->slot[i]], low_constant(q, x));
    }
    return high;
}

/* ---- double ---- */

/* Separate loops, because compilers would unroll loops in a switch before vectorising them. */
IN_WIDE void sum(const double *a, const double *b, double *restrict x)
{
    for (size_t l = 0; l < LANES; l++)
        x[l] = a[l] + b[l];
}

IN_WIDE void difference(const double *a, const double *b, double *restrict x)
{
    for (size_t l = 0; l < LANES; l++)
        x[l] = a[l] - b[l];
}

IN_WIDE void product(const double *a, const double *b, double *restrict x)
{
    for (size_t l = 0; l < LANES; l++)
        x[l] = a[l] * b[l];
}

IN_WIDE void quotient(const double *a, const double *b, double *restrict x)
{
    for (size_t l = 0; l < LANES; l++)
        x[l] = a[l] / b[l];
}

/* Computes sign a b + sign_c c. */
IN_WIDE void fused(const double *a, const double *b, double sign, const double *c, double sign_c, double *restrict x)
{
    for (size_t l = 0; l < LANES; l++)
        x[l] = fma(sign * a[l], b[l], sign_c * c[l]);
}

/* Computes x = a + sign b, or a product and the other term as one fma(), by chance. All three are written alike,
 * because a random jump cannot be predicted: fma() with 1 is a sum. */
IN_WIDE void contracted_sum(const struct lanes_step *s, uint64_t chance, double sign, const struct lanes *v, double *x)
{
    static const struct lanes one = {{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
    const bool left = chance == 1 && s->of[LEFT] >= 0, right = chance == 2 && s->of[RIGHT] >= 0;
    const int first = left ? LEFT : right ? RIGHT : B;
    const double *p = v[s->of[first]].at, *q = first == B ? one.at : v[s->of[first + 1]].at;
    fused(p, q, left ? 1 : sign, v[s->of[left ? B : A]].at, left ? sign : 1, x);
}

WIDE void lanes_double(const struct lanes_plan *plan, const struct lanes *input, uint64_t *contract,
                       struct lanes *value)
{
    for (const struct lanes_step *s = plan->step; s < plan->step + plan->steps; s++) {
        const double *restrict a = value[s->of[A]].at, *restrict b = value[s->of[B]].at;
        double *restrict x = value[s->to].at;
        switch (s->kind) {
        case OP_INPUT:
            for (size_t l = 0; l < LANES; l++)
                x[l] = input[s->input].at[l];
            break;
        case OP_NEG:
            for (size_t l = 0; l < LANES; l++)
                x[l] = -a[l];
            break;
        case OP_ADD:
        case OP_SUB:
            if (contract)
                contracted_sum(s, random_next(contract) % 3, s->kind == OP_ADD ? 1 : -1, value, x);
            else if (s->kind == OP_ADD)
                sum(a, b, x);
            else
                difference(a, b, x);
            break;
        case OP_MUL:
            product(a, b, x);
            break;
        case OP_DIV:
            quotient(a, b, x);
            break;
        default:
            for (size_t l = 0; l < LANES; l++)
                x[l] = point_operation(s->kind, a[l], b[l]);
        }
    }
}

/* ---- pairs ---- */

struct pair {
    double x, y;
};

/* Computes a + b; requires |a| >= |b| or a = 0. */
IN_WIDE struct pair pair_of(double a, double b)
{
    const double x = a + b;
    return (struct pair){x, b - (x - a)};
}

IN_WIDE struct pair pair_add(struct pair a, struct pair b)
{
    const double x = a.x + b.x, other = x - a.x;
    return pair_of(x, (a.x - (x - other)) + (b.x - other) + (a.y + b.y));
}

IN_WIDE struct pair pair_multiply(struct pair a, struct pair b)
{
    const double x = a.x * b.x, s = SPLITTER * a.x, t = SPLITTER * b.x;
    const double a1 = s - (s - a.x), b1 = t - (t - b.x), a2 = a.x - a1, b2 = b.x - b1;
    const double rest = ((a1 * b1 - x) + a1 * b2 + a2 * b1) + a2 * b2;
    return pair_of(x, rest + (a.x * b.y + a.y * b.x));
}

IN_WIDE struct pair pair_negative(struct pair a)
{
    return (struct pair){-a.x, -a.y};
}

IN_WIDE struct pair pair_divide(struct pair a, struct pair b)
{
    const double x = a.x / b.x;
    const struct pair rest = pair_add(a, pair_negative(pair_multiply((struct pair){x, 0}, b)));
    return pair_of(x, (rest.x + rest.y) / b.x);
}

IN_WIDE struct pair pair_root(struct pair a)
{
    const double x = sqrt(a.x);
    const struct pair rest = pair_add(a, pair_negative(pair_multiply((struct pair){x, 0}, (struct pair){x, 0})));
    return x > 0 ? pair_of(x, (rest.x + rest.y) / (2 * x)) : (struct pair){x, 0};
}

IN_WIDE bool pair_below(struct pair a, struct pair b)
{
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/* Computes choices, roots and functions. */
static struct pair pair_other(enum op_kind kind, struct pair a, struct pair b)
{
    switch (kind) {
    case OP_PDIV:
        return b.x == 0 ? (struct pair){1, 0} : pair_divide(a, b);
    case OP_MIN:
        return pair_below(a, b) ? a : b;
    case OP_MAX:
        return pair_below(b, a) ? a : b;
    case OP_SQRT:
        return pair_root(a);
    case OP_ABS:
        return a.x < 0 ? pair_negative(a) : a;
    default:
        return (struct pair){point_operation(kind, a.x, b.x), 0};
    }
}

WIDE void lanes_pairs(const struct lanes_plan *plan, const struct lanes *input, struct lanes *high, struct lanes *low)
{
#define EACH(value)                                                                                                    \
    for (size_t l = 0; l < LANES; l++) {                                                                               \
        const struct pair z = value;                                                                                   \
        x[l] = z.x;                                                                                                    \
        y[l] = z.y;                                                                                                    \
    }                                                                                                                  \
    break
#define X ((struct pair){ax[l], ay[l]})
#define Y ((struct pair){bx[l], by[l]})
    for (const struct lanes_step *s = plan->step; s < plan->step + plan->steps; s++) {
        const int a = s->of[A], b = s->of[B];
        const double *restrict ax = high[a].at, *restrict ay = low[a].at;
        const double *restrict bx = high[b].at, *restrict by = low[b].at;
        double *restrict x = high[s->to].at, *restrict y = low[s->to].at;
        switch (s->kind) {
        case OP_INPUT:
            EACH(((struct pair){input[s->input].at[l], 0}));
        case OP_NEG:
            EACH(pair_negative(X));
        case OP_ADD:
            EACH(pair_add(X, Y));
        case OP_SUB:
            EACH(pair_add(X, pair_negative(Y)));
        case OP_MUL:
            EACH(pair_multiply(X, Y));
        case OP_DIV:
            EACH(pair_divide(X, Y));
        default:
            EACH(pair_other(s->kind, X, Y));
        }
    }
#undef EACH
#undef X
#undef Y
}
