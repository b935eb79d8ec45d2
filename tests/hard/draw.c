/* Draws random numbers and segments; see draw.h. */
#include "draw.h"

#include <math.h>
#include <string.h>

const double draw_corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

/* Uses splitmix64. */
uint64_t draw_next(uint64_t *stream)
{
    uint64_t z = *stream += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

double draw_flat(uint64_t *stream, double low, double high)
{
    return low + (high - low) * ((double)(draw_next(stream) >> 11) * 0x1p-53);
}

double draw_power(uint64_t *stream, double low, double high)
{
    return pow(10, draw_flat(stream, low, high));
}

int draw_choose(uint64_t *stream, int n)
{
    return (int)(draw_next(stream) % (uint64_t)n);
}

double draw_sign(uint64_t *stream)
{
    return draw_choose(stream, 2) ? 1 : -1;
}

/* Uses Marsaglia's polar method. */
double draw_normal(uint64_t *stream)
{
    double x, square;
    do {
        const double y = draw_flat(stream, -1, 1);
        x = draw_flat(stream, -1, 1);
        square = x * x + y * y;
    } while (!(square > 0 && square < 1));
    return x * sqrt(-2 * log(square) / square);
}

void draw_direction(uint64_t *stream, double d[3])
{
    double square;
    do {
        for (int k = 0; k < 3; k++)
            d[k] = draw_flat(stream, -1, 1);
        square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    } while (!(square > 0.01 && square <= 1));
    for (int k = 0; k < 3; k++)
        d[k] /= sqrt(square);
}

void draw_quad(uint64_t *stream, double aspect, double moved, double warp, struct hard_case *h)
{
    for (int i = 0; i < 4; i++) {
        h->x[i][0] = aspect * draw_corner[i][0] / 2 + draw_flat(stream, -moved, moved);
        h->x[i][1] = draw_corner[i][1] / 2 + draw_flat(stream, -moved, moved);
        h->x[i][2] = draw_flat(stream, -warp, warp);
    }
}

void draw_evaluate(const struct hard_case *h, double xi, double eta, double r[3], double t[3], double u[3], double c[3])
{
    for (int k = 0; k < 3; k++) {
        r[k] = t[k] = u[k] = c[k] = 0;
        for (int i = 0; i < 4; i++) {
            r[k] += h->x[i][k] * (1 + draw_corner[i][0] * xi) * (1 + draw_corner[i][1] * eta) / 4;
            t[k] += h->x[i][k] * draw_corner[i][0] * (1 + draw_corner[i][1] * eta) / 4;
            u[k] += h->x[i][k] * (1 + draw_corner[i][0] * xi) * draw_corner[i][1] / 4;
            c[k] += h->x[i][k] * draw_corner[i][0] * draw_corner[i][1] / 4;
        }
    }
}

void draw_place(uint64_t *stream, struct hard_case *h, double xi, double eta, double gap)
{
    double r[3], t[3], u[3], c[3], n[3], any[3];
    draw_direction(stream, any);
    draw_evaluate(h, xi, eta, r, t, u, c);
    draw_cross(t, u, n);
    const double length = sqrt(draw_dot(n, n));
    for (int k = 0; k < 3; k++)
        h->x[4][k] = r[k] + gap * (length > 0 ? n[k] / length : any[k]);
}

void draw_move(uint64_t *stream, struct hard_case *h, double scale, double shift)
{
    double frame[3][3], by[3], size = 0;
    draw_direction(stream, frame[0]);
    do {
        draw_direction(stream, by);
        draw_cross(frame[0], by, frame[1]);
        size = sqrt(draw_dot(frame[1], frame[1]));
    } while (!(size > 0.1));
    for (int k = 0; k < 3; k++)
        frame[1][k] /= size;
    draw_cross(frame[0], frame[1], frame[2]);
    draw_direction(stream, by);
    for (int i = 0; i < 5; i++) {
        double y[3];
        for (int k = 0; k < 3; k++)
            y[k] = scale *
                   (frame[0][k] * h->x[i][0] + frame[1][k] * h->x[i][1] + frame[2][k] * h->x[i][2] + shift * by[k]);
        memcpy(h->x[i], y, sizeof y);
    }
}
