/* Rationals in intervals; see interval.h. */
#include "interval.h"

#include <mpfr.h>

struct interval interval_around(const fmpq *q)
{
    struct interval x;
    mpfr_t y;
    mpfr_init2(y, 53);
    fmpq_get_mpfr(y, q, MPFR_RNDD);
    x.lo = mpfr_get_d(y, MPFR_RNDD);
    fmpq_get_mpfr(y, q, MPFR_RNDU);
    x.hi = mpfr_get_d(y, MPFR_RNDU);
    mpfr_clear(y);
    return x;
}
