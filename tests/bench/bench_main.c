/* footpoint-bench: speed against error of every search, on the same held-out samples of a scene.
 *
 * Errors are taken against the certain foot point.  "scalar" is one search at a time, "batch" a loop over columns of
 * coordinates that the compiler may vectorise.  All methods are compiled alike, for several instruction sets, of which
 * the best that the machine has is taken. */
#include "../../codegen/genome/base.h"
#include "../../codegen/genome/console.h"
#include "../../evolve/common/data_root.h"
#include "../../evolve/input/scene.h"
#include "../rivals/contact_table.h"
#include "bench_map.h"
#include "bench_measure.h"

#include <getopt.h>
#include <glob.h>
#include <stdlib.h>
#include <string.h>

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#else
#define COMPILER "gcc " __VERSION__
#endif

struct bench_options {
    const char *scene, *isa, *map;
    bool csv, contact, quiet;
};

static void print_usage(FILE *out)
{
    fputs("usage: footpoint-bench [--scene NAME] [--csv] [--isa NAME] [--map FOLDER] [--contact] [--quiet]\n"
          "Speed against error of every search, on held-out samples.\n"
          "  --scene NAME   a scene of evolve/scenes, or a path; default: all of evolve/scenes\n"
          "  --csv          comma-separated values\n"
          "  --isa NAME     run the methods as compiled for x86-64, x86-64-v3 (AVX2, FMA) or x86-64-v4 (AVX-512);\n"
          "                 default: the best that this machine has\n"
          "  --map FOLDER   errors of our functions over the segment, FOLDER/SCENE-FUNCTION.vtk\n"
          "  --contact      instead: contact or not, and how deep, by the pinball test; comma-separated values\n"
          "  --quiet        say nothing while working: otherwise, beside --csv, which scene is done and what is left\n"
          "  --help         this text\n"
          "  --version      version\n",
          out);
}

static void print_csv(const struct scene *scene, const char *sample, const struct bench_table *table,
                      const struct bench_result *r, int mode)
{
    printf(
        "%s,%s,%s,%d,%s,%ld,%ld,%ld,%ld,%.2f,%.2f,%.3e,%.3e,%.3e,%.3e,%.3e,%.3e,%zu,%.3e,%.3e,%.3e,%.2f,%.4f,%s,%s\n",
        scene->name, sample, r->method->name, r->method->ours, bench_mode_name[mode], r->ops.mul, r->ops.div,
        r->ops.add, r->ops.sqrt, r->ns[mode], r->ratio[mode], r->xi.mean, r->xi.p99, r->xi.max, r->eta.mean, r->eta.p99,
        r->eta.max, r->xi.failures, r->gap.mean, r->gap.p99, r->gap.max, r->ns_min[mode], r->noise[mode], table->isa,
        COMPILER);
}

static void print_table(const struct scene *scene, const char *sample, const struct bench_result *r, int mode)
{
    printf("%-14s %-6s %c %-34s %-6s %4ld %3ld %4ld %4ld %7.2f %7.2f %6.2f %5.1f %8.1e %8.1e %8.1e %8.1e %8.1e %8.1e "
           "%8.1e %8.1e %8.1e %8zu\n",
           scene->name, sample, r->method->ours ? '*' : ' ', r->method->name, bench_mode_name[mode], r->ops.mul,
           r->ops.div, r->ops.add, r->ops.sqrt, r->ns_min[mode], r->ns[mode], r->ratio[mode], 100 * r->noise[mode],
           r->xi.mean, r->xi.p99, r->xi.max, r->eta.mean, r->eta.p99, r->eta.max, r->gap.mean, r->gap.p99, r->gap.max,
           r->xi.failures);
}

/* Once, before the first row: a scene that cannot be read leaves nothing on standard output. */
static void print_head(bool csv, const struct bench_table *table)
{
    static bool done;
    if (done)
        return;
    done = true;
    if (csv) {
        puts("scene,sample,method,ours,mode,mul,div,add,sqrt,ns,ratio,mean_xi,p99_xi,max_xi,mean_eta,p99_eta,max_eta,"
             "failures,mean_gap,p99_gap,max_gap,ns_min,noise,isa,compiler");
        return;
    }
    printf(
        "footpoint-bench " FOOTPOINT_VERSION ", all methods compiled by " COMPILER " %s\n"
        "*: ours; ns: of one search, least and median; ratio: converged Newton's median in the same mode over this "
        "one's;\nnoise: per cent, half of the interquartile range of the ratio over the rounds; gap: over the square "
        "root of the segment's area;\npinball finds no xi, eta: --contact\n\n",
        table->flags);
    printf("%-14s %-6s   %-34s %-6s %4s %3s %4s %4s %7s %7s %6s %5s %8s %8s %8s %8s %8s %8s %8s %8s %8s %8s\n", "scene",
           "sample", "method", "mode", "mul", "div", "add", "sqrt", "ns_min", "ns", "ratio", "noise", "mean_xi",
           "p99_xi", "max_xi", "mean_eta", "p99_eta", "max_eta", "mean_gap", "p99_gap", "max_gap", "failures");
}

/* Every method on one part of a scene's samples; maps only where `map` is a folder. */
static bool bench_part(const struct bench_options *o, const struct bench_table *table, const struct scene *scene,
                       const struct sample_set *training, enum sample_part part, const char *map, struct diag *d)
{
    struct sample_set set = {0};
    /* Of a scene that is random anyway, what is held out is off any grid. */
    const char *sample = part == PART_HELDOUT && scene->source != SOURCE_RANDOM ? "grid" : "random";
    bool done = scene_samples(scene, part, &set, d);
    if (done) {
        struct bench_run run = bench_measure(table, scene, training, &set);
        print_head(o->csv, table);
        for (int i = 0; i < run.count; i++)
            for (int mode = 0; mode < BENCH_MODES; mode++)
                if (mode == BENCH_BATCH && !run.result[i].method->batch)
                    continue;
                else if (o->csv)
                    print_csv(scene, sample, table, &run.result[i], mode);
                else
                    print_table(scene, sample, &run.result[i], mode);
        done = !map || bench_map_write(map, scene, &run, &set, d);
        bench_run_free(&run);
    }
    sample_set_free(&set);
    return done;
}

static bool bench_scene(const struct bench_options *o, const struct bench_table *table, const char *name,
                        struct diag *d)
{
    struct scene *scene = scene_read(root_default(), name, d);
    struct sample_set training = {0};
    if (!scene)
        return false;
    if (o->contact) {
        const bool decided = contact_table(scene, d);
        scene_free(scene);
        return decided;
    }
    bool done = scene_samples(scene, PART_TRAINING, &training, d);
    if (scene->source != SOURCE_RANDOM)
        done = done && bench_part(o, table, scene, &training, PART_HELDOUT, NULL, d) &&
               bench_part(o, table, scene, &training, PART_HELDOUT_RANDOM, o->map, d);
    else
        done = done && bench_part(o, table, scene, &training, PART_HELDOUT, o->map, d);
    sample_set_free(&training);
    scene_free(scene);
    return done;
}

/* Scenes in float: all methods here are in double. */
static bool is_float(const char *path)
{
    struct diag d;
    struct scene *scene = scene_read(root_default(), path, &d);
    const bool single = scene && strcmp(scene->precision, "float") == 0;
    scene_free(scene);
    return single;
}

/* Scene i of those in `steps`, told on stderr where the table is not. */
static bool bench_step(const struct bench_options *o, const struct bench_table *table, struct steps *steps, size_t i,
                       const char *name, struct diag *d)
{
    const char *slash = strrchr(name, '/');
    char what[200];
    snprintf(what, sizeof what, "bench: %.150s, %zu of %zu", slash ? slash + 1 : name, i + 1, steps->total);
    steps_show(steps, i, what);
    const bool done = (!o->scene && is_float(name)) || bench_scene(o, table, name, d);
    if (done)
        steps_log(steps, what);
    return done;
}

static bool bench_all(const struct bench_options *o, const struct bench_table *table, struct diag *d)
{
    char pattern[1024];
    glob_t found;
    bool done = true;
    snprintf(pattern, sizeof pattern, "%s/evolve/scenes/*.scene", root_default());
    if (glob(pattern, 0, NULL, &found) != 0)
        return diag_at(d, "evolve/scenes", 0, 0, "no scene here; run from the root of the source, or name one");
    struct steps steps = steps_start(o->csv && !o->quiet, found.gl_pathc);
    for (size_t i = 0; done && i < found.gl_pathc; i++)
        done = bench_step(o, table, &steps, i, found.gl_pathv[i], d);
    steps_end(&steps);
    globfree(&found);
    return done;
}

static bool bench_one(const struct bench_options *o, const struct bench_table *table, struct diag *d)
{
    struct steps steps = steps_start(o->csv && !o->quiet, 1);
    const bool done = bench_step(o, table, &steps, 0, o->scene, d);
    steps_end(&steps);
    return done;
}

int main(int argc, char **argv)
{
    static const struct option options[] = {{"scene", required_argument, NULL, 's'},
                                            {"csv", no_argument, NULL, 'c'},
                                            {"contact", no_argument, NULL, 'p'},
                                            {"isa", required_argument, NULL, 'i'},
                                            {"map", required_argument, NULL, 'm'},
                                            {"quiet", no_argument, NULL, 'q'},
                                            {"help", no_argument, NULL, 'h'},
                                            {"version", no_argument, NULL, 'v'},
                                            {NULL, 0, NULL, 0}};
    struct bench_options o = {0};
    struct diag d;
    for (int option; (option = getopt_long(argc, argv, "", options, NULL)) != -1;)
        switch (option) {
        case 's':
            o.scene = optarg;
            break;
        case 'c':
            o.csv = true;
            break;
        case 'p':
            o.contact = true;
            break;
        case 'i':
            o.isa = optarg;
            break;
        case 'm':
            o.map = optarg;
            break;
        case 'q':
            o.quiet = true;
            break;
        case 'h':
            print_usage(stdout);
            return exit_status(true, &d);
        case 'v':
            printf("footpoint-bench %s\n", FOOTPOINT_VERSION);
            return exit_status(true, &d);
        default:
            return EXIT_USAGE;
        }
    if (optind < argc) {
        fprintf(stderr, "footpoint-bench: unexpected argument '%s'\n", argv[optind]);
        return EXIT_USAGE;
    }
    const struct bench_table *table = bench_table_for(o.isa);
    if (!table) {
        fprintf(stderr, "footpoint-bench: error: no methods for '%s' here\n", o.isa);
        return EXIT_USAGE;
    }
    if (o.contact)
        puts(contact_table_head);
    return exit_status(o.scene ? bench_one(&o, table, &d) : bench_all(&o, table, &d), &d);
}
