/* footpoint-bench: speed against error of every search, bare and as callers use it, on the same held-out samples of a
 * scene.
 *
 * Errors are measured against certain answers. Mode "chain" is dependent calls, "scalar" independent calls, "batch" a
 * loop over columns of coordinates, which compilers may vectorise. All methods are compiled alike, for several
 * instruction sets; the best that the machine supports is used. */
#include "../../codegen/base/console.h"
#include "../../codegen/base/options.h"
#include "../../evolve/common/data_root.h"
#include "../../evolve/samples/samples.h"
#include "../rivals/contact_table.h"
#include "bench_map.h"
#include "bench_measure.h"
#include "bench_print.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>

struct bench_options {
    const char *scene, *isa, *map;
    bool all, csv, contact, quiet, validation;
    size_t rounds;
};

#define AT(member) offsetof(struct bench_options, member)
static const struct option_row rows[] = {
    {"scene", 0, OPTION_TEXT, AT(scene), "NAME",
     .help = "a scene of evolve/scenes, or a path (default: all of evolve/scenes)"},
    {"all", 0, OPTION_FLAG, AT(all),
     .help = "every method on all held-out samples; otherwise of bare searches the front alone: what no other method "
             "leaves behind in time and error, in calls, dependent or not, or over arrays"},
    {"csv", 0, OPTION_FLAG, AT(csv), .help = "comma-separated values"},
    {"validation", 0, OPTION_FLAG, AT(validation), .help = "on validation samples instead, to choose functions by"},
    {"isa", 0, OPTION_TEXT, AT(isa), "NAME",
     .help = "run the methods as compiled for x86-64, x86-64-v3 (AVX2, FMA) or x86-64-v4 (AVX-512) (default: the best "
             "that this machine has)"},
    {"map", 0, OPTION_TEXT, AT(map), "FOLDER",
     .help = "errors of our functions over the segment, FOLDER/SCENE-FUNCTION.vtk"},
    {"rounds", 0, OPTION_WHOLE, AT(rounds), "N", 1, BENCH_ROUNDS,
     .help = "turns that each method takes; fewer are done sooner, with more noise (default: 41)"},
    {"contact", 0, OPTION_FLAG, AT(contact),
     .help = "instead: contact or not, and how deep, by the pinball test; comma-separated values"},
    {"quiet", 0, OPTION_FLAG, AT(quiet),
     .help = "say nothing while working: otherwise, but for --all, which scene is done and what is left"}};
static const struct option_table options = {
    .program = "footpoint-bench",
    .usage = "usage: footpoint-bench [--scene NAME] [--all] [--csv] [--isa "
             "NAME] [--map FOLDER] [--rounds N] [--contact] [--validation] [--quiet]\n"
             "Speed against error of every search, on held-out samples.\n",
    .row = rows,
    .rows = sizeof rows / sizeof *rows,
    .surplus = "unexpected argument '%s'"};

/* Runs every method on one part of a scene's samples; writes maps only if `map` names a folder. */
static bool bench_part(const struct bench_options *o, const struct bench_table *table, const struct scene *scene,
                       const struct sample_set *training, enum sample_part part, const char *map, struct diag *d)
{
    struct sample_set set = {0};
    /* In random scenes, held-out samples are off any grid. */
    const char *sample = part == PART_VALIDATION                                  ? "validation"
                         : part == PART_HELDOUT && scene->source != SOURCE_RANDOM ? "grid"
                                                                                  : "random";
    bool done = scene_samples(scene, part, &set, d);
    if (done) {
        struct bench_run run = bench_measure(table, scene, training, &set, o->rounds);
        if (o->csv)
            bench_print_csv(scene, sample, table, &run);
        else if (o->all)
            bench_print_all(scene, sample, table, &run);
        else
            bench_print_front(scene, table, &run);
        done = !map || bench_map_write(map, scene, &run, d);
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
    scene->heldout = scene->heldout < 200000 ? scene->heldout : 200000; /* they are stored */
    if (o->contact) {
        const bool decided = contact_table(scene, d);
        scene_free(scene);
        return decided;
    }
    bool done = scene_samples(scene, PART_TRAINING, &training, d);
    if (o->validation)
        done = done && bench_part(o, table, scene, &training, PART_VALIDATION, NULL, d);
    else if (scene_has(scene, PART_HELDOUT_RANDOM) && scene->source != SOURCE_RANDOM)
        done = done && (!(o->all || o->csv) || bench_part(o, table, scene, &training, PART_HELDOUT, NULL, d)) &&
               bench_part(o, table, scene, &training, PART_HELDOUT_RANDOM, o->map, d);
    else
        done = done && bench_part(o, table, scene, &training, PART_HELDOUT, o->map, d);
    sample_set_free(&training);
    scene_free(scene);
    return done;
}

/* Returns true for scenes in float, which are skipped: all methods here are in double. */
static bool is_float(const char *path)
{
    struct diag d;
    struct scene *scene = scene_read(root_default(), path, &d);
    const bool single = scene && strcmp(scene->precision, "float") == 0;
    scene_free(scene);
    return single;
}

/* Runs scene i of `steps`, and reports progress on stderr if the table goes elsewhere. */
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

/* Returns true if progress goes to stderr: not beside a table that is printed line by line. */
static bool is_telling(const struct bench_options *o)
{
    return !o->quiet && !o->contact && (o->csv || !o->all);
}

static bool bench_all(const struct bench_options *o, const struct bench_table *table, struct diag *d)
{
    char pattern[1024];
    glob_t found;
    bool done = true;
    snprintf(pattern, sizeof pattern, "%s/evolve/scenes/*.scene", root_default());
    if (glob(pattern, 0, NULL, &found) != 0)
        return diag_at(d, "evolve/scenes", 0, 0, "no scene here; run from the root of the source, or name one");
    struct steps steps = steps_start(is_telling(o), found.gl_pathc);
    for (size_t i = 0; done && i < found.gl_pathc; i++)
        done = bench_step(o, table, &steps, i, found.gl_pathv[i], d);
    steps_end(&steps);
    globfree(&found);
    return done;
}

static bool bench_one(const struct bench_options *o, const struct bench_table *table, struct diag *d)
{
    struct steps steps = steps_start(is_telling(o), 1);
    const bool done = bench_step(o, table, &steps, 0, o->scene, d);
    steps_end(&steps);
    return done;
}

int main(int argc, char **argv)
{
    struct bench_options o = {.rounds = BENCH_ROUNDS};
    struct diag d;
    const enum options_outcome outcome = options_read(&options, argc, argv, &o, NULL, &d);
    if (outcome != OPTIONS_READ)
        return options_end(&options, outcome, &d);
    const struct bench_table *table = bench_table_for(o.isa);
    if (!table) {
        fprintf(stderr, "footpoint-bench: error: no methods for '%s' here\n", o.isa);
        return EXIT_USAGE;
    }
    if (o.contact)
        puts(contact_table_head);
    return exit_status(o.scene ? bench_one(&o, table, &d) : bench_all(&o, table, &d), &d);
}
