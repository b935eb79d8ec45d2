/* footpoint-bench: speed against error of every search, on the same held-out samples of a scene.
 *
 * Errors are taken over all samples (at most ERROR_SAMPLES, evenly spread), against the certain foot point.  Times are
 * taken over a smaller, evenly spread set: the methods take turns, ROUNDS times, and the median of a method's turns
 * counts, so that whatever else the machine does falls on all of them alike.  "scalar" is one call for each search,
 * "batch" a loop over columns of coordinates that the compiler may vectorise. */
#include "../codegen/base.h"
#include "../evolve/scene.h"
#include "bench_methods.h"
#include "contact_table.h"
#include "error_stats.h"

#include <getopt.h>
#include <glob.h>
#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdlib.h>
#include <time.h>

enum {
    ERROR_SAMPLES = 600000,
    TIMED_BLOCKS = 78,
    TIMED_SAMPLES = TIMED_BLOCKS * BENCH_BLOCK,
    ROUNDS = 15,
    REPEATS = 4
};

#ifdef __clang__
#define COMPILER __VERSION__
#else
#define COMPILER "gcc " __VERSION__
#endif

enum mode { SCALAR, BATCH, MODES };
static const char *const mode_name[MODES] = {"scalar", "batch"};

/* What a method did on one set of samples. */
struct result {
    struct bench_counts ops;
    struct error_stats xi, eta;
    double ns[MODES][ROUNDS]; /* per search, one for each round */
};

/* The samples that are timed, as structures and by columns. */
struct timed {
    struct sample *s;      /* owned; TIMED_SAMPLES */
    struct bench_block *b; /* owned; TIMED_BLOCKS */
};

static void print_usage(FILE *out)
{
    fputs("usage: footpoint-bench [--scene NAME] [--csv] [--contact]\n"
          "Speed against error of every search, on held-out samples.\n"
          "  --scene NAME  a scene of evolve/scenes, or a path; default: all of evolve/scenes\n"
          "  --csv         comma-separated values\n"
          "  --contact     instead: contact or not, and how deep, by the pinball test; comma-separated values\n"
          "  --help        this text\n"
          "  --version     version\n",
          out);
}

/* Sample i of `count` spread evenly over the set; the set is repeated if it is smaller. */
static const struct sample *spread(const struct sample_set *set, size_t i, size_t count)
{
    return &set->s[set->n < count ? i % set->n : i * set->n / count];
}

static struct timed timed_new(const struct sample_set *set)
{
    struct timed t = {new_array(TIMED_SAMPLES, sizeof *t.s), new_array(TIMED_BLOCKS, sizeof *t.b)};
    for (size_t i = 0; i < TIMED_SAMPLES; i++) {
        struct bench_block *b = &t.b[i / BENCH_BLOCK];
        t.s[i] = *spread(set, i, TIMED_SAMPLES);
        for (size_t k = 0; k < 15; k++)
            b->x[k][i % BENCH_BLOCK] = k < 12 ? t.s[i].x[k / 3][k % 3] : t.s[i].xs[k - 12];
    }
    return t;
}

static void timed_free(struct timed *t)
{
    free(t->s);
    free(t->b);
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Nanoseconds per search.  A block is searched several times while it is in the cache. */
static double time_turn(const struct bench_method *m, enum mode mode, struct timed *t)
{
    double found[2];
    const double start = seconds();
    for (size_t k = 0; k < TIMED_BLOCKS; k++)
        for (int repeat = 0; repeat < REPEATS; repeat++)
            if (mode == BATCH)
                m->batch(&t->b[k]);
            else
                for (size_t i = 0; i < BENCH_BLOCK; i++)
                    m->one(&t->s[k * BENCH_BLOCK + i], found);
    return 1e9 * (seconds() - start) / (REPEATS * (double)TIMED_SAMPLES);
}

static void measure_errors(const struct bench_method *m, const struct sample_set *set, struct result *r)
{
    const size_t n = set->n < ERROR_SAMPLES ? set->n : ERROR_SAMPLES;
    if (m->depth_only) {
        r->xi = r->eta = (struct error_stats){(double)NAN, (double)NAN, (double)NAN, 0};
        return;
    }
    double *error_xi = new_array(n, sizeof *error_xi), *error_eta = new_array(n, sizeof *error_eta);
    for (size_t i = 0; i < n; i++) {
        const struct sample *s = spread(set, i, n);
        double found[2];
        m->one(s, found);
        const bool finite = isfinite(found[0]) && isfinite(found[1]);
        error_xi[i] = finite ? fabs(found[0] - s->xi) : (double)NAN;
        error_eta[i] = finite ? fabs(found[1] - s->eta) : (double)NAN;
    }
    r->xi = error_stats_of(error_xi, n);
    r->eta = error_stats_of(error_eta, n);
    free(error_xi);
    free(error_eta);
}

/* Operations of converged Newton: its first step, and the later ones as often as they are taken on average. */
static struct bench_counts newton_counts(const struct timed *t)
{
    const struct bench_counts first = bench_counts_of("newton_first"), step = bench_counts_of("newton_step");
    double later = 0, xi, eta;
    for (size_t i = 0; i < TIMED_SAMPLES; i++) {
        const struct sample *s = &t->s[i];
        const int n = bench_newton_iterations(s->x[0], s->x[1], s->x[2], s->x[3], s->xs, &xi, &eta);
        later += (n ? n : RIVAL_NEWTON_MAX) - 1;
    }
    later /= TIMED_SAMPLES;
    return (struct bench_counts){
        "newton", first.mul + lrint(later * (double)step.mul), first.div + lrint(later * (double)step.div),
        first.add + lrint(later * (double)step.add), first.sqrt + lrint(later * (double)step.sqrt)};
}

static void print_csv(const struct scene *scene, const char *sample, const struct result *r, bool ours, int mode,
                      double ratio)
{
    printf("%s,%s,%s,%d,%s,%ld,%ld,%ld,%ld,%.2f,%.2f,%.3e,%.3e,%.3e,%.3e,%.3e,%.3e,%zu\n", scene->name, sample,
           r->ops.name, ours, mode_name[mode], r->ops.mul, r->ops.div, r->ops.add, r->ops.sqrt, r->ns[mode][ROUNDS / 2],
           ratio, r->xi.mean, r->xi.p99, r->xi.max, r->eta.mean, r->eta.p99, r->eta.max, r->xi.failures);
}

static void print_table(const struct scene *scene, const char *sample, const struct result *r, bool ours, int mode,
                        double ratio)
{
    printf("%-14s %-6s %c %-34s %-6s %4ld %3ld %4ld %4ld %7.2f %7.2f %6.2f %8.1e %8.1e %8.1e %8.1e %8.1e %8.1e %8zu\n",
           scene->name, sample, ours ? '*' : ' ', r->ops.name, mode_name[mode], r->ops.mul, r->ops.div, r->ops.add,
           r->ops.sqrt, r->ns[mode][0], r->ns[mode][ROUNDS / 2], ratio, r->xi.mean, r->xi.p99, r->xi.max, r->eta.mean,
           r->eta.p99, r->eta.max, r->xi.failures);
}

/* Once, before the first row: a scene that cannot be read leaves nothing on standard output. */
static void print_head(bool csv)
{
    static bool done;
    if (done)
        return;
    done = true;
    if (csv) {
        printf("scene,sample,method,ours,mode,mul,div,add,sqrt,ns,ratio,mean_xi,p99_xi,max_xi,mean_eta,p99_eta,max_eta,"
               "failures\n");
        return;
    }
    printf("footpoint-bench " FOOTPOINT_VERSION ", compiled by " COMPILER "\n"
           "*: ours; ns: of one search, least and median; ratio: converged Newton's median in the same mode over this "
           "one's;\npinball finds no xi, eta: --contact\n\n");
    printf("%-14s %-6s   %-34s %-6s %4s %3s %4s %4s %7s %7s %6s %8s %8s %8s %8s %8s %8s %8s\n", "scene", "sample",
           "method", "mode", "mul", "div", "add", "sqrt", "ns_min", "ns", "ratio", "mean_xi", "p99_xi", "max_xi",
           "mean_eta", "p99_eta", "max_eta", "failures");
}

/* A generated function is for its scene; a search that starts in A's quarter, for scenes where A is the nearest corner.
 */
static bool runs_on(const struct bench_method *m, const struct scene *scene)
{
    if (m->scene)
        return strcmp(m->scene, scene->name) == 0;
    return m->start == RIVAL_CENTRE || scene->order != CORNERS_ANY;
}

/* Every method on one part of a scene's samples. */
static bool bench_part(const struct scene *scene, enum sample_part part, const char *sample, bool csv, struct diag *d)
{
    struct sample_set set = {0};
    if (!scene_samples(scene, part, &set, d))
        return false;
    struct timed timed = timed_new(&set);
    struct result *result = new_array(BENCH_METHODS, sizeof *result);
    for (int i = 0; i < BENCH_METHODS; i++)
        if (runs_on(&bench_methods[i], scene)) {
            const struct bench_method *m = &bench_methods[i];
            result[i].ops = i == 0 ? newton_counts(&timed) : m->scene ? m->ops : bench_counts_of(m->ops.name);
            measure_errors(m, &set, &result[i]);
        }
    for (int round = 0; round < ROUNDS; round++)
        for (int mode = 0; mode < MODES; mode++)
            for (int i = 0; i < BENCH_METHODS; i++)
                if (runs_on(&bench_methods[i], scene))
                    result[i].ns[mode][round] = time_turn(&bench_methods[i], (enum mode)mode, &timed);
    for (int i = 0; i < BENCH_METHODS; i++)
        for (int mode = 0; mode < MODES; mode++)
            gsl_sort(result[i].ns[mode], 1, ROUNDS);
    print_head(csv);
    for (int i = 0; i < BENCH_METHODS; i++)
        for (int mode = 0; mode < MODES && runs_on(&bench_methods[i], scene); mode++)
            (csv ? print_csv : print_table)(scene, sample, &result[i], !bench_methods[i].rival, mode,
                                            result[0].ns[mode][ROUNDS / 2] / result[i].ns[mode][ROUNDS / 2]);
    free(result);
    timed_free(&timed);
    sample_set_free(&set);
    return true;
}

static bool bench_scene(const char *name, bool csv, bool contact, struct diag *d)
{
    struct scene *scene = scene_read(".", name, d);
    if (!scene)
        return false;
    if (contact) {
        const bool decided = contact_table(scene, d);
        scene_free(scene);
        return decided;
    }
    /* Of a scene that is random anyway, what is held out is off any grid. */
    const bool done = scene->source == SOURCE_RANDOM ? bench_part(scene, PART_HELDOUT, "random", csv, d)
                                                     : bench_part(scene, PART_HELDOUT, "grid", csv, d) &&
                                                           bench_part(scene, PART_HELDOUT_RANDOM, "random", csv, d);
    scene_free(scene);
    return done;
}

static bool bench_all(bool csv, bool contact, struct diag *d)
{
    glob_t found;
    bool done = true;
    if (glob("evolve/scenes/*.scene", 0, NULL, &found) != 0)
        return diag_at(d, "evolve/scenes", 0, 0, "no scene here; run from the root of the source, or name one");
    for (size_t i = 0; done && i < found.gl_pathc; i++)
        done = bench_scene(found.gl_pathv[i], csv, contact, d);
    globfree(&found);
    return done;
}

int main(int argc, char **argv)
{
    static const struct option options[] = {{"scene", required_argument, NULL, 's'}, {"csv", no_argument, NULL, 'c'},
                                            {"contact", no_argument, NULL, 'p'},     {"help", no_argument, NULL, 'h'},
                                            {"version", no_argument, NULL, 'v'},     {NULL, 0, NULL, 0}};
    const char *scene = NULL;
    bool csv = false, contact = false;
    struct diag d;
    for (int option; (option = getopt_long(argc, argv, "", options, NULL)) != -1;)
        switch (option) {
        case 's':
            scene = optarg;
            break;
        case 'c':
            csv = true;
            break;
        case 'p':
            contact = true;
            break;
        case 'h':
            print_usage(stdout);
            return EXIT_DONE;
        case 'v':
            printf("footpoint-bench %s\n", FOOTPOINT_VERSION);
            return EXIT_DONE;
        default:
            return EXIT_USAGE;
        }
    if (optind < argc) {
        fprintf(stderr, "footpoint-bench: unexpected argument '%s'\n", argv[optind]);
        return EXIT_USAGE;
    }
    if (contact)
        puts(contact_table_head);
    if (!(scene ? bench_scene(scene, csv, contact, &d) : bench_all(csv, contact, &d))) {
        fprintf(stderr, "%s\n", d.text);
        return (int)d.code;
    }
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "standard output: error: cannot write\n");
        return EXIT_SYSTEM;
    }
    return EXIT_DONE;
}
