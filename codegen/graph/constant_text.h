/* Rational constants and their text. */
#ifndef FOOTPOINT_CONSTANT_TEXT_H
#define FOOTPOINT_CONSTANT_TEXT_H

#include <flint/fmpq.h>

/** Returns the exact value: a decimal number, which compilers round once, if it is short enough, otherwise a quotient
 *  of two. Free it with free(). */
char *constant_text(const fmpq_t c);

/** Reads the exact value of an unsigned decimal such as 0.05 or 1.25e-3. Returns its end, or NULL if the text is not a
 *  decimal. */
const char *decimal_read(fmpq *q, const char *text);

/** Reads the exact value of a genome's constant, which may have a sign. */
void constant_read(fmpq *q, const char *text);

#endif
