/* An elastic block is pressed onto another and then drawn along it, with or without Coulomb friction: implicit, one
 * static equilibrium per step, by Newton's iteration, whose residuals are printed. The faces in contact are triangles
 * of three or six nodes, quadrilaterals of four, eight or nine or, in plane strain, edges of two or three.
 *
 *   press [KIND [FRICTION]]      default: all seven kinds, without friction and with 0.3
 *
 * Prints for each step how far the upper block's top has moved down and along, the contact force on the block (pressing
 * and drawing, N), how many slave nodes touch, how many of these slide, and the residuals of Newton's iterations: the
 * norm of the unbalanced forces, relative to the norm of the forces at the block's top. Without KIND, also prints for
 * each kind, with friction, how long local search takes from scratch, from the last answers, and by Newton's
 * iteration from these.
 *
 *   make -C ../.. runtime
 *   cc -O3 press.c ../../build/libfootpoint.a -o press -lm && ./press */
#include "friction.h"
#include "last_newton.h"

#include <time.h>

enum { STEPS = 8, PRESSING = 4, MOST_RESIDUALS = 30, HALVINGS = 4 };
static const double DEPTH = 0.14, WAY = 0.2; /* motion of the block's top; mm */
static const double FRICTION = 0.3;          /* Coulomb's coefficient, default */
static const double DONE = 1e-12;            /* relative residual */

/* A state of equilibrium, or an iterate. */
struct state {
    vec *x, *f;
    double *K, *right, *step;
    struct touch *touch;
    vec force; /* of contact on the upper block */
    local_search *search;
    double searching, searched; /* seconds, and number of foot points */
};

/* Returns processor time. */
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Adds all forces and tangents; returns the residual. */
static double assemble(const struct model *m, double friction, struct state *s)
{
    double free = 0.0, held = 0.0;
    memset(s->f, 0, (size_t)m->nodes * sizeof *s->f);
    memset(s->K, 0, (size_t)m->unknowns * (size_t)m->unknowns * sizeof *s->K);
    add_elements(m, (const vec *)s->x, s->f, s->K);
    const double start = seconds();
    find_feet(m, (const vec *)s->x, s->search, s->touch);
    s->searching += seconds() - start;
    s->searched += m->slaves;
    add_contact(m, (const vec *)s->x, friction, s->touch, s->f, s->K, s->force);
    for (int n = 0; n < m->nodes; n++)
        for (int k = 0; k < 3; k++) {
            if (m->unknown[n] >= 0) {
                free += s->f[n][k] * s->f[n][k];
                s->right[m->unknown[n] + k] = s->f[n][k];
            } else if (n >= m->first_upper) {
                held += s->f[n][k] * s->f[n][k];
            }
        }
    return sqrt(free / held);
}

/* Moves the state by a part of a step. */
static void advance(const struct model *m, struct state *s, double part)
{
    for (int n = 0; n < m->nodes; n++)
        for (int k = 0; k < 3 && m->unknown[n] >= 0; k++)
            s->x[n][k] += part * s->step[m->unknown[n] + k];
}

/* Runs Newton's iteration and returns how many residuals it wrote to `residual`. A step that increases the residual is
 * halved a few times, because contact and slip change along it. */
static int equilibrium(const struct model *m, double friction, struct state *s, double *residual)
{
    int n = 0;
    residual[n] = assemble(m, friction, s);
    while (residual[n++] > DONE && n < MOST_RESIDUALS && solve(m->unknowns, s->K, 1, s->right)) {
        double part = 1.0;
        memcpy(s->step, s->right, (size_t)m->unknowns * sizeof *s->step);
        advance(m, s, part);
        residual[n] = assemble(m, friction, s);
        for (int half = 0; half < HALVINGS && !(residual[n] < residual[n - 1]); half++) {
            part *= 0.5;
            advance(m, s, -part);
            residual[n] = assemble(m, friction, s);
        }
    }
    return n;
}

/* Moves the upper block's top. To begin with, the block is sheared and pressed evenly, and its underside stays. */
static void move(const struct model *m, struct state *s, const vec by)
{
    const int up = upwards(m->kind);
    const double low = m->X[m->first_upper][up], high = m->X[m->nodes - 1][up];
    for (int n = m->first_upper; n < m->nodes; n++)
        for (int k = 0; k < 3; k++)
            s->x[n][k] += by[k] * (m->X[n][up] - low) / (high - low);
}

static void print_step(int step, const struct model *m, const struct state *s, int residuals, const double *residual)
{
    const int down = step < PRESSING ? step : PRESSING;
    int touching = 0, sliding = 0;
    for (int i = 0; i < m->slaves; i++) {
        touching += s->touch[i].pressure > 0.0;
        sliding += s->touch[i].slides;
    }
    printf("%7.3f %6.3f %9.4f %9.4f %6d %6d ", DEPTH * down / PRESSING, WAY * (step - down) / (STEPS - PRESSING),
           s->force[upwards(m->kind)], -s->force[0], touching, sliding);
    for (int i = 0; i < residuals; i++)
        printf(" %.0e", residual[i]);
    putchar('\n');
}

/* Presses and draws `times` times, without printing, to measure the search. Returns 0 if no equilibrium was found. */
static int press(enum footpoint_face kind, double friction, local_search search, const char *times)
{
    struct model m = blocks(kind);
    const size_t nodes = (size_t)m.nodes, unknowns = (size_t)m.unknowns;
    struct state s = {room_for(NULL, nodes, sizeof *s.x),
                      room_for(NULL, nodes, sizeof *s.f),
                      room_for(NULL, unknowns * unknowns, sizeof *s.K),
                      room_for(NULL, unknowns, sizeof *s.right),
                      room_for(NULL, unknowns, sizeof *s.step),
                      room_for(NULL, (size_t)m.slaves, sizeof *s.touch),
                      {0},
                      search,
                      0.0,
                      0.0};
    const double start = seconds();
    int good = 1;
    memcpy(s.x, m.X, nodes * sizeof *s.x);
    memset(s.touch, 0, (size_t)m.slaves * sizeof *s.touch);
    if (!times)
        printf("%s, friction %g: %d elements, %d unknowns, %d faces, %d slave nodes\n"
               "   down  along  pressing   drawing  touch  slide  residuals\n",
               kind_name[kind], friction, m.elements, m.unknowns, m.faces, m.slaves);
    for (int step = 1; step <= STEPS && good; step++) {
        vec by[2] = {{0.0}, {WAY / (STEPS - PRESSING), 0.0, 0.0}};
        double residual[MOST_RESIDUALS];
        by[0][upwards(kind)] = -DEPTH / PRESSING;
        choose_faces(&m, (const vec *)s.x, s.touch);
        move(&m, &s, by[step > PRESSING]);
        const int residuals = equilibrium(&m, friction, &s, residual);
        if (!times)
            print_step(step, &m, &s, residuals, residual);
        good = residual[residuals - 1] <= DONE;
    }
    if (!good)
        puts("no equilibrium");
    if (times)
        printf("%-34s %6.0f ns a foot point, %8.3f ms of %8.1f ms\n", times, 1e9 * s.searching / s.searched,
               1e3 * s.searching, 1e3 * (seconds() - start));
    free(s.x);
    free(s.f);
    free(s.K);
    free(s.right);
    free(s.step);
    free(s.touch);
    free_model(&m);
    return good;
}

static int compare(enum footpoint_face kind)
{
    return press(kind, FRICTION, footpoint_face_locate, "local search from scratch") &&
           press(kind, FRICTION, footpoint_track, "from the last answers") &&
           press(kind, FRICTION, last_newton, "by Newton's iteration from these");
}

static int usage(void)
{
    fputs("usage: press [KIND [FRICTION]]       KIND: tri3, tri6, quad4, quad8, quad9, edge2, edge3; 0 <= FRICTION <= "
          "1\n",
          stderr);
    return 2;
}

int main(int argc, char **argv)
{
    int good = 1, found = argc < 2;
    char *end = NULL;
    const double friction = argc > 2 ? strtod(argv[2], &end) : 0.0;
    if (argc > 3 || (end && (end == argv[2] || *end || !(friction >= 0.0 && friction <= 1.0))))
        return usage();
    for (enum footpoint_face kind = FOOTPOINT_TRI3; kind <= FOOTPOINT_EDGE3; kind++) {
        if (kind == FOOTPOINT_FACES || (argc > 1 && strcmp(argv[1], kind_name[kind]) != 0))
            continue;
        found = 1;
        good = press(kind, friction, footpoint_track, NULL) && good;
        if (argc < 3)
            good = press(kind, FRICTION, footpoint_track, NULL) && good;
        if (argc < 2)
            good = compare(kind) && good;
    }
    return found ? !good : usage();
}
