/* Judges searches among several segments, and the search for CalculiX; see judges.h. */
#include "judges.h"

#include "../../runtime/footpoint.h"

#include <math.h>
#include <string.h>

enum { MOST = 8 };

#define NEAR 1e-10     /* permitted error of a distance, over the longest edge */
#define ATTACHED 1e-9  /* the same in attach_2d_ */
#define ROUNDING 1e-14 /* of distances and coordinates */
#define FARTHEST 1e11  /* longest edges from which a segment may count as a point */

void attach_2d_(double (*pneigh)[3], double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                double *etl);

static double true_distance(const struct truth *t)
{
    return verdict_root(t->point[0].square) * t->surface.scale;
}

static double tolerance(const struct truth *t, double part)
{
    const double size = t->surface.edge * t->surface.scale;
    return part * size + ROUNDING * true_distance(t) + (t->surface.distance > FARTHEST ? 2 * size : 0);
}

/* Judges a selection.  Node 0 is the common node; the others of each segment follow. */
void judge_select(const struct hard_case *h, const int *at, int count, const struct truth *t, struct tally *a)
{
    double xyz[3 * (4 * MOST + 1)], distance = -1, least = INFINITY, most = 0;
    int seg[4 * MOST], chosen = -1, nodes = 1;
    memcpy(xyz, h[0].x[at[0]], sizeof h[0].x[0]);
    for (int s = 0; s < count; s++)
        for (int k = 0; k < 4; k++) {
            seg[4 * s + k] = k == at[s] ? 0 : nodes;
            if (k != at[s])
                memcpy(xyz + 3 * nodes++, h[s].x[k], sizeof h[s].x[k]);
        }
    const int status = footpoint_select_closest(xyz, 0, count, seg, h[0].x[4], &chosen, &distance);
    a->calls++;
    a->answered += status == FOOTPOINT_OK;
    a->unproved += status == FOOTPOINT_UNPROVED;
    a->refused += status != FOOTPOINT_OK && status != FOOTPOINT_UNPROVED;
    if ((status != FOOTPOINT_OK && status != FOOTPOINT_UNPROVED) || chosen < 0 || chosen >= count) {
        a->why = "refused";
        a->wrong_status++;
        return;
    }
    for (int s = 0; s < count; s++) {
        least = fmin(least, true_distance(&t[s]));
        most = fmax(most, tolerance(&t[s], NEAR));
    }
    const double off = fabs(distance - true_distance(&t[chosen]));
    a->worst = fmax(a->worst, off / (t[chosen].surface.edge * t[chosen].surface.scale + true_distance(&t[chosen])));
    if (!(off <= tolerance(&t[chosen], NEAR)))
        a->why = "the distance", a->wrong++;
    else if (!(true_distance(&t[chosen]) <= least + 2 * most))
        a->why = "another segment is nearer", a->wrong++;
}

static void middle(const double a[3], const double b[3], double m[3])
{
    for (int k = 0; k < 3; k++)
        m[k] = 0.5 * (a[k] + b[k]);
}

void judge_attach(const struct hard_case *h, int nodes, const struct truth *t, struct tally *a)
{
    const int corners = nodes == 3 || nodes == 6 ? 3 : 4;
    double x[9][3] = {{0}}, xs[3], ratio[9], dist = -1, xi, eta, most = 0;
    for (int i = 0; i < corners; i++) {
        memcpy(x[i], h->x[i], sizeof x[i]);
        if (nodes > corners)
            middle(h->x[i], h->x[(i + 1) % corners], x[corners + i]);
    }
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            most = fmax(most, fabs(h->x[i][k]));
    memcpy(xs, h->x[4], sizeof xs);
    attach_2d_(x, xs, &nodes, ratio, &dist, &xi, &eta);
    a->calls++;
    a->answered++;
    const double off = fabs(dist - true_distance(t));
    a->worst = fmax(a->worst, off / (t->surface.edge * t->surface.scale + true_distance(t)));
    if (!(off <= tolerance(t, ATTACHED) + ROUNDING * most))
        a->why = "the distance", a->wrong++;
}
