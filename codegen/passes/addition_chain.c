/* The search of addition_chain.h. Values start as differences of two points and continue as sums of two values, one of
 * which may be doubled. All sets of values are tried, small sets first, until the wanted vectors follow from them one
 * by one, with any coefficients. */
#include "addition_chain.h"

#include <flint/ulong_extras.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_POINTS = 6, MOST_VECTORS = 5, MOST_VALUES = 16 }; /* more would have too many sets */
enum { MOST_COEFFICIENT = 1000, MOST_CHOICES = 600, MOST_SETS = 200000 };

struct plan {
    struct additions so_far;
    bool made[MOST_VECTORS];
    int missing;
};

struct chain_search {
    const struct vector *wanted;
    int n;
    struct additions *best; /* without values at first */
    long sets;
};

bool vector_reduce(struct vector *v, long *divisor)
{
    long common = 0, first = 0;
    bool small = true;
    for (int i = 0; i < ADDITIONS_POINTS; i++) {
        common = (long)n_gcd((ulong)common, (ulong)labs(v->of[i]));
        first = first == 0 ? v->of[i] : first;
    }
    *divisor = first < 0 ? -common : common;
    for (int i = 0; i < ADDITIONS_POINTS && first != 0; i++) {
        v->of[i] /= *divisor;
        small = small && labs(v->of[i]) <= MOST_COEFFICIENT;
    }
    return first != 0 && small;
}

bool vector_equal(const struct vector *a, const struct vector *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

static bool has(const struct additions *x, const struct vector *v)
{
    for (int i = 0; i < x->values; i++)
        if (vector_equal(&x->value[i], v))
            return true;
    return false;
}

bool addition_value(const struct additions *x, struct addition *s, struct vector *v)
{
    for (int i = 0; i < ADDITIONS_POINTS; i++)
        v->of[i] = s->p * x->value[s->a].of[i] + s->q * x->value[s->b].of[i];
    return vector_reduce(v, &s->d);
}

static void append(const struct chain_search *s, struct plan *p, struct addition a, const struct vector *v)
{
    struct additions *x = &p->so_far;
    x->value[x->values] = *v;
    x->addition[x->values++] = a;
    x->multiplications += labs(a.p) != labs(a.q);
    for (int i = 0; i < s->n; i++)
        if (!p->made[i] && vector_equal(v, &s->wanted[i])) {
            p->made[i] = true;
            p->missing--;
        }
}

/* Solves v = (p a + q b) / d with p and q not 0. */
static bool solve(const struct vector *a, const struct vector *b, const struct vector *v, struct addition *s)
{
    for (int i = 0; i < ADDITIONS_POINTS; i++)
        for (int k = i + 1; k < ADDITIONS_POINTS; k++) {
            const long d = a->of[i] * b->of[k] - a->of[k] * b->of[i];
            if (d == 0)
                continue;
            const long p = v->of[i] * b->of[k] - v->of[k] * b->of[i], q = a->of[i] * v->of[k] - a->of[k] * v->of[i];
            for (int n = 0; n < ADDITIONS_POINTS; n++)
                if (p * a->of[n] + q * b->of[n] != d * v->of[n])
                    return false;
            const long divisor = (long)n_gcd(n_gcd((ulong)labs(p), (ulong)labs(q)), (ulong)labs(d));
            s->p = p / divisor;
            s->q = q / divisor;
            s->d = d / divisor;
            return p != 0 && q != 0;
        }
    return false;
}

/* Returns the cheapest addition that makes a missing vector, or -1. */
static int find_last(const struct chain_search *s, const struct plan *p, struct addition *found)
{
    const struct additions *x = &p->so_far;
    int least = 2, which = -1;
    for (int i = 0; i < s->n && least > 0; i++)
        for (int a = 0; !p->made[i] && a < x->values; a++)
            for (int b = a + 1; b < x->values; b++) {
                struct addition last = {.a = a, .b = b};
                if ((a < x->points) != (b < x->points) || !solve(&x->value[a], &x->value[b], &s->wanted[i], &last))
                    continue;
                const int cost = labs(last.p) != labs(last.q);
                if (cost < least) {
                    least = cost;
                    which = i;
                    *found = last;
                }
            }
    return which;
}

static bool is_better(const struct chain_search *s, const struct plan *p)
{
    return s->best->values == 0 || p->so_far.multiplications < s->best->multiplications;
}

/* Makes all missing vectors. */
static void finish(struct chain_search *s, struct plan p)
{
    s->sets++;
    while (p.missing > 0) {
        struct addition last;
        const int which = find_last(s, &p, &last);
        if (which < 0)
            return;
        append(s, &p, last, &s->wanted[which]);
    }
    if (is_better(s, &p))
        *s->best = p.so_far;
}

/* Adds the choices that the newest value offers with each earlier value. */
static size_t add_choices(const struct additions *x, struct addition *choice, size_t n)
{
    static const long factor[][2] = {{1, 1}, {1, -1}, {1, 2}, {1, -2}, {2, 1}, {2, -1}};
    const int last = x->values - 1;
    for (int i = x->points; i < last; i++)
        for (size_t k = 0; k < sizeof factor / sizeof *factor && n < MOST_CHOICES; k++)
            choice[n++] = (struct addition){i, last, factor[k][0], factor[k][1], 1};
    return n;
}

/* Tries plans with `left` more values. A choice that was skipped is not tried again. */
static void try_plans(struct chain_search *s, const struct plan *p, const struct addition *choice, size_t choices,
                      int left)
{
    struct addition next[MOST_CHOICES];
    if (left == p->missing) {
        finish(s, *p);
        return;
    }
    for (size_t i = 0; i < choices && s->sets < MOST_SETS && is_better(s, p); i++) {
        struct addition taken = choice[i];
        struct vector v;
        if (!addition_value(&p->so_far, &taken, &v) || has(&p->so_far, &v))
            continue;
        struct plan more = *p;
        append(s, &more, taken, &v);
        memcpy(next, choice + i + 1, (choices - i - 1) * sizeof *next);
        try_plans(s, &more, next, add_choices(&more.so_far, next, choices - i - 1), left - 1);
    }
}

bool additions_few(int points, int vectors)
{
    return points <= MOST_POINTS && vectors <= MOST_VECTORS;
}

bool additions_find(int points, const struct vector *wanted, int n, int most, struct additions *found)
{
    struct chain_search s = {.wanted = wanted, .n = n, .best = found};
    struct plan start = {.so_far = {.points = points, .values = points}, .missing = n};
    struct addition choice[MOST_CHOICES];
    size_t choices = 0;
    for (int a = 0; a < points; a++) {
        start.so_far.value[a].of[a] = 1;
        for (int b = a + 1; b < points; b++)
            choice[choices++] = (struct addition){a, b, 1, -1, 1};
    }
    found->values = 0;
    for (int k = n; k <= most && points + k <= MOST_VALUES && found->values == 0; k++)
        try_plans(&s, &start, choice, choices, k);
    return found->values > 0;
}
