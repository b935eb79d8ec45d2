/* All points where a line meets a face, by a search that is certain: the face is halved until its image in the plane normal
 * to the line misses the line, or is turned one way and goes round it once.  In extended precision. */
#ifndef FOOTPOINT_LINE_POINTS_H
#define FOOTPOINT_LINE_POINTS_H

#include <stdbool.h>

enum { LINE_POINTS_MOST = 16 };

struct line_points {
    int count;
    struct line_point {
        double loc[2]; /* {xi, eta} */
        double dist;   /* xs = r(loc) + dist along / |along|; mesh length */
        double beyond; /* how far loc lies outside of the face; < 0 inside */
        double spread; /* the most that loc moves where the line moves by 1; per mesh length */
    } point[LINE_POINTS_MOST];
    bool clear; /* no fold of the image is so near the line that points cannot be told apart */
};

/** Finds the points of the line through `xs` along `along` on a face of 3, 4, 6, 8 or 9 nodes `x`, and on its surface up to
 *  `over` beyond the square -1..1, of triangles 0..1. */
void line_points_find(int nodes, double (*x)[3], const double xs[3], const double along[3], double over,
                      struct line_points *found);

/** Returns how far loc = {xi, eta} lies from the point to which Newton's steps lead from there, with the slopes there, in
 *  quadruple precision: the larger difference; infinite if they lead to none. */
double line_points_error(int nodes, double (*x)[3], const double xs[3], const double along[3], const double loc[2]);

/** Returns r_xi x r_eta . along at loc, in quadruple precision; *terms: the sum of the absolute values of its terms. */
double line_points_product(int nodes, double (*x)[3], const double along[3], const double loc[2], double *terms);

/** Writes r(xi,eta) - xs; mesh length. */
void line_points_offset(int nodes, double (*x)[3], const double xs[3], const double loc[2], double offset[3]);

#endif
