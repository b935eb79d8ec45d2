/* Constants of evolution: decimal numbers of up to seven digits, each encoded in its gene. Any value can be bred, sent
 * and written without a table shared between processes. */
#ifndef FOOTPOINT_DECIMAL_H
#define FOOTPOINT_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>

/** Returns the gene (< 0) of the nearest decimal number with seven significant digits, or fewer below 1e-6. Values
 *  beyond the largest, 9999999000, are clamped; NaN becomes 0. */
int decimal_gene(double value);
/** Returns true if decimal_gene() can return this gene. */
bool decimal_valid(int gene);
/** Returns the gene's value, correctly rounded to double. */
double decimal_value(int gene);

enum { DECIMAL_TEXT = 16 };
/** Writes the shortest text that reads back to the same value: "-0.35", "1e-07". */
void decimal_text(int gene, char text[DECIMAL_TEXT]);

/** Writes the shortest decimal text, with any number of digits, that reads back as v. */
void number_shortest(double v, char text[32]);

#endif
