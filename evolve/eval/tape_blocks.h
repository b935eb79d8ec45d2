/* Operators and their derivatives over blocks of samples, for functions that are WIDE. */
#ifndef FOOTPOINT_TAPE_BLOCKS_H
#define FOOTPOINT_TAPE_BLOCKS_H

#include "../../codegen/base/simd.h"
#include "../common/columns.h"

#include <math.h>

#if defined __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* for unoptimised builds */
#define EACH _Pragma("clang loop vectorize(assume_safety)") for (size_t k = 0; k < TAPE_BLOCK; k++)
#else
#define EACH _Pragma("GCC ivdep") for (size_t k = 0; k < TAPE_BLOCK; k++)
#endif

/* Computes to = x gene y; y is ignored for a unary gene. */
IN_WIDE void value_of(int gene, const double *x, const double *y, double *to)
{
#define VALUE(gene, operands, value)                                                                                   \
    case GENE_##gene:                                                                                                  \
        EACH                                                                                                           \
        {                                                                                                              \
            operands;                                                                                                  \
            to[k] = value;                                                                                             \
        }                                                                                                              \
        break;
#define VALUE_OF_ONE(gene, text, value, ...) VALUE(gene, const double a = x[k], value)
#define VALUE_OF_TWO(gene, text, value, ...) VALUE(gene, const double a = x[k]; const double b = y[k], value)
    switch (gene) {
        GENES_OF_ONE(VALUE_OF_ONE)
        GENES_OF_TWO(VALUE_OF_TWO)
    }
}

/* Computes the slopes of operands x and y of a gene from the slope of the operation. */
IN_WIDE void slope_of(int gene, const double *slope, const double *value, const double *x, const double *y, double *sx,
                      double *sy)
{
#define SLOPE(gene, ...)                                                                                               \
    case GENE_##gene:                                                                                                  \
        EACH                                                                                                           \
        {                                                                                                              \
            const double s = slope[k], v = value[k], a = x[k], b = y[k];                                               \
            (void)v, (void)a, (void)b;                                                                                 \
            __VA_ARGS__;                                                                                               \
        }                                                                                                              \
        break;
#define SLOPE_OF_ONE(gene, text, v, slope_a, ...) SLOPE(gene, sx[k] = slope_a)
#define SLOPE_OF_TWO(gene, text, v, slope_a, slope_b, ...) SLOPE(gene, sx[k] = slope_a, sy[k] = slope_b)
    switch (gene) {
        GENES_OF_ONE(SLOPE_OF_ONE)
        GENES_OF_TWO(SLOPE_OF_TWO)
    }
}

#endif
