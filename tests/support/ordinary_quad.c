/* Draws ordinary segments with known foot points; see ordinary_quad.h.  Position and normal are computed here from the
 * definition of the bilinear segment, without the code under test. */
#include "ordinary_quad.h"

#include "../../evolve/common/stream.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <string.h>

enum { SEED = 20081 };
enum key { KEY_SHAPE, KEY_ROTATION };

const struct quad_limits quad_ordinary = {0.15, 0.03, 0.1, 0.95};

static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

static double symmetric(gsl_rng *stream, double most)
{
    return gsl_ran_flat(stream, -most, most);
}

/* Draws columns a, b, a x b of a random orthonormal frame. */
static void draw_rotation(gsl_rng *stream, double frame[3][3])
{
    double a[3], b[3], along, length;
    gsl_ran_dir_3d(stream, &a[0], &a[1], &a[2]);
    do {
        gsl_ran_dir_3d(stream, &b[0], &b[1], &b[2]);
        along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        length = sqrt(1 - along * along);
    } while (!(length > 0.1));
    for (int k = 0; k < 3; k++)
        b[k] = (b[k] - along * a[k]) / length;
    for (int k = 0; k < 3; k++) {
        frame[k][0] = a[k];
        frame[k][1] = b[k];
        frame[k][2] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
}

static void move_point(double frame[3][3], double scale, const double shift[3], double x[3])
{
    double y[3];
    for (int k = 0; k < 3; k++)
        y[k] = scale * (frame[k][0] * x[0] + frame[k][1] * x[1] + frame[k][2] * x[2]) + shift[k];
    memcpy(x, y, sizeof y);
}

struct quad quad_move(const struct quad *q, uint64_t index, double scale, double shift)
{
    struct quad moved = *q;
    double frame[3][3], by[3], size = 0;
    gsl_rng *stream = stream_new();
    stream_key(stream, SEED, KEY_ROTATION, index, 0);
    draw_rotation(stream, frame);
    gsl_ran_dir_3d(stream, &by[0], &by[1], &by[2]);
    for (int k = 0; k < 3; k++)
        size = fmax(size, scale * fabs(q->x[2][k] - q->x[0][k]));
    for (int k = 0; k < 3; k++)
        by[k] *= shift * size;
    for (int i = 0; i < 4; i++)
        move_point(frame, scale, by, moved.x[i]);
    move_point(frame, scale, by, moved.xs);
    moved.gap *= scale;
    gsl_rng_free(stream);
    return moved;
}

/* Computes xs = r(xi,eta) + gap n(xi,eta). */
static void place_slave(struct quad *q)
{
    double r[3] = {0}, t[3] = {0}, u[3] = {0}, n[3], length = 0;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            r[k] += q->x[i][k] * (1 + corner[i][0] * q->xi) * (1 + corner[i][1] * q->eta) / 4;
            t[k] += q->x[i][k] * corner[i][0] * (1 + corner[i][1] * q->eta) / 4;
            u[k] += q->x[i][k] * (1 + corner[i][0] * q->xi) * corner[i][1] / 4;
        }
    for (int k = 0; k < 3; k++) {
        n[k] = t[(k + 1) % 3] * u[(k + 2) % 3] - t[(k + 2) % 3] * u[(k + 1) % 3];
        length += n[k] * n[k];
    }
    for (int k = 0; k < 3; k++)
        q->xs[k] = r[k] + q->gap * n[k] / sqrt(length);
}

struct quad quad_draw(const struct quad_limits *limits, uint64_t index)
{
    struct quad q;
    gsl_rng *stream = stream_new();
    stream_key(stream, SEED, KEY_SHAPE, index, 0);
    const double aspect = gsl_ran_flat(stream, 1, 3), size = pow(10, gsl_ran_flat(stream, -1, 1));
    for (int i = 0; i < 4; i++) {
        q.x[i][0] = aspect * corner[i][0] / 2 + symmetric(stream, limits->corner);
        q.x[i][1] = corner[i][1] / 2 + symmetric(stream, limits->corner);
        q.x[i][2] = symmetric(stream, limits->warp);
    }
    q.xi = symmetric(stream, limits->reach);
    q.eta = symmetric(stream, limits->reach);
    q.gap = symmetric(stream, limits->gap);
    gsl_rng_free(stream);
    place_slave(&q);
    return quad_move(&q, index, size, 2);
}

struct quad quad_turn_corners(const struct quad *q)
{
    struct quad t = *q;
    for (int i = 0; i < 4; i++)
        memcpy(t.x[i], q->x[(i + 1) % 4], sizeof t.x[i]);
    t.xi = q->eta;
    t.eta = -q->xi;
    return t;
}

struct quad quad_mirror_corners(const struct quad *q)
{
    struct quad t = *q;
    memcpy(t.x[1], q->x[3], sizeof t.x[1]);
    memcpy(t.x[3], q->x[1], sizeof t.x[3]);
    t.xi = q->eta;
    t.eta = q->xi;
    t.gap = -q->gap;
    return t;
}
