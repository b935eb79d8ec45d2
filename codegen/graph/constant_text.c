/* Rational constants and their text; see constant_text.h. */
#include "constant_text.h"

#include "../base/text.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_DIGITS = 64, MOST_EXPONENT = 1000 };

char *constant_text(const fmpq_t c)
{
    fmpz_t den, scaled;
    int twos, fives;
    char *text;
    fmpz_init(den);
    fmpz_init(scaled);
    fmpz_set_ui(scaled, 2);
    twos = (int)fmpz_remove(den, fmpq_denref(c), scaled);
    fmpz_set_ui(scaled, 5);
    fives = (int)fmpz_remove(den, den, scaled);
    const int places = twos > fives ? twos : fives;
    const bool decimal = fmpz_is_one(den) && places <= MOST_DIGITS;
    if (decimal) {
        fmpz_set_ui(scaled, 10);
        fmpz_pow_ui(scaled, scaled, (unsigned long)places);
        fmpz_mul(scaled, scaled, fmpq_numref(c));
        fmpz_divexact(scaled, scaled, fmpq_denref(c));
    }
    if (decimal && fmpz_sizeinbase(scaled, 10) <= MOST_DIGITS) {
        const bool negative = fmpz_sgn(scaled) < 0;
        fmpz_abs(scaled, scaled);
        char *digits = fmpz_get_str(NULL, 10, scaled);
        const int n = (int)strlen(digits), pad = places + 1 > n ? places + 1 - n : 0;
        char *all = new_array((size_t)(n + pad) + 1, 1);
        memset(all, '0', (size_t)pad);
        memcpy(all + pad, digits, (size_t)n);
        text = new_array((size_t)(n + pad) + 5, 1);
        const int whole = n + pad - places;
        sprintf(text, "%s%.*s.%s", negative ? "-" : "", whole, all, places ? all + whole : "0");
        free(all);
        flint_free(digits);
    } else {
        char *n = fmpz_get_str(NULL, 10, fmpq_numref(c)), *d = fmpz_get_str(NULL, 10, fmpq_denref(c));
        text = fmpz_is_one(fmpq_denref(c)) ? new_format("%s.0", n) : new_format("(%s.0 / %s.0)", n, d);
        flint_free(n);
        flint_free(d);
    }
    fmpz_clear(den);
    fmpz_clear(scaled);
    return text;
}

const char *decimal_read(fmpq *q, const char *text)
{
    const size_t whole = strspn(text, "0123456789"), point = text[whole] == '.',
                 after = point ? strspn(text + whole + 1, "0123456789") : 0;
    const char *end = text + whole + point + after;
    long exponent = 0;
    if (whole + after == 0)
        return NULL;
    if (*end == 'e' || *end == 'E') {
        char *rest;
        exponent = strtol(end + 1, &rest, 10);
        if (rest == end + 1 || labs(exponent) > MOST_EXPONENT)
            return NULL;
        end = rest;
    }
    exponent -= (long)after;
    char *digits = new_text(text, whole + point + after);
    memmove(digits + whole, digits + whole + point, after + 1);
    fmpz_t ten;
    fmpz_init_set_ui(ten, 10);
    fmpz_pow_ui(ten, ten, (unsigned long)labs(exponent));
    fmpz_set_str(fmpq_numref(q), digits, 10);
    fmpz_one(fmpq_denref(q));
    if (exponent < 0)
        fmpq_div_fmpz(q, q, ten);
    else
        fmpq_mul_fmpz(q, q, ten);
    fmpz_clear(ten);
    free(digits);
    return end;
}

void constant_read(fmpq *q, const char *text)
{
    decimal_read(q, text + (*text == '-' || *text == '+'));
    if (*text == '-')
        fmpq_neg(q, q);
}
