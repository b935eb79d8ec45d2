/* A block slides over a drum: the effect of smoothing the contact surface on the contact force.
 *
 * The drum is rigid, coarsely and unevenly meshed, and turns under an elastic block, whose upper side is pressed down
 * at first and then held. No friction. Four worlds advance side by side: contact with the drum's facets; with Gregory
 * patches over them (patches.h), from the paper's normals at nodes (44) and from better normals; and with the round
 * body itself. Global search, facets and units: penalty.h; elements: plates.h.
 *
 *   cc -O3 -march=native slide.c ../../runtime/geometry/{gregory,bezier,node_normals}.c -o slide -lm
 *   ./slide                  all four, a table
 *   ./slide 0.5 FOLDER       half the time step; slide.csv in a folder that exists: forces over the distance slid */
#include "patches.h"

static const double PI = 3.14159265358979323846;
static const double RING = 4.0, TUBE = 6.0;    /* radii of the drum, a torus about y; mm */
static const double WIDE = 0.7;                /* half width, rad */
static const double SPEED = 40.0, PRESS = 0.2; /* of the drum's middle, mm/ms; of the held side downwards, mm */
static const double UNEVEN = 0.06;             /* largest displacement of nodes, in edges */
static const double RAMP = 4.0, LENGTH = 16.0; /* distance slid until the block is pressed, and until the end; mm */
static const double DAMPING = 400.0;           /* by mass, 1/ms */
enum { AROUND = 24, ACROSS = 4, GLOBAL_EVERY = 10 };
enum surface { FACETS, PATCHES, EVEN_PATCHES, BODY, SURFACES };
static const char *const name[SURFACES] = {"facets", "patches", "even_patches", "body"};

struct slide {
    enum surface surface;
    struct world w;
    struct patches patches;
    struct touch *touch, *before; /* indexed by slave node, in this step and in the last */
    vec force, held;              /* on the block by contact; on the held nodes by the block */
    double power;                 /* of the drum on the block */
    double work, lost;            /* of drum and holder on the block; by damping */
    vec impulse;                  /* received by the block, damped like it */
};

/* ---- drum and block ---- */

static double level(double x, double y)
{
    (void)x;
    (void)y;
    return 0.0;
}

static void add_drum(struct model *m)
{
    m->X = room_for(NULL, AROUND * (ACROSS + 1), sizeof *m->X);
    m->seg = room_for(NULL, AROUND * ACROSS, sizeof *m->seg);
    for (int i = 0; i < AROUND; i++)
        for (int j = 0; j <= ACROSS; j++) {
            const double u = i + UNEVEN * sin(3.1 * i + 1.7 * j), v = j + UNEVEN * cos(2.3 * i + 1.1 * j);
            const double phi = 2.0 * PI / AROUND * u, theta = WIDE * (2.0 / ACROSS * v - 1.0);
            const double radius = RING + TUBE * cos(theta);
            const vec X = {radius * sin(phi), TUBE * sin(theta), radius * cos(phi)};
            memcpy(m->X[m->nodes++], X, sizeof X);
            const int a = i * (ACROSS + 1) + j, b = (i + 1) % AROUND * (ACROSS + 1) + j;
            if (j < ACROSS)
                memcpy(m->seg[m->segs++], (const int[4]){a, b, b + 1, a + 1}, sizeof *m->seg);
        }
    m->first_upper = m->nodes;
}

static struct model drum_and_block(void)
{
    const struct plate block = {{4, 4, 4}, {-0.7, -0.7, RING + TUBE}, {1.4, 1.4, 1.6}, 0.2, level, 0};
    struct model m = {.dt = 1e30};
    m.lambda = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
    m.mu = 0.5 * YOUNG / (1.0 + POISSON);
    m.penalty = 0.2 * (m.lambda + 2.0 * m.mu);
    add_drum(&m);
    add_plate(&m, &block);
    m.slaves = (block.n[0] + 1) * (block.n[1] + 1);
    m.slave = room_for(NULL, (size_t)m.slaves, sizeof *m.slave);
    for (int s = 0; s < m.slaves; s++)
        m.slave[s] = m.first_upper + s;
    m.mass = room_for(NULL, (size_t)m.nodes, sizeof *m.mass);
    m.element = room_for(NULL, (size_t)m.elements, sizeof *m.element);
    for (int n = 0; n < m.nodes; n++)
        m.mass[n] = 0.0;
    for (int e = 0; e < m.elements; e++)
        prepare_element(&m, e);
    return m;
}

/* Returns the first of the held nodes, the block's upper side, which are as many as the slave nodes below. */
static int first_held(const struct model *m)
{
    return m->nodes - m->slaves;
}

/* Returns how far the held side has moved down when the drum has slid by `distance`. */
static double pressed(double distance)
{
    return distance < RAMP ? 0.5 * PRESS * (1.0 - cos(PI * distance / RAMP)) : PRESS;
}

/* ---- contact ---- */

/* Finds contact with the torus itself, which does not change as it turns. */
static void body_touch(const struct model *m, const struct world *w, struct touch *touch)
{
    for (int i = 0; i < m->slaves; i++) {
        const double *const S = w->x[m->slave[i]];
        struct touch *const t = &touch[i];
        const double ring = hypot(S[0], S[2]);
        const vec tube = {S[0] * (1.0 - RING / ring), S[1], S[2] * (1.0 - RING / ring)};
        const double length = sqrt(dot(tube, tube));
        t->seg = 0;
        t->gap = length - TUBE;
        for (int k = 0; k < 3; k++) {
            t->n[k] = tube[k] / length;
            t->r[k] = S[k] - t->gap * t->n[k];
        }
    }
}

/* ---- the loop ---- */

/* Adds penalty forces on the block for negative gaps and returns their energy. Computes force and power of the drum,
 * whose velocity at r is (z, 0, -x) omega. */
static double push(const struct model *m, struct slide *s)
{
    const double omega = SPEED / (RING + TUBE);
    double energy = 0.0;
    memset(s->force, 0, sizeof s->force);
    s->power = 0.0;
    for (int i = 0; i < m->slaves; i++) {
        const struct touch *const t = &s->touch[i];
        if (t->seg < 0 || t->gap >= 0.0)
            continue;
        for (int k = 0; k < 3; k++) {
            s->w.f[m->slave[i]][k] -= m->penalty * t->gap * t->n[k];
            s->force[k] -= m->penalty * t->gap * t->n[k];
        }
        s->power -= m->penalty * t->gap * omega * (t->r[2] * t->n[0] - t->r[0] * t->n[2]);
        energy += 0.5 * m->penalty * t->gap * t->gap;
    }
    return energy;
}

static void forces(const struct model *m, struct slide *s, int step)
{
    struct world *const w = &s->w;
    struct touch *const touch = s->before;
    s->before = s->touch;
    s->touch = touch;
    memset(w->f, 0, (size_t)m->nodes * sizeof *w->f);
    w->strain = internal_forces(m, (const vec *)w->x, w->f);
    if (step % GLOBAL_EVERY == 0)
        global_search(m, w);
    switch (s->surface) {
    case FACETS:
        facets_touch(m, w, touch);
        break;
    case PATCHES:
    case EVEN_PATCHES:
        make_patches(m, w, m->first_upper, s->surface == EVEN_PATCHES, &s->patches);
        patches_touch(m, w, &s->patches, touch);
        break;
    default:
        body_touch(m, w, touch);
    }
    w->contact = push(m, s);
    memset(s->held, 0, sizeof s->held);
    for (int n = first_held(m); n < m->nodes; n++)
        for (int i = 0; i < 3; i++)
            s->held[i] += w->f[n][i];
}

/* Accelerates the free nodes by half a step, then damps; or damps first if `end` is set. */
static void kick(const struct model *m, struct slide *s, double dt, int end)
{
    const double keep = exp(-DAMPING * dt);
    for (int i = 0; i < 3; i++)
        s->impulse[i] = end ? keep * s->impulse[i] + dt * (s->force[i] - s->held[i])
                            : keep * (s->impulse[i] + dt * (s->force[i] - s->held[i]));
    for (int n = m->first_upper; n < first_held(m); n++)
        for (int i = 0; i < 3; i++) {
            double *const v = &s->w.v[n][i], mass = m->mass[n], change = dt * s->w.f[n][i] / mass;
            const double before = end ? *v : *v + change;
            s->lost += 0.5 * mass * before * before * (1.0 - keep * keep);
            *v = keep * before + (end ? change : 0.0);
        }
}

/* Moves drum and held side as prescribed, other nodes by their velocity. */
static void move(const struct model *m, struct slide *s, double from, double to, double dt)
{
    const double angle = to / (RING + TUBE), c = cos(angle), sine = sin(angle);
    for (int n = 0; n < m->first_upper; n++) {
        const double *const X = m->X[n];
        s->w.x[n][0] = c * X[0] + sine * X[2];
        s->w.x[n][2] = c * X[2] - sine * X[0];
    }
    for (int n = m->first_upper; n < first_held(m); n++)
        for (int i = 0; i < 3; i++)
            s->w.x[n][i] += dt * s->w.v[n][i];
    for (int n = first_held(m); n < m->nodes; n++)
        s->w.x[n][2] += pressed(from) - pressed(to);
}

static void advance(const struct model *m, struct slide *s, int step, double from, double to)
{
    const double dt = (to - from) / SPEED, down = pressed(to) - pressed(from);
    s->work += 0.5 * (dt * s->power + down * s->held[2]);
    kick(m, s, 0.5 * dt, 0);
    move(m, s, from, to, dt);
    forces(m, s, step);
    kick(m, s, 0.5 * dt, 1);
    s->work += 0.5 * (dt * s->power + down * s->held[2]);
}

/* Returns the energy from drum and holder minus stored and lost energy, and computes the error of the block's
 * momentum. */
static double energy_missing(const struct model *m, const struct slide *s)
{
    double kinetic = 0.0;
    for (int n = m->first_upper; n < first_held(m); n++)
        kinetic += 0.5 * m->mass[n] * dot(s->w.v[n], s->w.v[n]);
    return fabs(s->work - s->lost - kinetic - s->w.strain - s->w.contact);
}

static double momentum_missing(const struct model *m, const struct slide *s)
{
    vec off;
    memcpy(off, s->impulse, sizeof off);
    for (int n = m->first_upper; n < first_held(m); n++)
        for (int i = 0; i < 3; i++)
            off[i] -= m->mass[n] * s->w.v[n][i];
    return sqrt(dot(off, off));
}

/* ---- results ---- */

/* Sums over the steps after the ramp, and the worst steps. */
struct figures {
    double steps, sum, squares, along; /* normal force: its square; square of the tangential force */
    double last, jump;                 /* tangential force; its largest change in a step */
    double turn, gap_jump;             /* at a change of segment: of a node's normal, as a chord, and of its gap */
    double lost;                       /* nodes with contact that had no segment in the next step */
    double energy, momentum, brought;  /* missing, and the largest energy brought in */
};

static void take_figures(const struct model *m, const struct slide *s, struct figures *f)
{
    const double N = s->force[2], T = s->force[0];
    f->jump = fmax(f->jump, f->steps > 0.0 ? fabs(T - f->last) : 0.0);
    f->last = T;
    f->steps++;
    f->sum += N;
    f->squares += N * N;
    f->along += T * T;
    f->energy = fmax(f->energy, energy_missing(m, s));
    f->momentum = fmax(f->momentum, momentum_missing(m, s));
    f->brought = fmax(f->brought, s->work);
    for (int i = 0; i < m->slaves; i++) {
        const struct touch *const a = &s->before[i], *const b = &s->touch[i];
        if (a->seg < 0 || a->gap >= 0.0 || a->seg == b->seg)
            continue;
        if (b->seg < 0) {
            f->lost++;
            continue;
        }
        vec turn;
        for (int k = 0; k < 3; k++)
            turn[k] = b->n[k] - a->n[k];
        f->turn = fmax(f->turn, sqrt(dot(turn, turn)));
        f->gap_jump = fmax(f->gap_jump, fabs(b->gap - a->gap));
    }
}

static void row(const char *what, const double value[SURFACES])
{
    printf("%-42s %12.4g %12.4g %12.4g %12.4g\n", what, value[FACETS], value[PATCHES], value[EVEN_PATCHES],
           value[BODY]);
}

static void report(const struct model *m, const struct figures *f)
{
    enum { ROWS = 10 };
    static const char *const what[ROWS] = {"normal force, mean, N",
                                           "its jitter, rms, N",
                                           "its jitter / mean",
                                           "tangential force, rms, N",
                                           "its largest change in a step, N",
                                           "normal turned at a segment's edge, degrees",
                                           "gap's jump there, mm",
                                           "nodes that lost contact there",
                                           "energy error, relative",
                                           "momentum error, N ms"};
    double value[ROWS][SURFACES];
    for (int i = 0; i < SURFACES; i++) {
        const struct figures *const g = &f[i];
        const double mean = g->sum / g->steps, rms = sqrt(fmax(0.0, g->squares / g->steps - mean * mean));
        const double column[ROWS] = {mean,
                                     rms,
                                     rms / mean,
                                     sqrt(g->along / g->steps),
                                     g->jump,
                                     g->turn * 180.0 / PI,
                                     g->gap_jump,
                                     g->lost,
                                     g->energy / g->brought,
                                     g->momentum};
        for (int k = 0; k < ROWS; k++)
            value[k][i] = column[k];
    }
    printf("%d elements, %d slave nodes, %d segments, %.0f steps measured\n", m->elements, m->slaves, m->segs,
           f->steps);
    printf("%-42s %12s %12s %12s %12s\n", "", name[FACETS], name[PATCHES], name[EVEN_PATCHES], name[BODY]);
    for (int k = 0; k < ROWS; k++)
        row(what[k], value[k]);
}

static struct slide start(const struct model *m, enum surface surface)
{
    struct slide s = {.surface = surface};
    const size_t nodes = (size_t)m->nodes, slaves = (size_t)m->slaves;
    s.w.x = room_for(NULL, nodes, sizeof *s.w.x);
    s.w.v = room_for(NULL, nodes, sizeof *s.w.v);
    s.w.f = room_for(NULL, nodes, sizeof *s.w.f);
    s.w.nearest = room_for(NULL, slaves, sizeof *s.w.nearest);
    s.w.distance = room_for(NULL, slaves, sizeof *s.w.distance);
    s.patches.normal = room_for(NULL, nodes, sizeof(vec));
    s.patches.patch = room_for(NULL, (size_t)m->segs, sizeof *s.patches.patch);
    s.touch = room_for(NULL, slaves, sizeof *s.touch);
    s.before = room_for(NULL, slaves, sizeof *s.before);
    memcpy(s.w.x, m->X, nodes * sizeof *s.w.x);
    memset(s.w.v, 0, nodes * sizeof *s.w.v);
    forces(m, &s, 0);
    return s;
}

static void finish(struct slide *s)
{
    void *const owned[] = {s->w.x,           s->w.v,   s->w.f,   s->w.nearest, s->w.distance, s->w.pair_seg,
                           s->w.pair_slave,  s->w.xi,  s->w.eta, s->w.last_xi, s->w.last_eta, s->patches.normal,
                           s->patches.patch, s->touch, s->before};
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++)
        free(owned[i]);
}

static FILE *open_csv(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/slide.csv", folder);
    FILE *const f = fopen(path, "w");
    if (!f) {
        perror(path);
        exit(3);
    }
    fprintf(f, "slid_mm");
    for (int i = 0; i < SURFACES; i++)
        fprintf(f, ",%s_normal_N,%s_tangential_N", name[i], name[i]);
    fprintf(f, "\n");
    return f;
}

static void run(const struct model *m, double dt, const char *folder)
{
    const int steps = (int)ceil(LENGTH / (SPEED * dt));
    struct slide s[SURFACES];
    struct figures figures[SURFACES] = {0};
    FILE *const csv = folder ? open_csv(folder) : NULL;
    for (int i = 0; i < SURFACES; i++)
        s[i] = start(m, (enum surface)i);
    for (int step = 1; step <= steps; step++) {
        const double from = (step - 1) * LENGTH / steps, to = step * LENGTH / steps;
        for (int i = 0; i < SURFACES; i++) {
            advance(m, &s[i], step, from, to);
            if (from >= RAMP)
                take_figures(m, &s[i], &figures[i]);
        }
        if (csv) {
            fprintf(csv, "%.9g", to);
            for (int i = 0; i < SURFACES; i++)
                fprintf(csv, ",%.9g,%.9g", s[i].force[2], s[i].force[0]);
            fprintf(csv, "\n");
        }
    }
    if (csv)
        fclose(csv);
    report(m, figures);
    for (int i = 0; i < SURFACES; i++)
        finish(&s[i]);
}

int main(int argc, char **argv)
{
    struct model m = drum_and_block();
    const double scale = argc > 1 ? atof(argv[1]) : 1.0;
    const int good = scale > 0.0 && scale <= 1.0;
    if (good)
        run(&m, scale * m.dt, argc > 2 ? argv[2] : NULL);
    else
        fputs("usage: slide [SCALE [FOLDER]]       0 < SCALE <= 1: of the time step\n", stderr);
    free_model(&m);
    return good ? 0 : 2;
}
