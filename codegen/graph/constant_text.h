/* Rational constants and their text. */
#ifndef FOOTPOINT_CONSTANT_TEXT_H
#define FOOTPOINT_CONSTANT_TEXT_H

#include <flint/fmpq.h>

/** The exact value: a decimal number, which compilers round once, if that has not too many digits, else a quotient of
 *  two.  Free with free(). */
char *constant_text(const fmpq_t c);

/** Exact value of a decimal without sign, such as 0.05 or 1.25e-3; returns its end, or NULL if there is none. */
const char *decimal_read(fmpq *q, const char *text);

/** Exact value of a genome's constant, which may have a sign. */
void constant_read(fmpq *q, const char *text);

#endif
