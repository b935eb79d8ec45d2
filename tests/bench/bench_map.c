/* Maps of errors; see bench_map.h. */
#include "bench_map.h"

#include "../../codegen/base/outfile.h"

#include <math.h>
#include <stdlib.h>

enum { SIDE = 32, SQUARES = SIDE * SIDE };

struct map {
    double low[2], high[2];
    double error[2][SQUARES]; /* means of xi and of eta; xi runs fastest */
    long count[SQUARES];
};

static int square_of(const struct map *m, const struct bench_case *s)
{
    const double at[2] = {s->xi, s->eta};
    int index[2];
    for (int k = 0; k < 2; k++) {
        const double i = floor(SIDE * (at[k] - m->low[k]) / (m->high[k] - m->low[k]));
        index[k] = i < 0 ? 0 : i >= SIDE ? SIDE - 1 : (int)i;
    }
    return index[0] + SIDE * index[1];
}

static void fill(struct map *m, const struct bench_result *r, const struct bench_cases *cases)
{
    for (size_t first = 0; first < cases->n; first += BENCH_BLOCK) {
        const size_t n = cases->n - first < BENCH_BLOCK ? cases->n - first : BENCH_BLOCK;
        const struct bench_case *const c = cases->of + first;
        double found[BENCH_BLOCK][BENCH_FOUND];
        bench_find(r, BENCH_SCALAR, c, n, found, NULL);
        for (size_t i = 0; i < n; i++)
            if (fabs(found[i][0]) < BENCH_NO_ANSWER) {
                const int k = square_of(m, &c[i]);
                m->count[k]++;
                m->error[0][k] += fabs(found[i][0] - c[i].xi);
                m->error[1][k] += fabs(found[i][1] - c[i].eta);
            }
    }
    for (int k = 0; k < SQUARES; k++)
        for (int output = 0; output < 2 && m->count[k]; output++)
            m->error[output][k] /= (double)m->count[k];
}

static void print(FILE *f, const struct map *m, const char *scene, const char *function)
{
    static const char *const name[2] = {"mean_error_xi", "mean_error_eta"};
    fprintf(f, "# vtk DataFile Version 3.0\n%s, scene %s: errors over the segment\nASCII\nDATASET STRUCTURED_POINTS\n",
            function, scene);
    fprintf(f, "DIMENSIONS %d %d 1\nORIGIN %.9g %.9g 0\nSPACING %.9g %.9g 1\nCELL_DATA %d\n", SIDE + 1, SIDE + 1,
            m->low[0], m->low[1], (m->high[0] - m->low[0]) / SIDE, (m->high[1] - m->low[1]) / SIDE, SQUARES);
    for (int output = 0; output < 2; output++) {
        fprintf(f, "SCALARS %s double 1\nLOOKUP_TABLE default\n", name[output]);
        for (int k = 0; k < SQUARES; k++)
            fprintf(f, "%.6e\n", m->error[output][k]);
    }
    fputs("SCALARS samples int 1\nLOOKUP_TABLE default\n", f);
    for (int k = 0; k < SQUARES; k++)
        fprintf(f, "%ld\n", m->count[k]);
}

bool bench_map_write(const char *folder, const struct scene *scene, const struct bench_run *run, struct diag *d)
{
    struct map *m = new_array(1, sizeof *m);
    bool done = true;
    for (int i = 0; done && i < run->count; i++) {
        const struct bench_result *r = &run->result[i];
        char path[1000];
        struct outfile f;
        if (!r->method->ours || r->method->question != ASK_BARE)
            continue;
        *m = (struct map){0};
        scene_box(scene, m->low, m->high);
        fill(m, r, &run->cases[ASK_BARE]);
        snprintf(path, sizeof path, "%s/%s-%s.vtk", folder, scene->name, r->method->name);
        done = outfile_open(&f, path, d);
        if (done) {
            print(f.stream, m, scene->name, r->method->name);
            done = outfile_commit(&f, d);
        }
    }
    free(m);
    return done;
}
