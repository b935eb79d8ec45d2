// Counts the operations of every rival by running it with a scalar that counts, and prints them as rows of a C table:
//     {"name", mul, div, add, sqrt},
// newton_first and newton_step are the converged iteration's set-up with its first step, and each later step.
// Comparisons and changes of sign are free.
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
#include "rivals.h"

// A warped segment and a slave node off it; no iteration converges at once.
static const Real xA[3] = {0.0, 0.0, 0.0}, xB[3] = {1.0, 0.1, 0.0}, xC[3] = {1.2, 0.9, 0.2}, xD[3] = {-0.1, 1.0, 0.0};
static const Real xS[3] = {0.3, 0.6, 0.4};

static void print(const char *name, const Counts &c)
{
    std::printf("{\"%s\", %ld, %ld, %ld, %ld},\n", name, c.mul, c.div, c.add, c.sqrt);
}

template <typename Search> static void count(const char *name, Search search)
{
    Real xi, eta;
    counts = Counts();
    search(xA, xB, xC, xD, xS, &xi, &eta);
    print(name, counts);
}

static Counts newton_steps(int most)
{
    Real xi, eta;
    counts = Counts();
    rival_newton(xA, xB, xC, xD, xS, most, 0.0, &xi, &eta);
    return counts;
}

int main()
{
#define COUNT_ITERATION(name, start, gauss_newton, newton, clamped) count(#name, rival_##name);
#define COUNT_CLOSED_FORM(name) count(#name, rival_##name);
    RIVAL_ITERATIONS(COUNT_ITERATION)
    RIVAL_CLOSED_FORMS(COUNT_CLOSED_FORM)
    COUNT_CLOSED_FORM(pinball)
    const Counts one = newton_steps(1), two = newton_steps(2);
    print("newton_first", one);
    print("newton_step", {two.mul - one.mul, two.div - one.div, two.add - one.add, two.sqrt - one.sqrt});
    return 0;
}
