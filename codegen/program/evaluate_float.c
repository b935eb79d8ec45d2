/* Evaluation in float; see evaluate_float.h. */
#include "evaluate_float.h"

#include "evaluate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void single_constants(const struct program *p, float *value)
{
    double error;
    for (size_t i = 0; i < p->ops; i++)
        if (p->op[i].kind == OP_CONSTANT)
            value[i] = p->op[i].quotient ? (float)point_constant(p, &p->op[i], &error)
                                         : single_nearest(&p->constant[p->op[i].input]);
}

/* The root of a float computed in double and rounded again has a single rounding error. */
static float apply(enum op_kind kind, float a, float b)
{
#define VALUE(gene, text, value, ...)                                                                                  \
    case OP_##gene:                                                                                                    \
        return (float)value;
    switch (kind) {
        GENES_OF_TWO(VALUE)
        GENES_OF_ONE(VALUE)
    default:
        return NAN;
    }
}

void single_values(const struct program *p, const float *input, float *v)
{
    for (size_t i = 0; i < p->ops; i++) {
        const struct op *op = &p->op[i];
        if (op->kind == OP_INPUT)
            v[i] = input[op->input];
        else if (op->kind != OP_CONSTANT)
            v[i] = apply(op->kind, v[op->a], op->b >= 0 ? v[op->b] : 0);
    }
}

void single_inputs(const struct segment_kind *k, const float *x, float *y)
{
    const size_t nodes = strlen(k->nodes), vectors = segment_vectors(k);
    float sum = 0.0f;
    for (size_t i = 1; i < k->corners; i++) {
        float one = 0.0f;
        for (size_t c = 0; c < 3; c++) {
            const float size = fabsf(x[3 * i + c] - x[c]);
            one = c == 0 ? size : one + size;
        }
        sum = i == 1 ? one : sum + one;
    }
    const float scale = 4.0f / sum;
    for (size_t i = 0; i <= vectors; i++)
        for (size_t c = 0; c < 3; c++)
            y[3 * i + c] = i >= nodes && i < vectors ? x[3 * i + c] : (x[3 * i + c] - x[c]) * scale;
    for (size_t c = 0; c < 3; c++)
        y[c] = 0.0f;
}

static bool agree(double a, double b)
{
    return fabs(a - b) <= 1e-6 * fmax(1, fabs(a));
}

/* Random coordinates are multiples of 2^-20, so that moving and doubling them is exact. */
bool single_is_relative(const struct segment_kind *k, const struct program *p)
{
    enum { TRIES = 16 };
    const size_t nodes = strlen(k->nodes), vectors = segment_vectors(k);
    double *input = new_array(2 * p->inputs, sizeof *input), *value = new_array(2 * p->ops, sizeof *value);
    uint64_t seed = 1;
    bool same = true, told = false;
    for (int n = 0; n < TRIES && same; n++) {
        for (size_t i = 0; i < p->inputs; i++) {
            const size_t vector = i / 3;
            const bool normal = vector >= nodes && vector < vectors;
            input[i] = (double)(random_next(&seed) >> 43) * 0x1p-20 - 1;
            input[p->inputs + i] = normal ? input[i] : 2 * (input[i] + 3 + (double)(i % 3));
        }
        for (int moved = 0; moved < 2; moved++) {
            point_constants(p, value + moved * (ptrdiff_t)p->ops);
            point_double(p, input + moved * (ptrdiff_t)p->inputs, NULL, value + moved * (ptrdiff_t)p->ops);
        }
        for (size_t i = 0; i < p->outputs; i++) {
            const double a = value[p->output[i]], b = value[p->ops + (size_t)p->output[i]];
            told = told || isfinite(a);
            same = same && (!isfinite(a) || agree(a, b));
        }
    }
    free(input);
    free(value);
    return same && told;
}
