/* Constants of evolution: decimal numbers of up to seven digits, each coded in its gene.  Any value can be bred, sent
 * and written without a table that processes would have to agree on. */
#ifndef FOOTPOINT_DECIMAL_H
#define FOOTPOINT_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>

/** The gene (< 0) of the nearest decimal number of seven significant digits, or fewer below 1e-6.  Values beyond the
 *  largest, 9999999000, become that; a NaN becomes 0. */
int decimal_gene(double value);
/** True if the gene is one that decimal_gene returns. */
bool decimal_valid(int gene);
/** Its value, correctly rounded to double. */
double decimal_value(int gene);

enum { DECIMAL_TEXT = 16 };
/** Its shortest text, which reads back to the same value: "-0.35", "1e-07". */
void decimal_text(int gene, char text[DECIMAL_TEXT]);

/** The shortest decimal text, of any number of digits, that reads back as v. */
void number_shortest(double v, char text[32]);

#endif
