/* The value of an operator, in double. */
#ifndef FOOTPOINT_GENE_VALUE_H
#define FOOTPOINT_GENE_VALUE_H

#include "genome.h"

#include <math.h>

/** Returns the value of a gene; a unary gene ignores b. */
__attribute__((no_sanitize("float-divide-by-zero"))) static inline double gene_value(int gene, double a, double b)
{
#define RETURN(name, text, value, ...)                                                                                 \
    case GENE_##name:                                                                                                  \
        return value;
    switch (gene) {
        GENES_OF_TWO(RETURN)
        GENES_OF_ONE(RETURN)
    default:
        return NAN;
    }
#undef RETURN
}

#endif
