/* Operators and their derivatives over blocks of samples, for functions that are WIDE. */
#ifndef FOOTPOINT_TAPE_BLOCKS_H
#define FOOTPOINT_TAPE_BLOCKS_H

#include "../common/simd.h"
#include "columns.h"

#include <math.h>

#if defined __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* of builds that do not optimise */
#define EACH _Pragma("clang loop vectorize(assume_safety)") for (size_t k = 0; k < TAPE_BLOCK; k++)
#else
#define EACH _Pragma("GCC ivdep") for (size_t k = 0; k < TAPE_BLOCK; k++)
#endif

/* to = a gene b; b counts where the gene has two operands. */
static inline __attribute__((always_inline)) void value_of(int gene, const double *a, const double *b, double *to)
{
    switch (gene) {
    case GENE_ADD:
        EACH to[k] = a[k] + b[k];
        break;
    case GENE_SUB:
        EACH to[k] = a[k] - b[k];
        break;
    case GENE_MUL:
        EACH to[k] = a[k] * b[k];
        break;
    case GENE_DIV:
        EACH to[k] = a[k] / b[k];
        break;
    case GENE_PDIV:
        EACH to[k] = b[k] == 0 ? 1 : a[k] / b[k];
        break;
    case GENE_MIN:
        EACH to[k] = a[k] < b[k] ? a[k] : b[k];
        break;
    case GENE_MAX:
        EACH to[k] = a[k] > b[k] ? a[k] : b[k];
        break;
    case GENE_NEG:
        EACH to[k] = -a[k];
        break;
    case GENE_SQRT:
        EACH to[k] = sqrt(a[k]);
        break;
    default:
        EACH to[k] = fabs(a[k]);
        break;
    }
}

/* Slopes of the operands: s is that of the operation, v its value. */
static inline __attribute__((always_inline)) void slope_of(int gene, const double *s, const double *v, const double *a,
                                                           const double *b, double *sa, double *sb)
{
    switch (gene) {
    case GENE_SUB:
        EACH sb[k] = -s[k];
        break;
    case GENE_MUL:
        EACH sa[k] = s[k] * b[k];
        EACH sb[k] = s[k] * a[k];
        break;
    case GENE_DIV:
        EACH sa[k] = s[k] / b[k];
        EACH sb[k] = -sa[k] * v[k];
        break;
    case GENE_PDIV:
        EACH sa[k] = b[k] == 0 ? 0 : s[k] / b[k];
        EACH sb[k] = -sa[k] * v[k];
        break;
    case GENE_MIN:
        EACH sa[k] = a[k] < b[k] ? s[k] : 0;
        EACH sb[k] = a[k] < b[k] ? 0 : s[k];
        break;
    case GENE_MAX:
        EACH sa[k] = a[k] > b[k] ? s[k] : 0;
        EACH sb[k] = a[k] > b[k] ? 0 : s[k];
        break;
    case GENE_NEG:
        EACH sa[k] = -s[k];
        break;
    case GENE_SQRT:
        EACH sa[k] = 0.5 * s[k] / v[k];
        break;
    default:
        EACH sa[k] = a[k] < 0 ? -s[k] : s[k];
        break;
    }
}

#endif
