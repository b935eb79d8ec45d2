/* Rational constants as text of C. */
#ifndef FOOTPOINT_CONSTANT_TEXT_H
#define FOOTPOINT_CONSTANT_TEXT_H

#include <flint/fmpq.h>

/** The exact value: a decimal number, which compilers round once, if that has not too many digits, else a quotient of
 *  two.  Free with free(). */
char *constant_text(const fmpq_t c);

#endif
