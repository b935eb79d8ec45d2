/* Tests the statuses of every function of one generated header, compiled with any flags, as C99 and C++11.
 * tests/cli/statuses.sh writes the file that includes this file. Before it, that file includes the header and defines
 * the macros
 *   R           double or float             NODES, VECTORS, CORNERS   of the segment; VECTORS with the slave node
 *   ARGUMENTS   of a call, from vectors x   FUNCTIONS(F)              F(name) for each function
 *   ORDER       places below, one a vector  EXTREME                   largest power of 2 for edges
 *   WIDE        corners may have any order; wide_NAME(x, loc) is NAME_at in the numbers of
 *     tests/generated/wide_number.h
 *   EXACT       the compiler keeps the order of operations, so that bits can be compared
 *   CLOSEST(F)  if the header has them: F(NAME_closest) for each function; its distance is compared as the gap
 *   OVER        the header has NAME_over_n
 *   PATCH       the segment is a patch
 *   SIDE_BY_SIDE  arrays are searched side by side
 *
 * Each call of NAME is repeated in NAME_checked_n, between two good pairs, and in NAME_over_n. */
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef int checked(const R (*x)[3], R loc[2], R *gap);
typedef void arrays(size_t n, const R *const x[3 * VECTORS], R *xi, R *eta, R *gap, int *status);
typedef void over(const R *const nodes[VECTORS - 1], size_t n, const R *const x[3], R *xi, R *eta, R *gap, int *status);
typedef void wide_at(const __float128 (*x)[3], __float128 loc[2]);

static int as_arrays(arrays *checked_n, const R (*x)[3], int status, const R loc[2], R gap);
#ifdef OVER
static int as_over(over *over_n, const R (*x)[3], int status, const R loc[2], R gap);
#else
#define as_over(over_n, x, status, loc, gap) (status)
#endif

#define WRAP(name)                                                                                                     \
    static int call_##name(const R(*x)[3], R loc[2], R *gap)                                                           \
    {                                                                                                                  \
        const int status = name(ARGUMENTS, loc, gap);                                                                  \
        const int many = as_arrays(name##_checked_n, x, status, loc, *gap);                                            \
        return many == status ? as_over(name##_over_n, x, status, loc, *gap) : many;                                   \
    }
FUNCTIONS(WRAP)
#ifdef CLOSEST
#define WRAP_CLOSEST(name)                                                                                             \
    static int call_##name(const R(*x)[3], R loc[2], R *gap)                                                           \
    {                                                                                                                  \
        int region = 99;                                                                                               \
        const int status = name(ARGUMENTS, loc, gap, &region);                                                         \
        return (region == 99) == (status < FOOTPOINT_OK) ? status : 99;                                                \
    }
CLOSEST(WRAP_CLOSEST)
#define ROW_CLOSEST(name) {#name, call_##name, NULL},
#else
#define CLOSEST(F)
#endif
#ifdef WIDE
#define ROW(name) {#name, call_##name, wide_##name},
#else
#define ROW(name) {#name, call_##name, NULL},
#endif
static const struct {
    const char *name;
    checked *call;
    wide_at *wide;
} function[] = {FUNCTIONS(ROW) CLOSEST(ROW_CLOSEST)};
enum { FUNCTION_COUNT = sizeof function / sizeof *function };

/* Nodes A to I of a quadrilateral; a slave node; the middle of BC, a normal. */
static const double place[12][3] = {{0, 0, 0},
                                    {1, 0, 0},
                                    {1.125, 1, 0},
                                    {0, 0.875, 0.0625},
                                    {0.5, 0, 0},
                                    {1.0625, 0.5, 0},
                                    {0.5625, 0.9375, 0.03125},
                                    {0, 0.4375, 0.03125},
                                    {0.53125, 0.46875, 0.015625},
                                    {0.25, 0.3125, 0.03125},
                                    {0.5625, 0.5, 0.03125},
                                    {0, 0, 1}};
static const int order[VECTORS] = {ORDER};
static int failures;

/* Returns true for the status of a good pair. If compilers may reorder sums, nothing is proved, and some functions of
 * patches never prove anything. */
static int is_good(int status)
{
#if defined __FAST_MATH__ || defined PATCH
    return status == FOOTPOINT_OK || status == FOOTPOINT_UNPROVED;
#else
    return status == FOOTPOINT_OK;
#endif
}

static void complain(int f, const char *what, int a, int b, int status)
{
    if (failures++ < 20)
        printf("%s: %s %d %d: status %d\n", function[f].name, what, a, b, status);
}

static void take_places(R x[VECTORS][3])
{
    int i, j;
    for (i = 0; i < VECTORS; i++)
        for (j = 0; j < 3; j++)
            x[i][j] = (R)place[order[i]][j];
}

/* Compares numbers, to the bit if the compiler keeps the order of operations. */
static int is_same(R a, R b)
{
#ifdef EXACT
    return memcmp(&a, &b, sizeof a) == 0;
#else
    const R off = a > b ? a - b : b - a, size = a > 1 ? a : a < -1 ? -a : 1;
    return off <= (sizeof(R) == 4 ? (R)1e-5 : (R)1e-13) * size;
#endif
}

/* Compares numbers of a single call and of arrays. Where arrays are searched side by side both keep the promise, which
 * test_from and test_from_patches judge, but differ within it. */
static int is_equal(R a, R b)
{
#ifdef SIDE_BY_SIDE
    const R off = (R)0.01 * (a < 0 ? -a : a);
    return a - b <= off && b - a <= off;
#else
    return is_same(a, b);
#endif
}

/* Returns the status of NAME, or 98 if NAME_checked_n has another status or answer, for this pair or for the good
 * pairs. */
static int as_arrays(arrays *checked_n, const R (*x)[3], int status, const R loc[2], R gap)
{
    R good[VECTORS][3], column[3 * VECTORS][3], xi[3], eta[3], g[3];
    const R *at[3 * VECTORS];
    int found[3] = {77, 77, 77}, i, k;
    take_places(good);
    for (i = 0; i < 3 * VECTORS; i++) {
        at[i] = column[i];
        for (k = 0; k < 3; k++)
            column[i][k] = k == 1 ? x[i / 3][i % 3] : good[i / 3][i % 3];
    }
    checked_n(3, at, xi, eta, g, found);
    if (found[1] != status || !is_good(found[0]) || !is_good(found[2]))
        return 98;
    return status < 0 || (is_equal(xi[1], loc[0]) && is_equal(eta[1], loc[1]) && is_equal(g[1], gap)) ? status : 98;
}

#ifdef OVER
/* Returns the status of NAME, or 97 if NAME_over_n, with the same slave node three times, has another status or
 * answer. */
static int as_over(over *over_n, const R (*x)[3], int status, const R loc[2], R gap)
{
    R column[3][3], xi[3], eta[3], g[3];
    const R *nodes[VECTORS - 1], *at[3];
    int found[3] = {77, 77, 77}, i, k;
    for (i = 0; i < VECTORS - 1; i++)
        nodes[i] = x[i];
    for (i = 0; i < 3; i++) {
        at[i] = column[i];
        for (k = 0; k < 3; k++)
            column[i][k] = x[VECTORS - 1][i];
    }
    over_n(nodes, 3, at, xi, eta, g, found);
    for (i = 0; i < 3; i++)
        if (found[i] != status ||
            (status >= 0 && !(is_equal(xi[i], loc[0]) && is_equal(eta[i], loc[1]) && is_equal(g[i], gap))))
            return 97;
    return status;
}
#endif

/* Multiplies nodes by 2^power; normals keep their length. */
static void resize(R x[VECTORS][3], int power)
{
    int i, j;
    for (i = 0; i < VECTORS; i++)
        for (j = 0; j < 3 && (i < NODES || i == VECTORS - 1); j++)
            x[i][j] = (R)ldexp((double)x[i][j], power);
}

static void expect(int f, const R (*x)[3], int expected, const char *what, int a, int b)
{
    R loc[2] = {7, 7}, gap = 7;
    const int status = function[f].call(x, loc, &gap);
#if defined __FAST_MATH__ && defined PATCH /* nor is the lack of an area */
    if (status == FOOTPOINT_UNPROVED && expected == FOOTPOINT_ERR_DEGENERATE)
        return;
#endif
    if (status != expected ||
        (status != FOOTPOINT_OK && memcmp(&loc[0], &loc[1], sizeof gap) | memcmp(&loc[0], &gap, sizeof gap)) ||
        (status == FOOTPOINT_OK && gap == 7))
        complain(f, what, a, b, status);
}

/* Tests NaN of either sign and both infinities, made of their bits. */
static void test_not_finite(int f)
{
    static const unsigned char high[4][2] = {{0x7f, 0xf8}, {0xff, 0xf8}, {0x7f, 0xf0}, {0xff, 0xf0}};
    int i, j, b;
    for (i = 0; i < VECTORS; i++)
        for (j = 0; j < 3; j++)
            for (b = 0; b < 4; b++) {
                R x[VECTORS][3];
                unsigned char bytes[sizeof(R)] = {0};
                take_places(x);
                bytes[sizeof(R) - 1] = high[b][0];
                bytes[sizeof(R) - 2] = (unsigned char)(sizeof(R) == 4 && b > 1 ? 0x80 : high[b][1]);
                memcpy(&x[i][j], bytes, sizeof bytes);
                expect(f, x, FOOTPOINT_ERR_NOT_FINITE, "not finite", i, j);
            }
}

/* Tests nodes in one point, on a line, and corners that coincide crosswise, so that they enclose no area. */
static void test_no_area(int f)
{
    static const double along[11] = {0, 1, 3, 2, 0.5, 2, 2.5, 1, 1.5, 1, 2.25};
    int power, i, j;
    for (power = -EXTREME; power <= EXTREME; power += EXTREME / 4) {
        R x[VECTORS][3];
        take_places(x);
        for (i = 0; i < NODES; i++)
            for (j = 0; j < 3; j++)
                x[i][j] = 1;
        resize(x, power);
        expect(f, x, FOOTPOINT_ERR_DEGENERATE, "a point", power, 0);
        take_places(x);
        for (i = 0; i < NODES; i++)
            for (j = 0; j < 3; j++)
                x[i][j] = (R)(along[order[i]] * (j + 1));
        resize(x, power);
        expect(f, x, FOOTPOINT_ERR_DEGENERATE, "a line", power, 0);
    }
}

/* Statuses are the same in every unit of length. */
static void test_sizes(int f)
{
    R x[VECTORS][3], loc[2], gap;
    int power;
    take_places(x);
    if (!is_good(function[f].call(x, loc, &gap))) {
        complain(f, "ordinary", 0, 0, 0);
        return;
    }
    for (power = -EXTREME; power <= EXTREME; power++) {
        R l[2], g;
        int status;
        take_places(x);
        resize(x, power);
        status = function[f].call(x, l, &g);
        g = (R)ldexp((double)g, -power);
        if (!is_good(status) || !is_same(l[0], loc[0]) || !is_same(l[1], loc[1]) || !is_same(g, gap))
            complain(f, "size", power, 0, status);
    }
}

/* For needles and slave nodes far away, of any size, answers with FOOTPOINT_OK equal the expression without overflow
 * and underflow. */
static void test_shapes(int f)
{
    enum { STEPS = 24 };
    int thin, far, size, i, j;
    for (thin = 0; thin <= EXTREME; thin += EXTREME / STEPS)
        for (far = 0; far <= EXTREME; far += EXTREME / STEPS) {
            R x[VECTORS][3];
            __float128 y[VECTORS][3], w[2];
            take_places(x);
            for (i = 0; i < VECTORS; i++)
                for (j = 0; j < 3; j++) {
                    if (j > 0 && (i < NODES || i == VECTORS - 1))
                        x[i][j] = (R)ldexp((double)x[i][j], -thin);
                    if (i == VECTORS - 1)
                        x[i][j] = (R)ldexp((double)x[i][j], far);
                    y[i][j] = x[i][j];
                }
            function[f].wide(y, w);
            for (size = -EXTREME; size <= EXTREME; size += EXTREME / 4) {
                R z[VECTORS][3], loc[2], gap;
                memcpy(z, x, sizeof z);
                resize(z, size);
                if (function[f].call(z, loc, &gap) != FOOTPOINT_OK)
                    continue;
                for (i = 0; i < 2; i++) {
                    const __float128 off = w[i] - loc[i], unit = 1 + (w[i] < 0 ? -w[i] : w[i]);
                    if (!(off < 1e-12 * unit && -off < 1e-12 * unit)) {
                        printf("%g instead of %g\n", (double)loc[i], (double)w[i]);
                        complain(f, "shape", thin, far, size);
                        break;
                    }
                }
            }
        }
}

int main(void)
{
    int f;
    for (f = 0; f < FUNCTION_COUNT; f++) {
        test_not_finite(f);
        test_no_area(f);
        test_sizes(f);
#if defined EXACT && defined WIDE
        if (function[f].wide)
            test_shapes(f);
#endif
    }
    if (failures)
        printf("%d failures\n", failures);
    return failures != 0;
}
