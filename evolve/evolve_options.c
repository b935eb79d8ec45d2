/* Command line of footpoint-evolve: long options only, each checked. */
#include "evolve_options.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

const char evolve_help[] =
    "usage: footpoint-evolve --scene NAME [options]\n"
    "Evolve expressions for the foot point of a scene's segments; alone or under mpirun.\n"
    "\n"
    "  --scene NAME|FILE           what to evolve for: evolve/scenes/NAME.scene, or a file\n"
    "  --root DIR                  folder that holds evolve/ (default: .)\n"
    "  --start FILE                genomes to start from (default: evolve/genomes/NAME.gen, where there is one)\n"
    "  --from-scratch              start from random expressions alone\n"
    "  -o, --output FILE           genomes to write (default: evolve/genomes/NAME.gen)\n"
    "  --generations N             0: only measure and write (default: 200)\n"
    "  --seed N                    same seed, same result on any number of processes (default: 1)\n"
    "  --islands N                 islands for each output of each tier (default: 2)\n"
    "  --population N              individuals of an island (default: 200)\n"
    "  --max-length N              genes of an expression (default: as the tier says)\n"
    "  --functions polynomial|rational\n"
    "                              + - * or + - * and protected division (default: as the tier says)\n"
    "  --selection roulette|tournament\n"
    "                              of parents: on 1/error, or the best of 4 (default: tournament)\n"
    "  --parsimony X               what an operation costs, as a fraction of the error (default: 0.005)\n"
    "  --migrate-every N           generations between migrations (default: 10)\n"
    "  --migrate-fraction X        part of a population that migrates (default: 0.1)\n"
    "  --preset paper              the paper's run: 3000 generations on 5 islands of 200, roulette, no parsimony;\n"
    "                              options given beside it still count\n"
    "  --quiet                     no progress and no log, the table of changes alone\n"
    "  --benchmark                 speed of the evaluator as CSV: engine,precision,bits,genes_samples_per_s\n"
    "  --help, --version\n"
    "\n"
    "Exit status: 0 done, 1 input rejected, 2 wrong usage, 3 out of memory or unreadable or unwritable file.\n";

static const struct evolve_options standard = {.root = ".",
                                               .seed = 1,
                                               .generations = 200,
                                               .islands = 2,
                                               .population = 200,
                                               .selection = SELECT_TOURNAMENT,
                                               .parsimony = 0.005,
                                               .migrate_every = 10,
                                               .migrate_fraction = 0.1};

enum option_code {
    OPT_SCENE = 256,
    OPT_ROOT,
    OPT_START,
    OPT_FROM_SCRATCH,
    OPT_GENERATIONS,
    OPT_SEED,
    OPT_ISLANDS,
    OPT_POPULATION,
    OPT_MAX_LENGTH,
    OPT_FUNCTIONS,
    OPT_SELECTION,
    OPT_PARSIMONY,
    OPT_MIGRATE_EVERY,
    OPT_MIGRATE_FRACTION,
    OPT_PRESET,
    OPT_QUIET,
    OPT_BENCHMARK,
    OPT_HELP,
    OPT_VERSION
};

static const struct option options[] = {{"scene", required_argument, NULL, OPT_SCENE},
                                        {"root", required_argument, NULL, OPT_ROOT},
                                        {"start", required_argument, NULL, OPT_START},
                                        {"from-scratch", no_argument, NULL, OPT_FROM_SCRATCH},
                                        {"output", required_argument, NULL, 'o'},
                                        {"generations", required_argument, NULL, OPT_GENERATIONS},
                                        {"seed", required_argument, NULL, OPT_SEED},
                                        {"islands", required_argument, NULL, OPT_ISLANDS},
                                        {"population", required_argument, NULL, OPT_POPULATION},
                                        {"max-length", required_argument, NULL, OPT_MAX_LENGTH},
                                        {"functions", required_argument, NULL, OPT_FUNCTIONS},
                                        {"selection", required_argument, NULL, OPT_SELECTION},
                                        {"parsimony", required_argument, NULL, OPT_PARSIMONY},
                                        {"migrate-every", required_argument, NULL, OPT_MIGRATE_EVERY},
                                        {"migrate-fraction", required_argument, NULL, OPT_MIGRATE_FRACTION},
                                        {"preset", required_argument, NULL, OPT_PRESET},
                                        {"quiet", no_argument, NULL, OPT_QUIET},
                                        {"benchmark", no_argument, NULL, OPT_BENCHMARK},
                                        {"help", no_argument, NULL, OPT_HELP},
                                        {"version", no_argument, NULL, OPT_VERSION},
                                        {NULL, 0, NULL, 0}};

static bool usage(struct diag *d, const char *format, const char *option, const char *argument)
{
    diag_at(d, "footpoint-evolve", 0, 0, format, option, argument);
    d->code = EXIT_USAGE;
    return false;
}

static bool read_whole(const char *option, const char *text, uint64_t low, uint64_t high, uint64_t *value,
                       struct diag *d)
{
    char *rest;
    errno = 0;
    *value = strtoull(text, &rest, 10);
    if (!isdigit((unsigned char)text[0]) || *rest || errno)
        return usage(d, "--%s needs a whole number, not '%s'", option, text);
    return (*value >= low && *value <= high) || usage(d, "--%s %s is out of range", option, text);
}

static bool read_size(const char *option, const char *text, size_t low, size_t high, size_t *value, struct diag *d)
{
    uint64_t v;
    const bool good = read_whole(option, text, low, high, &v, d);
    *value = (size_t)v;
    return good;
}

static bool read_fraction(const char *option, const char *text, double *value, struct diag *d)
{
    char *rest;
    *value = strtod(text, &rest);
    if (rest == text || *rest)
        return usage(d, "--%s needs a number, not '%s'", option, text);
    return (*value >= 0 && *value <= 0.5) || usage(d, "--%s %s is out of range (0 to 0.5)", option, text);
}

/* Index of text in choice[], or an error. */
static bool read_choice(const char *option, const char *text, const char *const choice[2], int *index, struct diag *d)
{
    for (*index = 0; *index < 2; ++*index)
        if (choice[*index] && strcmp(text, choice[*index]) == 0)
            return true;
    return usage(d, "--%s knows no '%s'", option, text);
}

static bool read_option(int code, const char *name, const char *text, struct evolve_options *o, struct diag *d)
{
    int index;
    switch (code) {
    case OPT_SCENE:
        o->scene = text;
        return true;
    case OPT_ROOT:
        o->root = text;
        return true;
    case OPT_START:
        o->start = text;
        return true;
    case OPT_FROM_SCRATCH:
        return o->from_scratch = true;
    case 'o':
        o->output = text;
        return true;
    case OPT_GENERATIONS:
        return read_size(name, text, 0, 100000000, &o->generations, d);
    case OPT_SEED:
        return read_whole(name, text, 0, UINT64_MAX, &o->seed, d);
    case OPT_ISLANDS:
        return read_size(name, text, 1, 10000, &o->islands, d);
    case OPT_POPULATION:
        return read_size(name, text, 2, 1000000, &o->population, d);
    case OPT_MAX_LENGTH:
        return read_size(name, text, 1, 10000, &o->max_length, d);
    case OPT_FUNCTIONS:
        if (!read_choice(name, text, (const char *const[]){"polynomial", "rational"}, &index, d))
            return false;
        o->functions = index == 0 ? FUNCTIONS_POLYNOMIAL : FUNCTIONS_RATIONAL;
        return true;
    case OPT_SELECTION:
        if (!read_choice(name, text, (const char *const[]){"roulette", "tournament"}, &index, d))
            return false;
        o->selection = index == 0 ? SELECT_ROULETTE : SELECT_TOURNAMENT;
        return true;
    case OPT_PARSIMONY:
        return read_fraction(name, text, &o->parsimony, d);
    case OPT_MIGRATE_EVERY:
        return read_size(name, text, 1, 100000000, &o->migrate_every, d);
    case OPT_MIGRATE_FRACTION:
        return read_fraction(name, text, &o->migrate_fraction, d);
    case OPT_PRESET:
        return read_choice(name, text, (const char *const[2]){"paper"}, &index, d);
    case OPT_QUIET:
        return o->quiet = true;
    case OPT_BENCHMARK:
        o->action = ACTION_BENCHMARK;
        return true;
    case OPT_HELP:
        o->action = ACTION_HELP;
        return true;
    default:
        o->action = ACTION_VERSION;
        return true;
    }
}

static const char *option_name(int code)
{
    const struct option *p = options;
    while (p->name && p->val != code)
        p++;
    return p->name;
}

/* One pass over the command line; *preset tells whether --preset occurred. */
static bool read_all(int argc, char **argv, struct evolve_options *o, bool *preset, struct diag *d)
{
    int code;
    opterr = 0;
    optind = 0; /* GNU: start anew */
    while ((code = getopt_long(argc, argv, "+:o:", options, NULL)) != -1) {
        if (code == ':')
            return usage(d, "%s needs an argument%s", argv[optind - 1], "");
        if (code == '?')
            return usage(d, "unknown option '%s'%s", argv[optind - 1], "; see --help");
        if (!read_option(code, option_name(code), optarg, o, d))
            return false;
        *preset = *preset || code == OPT_PRESET;
    }
    return optind == argc || usage(d, "'%s' is no option%s", argv[optind], "; see --help");
}

bool evolve_options_read(int argc, char **argv, struct evolve_options *o, struct diag *d)
{
    bool preset = false;
    *o = standard;
    if (!read_all(argc, argv, o, &preset, d))
        return false;
    if (preset) { /* whatever is given beside it counts: read again over the preset's values */
        *o = standard;
        o->paper = true;
        o->generations = 3000;
        o->islands = 5;
        o->selection = SELECT_ROULETTE;
        o->parsimony = 0;
        read_all(argc, argv, o, &preset, d);
    }
    if (o->action == ACTION_EVOLVE && !o->scene)
        return usage(d, "--scene is missing%s%s", "", "; see --help");
    if (o->start && o->from_scratch)
        return usage(d, "--start and --from-scratch exclude each other%s%s", "", "");
    return true;
}
