/* Calls footpoint_quad4_along, the same with first derivatives, or Newton's iteration with dual numbers of 18
 * directions, on the same ordinary lines, to count their instructions: along_cost_main along|gradients|duals. Dual
 * numbers must have the same derivatives. */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad4_derivatives.h"

#include <cmath>
#include <cstdio>
#include <cstring>

enum { CALLS = 10000, ALL = 18 };

FOOTPOINT_QUAD4_GRADIENTS_ALONG_OF(footpoint_quad4_along)

struct answer {
    double value[3], d[3][ALL]; /* xi, eta, distance */
};

/* Holds a value and its derivatives by nodes, slave node and direction. */
struct dual {
    double v, d[ALL];
};

static dual constant(double v)
{
    dual r = {v, {0.0}};
    return r;
}

static dual operator+(const dual &a, const dual &b)
{
    dual r;
    r.v = a.v + b.v;
    for (int i = 0; i < ALL; i++)
        r.d[i] = a.d[i] + b.d[i];
    return r;
}

static dual operator-(const dual &a, const dual &b)
{
    dual r;
    r.v = a.v - b.v;
    for (int i = 0; i < ALL; i++)
        r.d[i] = a.d[i] - b.d[i];
    return r;
}

static dual operator*(const dual &a, const dual &b)
{
    dual r;
    r.v = a.v * b.v;
    for (int i = 0; i < ALL; i++)
        r.d[i] = a.d[i] * b.v + a.v * b.d[i];
    return r;
}

static dual operator*(double a, const dual &b)
{
    dual r;
    r.v = a * b.v;
    for (int i = 0; i < ALL; i++)
        r.d[i] = a * b.d[i];
    return r;
}

static dual operator/(const dual &a, const dual &b)
{
    const double over = 1.0 / b.v;
    dual r;
    r.v = a.v * over;
    for (int i = 0; i < ALL; i++)
        r.d[i] = (a.d[i] - r.v * b.d[i]) * over;
    return r;
}

static dual sqrt(const dual &a)
{
    dual r;
    r.v = std::sqrt(a.v);
    for (int i = 0; i < ALL; i++)
        r.d[i] = 0.5 / r.v * a.d[i];
    return r;
}

static dual determinant(const dual a[3], const dual b[3], const dual c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Takes a step for {xi, eta, distance}; returns its size. */
static double step(const dual x[6][3], const dual q[3], dual at[3])
{
    const dual one = constant(1.0), left = one - at[0], right = one + at[0], low = one - at[1], high = one + at[1];
    dual a[3], b[3], c[3];
    for (int i = 0; i < 3; i++) {
        a[i] = 0.25 * (low * (x[1][i] - x[0][i]) + high * (x[2][i] - x[3][i]));
        b[i] = 0.25 * (left * (x[3][i] - x[0][i]) + right * (x[2][i] - x[1][i]));
        c[i] = x[4][i] - at[2] * q[i] -
               0.25 * (low * (left * x[0][i] + right * x[1][i]) + high * (right * x[2][i] + left * x[3][i]));
    }
    const dual det = determinant(a, b, q);
    const dual by[3] = {determinant(c, b, q) / det, determinant(a, c, q) / det, determinant(a, b, c) / det};
    for (int i = 0; i < 3; i++)
        at[i] = at[i] + by[i];
    return std::fabs(by[0].v) + std::fabs(by[1].v);
}

extern "C" {
__attribute__((noinline)) int counted_along(const double x[6][3], answer *to);
__attribute__((noinline)) int counted_gradients(const double x[6][3], answer *to);
__attribute__((noinline)) int counted_duals(const double x[6][3], answer *to);
}

int counted_along(const double x[6][3], answer *to)
{
    return footpoint_quad4_along(x[0], x[1], x[2], x[3], x[4], x[5], to->value, &to->value[2]);
}

int counted_gradients(const double x[6][3], answer *to)
{
    return footpoint_quad4_along_gradients(x[0], x[1], x[2], x[3], x[4], x[5], to->value, &to->value[2], to->d[0],
                                           to->d[1], to->d[2]);
}

/* Iterates from the middle until the step is below 1e-10: then derivatives at its end are as accurate. */
int counted_duals(const double x[6][3], answer *to)
{
    dual y[6][3], at[3] = {constant(0.0), constant(0.0), constant(0.0)}, q[3];
    for (int i = 0; i < ALL; i++) {
        y[i / 3][i % 3] = constant(x[i / 3][i % 3]);
        y[i / 3][i % 3].d[i] = 1.0;
    }
    const dual length = sqrt(y[5][0] * y[5][0] + y[5][1] * y[5][1] + y[5][2] * y[5][2]);
    for (int i = 0; i < 3; i++)
        q[i] = y[5][i] / length;
    for (int n = 0; n < 20; n++)
        if (step(y, q, at) < 1e-10)
            break;
    for (int j = 0; j < 3; j++) {
        to->value[j] = at[j].v;
        std::memcpy(to->d[j], at[j].d, sizeof to->d[j]);
    }
    return 0;
}

static double draw()
{
    static unsigned long long seed = 5;
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(seed >> 11) / 9007199254740992.0 - 0.5;
}

static void draw_line(double x[6][3])
{
    static const double square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            x[k][i] = (i < 2 ? square[k][i] : 0.0) + 0.2 * draw();
    for (int i = 0; i < 3; i++) {
        x[4][i] = 1.6 * (i < 2 ? draw() : 0.3 * draw());
        x[5][i] = i < 2 ? 0.3 * draw() : 1.0 + 0.3 * draw();
    }
}

int main(int argc, char **argv)
{
    int (*const call)(const double x[6][3], answer *) = argc < 2                             ? nullptr
                                                        : std::strcmp(argv[1], "along") == 0 ? counted_along
                                                        : std::strcmp(argv[1], "duals") == 0 ? counted_duals
                                                                                             : counted_gradients;
    double worst = 0.0;
    int failed = 0;
    for (int n = 0; call && n < CALLS; n++) {
        double x[6][3];
        answer a, b;
        draw_line(x);
        failed += call(x, &a) != FOOTPOINT_OK;
        if (call == counted_gradients || n % 20)
            continue;
        failed += counted_gradients(x, &b) != FOOTPOINT_OK;
        for (int j = 0; j < 3 * (call == counted_duals); j++)
            for (int i = 0; i < ALL; i++)
                worst = std::fmax(worst, std::fabs(a.d[j][i] - b.d[j][i]));
    }
    std::printf("%d of %d failed, derivatives differ by %.1e\n", failed, (int)CALLS, worst);
    return !call || failed || !(worst < 1e-8);
}
