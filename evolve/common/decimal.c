/* A gene is -1 - code, code = (mantissa * 16 + exponent) * 2 + sign, for the number
 *
 *     (-1)^sign mantissa 10^(exponent - 12).
 *
 * The mantissa has no trailing zeros unless the exponent is the largest, and 0 has sign 0 and exponent 0. So each
 * number has exactly one gene. */
#include "decimal.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { DIGITS = 7, EXPONENTS = 16, SHIFT = 12, LARGEST = 9999999 };

static int gene_of(int mantissa, int exponent, bool negative)
{
    while (mantissa > 0 && mantissa % 10 == 0 && exponent < EXPONENTS - 1) {
        mantissa /= 10;
        exponent++;
    }
    return mantissa == 0 ? -1 : -1 - ((mantissa * EXPONENTS + exponent) * 2 + (negative ? 1 : 0));
}

/* Returns mantissa * 10^(exponent - SHIFT) with a single rounding: the powers are exact in double. */
static double scaled(double mantissa, int exponent)
{
    double power = 1;
    for (int i = exponent < SHIFT ? SHIFT - exponent : exponent - SHIFT; i > 0; i--)
        power *= 10;
    return exponent < SHIFT ? mantissa / power : mantissa * power;
}

int decimal_gene(double value)
{
    const double size = fabs(value);
    if (!(size > 0))
        return -1;
    for (int exponent = 0; exponent < EXPONENTS; exponent++) {
        const double mantissa = rint(scaled(size, 2 * SHIFT - exponent));
        if (mantissa <= LARGEST)
            return gene_of((int)mantissa, exponent, value < 0);
    }
    return gene_of(LARGEST, EXPONENTS - 1, value < 0);
}

bool decimal_valid(int gene)
{
    if (gene >= 0 || gene == INT_MIN)
        return false;
    const int code = -1 - gene, mantissa = code / (2 * EXPONENTS), exponent = code / 2 % EXPONENTS;
    return mantissa <= LARGEST && gene_of(mantissa, exponent, code % 2 == 1) == gene;
}

double decimal_value(int gene)
{
    const int code = -1 - gene;
    const double size = scaled(code / (2 * EXPONENTS), code / 2 % EXPONENTS);
    return code % 2 == 1 ? -size : size;
}

void decimal_text(int gene, char text[DECIMAL_TEXT])
{
    snprintf(text, DECIMAL_TEXT, "%.*g", DIGITS, decimal_value(gene));
}

void number_shortest(double v, char text[32])
{
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, 32, "%.*g", digits, v);
        if (strtod(text, NULL) == v)
            break;
    }
}
