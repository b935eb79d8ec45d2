/* Loops compiled for several widths of vector registers, of which the widest that the machine has is taken.  Nothing is
 * reassociated or contracted, so all give the same bits. */
#ifndef FOOTPOINT_SIMD_H
#define FOOTPOINT_SIMD_H

#if defined WIDE /* given to the compiler, to try one width alone */
#elif defined __x86_64__ && defined __gnu_linux__ && !defined __clang__
#define WIDE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define WIDE
#endif

/** A function that is compiled anew inside each WIDE one. */
#define IN_WIDE static inline __attribute__((always_inline))

/** Row i of a sum of products goes to lane i mod WIDE_LANES. */
enum { WIDE_LANES = 8 };
typedef double wide __attribute__((vector_size(WIDE_LANES * sizeof(double)), aligned(sizeof(double)), may_alias));

static inline const wide *wide_at(const double *p)
{
    return (const void *)p;
}

#endif
