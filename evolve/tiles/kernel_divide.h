/* Division for the engines of 512 bits. The divider takes 16 cycles for a vector of doubles, in which the other units
 * could do 32 operations. Meanwhile half of a tile is divided by Newton's method with fused multiply-add, to the same
 * bits: the quotient is correctly rounded (Markstein, IBM J. Res. Dev. 34 (1990) 111; Muller et al., Handbook of
 * Floating-Point Arithmetic, 2nd ed., section 4.7).
 *
 * From 14 bits of 1 / y, two steps leave an error of about 2^-53, and the residual e2 = 1 - y r2 is exact. The third
 * step is correctly rounded except for errors below 2^-104. These would matter for y near all ones, where 1 / y lies
 * closely above the midpoint of two numbers (y = 2^k (1 - 2^-53), with x a power of two, is the only case that fails).
 * The 2^-105 in the step rounds such cases up. q2 = x r2 (1 + e2) is within one unit in the last place of x / y, so the
 * remainder x - q2 y is exact wherever x / y is near the midpoint of two numbers, and the last step rounds correctly.
 *
 * This holds while no exponent leaves the range, which is so for x and 1 / y in [2^-511, 2^512): the two highest bits
 * of their exponents differ. Zeros, subnormal and infinite numbers and NaN fail this test, as does then the reciprocal,
 * and the divider computes the tile. */
#ifndef FOOTPOINT_KERNEL_DIVIDE_H
#define FOOTPOINT_KERNEL_DIVIDE_H

#include <immintrin.h>

#define DIVIDE_FN static inline __attribute__((always_inline)) TARGET_512

/* Returns ordinary & (high ^ 2 high): bit 30 of a high half stays set if the top bits of its exponent differ. */
DIVIDE_FN __m512i also_ordinary(__m512i ordinary, __m512i high)
{
    return _mm512_ternarylogic_epi32(ordinary, high, _mm512_add_epi32(high, high), 0x60);
}

DIVIDE_FN __m512d quotient(__m512d x, __m512d y, __m512i *ordinary)
{
    const __m512d one = _mm512_set1_pd(1), r0 = _mm512_rcp14_pd(y);
    const __m512d e0 = _mm512_fnmadd_pd(y, r0, one), r1 = _mm512_fmadd_pd(r0, e0, r0);
    const __m512d e1 = _mm512_fnmadd_pd(y, r1, one), r2 = _mm512_fmadd_pd(r1, e1, r1);
    const __m512d e2 = _mm512_fnmadd_pd(y, r2, one), q1 = _mm512_mul_pd(x, r2);
    const __m512d r3 = _mm512_fmadd_pd(r2, _mm512_add_pd(e2, _mm512_set1_pd(0x1p-105)), r2);
    const __m512d q2 = _mm512_fmadd_pd(q1, e2, q1);
    const __m512 high = _mm512_shuffle_ps(_mm512_castpd_ps(x), _mm512_castpd_ps(r3), 0xdd);
    *ordinary = also_ordinary(*ordinary, _mm512_castps_si512(high));
    return _mm512_fmadd_pd(_mm512_fnmadd_pd(q2, y, x), r3, q2);
}

DIVIDE_FN bool all_ordinary(__m512i ordinary)
{
    return _mm512_test_epi32_mask(ordinary, _mm512_set1_epi32(1 << 30)) == 0xffff;
}

/* Computes a tile of quotients: four vectors here, four in the divider. */
#define NEWTON(M, op, t, X, Y) M(0, op, t, X, Y) M(1, op, t, X, Y) M(2, op, t, X, Y) M(3, op, t, X, Y)
#define DIVIDER(M, op, t, X, Y) M(4, op, t, X, Y) M(5, op, t, X, Y) M(6, op, t, X, Y) M(7, op, t, X, Y)
#define OPERATE(i, op, t, X, Y) OPERATE_##op(i, t, X(i), Y(i))
#define QUOTIENT(i, op, t, X, Y) const VECTOR quotient_##i = quotient(X(i), Y(i), &ordinary);
#define ACCEPT(i, op, t, X, Y) t##i = quotient_##i;
#define QUICK_TILE(op, t, X, Y)                                                                                        \
    DIVIDER(OPERATE, op, t, X, Y)                                                                                      \
    __m512i ordinary = _mm512_set1_epi64(-1);                                                                          \
    NEWTON(QUOTIENT, op, t, X, Y)                                                                                      \
    if (__builtin_expect(all_ordinary(ordinary), 1)) {                                                                 \
        NEWTON(ACCEPT, op, t, X, Y)                                                                                    \
    } else {                                                                                                           \
        NEWTON(OPERATE, op, t, X, Y)                                                                                   \
    }

#endif
