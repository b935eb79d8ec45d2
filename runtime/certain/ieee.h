/* Refuses flags with which compilers change the meaning of floating-point operations: proofs, comparisons with NaN and sums of twice
 * the precision would be silently wrong.  Only for the files of this folder. */
#ifndef FOOTPOINT_IEEE_H
#define FOOTPOINT_IEEE_H

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "footpoint: proofs need IEEE arithmetic; compile this file without -ffast-math, -Ofast and -ffinite-math-only"
#endif
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "footpoint: proofs need IEEE arithmetic; compile this file without -fassociative-math and -freciprocal-math"
#endif

#endif
