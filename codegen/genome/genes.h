/* The operators. Each has a text in genomes, a value, the slopes that it passes to its operands, and its derivative by
 * each operand. a and b are the operands, v the value, and s its slope or, in genome text, the derivative of the
 * operand concerned. min and max return b if an operand is NaN. x / 0 follows IEEE 754. */
#ifndef FOOTPOINT_GENES_H
#define FOOTPOINT_GENES_H

#include <stdbool.h>

/* G(gene, text, value, slope of a, slope of b, derivative by a, by b, as genome text, of a quotient times b; or
 * NULL) */
#define CHOICES(G)                                                                                                     \
    G(PDIV, "%", (b == 0 ? 1 : a / b), (b == 0 ? 0 : s / b), -(b == 0 ? 0 : s / b) * v, NULL, NULL)                    \
    G(MIN, "min", (a < b ? a : b), (a < b ? s : 0), (a < b ? 0 : s), NULL, NULL)                                       \
    G(MAX, "max", (a > b ? a : b), (a > b ? s : 0), (a > b ? 0 : s), NULL, NULL)
#define GENES_OF_TWO(G)                                                                                                \
    G(ADD, "+", (a + b), s, s, "s", "s")                                                                               \
    G(SUB, "-", (a - b), s, -s, "s", "neg s")                                                                          \
    G(MUL, "*", (a * b), (s * b), (s * a), "* b s", "* a s")                                                           \
    G(DIV, "/", (a / b), (s / b), -(s / b) * v, "s", "neg * / a b s")                                                  \
    CHOICES(G)

/* Functions of one number: G(gene, text, value, slope of a,
 *     derivative       as genome text, where a is the operand and s its derivative; NULL if it does not exist everywhere
 *     C                its name in C; in float an f follows
 *     Fortran, LaTeX   as patterns, $a0 the operand
 *     root             true for the square root, false for the absolute value: all that passes, proofs and bounds need)
 *
 * graph/unary.c adds the exact values. */
#define UNARY(G)                                                                                                       \
    G(SQRT, "sqrt", sqrt(a), (0.5 * s / v), "/ s * 2 sqrt a", "sqrt", "sqrt($a0)", "\\sqrt{$a0}", true)                \
    G(ABS, "abs", fabs(a), (a < 0 ? -s : s), NULL, "fabs", "abs($a0)", "\\left|$a0\\right|", false)
/* G(gene, text, value, slope of a, derivative, C, ...) */
#define GENES_OF_ONE(G)                                                                                                \
    G(NEG, "neg", -a, -s, "neg s", "-")                                                                                \
    UNARY(G)

#define NUMBER(gene, ...) UNARY_##gene,
enum { UNARY(NUMBER) UNARIES };
#undef NUMBER

/** A function of one number, as its line defines it. */
struct unary {
    const char *text, *c;
    int root;      /* n: f(c a) = c^(1/n) f(a) for each c > 0 */
    int error;     /* largest error of the C function, in 2^-53 of the value */
    bool rising;   /* it never decreases; priced as a root */
    bool negative; /* it is defined below 0 */
};
extern const struct unary unary_of[UNARIES];

#endif
