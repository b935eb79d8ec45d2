/* The lines of a bilinear segment along xi, by t = (1 + eta)/2, or along eta, by t = (1 + xi)/2; only for the files of this folder.
 * On line t (7) is linear in s = (1 + xi)/2: with a = (1-t) AB + t DC and e = (xS - xA) - t AD it reads
 * s = p/Q, p = a . e, Q = a . a.  Then (8), times Q^2, is a quintic in t,
 *     P = (Q AD + p c) . (Q e - p a) = 0,   c = DC - AB.
 * P is computed with twice the precision from differences of nodes, which are exact: its coefficients are known to 1e-27 of
 * the sizes of their terms.  roots.c isolates its roots. */
#ifndef FOOTPOINT_LINES_H
#define FOOTPOINT_LINES_H

#include "bilinear.h"
#include "roots.h"

#define LINES_BEYOND 0x1p-37 /* points up to this far outside, in s and t, count as on the edge */

/* A family of lines, by t from -LINES_BEYOND (0) to 1 + LINES_BEYOND (1): direction a and e, linear in t; AD and c. */
struct lines {
    struct twofold along[2][3], e[2][3], across[3], twist[3];
    int exchanged; /* 1: along eta */
};

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Computes the lines and the roots of P.
 *  @param[in] x  the nodes A, B, C, D, S
 *  @return the number of intervals */
int footpoint_lines_isolate(const double *const x[5], int exponent, int exchanged, struct lines *l,
                            struct roots_interval interval[ROOTS_MOST]);

/** Computes xi and eta of the point of line t that is nearest to xS; the coordinate along the line is not limited. */
void footpoint_lines_point(const struct lines *l, struct twofold t, double z[2]);

/** Computes a and e at t. */
void footpoint_lines_at(const struct lines *l, struct twofold t, struct twofold a[3], struct twofold e[3]);

/** Bounds s = p/Q over an interval of t.
 *  @return a lower bound on Q; 0, with s from 0 to 1, if there is no bound */
double footpoint_lines_bound(const struct lines *l, const struct roots_interval *interval, double s[2]);

/** Returns 1 if s > 1 or s < 0 all over an interval of t. */
int footpoint_lines_outside(const struct lines *l, const struct roots_interval *interval);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

static inline double lines_length(const struct twofold a[3])
{
    return sqrt(a[0].high * a[0].high + a[1].high * a[1].high + a[2].high * a[2].high);
}

/* Returns +-1 if z is next to it. */
static inline double lines_clamp(double z)
{
    return fabs(z) <= 1.0 + 2.0 * LINES_BEYOND ? bilinear_clamp(z) : z;
}

/* Returns the t at a part, from 0 to 1, of an interval. */
static inline struct twofold lines_part(const struct roots_interval *interval, double part)
{
    return twofold_add(interval->low, twofold_of(part * interval->width));
}

/* Computes the interval of (1 + z)/2 that belongs to an interval of t. */
static inline void lines_place(const struct roots_interval *interval, double place[2])
{
    place[0] = (1.0 + 2.0 * LINES_BEYOND) * interval->low.high - LINES_BEYOND;
    place[1] = place[0] + (1.0 + 2.0 * LINES_BEYOND) * interval->width;
}

/* Returns the t of a point. */
static inline double lines_through(const struct lines *l, const double z[2])
{
    return (0.5 * (1.0 + z[!l->exchanged]) + LINES_BEYOND) / (1.0 + 2.0 * LINES_BEYOND);
}

#endif
