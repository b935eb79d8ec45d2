/* Exact values of the functions of one number; see unary.h. */
#include "unary.h"

static bool root(fmpq *x, const fmpq *a)
{
    if (!fmpz_is_square(fmpq_numref(a)) || !fmpz_is_square(fmpq_denref(a)))
        return false;
    fmpz_sqrt(fmpq_numref(x), fmpq_numref(a));
    fmpz_sqrt(fmpq_denref(x), fmpq_denref(a));
    return true;
}

bool unary_exact(unsigned k, fmpq *x, const fmpq *a)
{
    switch (k) {
    case UNARY_SQRT:
        return root(x, a);
    case UNARY_ABS:
        fmpq_abs(x, a);
        return true;
    }
    return false;
}

void unary_ball(unsigned k, arb_t x, const arb_t a, slong bits)
{
    switch (k) {
    case UNARY_SQRT:
        arb_sqrt(x, a, bits);
        break;
    case UNARY_ABS:
        arb_abs(x, a);
        break;
    }
}
