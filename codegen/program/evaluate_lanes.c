/* Evaluation at several points side by side; see evaluate_lanes.h.  Sums and products of pairs by Knuth's and Dekker's exact
 * transformations (T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18, 1971). */
#include "evaluate_lanes.h"

#include "evaluate.h"

#include <math.h>
#include <stdlib.h>

#define SPLITTER 0x1.0000002p27

/* ---- places ---- */

/* What operation i takes: its operands, and of a sum those of products, as one fma() may take them. */
#define OPERANDS 6
static void find_operands(const struct program *p, size_t i, int operand[OPERANDS])
{
    const struct op *op = &p->op[i];
    const int own[2] = {op->a, op->b};
    for (int k = 0; k < 2; k++) {
        const bool product = own[k] >= 0 && (op->kind == OP_ADD || op->kind == OP_SUB) && p->op[own[k]].kind == OP_MUL;
        operand[3 * k] = own[k];
        operand[3 * k + 1] = product ? p->op[own[k]].a : -1;
        operand[3 * k + 2] = product ? p->op[own[k]].b : -1;
    }
}

/* By operation, the last that takes it, itself if none does; those that are never given up, the end. */
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

struct lanes_plan lanes_plan_new(const struct program *p, size_t ops, const bool *kept)
{
    struct lanes_plan plan = {.program = p, .ops = ops, .slot = new_array(ops, sizeof *plan.slot)};
    size_t *last = find_last_uses(p, ops, kept), vacancies = 0;
    int *vacant = new_array(ops, sizeof *vacant), operand[OPERANDS + 1];
    for (size_t i = 0; i < ops; i++) {
        const bool own = p->op[i].kind == OP_CONSTANT || vacancies == 0; /* a constant is there from the beginning */
        plan.slot[i] = own ? (int)plan.slots++ : vacant[--vacancies];
        find_operands(p, i, operand);
        operand[OPERANDS] = (int)i;
        for (int k = 0; k <= OPERANDS; k++)
            if (operand[k] >= 0 && last[operand[k]] == i) {
                vacant[vacancies++] = plan.slot[operand[k]];
                last[operand[k]] = ops; /* once */
            }
    }
    free(last);
    free(vacant);
    return plan;
}

void lanes_plan_free(struct lanes_plan *plan)
{
    free(plan->slot);
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

/* Loops of their own: in a switch compilers unroll them before they vectorise. */
static void product(const double *a, const double *b, double *restrict x)
{
    for (size_t l = 0; l < LANES; l++)
        x[l] = a[l] * b[l];
}

static void quotient(const double *a, const double *b, double *restrict x)
{
    for (size_t l = 0; l < LANES; l++)
        x[l] = a[l] / b[l];
}

/* a b + sign c */
static void fused(const double *a, const double *b, double sign_product, const double *c, double sign, double *x)
{
    for (size_t l = 0; l < LANES; l++)
        x[l] = fma(sign_product * a[l], b[l], sign * c[l]);
}

static void sum(const struct lanes_plan *plan, const struct op *op, uint64_t *contract, const struct lanes *v,
                double *restrict x)
{
    const struct op *left = &plan->program->op[op->a], *right = &plan->program->op[op->b];
    const int *slot = plan->slot;
    const double *restrict a = v[slot[op->a]].at, *restrict b = v[slot[op->b]].at;
    const double sign = op->kind == OP_ADD ? 1 : -1;
    const uint64_t choice = contract ? random_next(contract) % 3 : 0;
    if (choice == 1 && left->kind == OP_MUL)
        fused(v[slot[left->a]].at, v[slot[left->b]].at, 1, b, sign, x);
    else if (choice == 2 && right->kind == OP_MUL)
        fused(v[slot[right->a]].at, v[slot[right->b]].at, sign, a, 1, x);
    else
        for (size_t l = 0; l < LANES; l++)
            x[l] = a[l] + sign * b[l];
}

/* The place of an operand; of none, any. */
static int place_of(const struct lanes_plan *plan, int op)
{
    return op >= 0 ? plan->slot[op] : 0;
}

void lanes_double(const struct lanes_plan *plan, const struct lanes *input, uint64_t *contract, struct lanes *value)
{
    for (size_t i = 0; i < plan->ops; i++) {
        const struct op *op = &plan->program->op[i];
        const double *restrict a = value[place_of(plan, op->a)].at, *restrict b = value[place_of(plan, op->b)].at;
        double *restrict x = value[plan->slot[i]].at;
        switch (op->kind) {
        case OP_CONSTANT:
            break;
        case OP_INPUT:
            for (size_t l = 0; l < LANES; l++)
                x[l] = input[op->input].at[l];
            break;
        case OP_NEG:
            for (size_t l = 0; l < LANES; l++)
                x[l] = -a[l];
            break;
        case OP_ADD:
        case OP_SUB:
            sum(plan, op, contract, value, x);
            break;
        case OP_MUL:
            product(a, b, x);
            break;
        case OP_DIV:
            quotient(a, b, x);
            break;
        default:
            for (size_t l = 0; l < LANES; l++)
                x[l] = point_operation(op->kind, a[l], b[l]);
        }
    }
}

/* ---- pairs ---- */

struct pair {
    double x, y;
};

/* a + b where |a| >= |b| or a is 0 */
static inline struct pair pair_of(double a, double b)
{
    const double x = a + b;
    return (struct pair){x, b - (x - a)};
}

static inline struct pair pair_add(struct pair a, struct pair b)
{
    const double x = a.x + b.x, other = x - a.x;
    return pair_of(x, (a.x - (x - other)) + (b.x - other) + (a.y + b.y));
}

static inline struct pair pair_multiply(struct pair a, struct pair b)
{
    const double x = a.x * b.x, s = SPLITTER * a.x, t = SPLITTER * b.x;
    const double a1 = s - (s - a.x), b1 = t - (t - b.x), a2 = a.x - a1, b2 = b.x - b1;
    const double rest = ((a1 * b1 - x) + a1 * b2 + a2 * b1) + a2 * b2;
    return pair_of(x, rest + (a.x * b.y + a.y * b.x));
}

static inline struct pair pair_negative(struct pair a)
{
    return (struct pair){-a.x, -a.y};
}

static inline struct pair pair_divide(struct pair a, struct pair b)
{
    const double x = a.x / b.x;
    const struct pair rest = pair_add(a, pair_negative(pair_multiply((struct pair){x, 0}, b)));
    return pair_of(x, (rest.x + rest.y) / b.x);
}

static inline struct pair pair_root(struct pair a)
{
    const double x = sqrt(a.x);
    const struct pair rest = pair_add(a, pair_negative(pair_multiply((struct pair){x, 0}, (struct pair){x, 0})));
    return x > 0 ? pair_of(x, (rest.x + rest.y) / (2 * x)) : (struct pair){x, 0};
}

static inline bool pair_below(struct pair a, struct pair b)
{
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/* Choices, roots and functions. */
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

void lanes_pairs(const struct lanes_plan *plan, const struct lanes *input, struct lanes *high, struct lanes *low)
{
#define EACH(value)                                                                                                    \
    for (size_t l = 0; l < LANES; l++) {                                                                               \
        const struct pair z = value;                                                                                   \
        x[l] = z.x;                                                                                                    \
        y[l] = z.y;                                                                                                    \
    }                                                                                                                  \
    break
#define A ((struct pair){ax[l], ay[l]})
#define B ((struct pair){bx[l], by[l]})
    for (size_t i = 0; i < plan->ops; i++) {
        const struct op *op = &plan->program->op[i];
        const int a = place_of(plan, op->a), b = place_of(plan, op->b);
        const double *restrict ax = high[a].at, *restrict ay = low[a].at;
        const double *restrict bx = high[b].at, *restrict by = low[b].at;
        double *restrict x = high[plan->slot[i]].at, *restrict y = low[plan->slot[i]].at;
        switch (op->kind) {
        case OP_CONSTANT:
            break;
        case OP_INPUT:
            EACH(((struct pair){input[op->input].at[l], 0}));
        case OP_NEG:
            EACH(pair_negative(A));
        case OP_ADD:
            EACH(pair_add(A, B));
        case OP_SUB:
            EACH(pair_add(A, pair_negative(B)));
        case OP_MUL:
            EACH(pair_multiply(A, B));
        case OP_DIV:
            EACH(pair_divide(A, B));
        default:
            EACH(pair_other(op->kind, A, B));
        }
    }
#undef EACH
#undef A
#undef B
}
