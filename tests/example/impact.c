/* Two elastic plates collide: explicit dynamics with penalty contact, the loop that footpoint is made for.
 *
 * Slave nodes of the upper plate meet master segments of the lower plate (penalty.h; elements: plates.h). This file has
 * the central differences and the results. Four worlds advance side by side, each with its own local search: Newton's
 * iteration and footpoint, from scratch and from the last step's answers. So all are timed under the same load.
 *
 *   cc -O3 -march=native -fno-math-errno -fno-trapping-math impact.c -o impact -lm
 *   ./impact                 all searches, a table
 *   ./impact 0.5 FOLDER      half the time step; energy.csv and VTK files in a folder that exists
 *   ./impact --inp           the mesh, as an input file with *CONTACT PAIR */
#include "alike.h"

#include <time.h>

static const double END = 0.03;                       /* ms */
static const double VELOCITY[3] = {20.0, 5.0, -40.0}; /* of the upper plate, mm/ms */
enum { GLOBAL_EVERY = 10, FRAMES = 20, WORLDS = 4 };

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- the loop ---- */

static void forces(const struct model *m, struct world *w, int step, void search(const struct model *, struct world *))
{
    memset(w->f, 0, (size_t)m->nodes * sizeof *w->f);
    w->strain = internal_forces(m, (const vec *)w->x, w->f);
    const double start = seconds();
    if (step % GLOBAL_EVERY == 0)
        global_search(m, w);
    const double local = seconds();
    search(m, w);
    const double end = seconds();
    choose_segments(m, w);
    w->contact = contact_forces(m, w);
    w->seconds[GLOBAL] += local - start;
    w->seconds[LOCAL] += end - local;
    w->searched += w->pairs;
    w->local[step] = (end - local) / (w->pairs ? w->pairs : 1);
}

/* Accelerates, from rest or from step to step: v is at half steps inside, at full steps outside. */
static void kick(const struct model *m, struct world *w, double dt)
{
    for (int n = 0; n < m->nodes; n++)
        for (int i = 0; i < 3; i++)
            w->v[n][i] += dt * w->f[n][i] / m->mass[n];
}

static void drift(const struct model *m, struct world *w, double dt)
{
    for (int n = 0; n < m->nodes; n++)
        for (int i = 0; i < 3; i++)
            w->x[n][i] += dt * w->v[n][i];
}

static void advance(const struct model *m, struct world *w, int step, double dt,
                    void search(const struct model *, struct world *))
{
    const double start = seconds();
    kick(m, w, 0.5 * dt);
    drift(m, w, dt);
    forces(m, w, step, search);
    kick(m, w, 0.5 * dt);
    w->seconds[ALL] += seconds() - start;
}

/* Returns the kinetic energy, and momentum and moment of momentum about the origin. */
static double kinetic(const struct model *m, const struct world *w, vec momentum, vec moment)
{
    double energy = 0.0;
    for (int i = 0; i < 3; i++)
        momentum[i] = moment[i] = 0.0;
    for (int n = 0; n < m->nodes; n++) {
        energy += 0.5 * m->mass[n] * dot(w->v[n], w->v[n]);
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            momentum[i] += m->mass[n] * w->v[n][i];
            moment[i] += m->mass[n] * (w->x[n][j] * w->v[n][k] - w->x[n][k] * w->v[n][j]);
        }
    }
    return energy;
}

static struct world start(const struct model *m, int steps)
{
    struct world w = {0};
    w.x = room_for(NULL, (size_t)m->nodes, sizeof *w.x);
    w.v = room_for(NULL, (size_t)m->nodes, sizeof *w.v);
    w.f = room_for(NULL, (size_t)m->nodes, sizeof *w.f);
    w.nearest = room_for(NULL, (size_t)m->slaves, sizeof *w.nearest);
    w.distance = room_for(NULL, (size_t)m->slaves, sizeof *w.distance);
    w.local = room_for(NULL, (size_t)steps + 1, sizeof *w.local);
    memcpy(w.x, m->X, (size_t)m->nodes * sizeof *w.x);
    for (int n = 0; n < m->nodes; n++)
        for (int i = 0; i < 3; i++)
            w.v[n][i] = n < m->first_upper ? 0.0 : VELOCITY[i];
    forces(m, &w, 0, search_newton);
    memset(w.seconds, 0, sizeof w.seconds);
    w.searched = 0.0;
    return w;
}

static void finish(struct world *w)
{
    void *const owned[] = {w->x,   w->v,       w->f,        w->pair_seg, w->pair_slave, w->xi,
                           w->eta, w->last_xi, w->last_eta, w->nearest,  w->distance,   w->local};
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++)
        free(owned[i]);
}

/* ---- results ---- */

/* Largest relative deviations of energy and momenta from their initial values. */
struct balance {
    double energy, worst_energy, worst_momentum, worst_moment;
    vec momentum, moment;
};

static void take_balance(const struct model *m, struct world *w, struct balance *b, int first)
{
    vec momentum, moment;
    w->kinetic = kinetic(m, w, momentum, moment);
    const double energy = w->kinetic + w->strain + w->contact;
    if (first) {
        *b = (struct balance){.energy = energy};
        memcpy(b->momentum, momentum, sizeof momentum);
        memcpy(b->moment, moment, sizeof moment);
    }
    for (int i = 0; i < 3; i++) {
        momentum[i] -= b->momentum[i];
        moment[i] -= b->moment[i];
    }
    b->worst_energy = fmax(b->worst_energy, fabs(energy - b->energy) / b->energy);
    b->worst_momentum = fmax(b->worst_momentum, sqrt(dot(momentum, momentum) / dot(b->momentum, b->momentum)));
    b->worst_moment = fmax(b->worst_moment, sqrt(dot(moment, moment) / dot(b->moment, b->moment)));
}

/* Largest differences between xi and eta by footpoint and by Newton's iteration, over pairs whose foot point lies on
 * the segment; and the least time per pair of each search. */
struct errors {
    double sum, worst, count;
    double ns[WAYS][2];
};

static void take_times(const struct model *m, struct world *w, struct errors *e)
{
    for (int k = 0; w->pairs > 0 && k < 2 * WAYS; k++) {
        const double start = seconds();
        alike[k / 2][k % 2](m, w);
        const double ns = 1e9 * (seconds() - start) / w->pairs;
        if (!(e->ns[k / 2][k % 2] > 0.0) || ns < e->ns[k / 2][k % 2])
            e->ns[k / 2][k % 2] = ns;
    }
}

static void take_errors(const struct model *m, struct world *w, struct errors *e)
{
    double *const xi = room_for(NULL, 2 * (size_t)w->pairs, sizeof *xi), *const eta = xi + w->pairs;
    take_times(m, w, e);
    search_footpoint(m, w);
    memcpy(xi, w->xi, (size_t)w->pairs * sizeof *xi);
    memcpy(eta, w->eta, (size_t)w->pairs * sizeof *eta);
    search_newton(m, w);
    for (int p = 0; p < w->pairs; p++)
        if (fabs(w->xi[p]) <= 1.0 && fabs(w->eta[p]) <= 1.0) {
            const double off = fmax(fabs(xi[p] - w->xi[p]), fabs(eta[p] - w->eta[p]));
            e->sum += off;
            e->worst = fmax(e->worst, off);
            e->count++;
        }
    free(xi);
}

static FILE *open_file(const char *folder, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *const f = fopen(path, "w");
    if (!f) {
        perror(path);
        exit(3);
    }
    return f;
}

/* Writes a frame for ParaView or VisIt: the deformed plates with velocities. */
static void write_vtk(const struct model *m, const struct world *w, const char *folder, int frame)
{
    char name[32];
    snprintf(name, sizeof name, "impact_%04d.vtk", frame);
    FILE *const f = open_file(folder, name);
    fprintf(f, "# vtk DataFile Version 3.0\nimpact\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS %d double\n", m->nodes);
    for (int n = 0; n < m->nodes; n++)
        fprintf(f, "%.7g %.7g %.7g\n", w->x[n][0], w->x[n][1], w->x[n][2]);
    fprintf(f, "CELLS %d %d\n", m->elements, 9 * m->elements);
    for (int e = 0; e < m->elements; e++) {
        fprintf(f, "8");
        for (int a = 0; a < 8; a++)
            fprintf(f, " %d", m->hex[e][a]);
        fprintf(f, "\n");
    }
    fprintf(f, "CELL_TYPES %d\n", m->elements);
    for (int e = 0; e < m->elements; e++)
        fprintf(f, "12\n");
    fprintf(f, "POINT_DATA %d\nVECTORS velocity double\n", m->nodes);
    for (int n = 0; n < m->nodes; n++)
        fprintf(f, "%.5g %.5g %.5g\n", w->v[n][0], w->v[n][1], w->v[n][2]);
    fclose(f);
}

static void write_energies(FILE *csv, double t, const struct world *w)
{
    fprintf(csv, "%.9g", t);
    for (int i = 0; i < 2; i++)
        fprintf(csv, ",%.9g,%.9g,%.9g,%.9g", w[i].kinetic, w[i].strain, w[i].contact, w[i].force);
    fprintf(csv, "\n");
}

/* Returns the largest difference between two worlds' kinetic, strain and contact energies, over their sum. */
static double energies_apart(const struct world *a, const struct world *b)
{
    const double sum = a->kinetic + a->strain + a->contact;
    const double most = fmax(fabs(a->kinetic - b->kinetic), fabs(a->strain - b->strain));
    return fmax(most, fabs(a->contact - b->contact)) / sum;
}

/* Returns the largest distance between the first two worlds' nodes. */
static double difference(const struct model *m, const struct world *w)
{
    double worst = 0.0;
    for (int n = 0; n < m->nodes; n++) {
        vec d;
        for (int i = 0; i < 3; i++)
            d[i] = w[0].x[n][i] - w[1].x[n][i];
        worst = fmax(worst, dot(d, d));
    }
    return sqrt(worst);
}

static void row(const char *what, double newton, double footpoint, int ratio)
{
    printf("%-34s %12.4g %12.4g", what, newton, footpoint);
    if (ratio)
        printf(" %7.2f times", newton / footpoint);
    printf("\n");
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Returns the median over the steps, which excludes interrupted steps. */
static double median_ns(struct world *w, int steps)
{
    qsort(w->local + 1, (size_t)steps, sizeof *w->local, ascending);
    return 1e9 * w->local[1 + steps / 2];
}

/* apart: largest difference of the energies in any step from the same search from scratch. */
static void report_last(struct world *w, const double apart[2], int steps)
{
    printf("from the answers of the step before\n");
    row("last: local search, ns a pair", median_ns(&w[0], steps), median_ns(&w[1], steps), 1);
    row("last: local search, ms", 1e3 * w[0].seconds[LOCAL], 1e3 * w[1].seconds[LOCAL], 1);
    row("last: everything, ms", 1e3 * w[0].seconds[ALL], 1e3 * w[1].seconds[ALL], 1);
    row("last: energies off, relative", apart[0], apart[1], 0);
}

static void report(const struct model *m, struct world *w, const struct balance *b, const struct errors *e, int steps)
{
    const double ns[2] = {median_ns(&w[0], steps), median_ns(&w[1], steps)};
    printf("%d elements, %d slave nodes, %d segments, %d steps\n", m->elements, m->slaves, m->segs, steps);
    printf("%-34s %12s %12s\n", "", "Newton", "footpoint");
    row("pairs searched in a step", w[0].searched / steps, w[1].searched / steps, 0);
    row("local search, ns a pair", ns[0], ns[1], 1);
    row("... one at a time, least ns", e->ns[ONE_AT_A_TIME][0], e->ns[ONE_AT_A_TIME][1], 1);
    row("... over arrays, least ns", e->ns[OVER_ARRAYS][0], e->ns[OVER_ARRAYS][1], 1);
    row("local search, ms", 1e3 * w[0].seconds[LOCAL], 1e3 * w[1].seconds[LOCAL], 0);
    row("global search, ms", 1e3 * w[0].seconds[GLOBAL], 1e3 * w[1].seconds[GLOBAL], 0);
    row("everything, ms", 1e3 * w[0].seconds[ALL], 1e3 * w[1].seconds[ALL], 0);
    row("energy, N mm", b[0].energy, b[1].energy, 0);
    row("energy error, relative", b[0].worst_energy, b[1].worst_energy, 0);
    row("momentum error, relative", b[0].worst_momentum, b[1].worst_momentum, 0);
    row("moment of momentum error, relative", b[0].worst_moment, b[1].worst_moment, 0);
    printf("%-34s %12s %12.4g\n", "xi, eta off Newton's, mean", "", e->sum / e->count);
    printf("%-34s %12s %12.4g\n", "xi, eta off Newton's, worst", "", e->worst);
    printf("%-34s %12s %12.4g\n", "nodes apart at the end, mm, worst", "", difference(m, w));
}

static void run(const struct model *m, double dt, const char *folder)
{
    static void (*const search[WORLDS])(const struct model *, struct world *) = {
        search_newton, search_footpoint, search_newton_last, search_footpoint_last};
    const int steps = (int)ceil(END / dt);
    struct world w[WORLDS];
    struct balance b[WORLDS];
    double apart[2] = {0.0, 0.0};
    struct errors errors = {0};
    FILE *const csv = folder ? open_file(folder, "energy.csv") : NULL;
    for (int i = 0; i < WORLDS; i++) {
        w[i] = start(m, steps);
        take_balance(m, &w[i], &b[i], 1);
    }
    for (int step = 1; step <= steps; step++) {
        for (int i = 0; i < WORLDS; i++) {
            advance(m, &w[i], step, dt, search[i]);
            take_balance(m, &w[i], &b[i], 0);
        }
        for (int i = 0; i < 2; i++)
            apart[i] = fmax(apart[i], energies_apart(&w[i], &w[2 + i]));
        if (step % GLOBAL_EVERY == 0)
            take_errors(m, &w[1], &errors);
        if (folder)
            write_energies(csv, step * dt, w);
        if (folder && step * FRAMES / steps != (step - 1) * FRAMES / steps)
            write_vtk(m, &w[1], folder, step * FRAMES / steps);
    }
    if (csv)
        fclose(csv);
    report(m, w, b, &errors, steps);
    report_last(w + 2, apart, steps);
    for (int i = 0; i < WORLDS; i++)
        finish(&w[i]);
}

int main(int argc, char **argv)
{
    struct model m = plates();
    const double scale = argc > 1 ? atof(argv[1]) : 1.0;
    if (argc > 1 && strcmp(argv[1], "--inp") == 0)
        write_inp(&m);
    else if (scale > 0.0 && scale <= 1.0)
        run(&m, scale * m.dt, argc > 2 ? argv[2] : NULL);
    else {
        fputs("usage: impact [SCALE [FOLDER]] | --inp       0 < SCALE <= 1: of the time step\n", stderr);
        return 2;
    }
    free_model(&m);
    return 0;
}
