/* The operators: for each its text in genomes, its value, and the slopes that its operands get of its own.  a and b are
 * the operands, v the value, s its slope.  Minima and maxima give b where one is not a number; x / 0 is what IEEE 754
 * says. */
#ifndef FOOTPOINT_GENES_H
#define FOOTPOINT_GENES_H

/* G(gene, text, value, slope of a, slope of b) */
#define GENES_OF_TWO(G)                                                                                                \
    G(ADD, "+", (a + b), s, s)                                                                                         \
    G(SUB, "-", (a - b), s, -s)                                                                                        \
    G(MUL, "*", (a * b), (s * b), (s * a))                                                                             \
    G(DIV, "/", (a / b), (s / b), -(s / b) * v)                                                                        \
    G(PDIV, "%", (b == 0 ? 1 : a / b), (b == 0 ? 0 : s / b), -(b == 0 ? 0 : s / b) * v)                                \
    G(MIN, "min", (a < b ? a : b), (a < b ? s : 0), (a < b ? 0 : s))                                                   \
    G(MAX, "max", (a > b ? a : b), (a > b ? s : 0), (a > b ? 0 : s))

/* G(gene, text, value, slope of a) */
#define GENES_OF_ONE(G)                                                                                                \
    G(NEG, "neg", -a, -s)                                                                                              \
    G(SQRT, "sqrt", sqrt(a), (0.5 * s / v))                                                                            \
    G(ABS, "abs", fabs(a), (a < 0 ? -s : s))

#endif
