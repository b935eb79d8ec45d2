/* Draws wild families; see wild.h. */
#include "wild.h"

#include "draw.h"

#include <math.h>
#include <string.h>

static void corners_of_normal(uint64_t *s, double width, double height, struct hard_case *h)
{
    for (int i = 0; i < 4; i++) {
        h->x[i][0] = draw_normal(s);
        h->x[i][1] = width * draw_normal(s);
        h->x[i][2] = height * draw_normal(s);
    }
}

/* Draws any point of the segment. */
static void draw_point(uint64_t *s, const struct hard_case *h, double r[3])
{
    const double xi = draw_flat(s, -1, 1), eta = draw_flat(s, -1, 1);
    double t[3], u[3], c[3];
    draw_evaluate(h, xi, eta, r, t, u, c);
}

/* Places xS on the segment to rounding, within the segment's height, or anywhere in the plane. */
static void place_flat(uint64_t *s, double height, struct hard_case *h)
{
    double r[3];
    const int kind = draw_choose(s, 5);
    draw_point(s, h, r);
    for (int k = 0; k < 3; k++)
        h->x[4][k] = r[k] + (kind < 2 ? 0 : height * draw_normal(s));
    if (kind == 4)
        for (int k = 0; k < 2; k++)
            h->x[4][k] += draw_normal(s);
}

static void settle(uint64_t *s, struct hard_case *h)
{
    if (draw_choose(s, 2)) {
        const double shift = draw_choose(s, 2) ? 2 : 0;
        draw_move(s, h, draw_power(s, -2, 2), shift);
    }
}

void wild_flat(uint64_t *s, struct hard_case *h)
{
    const double height = draw_power(s, -6, -1);
    corners_of_normal(s, 1, height, h);
    place_flat(s, height, h);
    settle(s, h);
}

void wild_flat_quad(uint64_t *s, struct hard_case *h)
{
    const double height = draw_power(s, -6, -1);
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0, h);
    for (int i = 0; i < 4; i++)
        h->x[i][2] = height * draw_normal(s);
    place_flat(s, height, h);
    settle(s, h);
}

void wild_flat_crossing(uint64_t *s, struct hard_case *h)
{
    const double height = draw_power(s, -6, -1);
    const int i = draw_choose(s, 4);
    double keep[3];
    draw_quad(s, draw_flat(s, 1, 3), 0.3, 0, h);
    memcpy(keep, h->x[i], sizeof keep);
    memcpy(h->x[i], h->x[(i + 1) % 4], sizeof keep);
    memcpy(h->x[(i + 1) % 4], keep, sizeof keep);
    for (int k = 0; k < 4; k++)
        h->x[k][2] = height * draw_normal(s);
    place_flat(s, height, h);
    settle(s, h);
}

void wild_flat_needle(uint64_t *s, struct hard_case *h)
{
    const double width = draw_power(s, -4, -1), height = width * draw_power(s, -5, 0);
    corners_of_normal(s, width, height, h);
    place_flat(s, height, h);
    settle(s, h);
}

/* Draws an edge of no length. */
void wild_flat_collapsed(uint64_t *s, struct hard_case *h)
{
    const double height = draw_power(s, -6, -1);
    const int i = draw_choose(s, 4);
    corners_of_normal(s, 1, height, h);
    memcpy(h->x[i], h->x[(i + 1) % 4], sizeof h->x[i]);
    place_flat(s, height, h);
    settle(s, h);
}

/* Draws two edges of no length, two coinciding opposite corners, or both pairs of them. */
void wild_flat_pairs(uint64_t *s, struct hard_case *h)
{
    const double height = draw_power(s, -6, -1);
    const int kind = draw_choose(s, 4);
    corners_of_normal(s, 1, height, h);
    if (kind == 0)
        memcpy(h->x[1], h->x[0], sizeof h->x[0]), memcpy(h->x[3], h->x[2], sizeof h->x[0]);
    else if (kind == 1)
        memcpy(h->x[3], h->x[0], sizeof h->x[0]), memcpy(h->x[2], h->x[1], sizeof h->x[0]);
    else
        memcpy(h->x[2], h->x[0], sizeof h->x[0]);
    if (kind == 3)
        memcpy(h->x[3], h->x[1], sizeof h->x[0]);
    place_flat(s, height, h);
    settle(s, h);
}

static void mix(uint64_t *s, double decades, struct hard_case *h)
{
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++) {
            const double size = draw_power(s, -decades / 2, decades / 2);
            h->x[i][k] = size * draw_normal(s);
        }
    if (draw_choose(s, 2))
        draw_point(s, h, h->x[4]);
}

void wild_scales4(uint64_t *s, struct hard_case *h)
{
    mix(s, 4, h);
}

void wild_scales8(uint64_t *s, struct hard_case *h)
{
    mix(s, 8, h);
}

void wild_scales16(uint64_t *s, struct hard_case *h)
{
    mix(s, 16, h);
}

/* Draws aspects of up to 1e8. */
void wild_needle(uint64_t *s, struct hard_case *h)
{
    const double aspect = draw_power(s, 2, 8);
    const int kind = draw_choose(s, 4);
    draw_quad(s, aspect, kind & 1 ? 0.15 : 0.6, kind & 2 ? 0.1 : 1, h);
    for (int i = 0; i < 4; i++)
        h->x[i][0] *= draw_flat(s, 0.2, 1);
    if (draw_choose(s, 2)) {
        const double xi = draw_flat(s, -1, 1), eta = draw_flat(s, -1, 1);
        draw_place(s, h, xi, eta, draw_choose(s, 3) ? draw_flat(s, -0.5, 0.5) : 0);
    } else
        for (int k = 0; k < 3; k++)
            h->x[4][k] = (k == 0 ? aspect : 1) * draw_normal(s);
    settle(s, h);
}

static double little(uint64_t *s)
{
    const double size = draw_power(s, -16, -2);
    return draw_choose(s, 3) ? draw_sign(s) * size : 0;
}

/* Draws a part of the saddle z = w x y with xS near the axis, at the height at which one closest point becomes two. */
void wild_pitchfork(uint64_t *s, struct hard_case *h)
{
    const double a = draw_flat(s, 0.5, 2), b = draw_choose(s, 2) ? a : draw_flat(s, 0.5, 2), w = draw_power(s, -1, 1);
    const double p = draw_choose(s, 2) ? 0 : draw_flat(s, -0.9, 0.9),
                 q = draw_choose(s, 2) ? p : draw_flat(s, -0.9, 0.9);
    for (int i = 0; i < 4; i++) {
        const double x = a * (draw_corner[i][0] - p), y = b * (draw_corner[i][1] - q);
        h->x[i][0] = x;
        h->x[i][1] = y;
        h->x[i][2] = w * x * y;
    }
    h->x[4][0] = little(s);
    h->x[4][1] = draw_choose(s, 2) ? h->x[4][0] : little(s);
    h->x[4][2] = (1 + little(s)) / w;
    h->x[4][2] *= draw_sign(s);
    settle(s, h);
}

static double coarse(double x)
{
    return nearbyint(x * 0x1p20) * 0x1p-20;
}

static void corners_of_few_bits(uint64_t *s, struct hard_case *h)
{
    const double height = draw_choose(s, 3) ? draw_power(s, -5, 0) : 0;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            h->x[i][k] = coarse((k == 2 ? height : 1) * draw_normal(s));
}

void wild_on_corner(uint64_t *s, struct hard_case *h)
{
    if (draw_choose(s, 2))
        corners_of_few_bits(s, h);
    else
        draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    settle(s, h);
    memcpy(h->x[4], h->x[draw_choose(s, 4)], sizeof h->x[4]);
}

/* Places xS on an edge to the last bit. */
void wild_on_edge(uint64_t *s, struct hard_case *h)
{
    const int i = draw_choose(s, 4);
    const double t = coarse(draw_flat(s, 0, 1));
    corners_of_few_bits(s, h);
    for (int k = 0; k < 3; k++)
        h->x[4][k] = h->x[i][k] + t * (h->x[(i + 1) % 4][k] - h->x[i][k]);
}

/* Places xS at the crossing of two edges. */
void wild_pinch(uint64_t *s, struct hard_case *h)
{
    const int turn = draw_choose(s, 4);
    const double height = draw_choose(s, 2) ? draw_power(s, -8, -1) : 0;
    corners_of_few_bits(s, h);
    for (int k = 0; k < 3; k++)
        h->x[4][k] = coarse(draw_normal(s));
    for (int pair = 0; pair < 2; pair++) {
        const double by = coarse(draw_flat(s, 0.1, 3));
        double *const from = h->x[(2 * pair + turn) % 4], *const to = h->x[(2 * pair + 1 + turn) % 4];
        for (int k = 0; k < 3; k++) {
            from[k] = coarse(draw_normal(s));
            to[k] = h->x[4][k] - by * (from[k] - h->x[4][k]);
        }
    }
    for (int k = 0; k < 3 && height > 0; k++)
        h->x[4][k] += height * draw_normal(s);
}

/* The worst cases found. */
static const double worst[][5][3] = {
    /* xS on a concave segment, nearly plane, of edges of 1 and of 10 to 200 */
    {{0.39997465605888455, 1.5333185436955445, 0.014074889855700344},
     {-0.16152746281492211, 0.50425809207297501, -0.0096560798677391441},
     {0.20985992062631359, 1.2602276817346791, -0.0062259698497370763},
     {-0.95846823731034669, -1.2045259798236725, -0.0021448588298890793},
     {-0.037613254483199556, 0.73607683461885853, -0.0051088522393966133}},
    {{-0x1.609ea7e5f9e27p+4, 0x1.3ffab79b397bep+4, -0x1.2729fe42d5c6dp-3},
     {0x1.8e3f4a4973a21p-4, 0x1.a7c5e3e029a3p+7, -0x1.1dff4b5969df6p+0},
     {-0x1.4be0a607f881ep+3, 0x1.a0040bbecfdap+2, 0x1.2477c8715b51ap-13},
     {0x1.67a9b158091c7p+2, -0x1.64227d5644721p-4, 0x1.3e765613491f4p-5},
     {-0x1.630bb51eae4e1p+0, 0x1.92d72539426dp+3, -0x1.457ae8fdacf79p-5}},
    /* xS within 1.75e-4 of a needle */
    {{0.055083560448298784, 0.0035858627859185173, 0.25221654396375293},
     {0.01071295848258379, -32.241869191362063, -2.0011733539178804},
     {-0.032331437731213566, 0.026990375581251929, 0.16902909197240962},
     {-0.04257153124827176, -15.814259989348622, -0.68195453726614341},
     {-0.011057098387278792, -10.669936415485187, -0.44591646831223664}},
    /* edges of 20 to 1e6 */
    {{-0x1.2dafeed9c2cfp+9, -0x1.3378cd60a6097p-2, 0x1.050d11401c26dp-5},
     {0x1.5e8c68823505cp-16, -0x1.7fea4f2f8da69p-28, -0x1.d1b70225b8b67p+22},
     {0x1.c4ba4451951cfp-26, 0x1.db8b7e1d69fb6p-17, -0x1.0e4e692448d31p+8},
     {-0x1.11bdc5470a23p-7, -0x1.37c7415a9dc46p+4, -0x1.37e8c3a791c37p+20},
     {-0x1.730d043372b7bp+7, -0x1.591dadbbf3b8p+3, -0x1.0be46660f74a1p+20}}};

/* Draws one of them as it is, with other numbers of the corners and another unit, or with last digits changed. */
void wild_worst(uint64_t *s, struct hard_case *h)
{
    const int which = draw_choose(s, sizeof worst / sizeof *worst), turn = draw_choose(s, 4),
              mirror = draw_choose(s, 2);
    const double scale = draw_choose(s, 2) ? 1 : ldexp(1, draw_choose(s, 41) - 20);
    const double change = draw_choose(s, 2) ? 0 : draw_power(s, -16, -6);
    for (int i = 0; i < 5; i++) {
        const int from = i == 4 ? 4 : mirror ? (turn + 4 - i) % 4 : (turn + i) % 4;
        for (int k = 0; k < 3; k++)
            h->x[i][k] = scale * worst[which][from][k] * (1 + change * draw_normal(s));
    }
}
