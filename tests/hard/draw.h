/* Draws random numbers and segments for the families of hard cases.  Each case has a stream of 64 bits, and only sums, products,
 * roots, exp and log are computed from it. */
#ifndef FOOTPOINT_DRAW_H
#define FOOTPOINT_DRAW_H

#include "hard_case.h"

extern const double draw_corner[4][2];

uint64_t draw_next(uint64_t *stream);
/** Returns a uniform number between low and high. */
double draw_flat(uint64_t *stream, double low, double high);
/** Returns 10 to the power of a uniform number between low and high. */
double draw_power(uint64_t *stream, double low, double high);
/** Returns a normally distributed number of variance 1. */
double draw_normal(uint64_t *stream);
/** Returns 0 to n - 1. */
int draw_choose(uint64_t *stream, int n);
/** Returns 1 or -1. */
double draw_sign(uint64_t *stream);
/** Draws a direction of length 1. */
void draw_direction(uint64_t *stream, double d[3]);

/** Draws a quadrilateral with edges `aspect` and 1 and moved corners. */
void draw_quad(uint64_t *stream, double aspect, double moved, double warp, struct hard_case *h);
/** Places xS over (xi,eta), in any direction if there is no normal. */
void draw_place(uint64_t *stream, struct hard_case *h, double xi, double eta, double gap);
/** Turns, scales and moves a case by `shift` edges. */
void draw_move(uint64_t *stream, struct hard_case *h, double scale, double shift);

static inline void draw_cross(const double a[3], const double b[3], double c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static inline double draw_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Computes the position and its derivatives at (xi,eta). */
void draw_evaluate(const struct hard_case *h, double xi, double eta, double r[3], double t[3], double u[3],
                   double c[3]);

#endif
