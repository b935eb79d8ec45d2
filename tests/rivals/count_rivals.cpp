// Counts the operations of every rival by running it with a counting scalar, and prints them for C:
//     #define OPS_name {mul, div, add, sqrt}
// For an iteration that converges, OPS is its set-up with the first step, and STEP_name each later step. Comparisons
// and changes of sign are free.
#include <cmath>
#include <cstdio>

struct Counts {
    long mul = 0, div = 0, add = 0, sqrt = 0;
};
static Counts counts;

struct Real {
    double value = 0;
    Real() = default;
    Real(double v) : value(v)
    {
    }
};

static Real operator+(Real a, Real b)
{
    counts.add++;
    return a.value + b.value;
}
static Real operator-(Real a, Real b)
{
    counts.add++;
    return a.value - b.value;
}
static Real operator*(Real a, Real b)
{
    counts.mul++;
    return a.value * b.value;
}
static Real operator/(Real a, Real b)
{
    counts.div++;
    return a.value / b.value;
}
static Real sqrt(Real a)
{
    counts.sqrt++;
    return std::sqrt(a.value);
}
static Real operator-(Real a)
{
    return -a.value;
}
static Real fabs(Real a)
{
    return std::fabs(a.value);
}
static bool operator<(Real a, Real b)
{
    return a.value < b.value;
}
static bool operator<=(Real a, Real b)
{
    return a.value <= b.value;
}

#define FOOTPOINT_REAL Real
#include "pinball.h"
#include "rivals_closed.h"
#include "rivals_converged.h"
#include "rivals_faces.h"
#include "rivals_kept.h"
#include "trust_region.h"

// A warped segment and a slave node off it; no iteration converges at once.
static const Real xA[3] = {0.0, 0.0, 0.0}, xB[3] = {1.0, 0.1, 0.0}, xC[3] = {1.2, 0.9, 0.2}, xD[3] = {-0.1, 1.0, 0.0};
static const Real xS[3] = {0.3, 0.6, 0.4};

// A face of any kind; counting does not depend on its nodes.
static const Real face[10][3] = {{0.0, 0.0, 0.0}, {1.0, 0.1, 0.0}, {1.2, 0.9, 0.2}, {-0.1, 1.0, 0.0}, {0.6, 0.0, 0.1},
                                 {1.1, 0.4, 0.2}, {0.5, 1.0, 0.0}, {0.0, 0.6, 0.1}, {0.5, 0.5, 0.1},  {0.3, 0.6, 0.4}};

static void print(const char *kind, const char *name, const Counts &c)
{
    std::printf("#define %s_%s {%ld, %ld, %ld, %ld}\n", kind, name, c.mul, c.div, c.add, c.sqrt);
}

template <typename Search> static Counts count(Search search)
{
    Real xi, eta;
    counts = Counts();
    search(&xi, &eta);
    return counts;
}

// An iteration that never converges: search(steps, &xi, &eta).
template <typename Search> static void count_steps(const char *name, Search search)
{
    const Counts one = count([&](Real *xi, Real *eta) { search(1, xi, eta); });
    const Counts two = count([&](Real *xi, Real *eta) { search(2, xi, eta); });
    print("OPS", name, one);
    print("STEP", name, {two.mul - one.mul, two.div - one.div, two.add - one.add, two.sqrt - one.sqrt});
}

int main()
{
    static rival_tuning t;
    t.box = {{-1.0, -1.0}, {1.0, 1.0}};
#define COUNT(name, ...)                                                                                               \
    print("OPS", #name, count([](Real *xi, Real *eta) { rival_##name(xA, xB, xC, xD, xS, xi, eta); }));
#define COUNT_TUNED(name, ...)                                                                                         \
    print("OPS", #name, count([](Real *xi, Real *eta) { rival_##name(xA, xB, xC, xD, xS, &t, xi, eta); }));
    RIVAL_ITERATIONS(COUNT)
    RIVAL_CLOSED_FORMS(COUNT)
    COUNT(pinball)
    RIVAL_TUNED_ITERATIONS(COUNT_TUNED)
    RIVAL_KEPT(COUNT_TUNED)
    RIVAL_POLYNOMIALS(COUNT_TUNED)
    const auto newton = [](int most, Real *xi, Real *eta) { rival_newton(xA, xB, xC, xD, xS, most, 0.0, xi, eta); };
    count_steps("newton", newton);
    count_steps("newton_loose", newton);
    count_steps("newton_fair",
                [](int most, Real *xi, Real *eta) { rival_newton_fair(xA, xB, xC, xD, xS, most, 0.0, xi, eta); });
    count_steps("newton_previous",
                [](int most, Real *xi, Real *eta) { rival_newton_from(xA, xB, xC, xD, xS, most, 0.0, xi, eta); });
    count_steps("trust_region", [](int most, Real *xi, Real *eta) {
        rival_trust_region(xA, xB, xC, xD, xS, &t.box, most, 0.0, xi, eta);
    });
#define COUNT_FACE(name, ...) print("OPS", #name, count([](Real *xi, Real *eta) { rival_##name(face, xi, eta); }));
#define COUNT_CONVERGED(kind, vectors)                                                                                 \
    count_steps(#kind "_newton",                                                                                       \
                [](int most, Real *xi, Real *eta) { rival_##kind##_newton(face, most, 0.0, xi, eta); });
    COUNT_FACE(tri3_areas)
    RIVAL_FACE_ITERATIONS(COUNT_FACE)
    RIVAL_FACES(COUNT_CONVERGED)
    return 0;
}
