/* Loops compiled for several widths of vector registers; the widest that the machine has is used. Operations are
 * neither reassociated nor contracted, so all widths give the same bits. */
#ifndef FOOTPOINT_SIMD_H
#define FOOTPOINT_SIMD_H

#if defined WIDE /* set by compiler options to test a single width */
#elif defined __x86_64__ && defined __gnu_linux__ && !defined __clang__
#define WIDE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define WIDE
#endif

/** A function that is compiled again inside each WIDE function. */
#define IN_WIDE static inline __attribute__((always_inline))

/** Row i of a sum of products goes to lane i mod WIDE_LANES. */
enum { WIDE_LANES = 8 };
typedef double wide __attribute__((vector_size(WIDE_LANES * sizeof(double)), aligned(sizeof(double)), may_alias));

static inline const wide *wide_at(const double *p)
{
    return (const void *)p;
}

#endif
