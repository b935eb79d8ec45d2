/* The evaluator of evolution.  A prefix genome is read from the back with a stack (Tokui and Iba's linear genetic
 * programming, section 4.2 of the paper) once, which gives a list of steps `block = block op block`; the steps then run
 * over one block of samples after the other.  Leaves are never copied: a column is read in place, a constant is a
 * scalar of the loop, and operators of constants are folded.  The loops are plain C, vectorised by the compiler; the
 * same source is compiled for several vector widths, and the widest that the machine has is taken when the workspace
 * is made.  Nothing is reassociated or contracted, so all widths give the same bits. */
#include "kernel.h"

#include "decimal.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Operands and result of a step are one block or separate ones, never shifted against each other. */
#if defined __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* of the next pragma, in builds that do not optimise */
#define INDEPENDENT _Pragma("clang loop vectorize(assume_safety) interleave_count(4)")
#else
#define INDEPENDENT _Pragma("GCC ivdep") _Pragma("GCC unroll 4")
#endif
#define INLINE static inline __attribute__((always_inline))

/* What an operand is. */
enum kind { CONSTANT, BLOCK, COLUMN };

struct operand {
    enum kind kind;
    double constant;
    const double *first; /* of the block, or of the column's first row */
};

/* Which operands of a step are arrays. */
enum form { ARRAY_ARRAY, ARRAY_CONSTANT, CONSTANT_ARRAY, FORMS };

struct step {
    int code; /* operator * FORMS + form */
    struct operand a, b;
    double *to;
};

struct kernel {
    enum kernel_width width;
    double work;
    struct step *step; /* owned */
    size_t steps, step_room;
    struct operand *stack; /* owned */
    size_t stack_room;
    struct operand root;
    double *block, *memory; /* stack of blocks, aligned in `memory`, which is owned */
    size_t blocks;
};

enum { LINE = 64 };

static double *align(double *p)
{
    const uintptr_t over = (uintptr_t)p % LINE;
    return over ? p + (LINE - over) / sizeof *p : p;
}

struct columns columns_new(size_t n, size_t count)
{
    const size_t room = (n + KERNEL_BLOCK - 1) / KERNEL_BLOCK * KERNEL_BLOCK;
    struct columns c = {.n = n, .count = count, .room = room};
    c.memory = new_array(room * count + LINE / sizeof(double), sizeof(double));
    c.data = align(c.memory);
    return c;
}

void columns_free(struct columns *c)
{
    free(c->memory);
    *c = (struct columns){0};
}

double *columns_at(const struct columns *c, size_t column)
{
    return c->data + column * c->room;
}

/* Meaning of the operators, for scalars and, vectorised, for blocks.  Min and max give the second operand where one
 * is not a number; x / 0 is what IEEE 754 says. */
__attribute__((no_sanitize("float-divide-by-zero"))) INLINE double apply(int op, double x, double y)
{
    switch (op) {
    case GENE_ADD:
        return x + y;
    case GENE_SUB:
        return x - y;
    case GENE_MUL:
        return x * y;
    case GENE_DIV:
        return x / y;
    case GENE_PDIV: /* one division without a condition, so that it vectorises */
        return (y == 0 ? 1 : x) / (y + (y == 0 ? 1 : 0));
    case GENE_MIN:
        return x < y ? x : y;
    case GENE_MAX:
        return x > y ? x : y;
    case GENE_NEG:
        return -x;
    case GENE_SQRT:
        return sqrt(x);
    default:
        return fabs(x);
    }
}

#define CASE(op, form, x, y)                                                                                           \
    case (op)*FORMS + (form):                                                                                          \
        INDEPENDENT for (size_t i = 0; i < KERNEL_BLOCK; i++) to[i] = apply(op, x, y);                                 \
        break;
#define UNARY(op) CASE(op, ARRAY_ARRAY, a[i], 0)
#define BINARY(op)                                                                                                     \
    CASE(op, ARRAY_ARRAY, a[i], b[i])                                                                                  \
    CASE(op, ARRAY_CONSTANT, a[i], kb)                                                                                 \
    CASE(op, CONSTANT_ARRAY, ka, b[i])

INLINE const double *at(const struct operand *o, size_t row)
{
    return o->kind == COLUMN ? o->first + row : o->first;
}

/* All steps for the block of samples that begins at `row`. */
INLINE void run_steps(const struct kernel *k, size_t row)
{
    for (const struct step *s = k->step; s < k->step + k->steps; s++) {
        const double *a = at(&s->a, row), *b = at(&s->b, row);
        const double ka = s->a.constant, kb = s->b.constant;
        double *to = s->to;
        switch (s->code) {
            BINARY(GENE_ADD)
            BINARY(GENE_SUB)
            BINARY(GENE_MUL)
            BINARY(GENE_DIV)
            BINARY(GENE_PDIV)
            BINARY(GENE_MIN)
            BINARY(GENE_MAX)
            UNARY(GENE_NEG)
            UNARY(GENE_ABS)
            UNARY(GENE_SQRT)
        }
    }
}

static double sum_lanes(const double lane[KERNEL_LANES])
{
    double sum = 0;
    for (int j = 0; j < KERNEL_LANES; j++)
        sum += lane[j];
    return sum;
}

INLINE double run_error_sum(struct kernel *k, const struct kernel_task *t, size_t target, double bound)
{
    const double *goal = columns_at(t->table, target);
    double lane[KERNEL_LANES] = {0}, sum = 0;
    for (size_t row = 0; row < t->table->n; row += KERNEL_BLOCK) {
        const size_t left = t->table->n - row, n = left < KERNEL_BLOCK ? left : KERNEL_BLOCK;
        run_steps(k, row);
        const double *value = at(&k->root, row);
        size_t i = 0;
        for (; i + KERNEL_LANES <= n; i += KERNEL_LANES)
            for (size_t j = 0; j < KERNEL_LANES; j++)
                lane[j] += fabs(value[i + j] - goal[row + i + j]);
        for (size_t j = 0; i + j < n; j++)
            lane[j] += fabs(value[i + j] - goal[row + i + j]);
        k->work += (double)(t->length * n);
        sum = sum_lanes(lane);
        if (!(sum <= bound))
            return INFINITY;
    }
    return isfinite(sum) ? sum : INFINITY;
}

INLINE void run_values(const struct kernel *k, const struct kernel_task *t, double *value)
{
    for (size_t row = 0; row < t->table->n; row += KERNEL_BLOCK) {
        const size_t left = t->table->n - row;
        run_steps(k, row);
        memcpy(value + row, at(&k->root, row), (left < KERNEL_BLOCK ? left : KERNEL_BLOCK) * sizeof *value);
    }
}

typedef double error_sum_fn(struct kernel *, const struct kernel_task *, size_t, double);
typedef void values_fn(const struct kernel *, const struct kernel_task *, double *);

#define ENGINE(name, attribute)                                                                                        \
    attribute static double error_sum_##name(struct kernel *k, const struct kernel_task *t, size_t target,             \
                                             double bound)                                                             \
    {                                                                                                                  \
        return run_error_sum(k, t, target, bound);                                                                     \
    }                                                                                                                  \
    attribute static void values_##name(const struct kernel *k, const struct kernel_task *t, double *value)            \
    {                                                                                                                  \
        run_values(k, t, value);                                                                                       \
    }

ENGINE(plain, )
#if defined __x86_64__
ENGINE(256, __attribute__((target("arch=x86-64-v3"))))
ENGINE(512, __attribute__((target("arch=x86-64-v4"))))
#endif

static const struct {
    int bits;
    error_sum_fn *error_sum;
    values_fn *values;
} engine[KERNEL_WIDTHS] = {
#if defined __AVX512F__
    {512, error_sum_plain, values_plain},
#elif defined __AVX__
    {256, error_sum_plain, values_plain},
#else
    {128, error_sum_plain, values_plain},
#endif
#if defined __x86_64__
    {256, error_sum_256, values_256},
    {512, error_sum_512, values_512},
#endif
};

int kernel_bits(enum kernel_width width)
{
    return engine[width].bits;
}

bool kernel_supports(enum kernel_width width)
{
#if defined __x86_64__
    switch (width) {
    case KERNEL_256:
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
    case KERNEL_512:
        return kernel_supports(KERNEL_256) && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
    default:
        return true;
    }
#else
    return width == KERNEL_PLAIN;
#endif
}

struct kernel *kernel_new(enum kernel_width width)
{
    struct kernel *k = new_array(1, sizeof *k);
    k->width = width;
    return k;
}

struct kernel *kernel_new_widest(void)
{
    enum kernel_width width = KERNEL_512;
    while (!kernel_supports(width))
        width--;
    return kernel_new(width);
}

void kernel_free(struct kernel *k)
{
    if (!k)
        return;
    free(k->step);
    free(k->stack);
    free(k->memory);
    free(k);
}

/* Room for a genome of `length` genes: at most length / 2 operators, as many blocks. */
static void reserve(struct kernel *k, size_t length)
{
    if (length <= k->stack_room)
        return;
    free(k->step);
    free(k->stack);
    free(k->memory);
    k->stack_room = length;
    k->step = new_array(length, sizeof *k->step);
    k->stack = new_array(length, sizeof *k->stack);
    k->memory = new_array((length / 2 + 1) * KERNEL_BLOCK + LINE / sizeof(double), sizeof(double));
    k->block = align(k->memory);
}

static void translate(struct kernel *k, const struct kernel_task *t)
{
    reserve(k, t->length);
    k->steps = 0;
    struct operand *top = k->stack; /* one past the top */
    size_t blocks = 0;              /* live on the stack */
    for (size_t i = t->length; i-- > 0;) {
        const int gene = t->gene[i], arity = gene_arity(gene);
        if (gene >= GENE_SYMBOL) {
            *top++ = (struct operand){COLUMN, 0, columns_at(t->table, (size_t)(gene - GENE_SYMBOL))};
            continue;
        }
        if (gene < 0) {
            *top++ = (struct operand){CONSTANT, t->constant ? t->constant[-1 - gene].value : decimal_value(gene), NULL};
            continue;
        }
        const struct operand a = *--top, b = arity == 2 ? *--top : a;
        if (a.kind == CONSTANT && b.kind == CONSTANT) {
            *top++ = (struct operand){CONSTANT, apply(gene, a.constant, b.constant), NULL};
            continue;
        }
        blocks -= (size_t)(a.kind == BLOCK) + (size_t)(arity == 2 && b.kind == BLOCK);
        double *to = k->block + KERNEL_BLOCK * blocks++;
        const enum form form = a.kind == CONSTANT ? CONSTANT_ARRAY : b.kind == CONSTANT ? ARRAY_CONSTANT : ARRAY_ARRAY;
        k->step[k->steps++] = (struct step){gene * FORMS + (int)form, a, b, to};
        *top++ = (struct operand){BLOCK, 0, to};
    }
    k->root = *--top;
    if (k->root.kind == CONSTANT) {
        for (size_t i = 0; i < KERNEL_BLOCK; i++)
            k->block[i] = k->root.constant;
        k->root = (struct operand){BLOCK, 0, k->block};
    }
}

double kernel_error_sum(struct kernel *k, const struct kernel_task *t, size_t target, double bound)
{
    translate(k, t);
    return engine[k->width].error_sum(k, t, target, bound);
}

void kernel_values(struct kernel *k, const struct kernel_task *t, double *value)
{
    translate(k, t);
    engine[k->width].values(k, t, value);
}

double kernel_work(const struct kernel *k)
{
    return k->work;
}
