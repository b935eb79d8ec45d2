/* Compiler-dependent macros of a header, and the statuses. */

#if (defined(__CUDACC__) || defined(__HIP__) || defined(__HIPCC__)) && !defined(FOOTPOINT_DEVICE)
#define FOOTPOINT_DEVICE /* functions are compiled for a device, too */
#endif
#ifndef FOOTPOINT_FN
#ifdef __CUDACC__
#define FOOTPOINT_FN static __host__ __device__ __forceinline__
#elif defined(FOOTPOINT_DEVICE) /* clang, before or without HIP's own macros */
#define FOOTPOINT_FN static __attribute__((host, device, always_inline)) inline
#else
#define FOOTPOINT_FN static inline
#endif
#endif
#ifndef FOOTPOINT_PART /* before parts of functions: inlined, so that unused results are not computed */
#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(FOOTPOINT_DEVICE)
#define FOOTPOINT_PART static inline __attribute__((always_inline))
#else
#define FOOTPOINT_PART FOOTPOINT_FN
#endif
#endif
#ifndef FOOTPOINT_APART /* before functions that stay separate: they vectorise whatever the caller's arrays */
#if defined(__GNUC__) && !defined(FOOTPOINT_DEVICE)
#if defined(__clang__) || __GNUC__ < 8
#define FOOTPOINT_APART static __attribute__((noinline, unused))
#else /* gcc 12 with -O1 takes some of them for functions without effects */
#define FOOTPOINT_APART static __attribute__((noipa, unused))
#endif
#else
#define FOOTPOINT_APART FOOTPOINT_FN
#endif
#endif
#ifndef FOOTPOINT_LOOP /* before loops over arrays: their callees are inlined, whatever their size */
#if defined(__GNUC__) && !defined(FOOTPOINT_DEVICE)
#define FOOTPOINT_LOOP __attribute__((flatten)) FOOTPOINT_APART
#else
#define FOOTPOINT_LOOP FOOTPOINT_FN
#endif
#endif
#ifndef FOOTPOINT_COLD /* before functions that are seldom called: not inlined */
#if defined(__GNUC__) && !defined(FOOTPOINT_DEVICE)
#if defined(__clang__) || __GNUC__ < 8
#define FOOTPOINT_COLD static __attribute__((noinline, cold, unused))
#else
#define FOOTPOINT_COLD static __attribute__((noipa, cold, unused))
#endif
#else
#define FOOTPOINT_COLD FOOTPOINT_FN
#endif
#endif
#ifndef FOOTPOINT_EACH /* before loops over arrays that do not overlap; for clang pass -DFOOTPOINT_EACH=
                       * '_Pragma("clang loop vectorize(assume_safety)")', which warns if it is not obeyed */
#if defined(__GNUC__) && !defined(__clang__) && !defined(FOOTPOINT_DEVICE)
#define FOOTPOINT_EACH _Pragma("GCC ivdep")
#else
#define FOOTPOINT_EACH
#endif
#endif
#ifndef FOOTPOINT_UNROLL /* before short loops inside loops over arrays, which vectorise only without them */
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__) && !defined(FOOTPOINT_DEVICE)
#define FOOTPOINT_UNROLL _Pragma("GCC unroll 32")
#else
#define FOOTPOINT_UNROLL
#endif
#endif
#ifndef FOOTPOINT_WHOLE /* the same for known counts, also long ones, which clang needs */
#if defined(__clang__) && !defined(FOOTPOINT_DEVICE)
#define FOOTPOINT_WHOLE _Pragma("clang loop unroll(full)")
#else
#define FOOTPOINT_WHOLE FOOTPOINT_UNROLL
#endif
#endif
#ifndef FOOTPOINT_RESTRICT
#if defined(__GNUC__) || defined(_MSC_VER) || defined(FOOTPOINT_DEVICE)
#define FOOTPOINT_RESTRICT __restrict
#else
#define FOOTPOINT_RESTRICT
#endif
#endif
#ifndef FOOTPOINT_LOOSE /* 1 if the compiler announces that it may change results: then nothing is proved */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#define FOOTPOINT_LOOSE 1
#elif defined(_M_FP_FAST) || (defined(__USE_FAST_MATH__) && __USE_FAST_MATH__)
#define FOOTPOINT_LOOSE 1
#else
#define FOOTPOINT_LOOSE 0
#endif
#endif
#ifndef FOOTPOINT_ORDERED /* 1 if a pragma switches off all parts of -ffast-math, of which clang announces few; clang 14
                           * keeps approximate roots of floats, under -ffast-math -fhonor-nans for instance */
#if !defined(__clang__) || defined(FOOTPOINT_DEVICE) || __clang_major__ < 12
#define FOOTPOINT_ORDERED 0
#elif defined(__x86_64__) || defined(__i386__) || defined(__powerpc64__)
#define FOOTPOINT_ORDERED 1
#elif defined(__aarch64__) && __clang_major__ >= 17
#define FOOTPOINT_ORDERED 1
#else
#define FOOTPOINT_ORDERED 0
#endif
#endif
#if !defined(__CUDACC_RTC__) && !defined(__HIPCC_RTC__)
#include <math.h>
#include <stddef.h>
#endif
#if FOOTPOINT_ORDERED
#pragma float_control(push)
#pragma float_control(precise, on)
#pragma STDC FP_CONTRACT DEFAULT /* as the command line says */
#endif

#ifndef FOOTPOINT_OK
#define FOOTPOINT_OK 0
#endif
#ifndef FOOTPOINT_UNPROVED
#define FOOTPOINT_UNPROVED 4
#endif
#ifndef FOOTPOINT_ERR_NOT_FINITE
#define FOOTPOINT_ERR_NOT_FINITE (-1)
#endif
#ifndef FOOTPOINT_ERR_DEGENERATE
#define FOOTPOINT_ERR_DEGENERATE (-2)
#endif
