/* Compares templates of C++ for double, float, long double and a dual number of the caller's own with the C header, on
 * faces with moved nodes. The compiler includes the headers and defines NAME, AT and GRADIENTS, functions of one kind
 * of face; NODES, the kind's number of nodes; COUNT, the number of faces; and NEAR, the allowed distance of C's and
 * templates' foot points. */
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

enum { ALL = 3 * (NODES + 1) };

/* v + d e with e^2 = 0.  Only the conversions that the headers need. */
struct dual {
    double v, d;
    dual() = default;
    explicit dual(double value, double slope = 0.0) : v(value), d(slope) {}
    dual &operator+=(const dual &b) { return *this = dual(v + b.v, d + b.d); }
    dual &operator-=(const dual &b) { return *this = dual(v - b.v, d - b.d); }
};
static dual operator+(const dual &a, const dual &b) { return dual(a.v + b.v, a.d + b.d); }
static dual operator-(const dual &a, const dual &b) { return dual(a.v - b.v, a.d - b.d); }
static dual operator-(const dual &a) { return dual(-a.v, -a.d); }
static dual operator*(const dual &a, const dual &b) { return dual(a.v * b.v, a.d * b.v + a.v * b.d); }
static dual operator/(const dual &a, const dual &b) { return dual(a.v / b.v, (a.d - a.v / b.v * b.d) / b.v); }
static dual sqrt(const dual &a) { return dual(std::sqrt(a.v), 0.5 * a.d / std::sqrt(a.v)); }
[[maybe_unused]] static dual fabs(const dual &a) { return a.v < 0.0 ? -a : a; }
[[maybe_unused]] static bool operator<(const dual &a, const dual &b) { return a.v < b.v; }
[[maybe_unused]] static bool operator>(const dual &a, const dual &b) { return a.v > b.v; }
[[maybe_unused]] static bool operator<=(const dual &a, const dual &b) { return a.v <= b.v; }
[[maybe_unused]] static bool operator>=(const dual &a, const dual &b) { return a.v >= b.v; }
[[maybe_unused]] static bool operator==(const dual &a, const dual &b) { return a.v == b.v; }

#if NODES == 3
#define ROWS(x) x, x + 3, x + 6, x + 9
#elif NODES == 4
#define ROWS(x) x, x + 3, x + 6, x + 9, x + 12
#elif NODES == 6
#define ROWS(x) x, x + 3, x + 6, x + 9, x + 12, x + 15, x + 18
#elif NODES == 8
#define ROWS(x) x, x + 3, x + 6, x + 9, x + 12, x + 15, x + 18, x + 21, x + 24
#else
#define ROWS(x) x, x + 3, x + 6, x + 9, x + 12, x + 15, x + 18, x + 21, x + 24, x + 27
#endif

static double draw()
{
    static unsigned long long seed = 5;
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(seed >> 11) / 9007199254740992.0 - 0.5;
}

/* Nodes of the face of reference, each moved by up to `moved` of half an edge, and a slave node near it; coordinates that
 * float has. */
static void draw_face(double x[ALL], double moved)
{
    const bool triangle = NODES == 3 || NODES == 6;
    const double half = triangle ? 0.5 : 1.0, middle = triangle ? 0.33 : 0.0;
    static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
    static const double corner[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    for (int k = 0; k < NODES; k++) {
        const double *const at = triangle ? corner[k % 6] : square[k];
        x[3 * k] = at[0] + half * moved * draw();
        x[3 * k + 1] = at[1] + half * moved * draw();
        x[3 * k + 2] = half * moved * draw();
    }
    x[3 * NODES] = middle + half * draw();
    x[3 * NODES + 1] = middle + half * draw();
    x[3 * NODES + 2] = half * 0.4 * draw();
    for (int i = 0; i < ALL; i++)
        x[i] = (double)(float)x[i];
}

static void fail(const char *what, double a, double b)
{
    std::printf("%s: %.17g, not %.17g\n", what, a, b);
    std::exit(1);
}

static void near_to(const char *what, double a, double b, double most)
{
    if (!(std::fabs(a - b) <= most))
        fail(what, a, b);
}

static void check_double(const double *x, double loc[2], double *gap)
{
    double c[2], t[2], at[2], height;
    AT(ROWS(x), c, c + 1);
    AT<double>(ROWS(x), t, t + 1);
    if (std::memcmp(c, t, sizeof c) != 0)
        fail("the bits of C", t[0], c[0]);
    if (NAME(ROWS(x), loc, gap) != FOOTPOINT_OK)
        fail("status in double", 1, 0);
    if (NAME<double>(ROWS(x), at, &height) != FOOTPOINT_UNPROVED)
        fail("status of the template", 0, FOOTPOINT_UNPROVED);
    near_to("xi", at[0], loc[0], NEAR);
    near_to("eta", at[1], loc[1], NEAR);
    near_to("gap", height, *gap, 1e-13);
}

static void check_float(const double *x, const double loc[2], double gap)
{
    float y[ALL], at[2], height;
    for (int i = 0; i < ALL; i++)
        y[i] = (float)x[i];
    if (NAME(ROWS(y), at, &height) != FOOTPOINT_OK || !(at[0] == (float)loc[0]) || !(at[1] == (float)loc[1]) ||
        !(height == (float)gap))
        fail("float is double rounded", (double)at[0], loc[0]);
    NAME<float>(ROWS(y), at, &height);
    near_to("xi in float", (double)at[0], loc[0], 3e-5);
    near_to("gap in float", (double)height, gap, 1e-5);
}

/* Checks that (xS - r) . r_xi is 0 to the rounding of long double, by differences of the squared distance. */
static void check_long_double(const double *x, const double loc[2], double gap)
{
    long double y[ALL], at[2], height;
    for (int i = 0; i < ALL; i++)
        y[i] = (long double)x[i];
    NAME(ROWS(y), at, &height);
    near_to("xi in long double", (double)at[0], loc[0], NEAR);
    near_to("eta in long double", (double)at[1], loc[1], NEAR);
    near_to("gap in long double", (double)height, gap, 1e-14);
#if NODES == 4
    long double f = 0, g = 0, size = 0;
    for (int i = 0; i < 3; i++) {
        const long double a = 1 - at[0], b = 1 + at[0], c = 1 - at[1], d = 1 + at[1];
        const long double u = (c * (y[3 + i] - y[i]) + d * (y[6 + i] - y[9 + i])) / 4;
        const long double v = (a * (y[9 + i] - y[i]) + b * (y[6 + i] - y[3 + i])) / 4;
        const long double w = y[12 + i] - (a * c * y[i] + b * c * y[3 + i] + b * d * y[6 + i] + a * d * y[9 + i]) / 4;
        f += u * w;
        g += v * w;
        size += u * u + v * v;
    }
    near_to("normal in long double", (double)((std::fabs(f) + std::fabs(g)) / size), 0.0, 20.0 * (double)LDBL_EPSILON);
#endif
}

/* Checks that the derivative along a direction of all coordinates is the sum of the analytic derivatives. */
static void check_dual(const double *x, const double loc[2], double gap)
{
    double phi[NODES], u[3], v[3], n[3], height, slope[3][ALL];
    dual y[ALL], at[2], above;
    for (int i = 0; i < ALL; i++)
        y[i] = dual(x[i], 2.0 * draw());
    if (NAME(ROWS(y), at, &above) != FOOTPOINT_UNPROVED)
        fail("status of a dual number", 0, FOOTPOINT_UNPROVED);
    near_to("xi of a dual number", at[0].v, loc[0], NEAR);
    near_to("gap of a dual number", above.v, gap, 1e-13);
    const double place[2] = {at[0].v, at[1].v};
    if (GRADIENTS(ROWS(x), place, phi, u, v, n, &height, slope[0], slope[1], slope[2]) != FOOTPOINT_OK)
        fail("derivatives", 0, 0);
    const double found[3] = {at[0].d, at[1].d, above.d};
    for (int k = 0; k < 3; k++) {
        double sum = 0.0, size = 0.0;
        for (int i = 0; i < ALL; i++) {
            sum += slope[k][i] * y[i].d;
            size += std::fabs(slope[k][i]);
        }
        near_to("derivative", found[k], sum, NEAR * size);
    }
}

int main()
{
    for (int n = 0; n < COUNT; n++) {
        double x[ALL], loc[2], gap;
        draw_face(x, NODES > 4 ? 0.1 : 0.4);
        check_double(x, loc, &gap);
        check_float(x, loc, gap);
        check_long_double(x, loc, gap);
        check_dual(x, loc, gap);
    }
    return 0;
}
