/* What the families of hard cases are drawn with: one stream of 64 bits a case, from which come nothing but sums,
 * products, roots, exp and log. */
#ifndef FOOTPOINT_DRAW_H
#define FOOTPOINT_DRAW_H

#include "hard_case.h"

extern const double draw_corner[4][2];

uint64_t draw_next(uint64_t *stream);
/** Between low and high, evenly. */
double draw_flat(uint64_t *stream, double low, double high);
/** 10 to the power of a number between low and high. */
double draw_power(uint64_t *stream, double low, double high);
/** Normally distributed, of variance 1. */
double draw_normal(uint64_t *stream);
/** 0 to n - 1. */
int draw_choose(uint64_t *stream, int n);
/** 1 or -1. */
double draw_sign(uint64_t *stream);
/** Of length 1. */
void draw_direction(uint64_t *stream, double d[3]);

/** A quadrilateral of edges `aspect` and 1, corners moved. */
void draw_quad(uint64_t *stream, double aspect, double moved, double warp, struct hard_case *h);
/** xS over (xi,eta); where there is no normal, in any direction. */
void draw_place(uint64_t *stream, struct hard_case *h, double xi, double eta, double gap);
/** Turned, scaled and moved by `shift` edges. */
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

/** Position and its derivatives at (xi,eta). */
void draw_evaluate(const struct hard_case *h, double xi, double eta, double r[3], double t[3], double u[3],
                   double c[3]);

#endif
