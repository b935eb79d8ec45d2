/* Compares batches of pairs from a mesh's arrays with a loop that only gathers the same coordinates and stores two
 * doubles, interleaved in one run. The arrays are far larger than any cache; pairs are in the order of the mesh and in
 * random order.
 *   bench_pairs [EDGE [ROUNDS]]     EDGE x EDGE segments, one slave node over each
 *
 * Prints lines order,layout,index,what,ns,ratio with the least ns per pair and its ratio to the loop's. */
#include "../../runtime/footpoint_batch.h"

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

/* Returns corners and slave nodes of a wavy square, moved at random by up to a tenth of an edge. */
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

/* Fills in the pairs in the order of the segments, or in random order. */
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

/* ---- contenders ---- */

/* Loops over five nodes, fifteen coordinates. They store two doubles, or also a third and a status. */
#define ONLY_GATHER(name, INDEX, seg_, slave_, X, everything)                                                          \
    static void name(struct mesh *m)                                                                                   \
    {                                                                                                                  \
        const double *const xyz = m->xyz, *const x = m->column[0], *const y = m->column[1], *const z = m->column[2];   \
        const INDEX *const segment = m->seg_, *const node = m->slave_;                                                 \
        double *const loc = m->loc, *const gap = m->gap;                                                               \
        int *const status = m->status;                                                                                 \
        (void)xyz, (void)x, (void)y, (void)z, (void)gap, (void)status;                                                 \
        for (size_t i = 0; i < m->n; i++) {                                                                            \
            const INDEX a = segment[4 * i], b = segment[4 * i + 1], c = segment[4 * i + 2], d = segment[4 * i + 3];    \
            const INDEX s = node[i];                                                                                   \
            loc[2 * i] = (X(a, 0) + X(a, 1)) + (X(a, 2) + X(b, 0)) + (X(b, 1) + X(b, 2)) + (X(s, 0) + X(s, 1));        \
            loc[2 * i + 1] = (X(c, 0) + X(c, 1)) + (X(c, 2) + X(d, 0)) + (X(d, 1) + X(d, 2)) + X(s, 2);                \
            if (everything) {                                                                                          \
                gap[i] = X(a, 0) + X(c, 1);                                                                            \
                status[i] = 0;                                                                                         \
            }                                                                                                          \
        }                                                                                                              \
    }
#define OF_TRIPLE(node, i) xyz[3 * (node) + (i)]
#define OF_COLUMN(node, i) ((i) == 0 ? x : (i) == 1 ? y : z)[node]

ONLY_GATHER(gather_triples32, int32_t, seg, slave, OF_TRIPLE, 0)
ONLY_GATHER(gather_triples64, int64_t, seg64, slave64, OF_TRIPLE, 0)
ONLY_GATHER(gather_columns32, int32_t, seg, slave, OF_COLUMN, 0)
ONLY_GATHER(gather_columns64, int64_t, seg64, slave64, OF_COLUMN, 0)
ONLY_GATHER(gather_triples32_more, int32_t, seg, slave, OF_TRIPLE, 1)
ONLY_GATHER(gather_triples64_more, int64_t, seg64, slave64, OF_TRIPLE, 1)
ONLY_GATHER(gather_columns32_more, int32_t, seg, slave, OF_COLUMN, 1)
ONLY_GATHER(gather_columns64_more, int64_t, seg64, slave64, OF_COLUMN, 1)

/* A batch by tier, with or without gap and status. */
#define BATCH(name, tier, columns, wide, everything)                                                                   \
    static void name(struct mesh *m)                                                                                   \
    {                                                                                                                  \
        batch(m, tier, columns, wide, everything);                                                                     \
    }

static void batch(struct mesh *m, enum footpoint_tier tier, int columns, int wide, int everything)
{
    struct footpoint_pairs p = {
        .n = m->n, .nodes = m->nodes, .x = m->xyz, .y = m->xyz + 1, .z = m->xyz + 2, .stride = 3};
    if (columns)
        p.x = m->column[0], p.y = m->column[1], p.z = m->column[2], p.stride = 1;
    if (wide)
        p.seg64 = m->seg64, p.slave64 = m->slave64;
    else
        p.seg = m->seg, p.slave = m->slave;
    m->failed += footpoint_locate_batch(&p, tier, m->loc, everything ? m->gap : NULL, everything ? m->status : NULL);
}

BATCH(fast_triples32, FOOTPOINT_FAST, 0, 0, 0)
BATCH(fast_triples64, FOOTPOINT_FAST, 0, 1, 0)
BATCH(fast_columns32, FOOTPOINT_FAST, 1, 0, 0)
BATCH(fast_columns64, FOOTPOINT_FAST, 1, 1, 0)
BATCH(fast_triples32_more, FOOTPOINT_FAST, 0, 0, 1)
BATCH(fast_triples64_more, FOOTPOINT_FAST, 0, 1, 1)
BATCH(fast_columns32_more, FOOTPOINT_FAST, 1, 0, 1)
BATCH(fast_columns64_more, FOOTPOINT_FAST, 1, 1, 1)
BATCH(balanced, FOOTPOINT_BALANCED, 0, 0, 0)
BATCH(accurate, FOOTPOINT_ACCURATE, 0, 0, 0)
BATCH(accurate_more, FOOTPOINT_ACCURATE, 0, 0, 1)

/* Each batch is compared with the loop over the same arrays that stores the same results, each such loop with the loop
 * that stores two doubles. */
static const struct contender {
    const char *layout, *index, *what;
    int baseline;
    void (*run)(struct mesh *m);
} contenders[] = {{"nodes x 3", "32", "gather and store", 0, gather_triples32},
                  {"nodes x 3", "32", "fast", 0, fast_triples32},
                  {"nodes x 3", "32", "gather and store with gap and status", 0, gather_triples32_more},
                  {"nodes x 3", "32", "fast with gap and status", 2, fast_triples32_more},
                  {"nodes x 3", "32", "balanced", 0, balanced},
                  {"nodes x 3", "32", "accurate", 0, accurate},
                  {"nodes x 3", "32", "accurate with gap and status", 2, accurate_more},
                  {"nodes x 3", "64", "gather and store", 7, gather_triples64},
                  {"nodes x 3", "64", "fast", 7, fast_triples64},
                  {"nodes x 3", "64", "gather and store with gap and status", 7, gather_triples64_more},
                  {"nodes x 3", "64", "fast with gap and status", 9, fast_triples64_more},
                  {"columns", "32", "gather and store", 11, gather_columns32},
                  {"columns", "32", "fast", 11, fast_columns32},
                  {"columns", "32", "gather and store with gap and status", 11, gather_columns32_more},
                  {"columns", "32", "fast with gap and status", 13, fast_columns32_more},
                  {"columns", "64", "gather and store", 15, gather_columns64},
                  {"columns", "64", "fast", 15, fast_columns64},
                  {"columns", "64", "gather and store with gap and status", 15, gather_columns64_more},
                  {"columns", "64", "fast with gap and status", 17, fast_columns64_more}};
enum { CONTENDERS = sizeof contenders / sizeof *contenders };

/* Returns processor seconds, which exclude other processes, except for the memory they share. */
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
