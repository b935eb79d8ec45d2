/* Additions for many points, for which addition_chain.c has too many sets of values to try. Differences of points along
 * the edges of a tree make every vector in exactly one way. The pair of terms that most of these sums share, up to a
 * factor, is added first, and so on. The tree is changed edge by edge, keeping changes that cost no more. */
#include "addition_chain.h"
#include "choices.h"

#include <flint/ulong_extras.h>
#include <stdlib.h>
#include <string.h>

enum { CHANGES = 700, PAIRS = 1024 /* a power of 2 */, MANY = 100 };

struct tree {
    int from[ADDITIONS_POINTS], to[ADDITIONS_POINTS]; /* by edge: its vector points from `to` to `from` */
};

/* A partial vector: the sum of of[i] times value i. */
struct row {
    long of[ADDITIONS_VALUES];
};

struct sums {
    struct additions *made;
    struct row row[ADDITIONS_VECTORS];
    int rows;
    uint64_t *random;
};

/* p a + q b with p > 0 and without common divisor, and the number of rows that contain a multiple of it. */
struct pair {
    int a, b, count;
    long p, q;
};

static uint64_t draw(uint64_t *random, int below)
{
    return random_of(++*random) % (uint64_t)below;
}

/* Returns the value (p a + q b) / d, new or existing, or -1 if there is no room. */
static int value_of(struct additions *x, struct addition s)
{
    struct vector v;
    if (!addition_value(x, &s, &v))
        return -1;
    for (int i = x->points; i < x->values; i++)
        if (vector_equal(&x->value[i], &v))
            return i;
    if (x->values == ADDITIONS_VALUES)
        return -1;
    x->value[x->values] = v;
    x->addition[x->values] = s;
    x->multiplications += labs(s.p) != labs(s.q);
    return x->values++;
}

/* Returns the part of v on the side of the edge's `from`, once the edge is cut. */
static long side(const struct tree *t, int points, int edge, const struct vector *v)
{
    bool reached[ADDITIONS_POINTS] = {false};
    bool more = true;
    long sum = 0;
    reached[t->from[edge]] = true;
    while (more) {
        more = false;
        for (int e = 0; e < points - 1; e++)
            if (e != edge && reached[t->from[e]] != reached[t->to[e]])
                reached[t->from[e]] = reached[t->to[e]] = more = true;
    }
    for (int i = 0; i < points; i++)
        sum += reached[i] ? v->of[i] : 0;
    return sum;
}

/* If v is the difference of two points, returns the first and sets *other to the second; otherwise returns -1. */
static int difference(const struct vector *v, int *other)
{
    int first = -1;
    *other = -1;
    for (int i = 0; i < ADDITIONS_POINTS; i++) {
        if (v->of[i] == 0)
            continue;
        if (labs(v->of[i]) != 1 || *other >= 0)
            return -1;
        if (first < 0)
            first = i;
        else
            *other = i;
    }
    return first;
}

/* Adds c (p - q) to a row. */
static void add_difference(struct sums *s, struct row *r, int p, int q, long c)
{
    const int a = p < q ? p : q, b = p + q - a;
    r->of[value_of(s->made, (struct addition){a, b, 1, -1, 1})] += a == p ? c : -c;
}

/* Writes the wanted vectors as sums over the edges; differences of two points are made at once. */
static void write_rows(struct sums *s, const struct tree *t, const struct vector *wanted, int n)
{
    s->rows = n;
    for (int i = 0; i < n; i++) {
        int second;
        const int first = difference(&wanted[i], &second);
        s->row[i] = (struct row){{0}};
        if (first >= 0)
            add_difference(s, &s->row[i], first, second, 1);
        for (int e = 0; e < s->made->points - 1 && first < 0; e++) {
            const long c = side(t, s->made->points, e, &wanted[i]);
            if (c != 0)
                add_difference(s, &s->row[i], t->from[e], t->to[e], c);
        }
    }
}

static struct pair pair_of(const struct row *r, int a, int b)
{
    const long size = labs(r->of[a]), other = labs(r->of[b]);
    const long common = size == 1 || size == other ? size : (long)n_gcd((ulong)size, (ulong)other);
    const long d = r->of[a] < 0 ? -common : common;
    return (struct pair){a, b, 0, r->of[a] / d, r->of[b] / d};
}

static bool same(const struct pair *x, const struct pair *y)
{
    return x->a == y->a && x->b == y->b && x->p == y->p && x->q == y->q;
}

static bool plain(const struct pair *x)
{
    return x->p == labs(x->q);
}

/* A hash table of pairs; `taken` has a bit for each place. */
struct pairs {
    struct pair pair[PAIRS];
    uint64_t taken[PAIRS / 64];
};

static bool is_taken(const struct pairs *t, size_t k)
{
    return t->taken[k / 64] >> k % 64 & 1;
}

static void count_pair(struct pairs *t, const struct pair *x)
{
    size_t k = random_of((uint64_t)(x->a * 64 + x->b) << 32 ^ (uint64_t)(x->p * 4096 + x->q)) & (PAIRS - 1);
    while (is_taken(t, k) && !same(&t->pair[k], x))
        k = (k + 1) & (PAIRS - 1);
    if (!is_taken(t, k))
        t->pair[k] = *x;
    t->pair[k].count++;
    t->taken[k / 64] |= (uint64_t)1 << k % 64;
}

static void count_pairs(const struct sums *s, struct pairs *t)
{
    for (int i = 0; i < s->rows; i++) {
        int value[ADDITIONS_VALUES], n = 0; /* values of the row */
        for (int a = 0; a < s->made->values; a++)
            if (s->row[i].of[a] != 0)
                value[n++] = a;
        for (int a = 0; a < n; a++)
            for (int b = a + 1; b < n; b++) {
                const struct pair x = pair_of(&s->row[i], value[a], value[b]);
                count_pair(t, &x);
            }
    }
}

/* Chooses the pair that saves most, then a pair without a multiplication, then any. Returns false if every row has one
 * term. */
static bool choose(struct sums *s, struct pair *best)
{
    struct pairs t;
    int equal = 0;
    memset(t.taken, 0, sizeof t.taken);
    count_pairs(s, &t);
    *best = (struct pair){.count = 0};
    for (size_t k = 0; k < PAIRS; k++) {
        const struct pair *x = &t.pair[k];
        if (t.taken[k / 64] >> k % 64 == 0)
            k |= 63;
        if (!is_taken(&t, k))
            continue;
        const int gain = 2 * (x->count - best->count) + plain(x) - (best->count > 0 && plain(best));
        equal = gain > 0 ? 1 : equal + (gain == 0);
        if (gain > 0 || (gain == 0 && draw(s->random, equal) == 0))
            *best = *x;
    }
    return best->count > 0;
}

/* Replaces the pair by a value everywhere. Returns false if there is no room. */
static bool replace(struct sums *s, const struct pair *x)
{
    const int k = value_of(s->made, (struct addition){x->a, x->b, x->p, x->q, 1});
    if (k < 0)
        return false;
    long size = 0; /* (p a + q b) / value */
    for (int i = 0; i < ADDITIONS_POINTS && size == 0; i++)
        if (s->made->value[k].of[i] != 0)
            size = (x->p * s->made->value[x->a].of[i] + x->q * s->made->value[x->b].of[i]) / s->made->value[k].of[i];
    for (int i = 0; i < s->rows; i++) {
        struct row *r = &s->row[i];
        if (r->of[x->a] == 0 || r->of[x->b] == 0)
            continue;
        const struct pair own = pair_of(r, x->a, x->b);
        if (!same(&own, x))
            continue;
        const long times = r->of[x->a] / x->p;
        r->of[x->a] = r->of[x->b] = 0;
        r->of[k] += times * size;
    }
    return true;
}

static bool make(const struct tree *t, int points, const struct vector *wanted, int n, uint64_t *random,
                 struct additions *made)
{
    struct sums s = {.made = made, .random = random};
    struct pair best = {.count = 0};
    *made = (struct additions){.points = points, .values = points};
    for (int i = 0; i < points; i++)
        made->value[i].of[i] = 1;
    write_rows(&s, t, wanted, n);
    while (choose(&s, &best))
        if (!replace(&s, &best))
            return false;
    return true;
}

/* Returns the number of operations, with multiplications to break ties. */
static int cost_of(const struct additions *x)
{
    return MANY * (x->values + x->multiplications) + x->multiplications;
}

/* Cuts an edge and joins the two parts by another edge. */
static void change(struct tree *t, int points, uint64_t *random)
{
    const int edge = (int)draw(random, points - 1);
    struct vector one = {{0}};
    int from, to;
    do {
        from = (int)draw(random, points);
        to = (int)draw(random, points);
        memset(&one, 0, sizeof one);
        one.of[from]++;
        one.of[to]--;
    } while (side(t, points, edge, &one) == 0);
    t->from[edge] = from;
    t->to[edge] = to;
}

static bool find_additions(int points, const struct vector *wanted, int n, uint64_t seed, struct additions *found)
{
    uint64_t random = random_of(seed);
    struct tree best = {.from = {0}};
    found->values = 0;
    for (int e = 0; e < points - 1; e++) {
        best.from[e] = e + 1;
        best.to[e] = (int)draw(&random, e + 1);
    }
    for (int i = 0; i < CHANGES; i++) {
        struct tree t = best;
        struct additions made;
        if (i > 0)
            change(&t, points, &random);
        if (!make(&t, points, wanted, n, &random, &made) || (found->values > 0 && cost_of(&made) > cost_of(found)))
            continue;
        best = t;
        *found = made;
    }
    return found->values > 0;
}

/* Remembers the last call, because the functions of a file want the same vectors. */
bool additions_along_tree(int points, const struct vector *wanted, int n, uint64_t seed, struct additions *found)
{
    enum { REMEMBERED = 64 };
    static struct {
        int points, n;
        uint64_t seed;
        struct vector wanted[ADDITIONS_VECTORS];
        struct additions found;
    } memo[REMEMBERED], *m;
    m = &memo[seed % REMEMBERED];
    if (m->points != points || m->n != n || m->seed != seed ||
        memcmp(m->wanted, wanted, (size_t)n * sizeof *wanted) != 0) {
        m->points = points;
        m->n = n;
        m->seed = seed;
        memcpy(m->wanted, wanted, (size_t)n * sizeof *wanted);
        find_additions(points, wanted, n, seed, &m->found);
    }
    *found = m->found;
    return found->values > 0;
}
