/* Judges answers; see library_judge.h.
 *
 * A search for the closest point of the closed face is right if its point is a closest point, to the tolerance, or
 * equally near to xS, to 1e-10 of an edge. A search for a foot point is right if it finds the closest point, if that is
 * a foot point inside the face. Otherwise it is right if it finds any foot point, inside or not, or reports that there
 * is no answer. */
#include "library_judge.h"

#include <math.h>
#include <string.h>

#define AGREE 2e-8 /* largest difference between two references, in longest edges */
#define STEP 1e-9  /* step of differences; in 113 bits their error is about its square */
#define ROUNDING 1e-14

/* Returns true if tests/hard finds the same distance, by another subdivision and other arithmetic. */
static int agrees(const struct library_truth *t)
{
    static struct truth other;
    struct hard_case h;
    memcpy(h.x, t->c.x, 4 * sizeof *h.x);
    memcpy(h.x[4], t->c.xs, sizeof h.x[4]);
    truth_find(&h, TRUTH_ALL, &other);
    if (other.count == 0 || !other.decided)
        return 1;
    const double distance = sqrt((double)other.point[0].square) * other.surface.scale;
    return fabs(distance - t->nearest.distance) <= AGREE * t->face.edge + ROUNDING * distance;
}

int library_truth_find(int kind, const struct library_case *c, struct library_truth *t)
{
    t->c = *c;
    face_of(kind, c->x[0], &t->face);
    face_find(&t->face, c->xs, &t->nearest);
    return t->nearest.certain && (kind != LIBRARY_QUAD4 || agrees(t));
}

/* Finds xi and eta of a point in space; returns its distance from the face, in longest edges. */
static double place_of(const struct face *f, const double point[3], double loc[2])
{
    struct face_nearest n;
    if (!isfinite(point[0]) || !isfinite(point[1]) || !isfinite(point[2]))
        return INFINITY;
    face_find(f, point, &n);
    loc[0] = (double)n.z[0];
    loc[1] = (double)n.z[1];
    return n.distance / f->edge;
}

enum library_verdict library_judge(enum library_question question, const struct library_truth *t, int status,
                                   const struct library_answer *a, double *off)
{
    double loc[2] = {a->loc[0], a->loc[1]};
    const int beside = question != LIBRARY_CLOSEST && t->nearest.on_edge;
    *off = 0;
    if (beside && question == LIBRARY_INSIDE)
        return VERDICT_NONE;
    if (status != LIBRARY_ANSWER)
        return beside ? VERDICT_RIGHT : VERDICT_REFUSED;
    if (a->is_point)
        *off = place_of(&t->face, a->point, loc);
    const double away =
        beside ? face_off_foot(&t->face, t->c.xs, loc) : face_off_closest(&t->face, t->c.xs, &t->nearest, loc);
    *off = fmax(*off, away / t->face.edge);
    return *off <= LIBRARY_TOLERANCE ? VERDICT_RIGHT : VERDICT_WRONG;
}

/* ---- derivatives ---- */

static void foot_of(const wide x[5][3], const double loc[2], wide out[3])
{
    struct truth_surface s;
    wide u[3], v[3], n[3], d[3], nn = 0, dn = 0;
    for (int k = 0; k < 3; k++) {
        s.c1[k] = (-x[0][k] + x[1][k] + x[2][k] - x[3][k]) / 4;
        s.c2[k] = (-x[0][k] - x[1][k] + x[2][k] + x[3][k]) / 4;
        s.c3[k] = (x[0][k] - x[1][k] + x[2][k] - x[3][k]) / 4;
        s.d0[k] = x[4][k] - (x[0][k] + x[1][k] + x[2][k] + x[3][k]) / 4;
    }
    (void)truth_stationary(&s, loc, out);
    truth_offset(&s, out, d);
    for (int k = 0; k < 3; k++) {
        u[k] = s.c1[k] + out[1] * s.c3[k];
        v[k] = s.c2[k] + out[0] * s.c3[k];
    }
    for (int k = 0; k < 3; k++) {
        n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
        nn += n[k] * n[k];
        dn += n[k] * d[k];
    }
    wide root = sqrt((double)nn); /* Heron's method doubles the digits */
    for (int i = 0; i < 3; i++)
        root = (root + nn / root) / 2;
    out[2] = dn / root;
}

double library_judge_derivatives(const struct library_truth *t, const double d[3][15])
{
    wide x[5][3], true_d[3][15];
    double most[3] = {0, 0, 0}, worst = 0;
    const double loc[2] = {(double)t->nearest.z[0], (double)t->nearest.z[1]};
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            x[i][k] = i < 4 ? t->c.x[i][k] : t->c.xs[k];
    for (int j = 0; j < 15; j++) {
        wide side[2][3], *const one = &x[j / 3][j % 3], before = *one, h = (wide)(STEP * t->face.edge);
        for (int s = 0; s < 2; s++) {
            *one = before + (s ? h : -h);
            foot_of((const wide(*)[3])x, loc, side[s]);
        }
        *one = before;
        for (int i = 0; i < 3; i++)
            true_d[i][j] = (side[1][i] - side[0][i]) / (2 * h);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 15; j++)
            most[i] = fmax(most[i], fabs((double)true_d[i][j]));
        for (int j = 0; j < 15; j++) {
            const double error = fabs((double)(d[i][j] - true_d[i][j])) / most[i];
            worst = error <= worst ? worst : error;
        }
    }
    return worst;
}
