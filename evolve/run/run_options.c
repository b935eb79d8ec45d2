/* Command line of footpoint-evolve, long options only, and the options that a checkpoint stores. */
#include "run_options.h"

#include "../common/data_root.h"
#include "../write/archive_write.h"

#include <string.h>

static const struct evolve_options standard = {.root = ".",
                                               .seed = 1,
                                               .generations = 200,
                                               .islands = 2,
                                               .population = 200,
                                               .breeding = BREED_FRONT,
                                               .selection = SELECT_TOURNAMENT,
                                               .parsimony = 0.005,
                                               .migrate_every = 10,
                                               .migrate_fraction = 0.1,
                                               .log_every = 1,
                                               .checkpoint_every = 600};

/* How a checkpoint treats an option: not stored; stored, but replaced if given anew; stored and fixed. */
enum role { PASSING, KEPT, FIXED };

static const char *const functions[] = {"tier", "polynomial", "rational", NULL};
static const char *const breedings[] = {"paper", "front", NULL};
static const char *const costs[] = {"throughput", "paper", NULL};
static const char *const selections[] = {"roulette", "tournament", NULL};
static const char *const topologies[] = {"ring", "torus", "random", "none", NULL};
static const char *const presets[] = {"paper", NULL};

static bool read_kind(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                      struct diag *d)
{
    const struct segment_kind *kind = segment_find(text);
    ((struct evolve_options *)values)->print_scene = kind;
    return kind || options_refuse(t, d, "error: --%s: unknown segment '%s'", r->name, text);
}

#define AT(member) offsetof(struct evolve_options, member)
static const struct option_row rows[] = {
    {"scene", 0, OPTION_TEXT, AT(scene), "NAME|FILE", .role = KEPT,
     .help = "what to evolve for: evolve/scenes/NAME.scene, or a file"},
    {"root", 0, OPTION_TEXT, AT(root), "DIR", .role = KEPT,
     .help = "folder that holds evolve/ (default: ., or else what is installed)"},
    {"start", 0, OPTION_TEXT, AT(start), "FILE",
     .help = "genomes to start from (default: evolve/genomes/NAME.gen, or else the kind's, quad4.gen, say)"},
    {"from-scratch", 0, OPTION_FLAG, AT(from_scratch), .help = "start without them"},
    {"output", 'o', OPTION_TEXT, AT(output), "FILE", .role = KEPT,
     .help = "genomes to write (default: evolve/genomes/NAME.gen; NAME.gen here if that is installed)"},
    {"seeds", 0, OPTION_TEXT, AT(seeds), "FILE", .help = "more genomes to breed from"},
    {"front", 0, OPTION_TEXT, AT(front), "FILE", .role = KEPT,
     .help = "write all of the front of error against cost: a genome for each output and cost, or, where the name ends "
             "in .csv, a line for each"},
    {"members", 0, OPTION_WHOLE, AT(members), "N", 0, 1000, .role = KEPT,
     .help = "of each tier of programs on the front no more than N genomes: within its budget, each the best on "
             "validation samples of all that are no dearer (default: 0, all of the front)"},
    {"print-scene", 0, OPTION_OWN, AT(print_scene), "KIND", .read = read_kind,
     .help = "only print a scene of random faces of that kind, quad4, say, with every key explained"},
    {"page", 0, OPTION_TEXT, AT(page), "FILE", .role = KEPT,
     .help = "write a picture (SVG): errors by function and gap beside those of the kind of face, shapes of the faces"},
    {"samples", 0, OPTION_TEXT, AT(samples), "FILE",
     .help = "only write the samples held out, for codegen; with --start, those found by climbing, too"},
    {"generations", 0, OPTION_WHOLE, AT(generations), "N", 0, 100000000, .role = KEPT,
     .help = "0: only measure and write (default: 200)"},
    {"seed", 0, OPTION_SEED, AT(seed), "N", .role = FIXED,
     .help = "same seed, same result on any number of processes (default: 1)"},
    {"islands", 0, OPTION_WHOLE, AT(islands), "N", 1, 1000000, .role = FIXED,
     .help = "islands for each tier; for each output, of the paper's trees (default: 2)"},
    {"population", 0, OPTION_WHOLE, AT(population), "N", 2, 1000000, .role = FIXED,
     .help = "individuals of an island (default: 200)"},
    {"max-length", 0, OPTION_WHOLE, AT(max_length), "N", 0, 10000, .role = FIXED,
     .help = "operations of a program, genes of the paper's expressions (default: as the tier says)"},
    {"functions", 0, OPTION_CHOICE, AT(functions), .choice = functions, .role = FIXED,
     .help = "+ - * or + - * and division (default: as the tier says); tiers that list their functions keep them"},
    {"breeding", 0, OPTION_CHOICE, AT(breeding), .choice = breedings, .role = FIXED,
     .help =
         "programs towards the front of error against cost, numbers fitted, or the paper's pd-LinearGP, expressions "
         "of one output each (default: front)"},
    {"cost", 0, OPTION_CHOICE, AT(cost), .choice = costs, .role = FIXED,
     .help = "what operations cost: a product 1, a sum 1, a quotient 8; or 1, 0, 1 (default: throughput)"},
    {"selection", 0, OPTION_CHOICE, AT(selection), .choice = selections, .role = FIXED,
     .help = "of parents: on 1/error, or the best of 4 (default: tournament)"},
    {"parsimony", 0, OPTION_PART, AT(parsimony), "X", 0, 0.5, .role = FIXED,
     .help = "what an operation costs, as a fraction of the error (default: 0.005)"},
    {"topology", 0, OPTION_CHOICE, AT(topology), .choice = topologies, .role = FIXED,
     .help = "where migrants go: to the next island; along the rows and the columns of a grid in turn; along a circle "
             "drawn anew each time; nowhere (default: ring)"},
    {"migrate-every", 0, OPTION_WHOLE, AT(migrate_every), "N", 1, 100000000, .role = FIXED,
     .help = "generations between migrations (default: 10)"},
    {"migrate-fraction", 0, OPTION_PART, AT(migrate_fraction), "X", 0, 0.5, .role = FIXED,
     .help = "part of a population that migrates (default: 0.1)"},
    {"preset", 0, OPTION_CHOICE, AT(preset), .choice = presets,
     .help = "the paper's run: 3000 generations on 5 islands of 200, roulette, no parsimony, a tenth around the ring "
             "every 10 generations; options given beside it still count"},
    {"checkpoint", 0, OPTION_TEXT, AT(checkpoint), "FILE", .role = KEPT,
     .help = "keep the state of the run in FILE, and write it at the end as well"},
    {"checkpoint-every", 0, OPTION_TIME, AT(checkpoint_every), "TIME", .role = KEPT,
     .help = "seconds or H:MM:SS between checkpoints (default: 600)"},
    {"resume", 0, OPTION_TEXT, AT(resume), "FILE",
     .help = "go on from a checkpoint, on any number of processes, to the same bytes; its options count where none are "
             "given, and of them generations, time limit, files and log may be given anew"},
    {"time-limit", 0, OPTION_TIME, AT(time_limit), "TIME",
     .help = "seconds or H:MM:SS from the start, within which to end and write what was found"},
    {"log", 0, OPTION_TEXT, AT(log), "FILE", .role = KEPT, .help = "CSV, a line for each island and generation"},
    {"log-every", 0, OPTION_WHOLE, AT(log_every), "N", 1, 100000000, .role = KEPT,
     .help = "only each N-th generation (default: 1)"},
    {"quiet", 0, OPTION_FLAG, AT(quiet), .help = "no progress and no list of finds, the table of changes alone"},
    {"benchmark", 0, OPTION_FLAG, AT(benchmark), .help = "speed of the evaluator as CSV: engine,genes_samples_per_s"}};
enum { ROWS = sizeof rows / sizeof *rows };

const struct option_table evolve_option_table = {
    .program = "footpoint-evolve",
    .usage = "usage: footpoint-evolve --scene NAME [options]\n"
             "       footpoint-evolve --resume FILE [options]\n"
             "Evolve expressions for foot points; alone or under mpirun.\n",
    .notes = "SIGUSR1, SIGTERM and SIGINT (Ctrl-C) end a run some generations later with its checkpoint and the best "
             "genomes so\n"
             "far; a second SIGINT ends it at once.\n"
             "\n"
             "Exit status: 0 done, or the time was up (--time-limit, SIGUSR1); 1 input rejected; 2 wrong usage; 3 out "
             "of memory\n"
             "or unreadable or unwritable file; 130 SIGINT, 143 SIGTERM, with everything written.\n",
    .row = rows,
    .rows = ROWS};
static const struct option_table *const table = &evolve_option_table;

static bool is_given(const bool given[ROWS], const char *name)
{
    return given[option_find(table, name)];
}

static bool exclude(const bool given[ROWS], const char *one, const char *other, struct diag *d)
{
    return !is_given(given, one) || !is_given(given, other) ||
           options_refuse(table, d, "error: --%s and --%s exclude each other", one, other);
}

/* Returns false with *d filled if an option is given that a resumed run cannot change. */
static bool suits_resume(const bool given[ROWS], struct diag *d)
{
    return exclude(given, "resume", "samples", d) && exclude(given, "resume", "start", d) &&
           exclude(given, "resume", "from-scratch", d) && exclude(given, "resume", "seeds", d);
}

static bool consistent(const struct evolve_options *o, const bool given[ROWS], struct diag *d)
{
    if (!options_need(table, "scene", o->scene, d) || !exclude(given, "start", "from-scratch", d) ||
        !suits_resume(given, d))
        return false;
    if (is_given(given, "checkpoint-every") && !o->checkpoint)
        return options_refuse(table, d, "error: --checkpoint-every needs --checkpoint");
    if (is_given(given, "members") && !o->front)
        return options_refuse(table, d, "error: --members needs --front");
    if (is_given(given, "members") && o->members > 0 && archive_is_list(o->front))
        return options_refuse(table, d, "error: --members is of genomes, not of a list, %s", o->front);
    if (is_given(given, "log-every") && !o->log)
        return options_refuse(table, d, "error: --log-every needs --log");
    if (is_given(given, "time-limit") && !(o->time_limit > 0))
        return options_refuse(table, d, "error: --time-limit 0 is out of range");
    return true;
}

static void set_paper(struct evolve_options *o)
{
    o->generations = 3000;
    o->islands = 5;
    o->population = 200;
    o->breeding = BREED_PAPER;
    o->cost = COST_PAPER;
    o->selection = SELECT_ROULETTE;
    o->parsimony = 0;
    o->topology = TOPOLOGY_RING;
    o->migrate_every = 10;
    o->migrate_fraction = 0.1;
}

/* Reads the command line over `base`. A preset applies before the other options. */
static enum options_outcome read_over(int argc, char **argv, const struct evolve_options *base,
                                      struct evolve_options *o, bool given[ROWS], struct diag *d)
{
    *o = *base;
    const enum options_outcome outcome = options_read(table, argc, argv, o, given, d);
    if (outcome != OPTIONS_READ || !is_given(given, "preset"))
        return outcome;
    *o = *base;
    set_paper(o);
    return options_read(table, argc, argv, o, given, d);
}

enum options_outcome evolve_options_read(int argc, char **argv, struct evolve_options *o, struct diag *d)
{
    bool given[ROWS] = {false};
    struct evolve_options base = standard;
    base.root = root_default();
    const enum options_outcome outcome = read_over(argc, argv, &base, o, given, d);
    if (outcome != OPTIONS_READ || o->benchmark || o->print_scene)
        return outcome;
    /* A checkpoint may supply omitted options; they are checked after it is read. */
    const bool good = o->resume ? suits_resume(given, d) : consistent(o, given, d);
    return good ? OPTIONS_READ : OPTIONS_WRONG;
}

enum { VALUE = 1100 };

void evolve_options_facts(const struct evolve_options *o, char *text, size_t n)
{
    char value[VALUE];
    size_t used = strlen(text);
    for (size_t i = 0; i < ROWS; i++)
        if (rows[i].role != PASSING && option_text(&rows[i], o, value, sizeof value) && used < n)
            used += (size_t)snprintf(text + used, n - used, "%s %s\n", rows[i].name, value);
}

/* Reads a checkpoint's options and skips lines whose key is not an option. */
static bool read_facts(char *facts, struct evolve_options *o, struct diag *d)
{
    *o = standard;
    for (char *line = facts; *line;) {
        char *end = line + strcspn(line, "\n"), *next = end + (*end == '\n');
        char *space = line + strcspn(line, " \n");
        *end = '\0';
        if (*space == ' ') {
            *space = '\0';
            const size_t i = option_find(table, line);
            if (i < ROWS && rows[i].role != PASSING && !option_set(table, &rows[i], space + 1, o, d))
                return false;
        }
        line = next;
    }
    return true;
}

bool evolve_options_resume(int argc, char **argv, char *facts, struct evolve_options *o, struct diag *d)
{
    struct evolve_options base;
    bool given[ROWS] = {false};
    if (!read_facts(facts, &base, d) || read_over(argc, argv, &base, o, given, d) != OPTIONS_READ)
        return false;
    for (size_t i = 0; i < ROWS; i++) {
        char before[VALUE], now[VALUE];
        if (rows[i].role == FIXED && option_text(&rows[i], &base, before, sizeof before) &&
            option_text(&rows[i], o, now, sizeof now) && strcmp(before, now) != 0)
            return options_refuse(table, d, "error: --%s %s contradicts the checkpoint, which has %s", rows[i].name,
                                  now, before);
    }
    return consistent(o, given, d);
}
