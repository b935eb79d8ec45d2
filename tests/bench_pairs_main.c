/* Batches of pairs out of a mesh's arrays beside a loop that only gathers the same coordinates and stores two doubles,
 * interleaved in one run: arrays far larger than any cache, pairs in the order of the mesh and in random order.
 *     bench_pairs [EDGE [ROUNDS]]     EDGE x EDGE segments, one slave node over each
 * prints lines  order,layout,index,what,ns,ratio  with the least ns per pair and its ratio to the loop's. */
#include "../runtime/footpoint_batch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

struct mesh {
    size_t n, nodes;
    double *xyz, *column[3];
    int32_t *seg, *slave;
    int64_t *seg64, *slave64;
    double *loc, *gap;
    int *status;
    size_t failed;
};

static void *array(size_t n, size_t size)
{
    void *const p = malloc(n * size);
    if (!p) {
        fprintf(stderr, "bench_pairs: out of memory\n");
        exit(3);
    }
    return p;
}

static uint64_t draw(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005U + 1442695040888963407U;
    return *seed >> 33;
}

static double uniform(uint64_t *seed)
{
    return (double)draw(seed) / 2147483648.0 - 0.5;
}

/* Corners and slave nodes of a wavy square, moved at random by up to a tenth of an edge. */
static struct mesh mesh_new(size_t edge)
{
    struct mesh m = {.n = edge * edge, .nodes = (edge + 1) * (edge + 1) + edge * edge};
    const size_t corners = (edge + 1) * (edge + 1);
    uint64_t seed = 1;
    m.xyz = array(3 * m.nodes, sizeof *m.xyz);
    for (size_t i = 0; i < m.nodes; i++) {
        const size_t row = i < corners ? i / (edge + 1) : (i - corners) / edge;
        const size_t column = i < corners ? i % (edge + 1) : (i - corners) % edge;
        const double x = (double)column + (i < corners ? 0.0 : 0.5), y = (double)row + (i < corners ? 0.0 : 0.5);
        m.xyz[3 * i] = x + 0.2 * uniform(&seed);
        m.xyz[3 * i + 1] = y + 0.2 * uniform(&seed);
        m.xyz[3 * i + 2] = 0.05 * sin(x) * cos(y) + 0.05 * uniform(&seed);
    }
    for (int k = 0; k < 3; k++) {
        m.column[k] = array(m.nodes, sizeof *m.column[k]);
        for (size_t i = 0; i < m.nodes; i++)
            m.column[k][i] = m.xyz[3 * i + (size_t)k];
    }
    m.seg = array(4 * m.n, sizeof *m.seg);
    m.seg64 = array(4 * m.n, sizeof *m.seg64);
    m.slave = array(m.n, sizeof *m.slave);
    m.slave64 = array(m.n, sizeof *m.slave64);
    m.loc = array(2 * m.n, sizeof *m.loc);
    m.gap = array(m.n, sizeof *m.gap);
    m.status = array(m.n, sizeof *m.status);
    return m;
}

/* Pairs in the order of the segments, or in random order. */
static void mesh_pairs(struct mesh *m, size_t edge, int shuffled)
{
    uint64_t seed = 2;
    size_t *const order = array(m->n, sizeof *order);
    for (size_t i = 0; i < m->n; i++)
        order[i] = i;
    for (size_t i = m->n - 1; shuffled && i > 0; i--) {
        const size_t j = (size_t)(draw(&seed) * (i + 1) >> 31), other = order[j];
        order[j] = order[i];
        order[i] = other;
    }
    for (size_t i = 0; i < m->n; i++) {
        const size_t a = order[i] / edge * (edge + 1) + order[i] % edge;
        const size_t node[4] = {a, a + 1, a + edge + 2, a + edge + 1};
        for (size_t k = 0; k < 4; k++)
            m->seg64[4 * i + k] = m->seg[4 * i + k] = (int32_t)node[k];
        m->slave64[i] = m->slave[i] = (int32_t)((edge + 1) * (edge + 1) + order[i]);
    }
    free(order);
}

/* ---- what is compared ---- */

/* The loop: five nodes, fifteen coordinates, two doubles. */
static void only_gather(struct mesh *m)
{
    const double *const xyz = m->xyz;
    const int32_t *const seg = m->seg, *const slave = m->slave;
    double *const loc = m->loc;
    for (size_t i = 0; i < m->n; i++) {
        const double *const a = xyz + 3 * seg[4 * i], *const b = xyz + 3 * seg[4 * i + 1];
        const double *const c = xyz + 3 * seg[4 * i + 2], *const d = xyz + 3 * seg[4 * i + 3];
        const double *const s = xyz + 3 * slave[i];
        loc[2 * i] = (a[0] + a[1]) + (a[2] + b[0]) + (b[1] + b[2]) + (s[0] + s[1]);
        loc[2 * i + 1] = (c[0] + c[1]) + (c[2] + d[0]) + (d[1] + d[2]) + s[2];
    }
}

static void only_gather_columns64(struct mesh *m)
{
    const double *const x = m->column[0], *const y = m->column[1], *const z = m->column[2];
    const int64_t *const seg = m->seg64, *const slave = m->slave64;
    double *const loc = m->loc;
    for (size_t i = 0; i < m->n; i++) {
        const int64_t a = seg[4 * i], b = seg[4 * i + 1], c = seg[4 * i + 2], d = seg[4 * i + 3], s = slave[i];
        loc[2 * i] = (x[a] + y[a]) + (z[a] + x[b]) + (y[b] + z[b]) + (x[s] + y[s]);
        loc[2 * i + 1] = (x[c] + y[c]) + (z[c] + x[d]) + (y[d] + z[d]) + z[s];
    }
}

static void batch(struct mesh *m, enum footpoint_tier tier, int columns, int everything)
{
    struct footpoint_pairs p = {
        .n = m->n, .nodes = m->nodes, .x = m->xyz, .y = m->xyz + 1, .z = m->xyz + 2, .stride = 3};
    if (columns) {
        p.x = m->column[0], p.y = m->column[1], p.z = m->column[2], p.stride = 1;
        p.seg64 = m->seg64, p.slave64 = m->slave64;
    } else {
        p.seg = m->seg, p.slave = m->slave;
    }
    m->failed += footpoint_locate_batch(&p, tier, m->loc, everything ? m->gap : NULL, everything ? m->status : NULL);
}

static void fast(struct mesh *m)
{
    batch(m, FOOTPOINT_FAST, 0, 0);
}
static void fast_gap(struct mesh *m)
{
    batch(m, FOOTPOINT_FAST, 0, 1);
}
static void balanced(struct mesh *m)
{
    batch(m, FOOTPOINT_BALANCED, 0, 0);
}
static void accurate(struct mesh *m)
{
    batch(m, FOOTPOINT_ACCURATE, 0, 0);
}
static void accurate_gap(struct mesh *m)
{
    batch(m, FOOTPOINT_ACCURATE, 0, 1);
}
static void fast_columns64(struct mesh *m)
{
    batch(m, FOOTPOINT_FAST, 1, 0);
}

static const struct contender {
    const char *layout, *index, *what;
    int baseline; /* which contender it is measured against */
    void (*run)(struct mesh *m);
} contenders[] = {{"nodes x 3", "32", "gather and store", 0, only_gather},
                  {"nodes x 3", "32", "fast", 0, fast},
                  {"nodes x 3", "32", "fast with gap and status", 0, fast_gap},
                  {"nodes x 3", "32", "balanced", 0, balanced},
                  {"nodes x 3", "32", "accurate", 0, accurate},
                  {"nodes x 3", "32", "accurate with gap and status", 0, accurate_gap},
                  {"columns", "64", "gather and store", 6, only_gather_columns64},
                  {"columns", "64", "fast", 6, fast_columns64}};
enum { CONTENDERS = sizeof contenders / sizeof *contenders };

/* Seconds of this program's own: the same on a machine that others use, but for the memory they share. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void measure(struct mesh *m, const char *order, int rounds)
{
    double least[CONTENDERS];
    for (int round = 0; round < rounds; round++)
        for (int c = 0; c < CONTENDERS; c++) {
            const double start = now();
            contenders[c].run(m);
            const double ns = 1e9 * (now() - start) / (double)m->n;
            least[c] = round == 0 || ns < least[c] ? ns : least[c];
        }
    for (int c = 0; c < CONTENDERS; c++) {
        const struct contender *const k = &contenders[c];
        printf("%s,%s,%s,%s,%.2f,%.2f\n", order, k->layout, k->index, k->what, least[c], least[c] / least[k->baseline]);
    }
}

int main(int argc, char **argv)
{
    const size_t edge = argc > 1 ? strtoul(argv[1], NULL, 10) : 2500;
    const int rounds = argc > 2 ? atoi(argv[2]) : 4;
    if (edge < 1 || edge > 20000 || rounds < 1) {
        fprintf(stderr, "usage: bench_pairs [EDGE [ROUNDS]]\n");
        return 2;
    }
    struct mesh m = mesh_new(edge);
    printf("order,layout,index,what,ns,ratio\n");
    for (int shuffled = 0; shuffled < 2; shuffled++) {
        mesh_pairs(&m, edge, shuffled);
        measure(&m, shuffled ? "random" : "mesh", rounds);
    }
    if (m.failed)
        printf("# %zu pairs failed\n", m.failed);
    return m.failed != 0;
}
