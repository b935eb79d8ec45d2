/* Runs both searches on recorded calls, in turn: replay FILE...
 *
 * Prints CSV, a line for each kind of face:
 *   nodes,calls,original_ns,ours_ns,ratio,farther,undercut,moved,edge
 *
 * ns: processor time, the least over rounds of the mean of a call; ratio: of the two times; farther: by how much our
 * point is farther away than the original's, at most, over the longest edge; undercut: the share of calls in which ours
 * is nearer by more than 1e-8 of it; moved: the largest difference of local coordinates in other calls; edge: the share
 * of points on edges. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ROUNDS = 25 };

typedef void search(double (*pneigh)[3], double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                    double *etl);
search original_attach_2d_, attach_2d_;

struct call {
    int nodes;
    double x[9][3], xs[3];
};

struct answer {
    double at[3], ratio[9], dist, xi, eta;
};

static struct call *call;
static size_t calls;

static void read_calls(const char *path)
{
    FILE *const f = fopen(path, "rb");
    double nodes;
    if (!f) {
        perror(path);
        exit(3);
    }
    while (fread(&nodes, sizeof nodes, 1, f) == 1) {
        struct call c = {.nodes = (int)nodes};
        if (fread(c.x, sizeof *c.x, (size_t)c.nodes, f) != (size_t)c.nodes || fread(c.xs, sizeof *c.xs, 3, f) != 3)
            break;
        if ((calls & (calls - 1)) == 0 && !(call = realloc(call, 2 * (calls + 1) * sizeof *call)))
            exit(3);
        call[calls++] = c;
    }
    fclose(f);
}

static struct answer answer_of(search *find, struct call *c)
{
    struct answer a;
    memcpy(a.at, c->xs, sizeof a.at);
    find(c->x, a.at, &c->nodes, a.ratio, &a.dist, &a.xi, &a.eta);
    return a;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static volatile double sink;

static double time_of(search *find, struct call *of, size_t count)
{
    const double start = now();
    double sum = 0.0;
    for (size_t i = 0; i < count; i++)
        sum += answer_of(find, &of[i]).dist;
    sink = sum;
    return (now() - start) / (double)count;
}

static int by_nodes(const void *a, const void *b)
{
    return ((const struct call *)a)->nodes - ((const struct call *)b)->nodes;
}

static double longest_edge(const struct call *c)
{
    const int corners = c->nodes > 4 ? c->nodes / 2 : c->nodes;
    double most = 0.0;
    for (int i = 0; i < corners; i++) {
        const double *const a = c->x[i], *const b = c->x[(i + 1) % corners];
        most = fmax(most, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
    }
    return most;
}

/* Compares `count` calls with faces of one kind. */
static void compare(struct call *of, size_t count)
{
    const int nodes = of->nodes;
    double original = HUGE_VAL, ours = HUGE_VAL, farther = 0.0, moved = 0.0;
    size_t undercut = 0, edge = 0;
    for (size_t i = 0; i < count; i++) {
        const struct answer a = answer_of(original_attach_2d_, &of[i]), b = answer_of(attach_2d_, &of[i]);
        const double h = longest_edge(&of[i]);
        const int triangle = nodes == 3 || nodes == 6;
        farther = fmax(farther, (b.dist - a.dist) / h);
        edge += triangle ? b.xi <= 0.0 || b.eta <= 0.0 || b.xi + b.eta >= 1.0 : fabs(b.xi) >= 1.0 || fabs(b.eta) >= 1.0;
        if (a.dist - b.dist > 1e-8 * h)
            undercut++;
        else
            moved = fmax(moved, fmax(fabs(a.xi - b.xi), fabs(a.eta - b.eta)));
    }
    for (int r = 0; r < ROUNDS; r++) {
        original = fmin(original, time_of(original_attach_2d_, of, count));
        ours = fmin(ours, time_of(attach_2d_, of, count));
    }
    printf("%d,%zu,%.1f,%.1f,%.1f,%.1e,%.2e,%.1e,%.3f\n", nodes, count, original, ours, original / ours, farther,
           (double)undercut / (double)count, moved, (double)edge / (double)count);
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        read_calls(argv[i]);
    puts("nodes,calls,original_ns,ours_ns,ratio,farther,undercut,moved,edge");
    qsort(call, calls, sizeof *call, by_nodes);
    for (size_t i = 0, end; i < calls; i = end) {
        for (end = i; end < calls && call[end].nodes == call[i].nodes;)
            end++;
        compare(&call[i], end - i);
    }
    free(call);
    return 0;
}
