/* The nearest of many faces, with a grid of cells as broad phase.
 *
 * grid [FACES]: a wavy sheet of about FACES quadrilaterals (100,000) and as many slave nodes, near it and up to 20
 * edges away. The grid returns the faces of the cells within `ring` cells of a node's cell. All other faces lie beyond
 * ring times the size of a cell. So an answer nearer than that is the nearest of all, and all faces at its edge or
 * corner were candidates, so that the sign is right for the sheet. Otherwise its distance determines how many rings
 * suffice. Prints time and candidates per node, and compares some nodes with a search of all faces.
 *
 * cc -O2 -Iruntime tests/example/grid.c build/libfootpoint.a -lm */
#include "footpoint_face.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { COMPARED = 20 };

struct sheet {
    size_t side, faces;
    double *xyz; /* owned; 3 per node */
    int *seg;    /* owned; 4 per face */
};

struct grid {
    const struct sheet *sheet;
    double from[3], cell;
    long cells[3];
    size_t *first; /* owned, indexed by cell: its first face in `face`; one more at the end */
    int *face;     /* owned */
    size_t *seen;  /* owned, indexed by face: the last query that it was a candidate of */
    int *seg;      /* owned; nodes of the candidates */
    size_t *which; /* owned; faces of the candidates */
    size_t query;
};

static void *allocate(size_t n, size_t size)
{
    void *p = calloc(n ? n : 1, size);
    if (!p)
        exit(3);
    return p;
}

static double uniform(void)
{
    static uint64_t seed = 1;
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static struct sheet make_sheet(size_t side)
{
    struct sheet s = {side, side * side, allocate(3 * (side + 1) * (side + 1), sizeof *s.xyz),
                      allocate(4 * side * side, sizeof *s.seg)};
    for (size_t k = 0; k < (side + 1) * (side + 1); k++) {
        const double x = (double)(k % (side + 1)), y = (double)(k / (side + 1));
        s.xyz[3 * k] = x;
        s.xyz[3 * k + 1] = y;
        s.xyz[3 * k + 2] = 2.0 * sin(0.3 * x) * cos(0.2 * y);
    }
    for (size_t f = 0; f < s.faces; f++) {
        const int a = (int)(f / side * (side + 1) + f % side), up = (int)side + 1;
        const int node[4] = {a, a + 1, a + 1 + up, a + up};
        memcpy(s.seg + 4 * f, node, sizeof node);
    }
    return s;
}

/* ---- the grid ---- */

/* Computes the range of cells that the box about a face touches, clipped to the grid, like all ranges. */
static void range_of(const struct grid *g, const double low[3], const double high[3], long from[3], long to[3])
{
    for (int i = 0; i < 3; i++) {
        from[i] = (long)fmax(floor((low[i] - g->from[i]) / g->cell), 0.0);
        to[i] = (long)fmin(floor((high[i] - g->from[i]) / g->cell), (double)(g->cells[i] - 1));
    }
}

static void range_of_face(const struct grid *g, size_t face, long from[3], long to[3])
{
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], g->sheet->xyz[3 * g->sheet->seg[4 * face + (size_t)k] + i]);
            high[i] = fmax(high[i], g->sheet->xyz[3 * g->sheet->seg[4 * face + (size_t)k] + i]);
        }
    range_of(g, low, high, from, to);
}

/* Calls visit() for each cell of a range. */
static void each_cell(struct grid *g, const long from[3], const long to[3],
                      void (*visit)(struct grid *, size_t, void *), void *with)
{
    for (long c = from[2]; c <= to[2]; c++)
        for (long b = from[1]; b <= to[1]; b++)
            for (long a = from[0]; a <= to[0]; a++)
                visit(g, (size_t)((c * g->cells[1] + b) * g->cells[0] + a), with);
}

static void count(struct grid *g, size_t cell, void *unused)
{
    (void)unused;
    g->first[cell + 1]++;
}

/* Enters a face from the end of a cell's faces. */
static void enter(struct grid *g, size_t cell, void *face)
{
    g->face[--g->first[cell + 1]] = *(int *)face;
}

static struct grid make_grid(const struct sheet *s, double cell)
{
    struct grid g = {.sheet = s, .from = {0.0, 0.0, -2.0}, .cell = cell};
    const double size[3] = {(double)s->side, (double)s->side, 4.0};
    size_t cells = 1, sum = 0;
    long from[3], to[3];
    for (int i = 0; i < 3; i++)
        cells *= (size_t)(g.cells[i] = (long)(size[i] / cell) + 1);
    g.first = allocate(cells + 2, sizeof *g.first);
    for (size_t f = 0; f < s->faces; f++) {
        range_of_face(&g, f, from, to);
        each_cell(&g, from, to, count, NULL);
    }
    for (size_t c = 0; c <= cells; c++)
        g.first[c] = sum += g.first[c];
    g.face = allocate(sum, sizeof *g.face);
    for (int f = 0; f < (int)s->faces; f++) {
        range_of_face(&g, (size_t)f, from, to);
        each_cell(&g, from, to, enter, &f);
    }
    g.first[cells + 1] = sum;
    g.seen = allocate(s->faces, sizeof *g.seen);
    g.seg = allocate(4 * s->faces, sizeof *g.seg);
    g.which = allocate(s->faces, sizeof *g.which);
    return g;
}

static void free_all(struct sheet *s, struct grid *g)
{
    free(s->xyz);
    free(s->seg);
    free(g->first);
    free(g->face);
    free(g->seen);
    free(g->seg);
    free(g->which);
}

/* ---- the search ---- */

/* Adds the faces of a cell to the candidates, each once. */
static void hand_over(struct grid *g, size_t cell, void *candidates)
{
    size_t *n = candidates;
    for (size_t i = g->first[cell + 1]; i < g->first[cell + 2]; i++) {
        const int face = g->face[i];
        if (g->seen[face] == g->query)
            continue;
        g->seen[face] = g->query;
        memcpy(g->seg + 4 * *n, g->sheet->seg + 4 * face, 4 * sizeof *g->seg);
        g->which[(*n)++] = (size_t)face;
    }
}

struct answer {
    size_t face, candidates;
    double loc[2], distance;
    int region, status;
};

static void find_nearest(struct grid *g, const double xS[3], struct answer *a)
{
    const double all = g->cell * (double)(g->cells[0] + g->cells[1] + g->cells[2]);
    a->candidates = 0;
    for (double ring = 1.0;; ring *= 2.0) {
        const double reach = ring * g->cell, low[3] = {xS[0] - reach, xS[1] - reach, xS[2] - reach},
                     high[3] = {xS[0] + reach, xS[1] + reach, xS[2] + reach};
        long from[3], to[3];
        size_t n = 0;
        g->query++;
        range_of(g, low, high, from, to);
        each_cell(g, from, to, hand_over, &n);
        a->candidates += n;
        a->status = footpoint_face_select(FOOTPOINT_QUAD4, g->sheet->xyz, n, g->seg, xS, &a->face, a->loc, &a->distance,
                                          &a->region);
        if (a->status >= FOOTPOINT_OK && fabs(a->distance) < reach)
            break;
        if (a->status >= FOOTPOINT_OK) /* doubles the rings until they suffice */
            ring = 0.501 * fabs(a->distance) / g->cell;
        else if (reach > 100.0 * all)
            return;
    }
    a->face = g->which[a->face];
}

int main(int argc, char **argv)
{
    const long faces = argc > 1 ? atol(argv[1]) : 100000;
    if (argc > 2 || faces < 4 || faces > 10000000)
        return fputs("usage: grid [FACES]       from 4 to 10000000\n", stderr), 2;
    struct sheet s = make_sheet((size_t)sqrt((double)faces));
    struct grid g = make_grid(&s, 1.5);
    size_t candidates = 0, failed = 0, wrong = 0;
    double seconds = 0.0;
    for (size_t i = 0; i < s.faces; i++) {
        const double height = i % 4 ? 2.0 : 40.0,
                     xS[3] = {(double)s.side * uniform(), (double)s.side * uniform(), height * (uniform() - 0.5)};
        struct answer a, all;
        const clock_t begin = clock();
        find_nearest(&g, xS, &a);
        seconds += (double)(clock() - begin) / CLOCKS_PER_SEC;
        candidates += a.candidates;
        failed += a.status != FOOTPOINT_OK;
        if (i % (s.faces / COMPARED + 1))
            continue;
        all.status = footpoint_face_select(FOOTPOINT_QUAD4, s.xyz, s.faces, s.seg, xS, &all.face, all.loc,
                                           &all.distance, &all.region);
        wrong += all.status != a.status || !(fabs(all.distance - a.distance) <= 1e-9);
    }
    printf("%zu faces, %zu slave nodes: %.1f candidates and %.2f microseconds a node; %zu without an answer, %zu of %d "
           "wrong\n",
           s.faces, s.faces, (double)candidates / (double)s.faces, 1e6 * seconds / (double)s.faces, failed, wrong,
           COMPARED);
    free_all(&s, &g);
    return failed + wrong > 0;
}
