/* Command line of footpoint-pga: long options only, each checked. */
#include "pga_options.h"

#include <ctype.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

const char pga_help[] =
    "usage: footpoint-pga --scene NAME -o FILE [options]\n"
    "Search polynomials for xi and eta of a scene by the genetic algorithm of Oishi and Yoshimura (2008), sections "
    "3.2\n"
    "and 5.2; alone or under mpirun, where rank 0 breeds and all ranks evaluate.\n"
    "\n"
    "  --scene NAME|FILE    evolve/scenes/NAME.scene, or a file; a tier's terminals are the polynomials' variables\n"
    "  --tier NAME          which tier (default: the first)\n"
    "  --root DIR           folder that holds evolve/ (default: .)\n"
    "  -o, --output FILE    genome to write\n"
    "  --name NAME          of the genome (default: pga)\n"
    "  --order N            of the polynomials, 1 to 4 (default: 3)\n"
    "  --generations N      (default: 3000)\n"
    "  --population N       individuals (default: 100)\n"
    "  --restrict N[,N...]  terms above which equation (40) punishes, 0: no restriction (default); a search for each, "
    "a\n"
    "                       genome NAME_N for each if there are several\n"
    "  --crossover X        part of the pairs that exchange a range of genes (default: 0.7)\n"
    "  --mutation X         part of the individuals of which a gene is changed (default: 0.3)\n"
    "  --seed N             same seed, same result on any number of processes (default: 1)\n"
    "  --log FILE           CSV, a line for each output and generation\n"
    "  --quiet              no times on stderr\n"
    "  --help, --version\n"
    "\n"
    "Beyond the paper:\n"
    "  --exchange           improve each new best by exchanging terms, forward and backward\n"
    "  --terms FILE         no search: the terms of this file, a line \"xi = yd, xs, xc ys, 1\" for each output\n"
    "  --coefficients squares|mean|worst\n"
    "                       what the coefficients of what is written minimise: the squares of the errors, their mean, "
    "or\n"
    "                       the largest (default: squares)\n"
    "\n"
    "Exit status: 0 done; 1 input rejected; 2 wrong usage; 3 out of memory or unreadable or unwritable file.\n";

static bool usage(struct diag *d, const char *format, const char *option, const char *argument)
{
    diag_at(d, "footpoint-pga", 0, 0, format, option, argument);
    d->code = EXIT_USAGE;
    return false;
}

static bool read_whole(const char *name, const char *text, size_t low, size_t high, size_t *value, struct diag *d)
{
    unsigned long long v;
    if (!text_whole(text, &v))
        return usage(d, "--%s needs a whole number, not '%s'", name, text);
    *value = (size_t)v;
    return (v >= low && v <= high) || usage(d, "--%s %s is out of range", name, text);
}

static bool read_part(const char *name, const char *text, double *value, struct diag *d)
{
    char *rest;
    *value = strtod(text, &rest);
    if (rest == text || *rest)
        return usage(d, "--%s needs a number, not '%s'", name, text);
    return (*value >= 0 && *value <= 1) || usage(d, "--%s %s is out of range (0 to 1)", name, text);
}

static bool read_limits(const char *text, struct pga_options *o, struct diag *d)
{
    char list[200], *rest;
    snprintf(list, sizeof list, "%s", text);
    o->limits = 0;
    for (char *one = strtok_r(list, ",", &rest); one; one = strtok_r(NULL, ",", &rest)) {
        if (o->limits == PGA_LIMITS)
            return usage(d, "--%s %s has too many numbers", "restrict", text);
        if (!read_whole("restrict", one, 0, 100000, &o->limit[o->limits++], d))
            return false;
    }
    return (o->limits > 0 && strlen(text) < sizeof list) ||
           usage(d, "--%s needs whole numbers, not '%s'", "restrict", text);
}

static bool read_coefficients(const char *text, enum coefficients *value, struct diag *d)
{
    static const char *const name[] = {"squares", "mean", "worst", NULL};
    const int word = text_word(text, name);
    *value = (enum coefficients)word;
    return word >= 0 || usage(d, "--%s knows no '%s'", "coefficients", text);
}

/* As genome text has it. */
static bool read_name(const char *text, const char **value, struct diag *d)
{
    *value = text;
    bool good = isalpha((unsigned char)text[0]) && strlen(text) < 60;
    for (const char *c = text; *c; c++)
        good = good && (isalnum((unsigned char)*c) || *c == '_');
    return good || usage(d, "--%s needs letters, digits and _, not '%s'", "name", text);
}

enum {
    SCENE = 256,
    TIER,
    ROOT,
    NAME,
    ORDER,
    GENERATIONS,
    POPULATION,
    RESTRICT,
    CROSSOVER,
    MUTATION,
    SEED,
    LOG,
    QUIET,
    EXCHANGE,
    TERMS,
    COEFFICIENTS,
    HELP,
    VERSION
};
static const struct option options[] = {{"scene", required_argument, NULL, SCENE},
                                        {"tier", required_argument, NULL, TIER},
                                        {"root", required_argument, NULL, ROOT},
                                        {"output", required_argument, NULL, 'o'},
                                        {"name", required_argument, NULL, NAME},
                                        {"order", required_argument, NULL, ORDER},
                                        {"generations", required_argument, NULL, GENERATIONS},
                                        {"population", required_argument, NULL, POPULATION},
                                        {"restrict", required_argument, NULL, RESTRICT},
                                        {"crossover", required_argument, NULL, CROSSOVER},
                                        {"mutation", required_argument, NULL, MUTATION},
                                        {"seed", required_argument, NULL, SEED},
                                        {"log", required_argument, NULL, LOG},
                                        {"quiet", no_argument, NULL, QUIET},
                                        {"exchange", no_argument, NULL, EXCHANGE},
                                        {"terms", required_argument, NULL, TERMS},
                                        {"coefficients", required_argument, NULL, COEFFICIENTS},
                                        {"help", no_argument, NULL, HELP},
                                        {"version", no_argument, NULL, VERSION},
                                        {NULL, 0, NULL, 0}};

static bool read_option(int code, const char *text, struct pga_options *o, struct diag *d)
{
    size_t seed;
    switch (code) {
    case SCENE:
        o->scene = text;
        return true;
    case TIER:
        o->tier = text;
        return true;
    case ROOT:
        o->root = text;
        return true;
    case 'o':
        o->output = text;
        return true;
    case NAME:
        return read_name(text, &o->name, d);
    case LOG:
        o->log = text;
        return true;
    case ORDER:
        return read_whole("order", text, 1, MONOMIAL_DEGREE, &o->order, d);
    case GENERATIONS:
        return read_whole("generations", text, 0, 100000000, &o->generations, d);
    case POPULATION:
        return read_whole("population", text, 2, 100000, &o->plan.population, d);
    case RESTRICT:
        return read_limits(text, o, d);
    case CROSSOVER:
        return read_part("crossover", text, &o->plan.crossover, d);
    case MUTATION:
        return read_part("mutation", text, &o->plan.mutation, d);
    case SEED:
        if (!read_whole("seed", text, 0, SIZE_MAX, &seed, d))
            return false;
        o->plan.seed = seed;
        return true;
    case QUIET:
        return o->quiet = true;
    case EXCHANGE:
        return o->plan.exchange = true;
    case TERMS:
        o->terms = text;
        return true;
    case COEFFICIENTS:
        return read_coefficients(text, &o->coefficients, d);
    default:
        o->action = code == HELP ? PGA_HELP : PGA_VERSION;
        return true;
    }
}

bool pga_options_read(int argc, char **argv, struct pga_options *o, struct diag *d)
{
    *o = (struct pga_options){
        .root = ".", .name = "pga", .order = 3, .generations = 3000, .limits = 1, .plan = pga_plan_default()};
    opterr = 0;
    optind = 0; /* GNU: start anew */
    for (int code; (code = getopt_long(argc, argv, "+:o:", options, NULL)) != -1;) {
        if (code == ':')
            return usage(d, "%s needs an argument%s", argv[optind - 1], "");
        if (code == '?')
            return usage(d, "unknown option '%s'%s", argv[optind - 1], "; see --help");
        if (!read_option(code, optarg, o, d))
            return false;
    }
    if (optind < argc)
        return usage(d, "'%s' is no option%s", argv[optind], "; see --help");
    if (o->action == PGA_SEARCH && (!o->scene || !o->output))
        return usage(d, "--%s is missing%s", o->scene ? "output" : "scene", "; see --help");
    return true;
}
