/* Command line of footpoint-evolve: long options only, each checked; and the same options as the facts of a checkpoint.
 */
#include "run_options.h"

#include "../common/data_root.h"

#include <ctype.h>
#include <getopt.h>
#include <stdlib.h>
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

enum kind { TEXT, FLAG, WHOLE, SEED, FRACTION, TIME, CHOICE, ACTION, PRESET };
/* What an option is to a checkpoint: nothing; kept, but may be given anew; or part of what the result depends on. */
enum role { PASSING, KEPT, FIXED };

static const char *const functions[] = {"tier", "polynomial", "rational", NULL};
static const char *const breedings[] = {"paper", "front", NULL};
static const char *const growths[] = {"yes", "no", NULL};
static const char *const costs[] = {"throughput", "paper", NULL};
static const char *const selections[] = {"roulette", "tournament", NULL};
static const char *const topologies[] = {"ring", "torus", "random", "none", NULL};
static const char *const presets[] = {"paper", NULL};

#define AT(member) offsetof(struct evolve_options, member)
static const struct entry {
    const char *name;
    enum kind kind;
    enum role role;
    size_t at;        /* the member in struct evolve_options */
    size_t low, high; /* of whole numbers; of an action its value */
    const char *const *choice;
} entry[] = {{"scene", TEXT, KEPT, AT(scene), 0, 0, NULL},
             {"root", TEXT, KEPT, AT(root), 0, 0, NULL},
             {"start", TEXT, PASSING, AT(start), 0, 0, NULL},
             {"from-scratch", FLAG, PASSING, AT(from_scratch), 0, 0, NULL},
             {"output", TEXT, KEPT, AT(output), 0, 0, NULL},
             {"seeds", TEXT, PASSING, AT(seeds), 0, 0, NULL},
             {"samples", TEXT, PASSING, AT(samples), 0, 0, NULL},
             {"front", TEXT, KEPT, AT(front), 0, 0, NULL},
             {"generations", WHOLE, KEPT, AT(generations), 0, 100000000, NULL},
             {"seed", SEED, FIXED, AT(seed), 0, 0, NULL},
             {"islands", WHOLE, FIXED, AT(islands), 1, 1000000, NULL},
             {"population", WHOLE, FIXED, AT(population), 2, 1000000, NULL},
             {"max-length", WHOLE, FIXED, AT(max_length), 0, 10000, NULL},
             {"functions", CHOICE, FIXED, AT(functions), 0, 0, functions},
             {"growth", CHOICE, FIXED, AT(growth), 0, 0, growths},
             {"breeding", CHOICE, FIXED, AT(breeding), 0, 0, breedings},
             {"cost", CHOICE, FIXED, AT(cost), 0, 0, costs},
             {"selection", CHOICE, FIXED, AT(selection), 0, 0, selections},
             {"parsimony", FRACTION, FIXED, AT(parsimony), 0, 0, NULL},
             {"topology", CHOICE, FIXED, AT(topology), 0, 0, topologies},
             {"migrate-every", WHOLE, FIXED, AT(migrate_every), 1, 100000000, NULL},
             {"migrate-fraction", FRACTION, FIXED, AT(migrate_fraction), 0, 0, NULL},
             {"preset", PRESET, PASSING, 0, 0, 0, presets},
             {"checkpoint", TEXT, KEPT, AT(checkpoint), 0, 0, NULL},
             {"checkpoint-every", TIME, KEPT, AT(checkpoint_every), 0, 0, NULL},
             {"resume", TEXT, PASSING, AT(resume), 0, 0, NULL},
             {"time-limit", TIME, PASSING, AT(time_limit), 0, 0, NULL},
             {"log", TEXT, KEPT, AT(log), 0, 0, NULL},
             {"log-every", WHOLE, KEPT, AT(log_every), 1, 100000000, NULL},
             {"quiet", FLAG, PASSING, AT(quiet), 0, 0, NULL},
             {"benchmark", ACTION, PASSING, 0, ACTION_BENCHMARK, 0, NULL},
             {"help", ACTION, PASSING, 0, ACTION_HELP, 0, NULL},
             {"version", ACTION, PASSING, 0, ACTION_VERSION, 0, NULL}};
enum { ENTRIES = sizeof entry / sizeof *entry, SHORT_OUTPUT = 4 };

static bool usage(struct diag *d, const char *format, const char *option, const char *argument)
{
    diag_at(d, "footpoint-evolve", 0, 0, format, option, argument);
    d->code = EXIT_USAGE;
    return false;
}

static void *member(struct evolve_options *o, const struct entry *e)
{
    return (char *)o + e->at;
}

static const void *member_of(const struct evolve_options *o, const struct entry *e)
{
    return (const char *)o + e->at;
}

static bool read_whole(const struct entry *e, const char *text, void *value, struct diag *d)
{
    unsigned long long v;
    if (!text_whole(text, &v))
        return usage(d, "--%s needs a whole number, not '%s'", e->name, text);
    const size_t size = (size_t)v;
    if (e->kind == SEED)
        *(uint64_t *)value = v;
    else if (v >= e->low && v <= e->high)
        memcpy(value, &size, sizeof size);
    else
        return usage(d, "--%s %s is out of range", e->name, text);
    return true;
}

static bool read_fraction(const struct entry *e, const char *text, double *value, struct diag *d)
{
    char *rest;
    *value = strtod(text, &rest);
    if (rest == text || *rest)
        return usage(d, "--%s needs a number, not '%s'", e->name, text);
    return (*value >= 0 && *value <= 0.5) || usage(d, "--%s %s is out of range (0 to 0.5)", e->name, text);
}

/* Seconds, M:SS or H:MM:SS. */
static bool read_time(const struct entry *e, const char *text, double *value, struct diag *d)
{
    const char *at = text;
    bool good = true;
    *value = 0;
    for (int part = 0; good; part++) {
        char *rest;
        const double v = strtod(at, &rest);
        good = part < 3 && isdigit((unsigned char)at[0]) && (part == 0 || v < 60);
        *value = *value * 60 + v;
        if (*rest != ':') {
            good = good && *rest == '\0';
            break;
        }
        at = rest + 1;
    }
    if (!good)
        return usage(d, "--%s needs seconds or H:MM:SS, not '%s'", e->name, text);
    return *value <= 1e9 || usage(d, "--%s %s is out of range", e->name, text);
}

/* Index of text in choice[], or an error. */
static bool read_choice(const struct entry *e, const char *text, int *index, struct diag *d)
{
    *index = text_word(text, e->choice);
    return *index >= 0 || usage(d, "--%s knows no '%s'", e->name, text);
}

static bool read_text_option(const struct entry *e, const char *text, const char **value, struct diag *d)
{
    if (!*text || strchr(text, '\n'))
        return usage(d, "--%s needs a name without line breaks%s", e->name, "");
    *value = text;
    return true;
}

static bool read_value(const struct entry *e, const char *text, struct evolve_options *o, struct diag *d)
{
    int preset;
    switch (e->kind) {
    case TEXT:
        return read_text_option(e, text, member(o, e), d);
    case FLAG:
        return *(bool *)member(o, e) = true;
    case WHOLE:
    case SEED:
        return read_whole(e, text, member(o, e), d);
    case FRACTION:
        return read_fraction(e, text, member(o, e), d);
    case TIME:
        return read_time(e, text, member(o, e), d);
    case CHOICE:
        return read_choice(e, text, member(o, e), d);
    case PRESET:
        return read_choice(e, text, &preset, d);
    default:
        o->action = (enum action)e->low;
        return true;
    }
}

/* One pass over the command line; given[i] tells whether entry i occurred. */
static bool read_all(int argc, char **argv, struct evolve_options *o, bool given[ENTRIES], struct diag *d)
{
    struct option options[ENTRIES + 1] = {{NULL, 0, NULL, 0}};
    int code;
    for (int i = 0; i < ENTRIES; i++) {
        const bool bare = entry[i].kind == FLAG || entry[i].kind == ACTION;
        options[i] = (struct option){entry[i].name, bare ? no_argument : required_argument, NULL, 256 + i};
    }
    opterr = 0;
    optind = 0; /* GNU: start anew */
    while ((code = getopt_long(argc, argv, "+:o:", options, NULL)) != -1) {
        if (code == ':')
            return usage(d, "%s needs an argument%s", argv[optind - 1], "");
        if (code == '?')
            return usage(d, "unknown option '%s'%s", argv[optind - 1], "; see --help");
        const int at = code == 'o' ? SHORT_OUTPUT : code - 256;
        if (!read_value(&entry[at], optarg, o, d))
            return false;
        given[at] = true;
    }
    return optind == argc || usage(d, "'%s' is no option%s", argv[optind], "; see --help");
}

static int find_entry(const char *name)
{
    for (int i = 0; i < ENTRIES; i++)
        if (strcmp(entry[i].name, name) == 0)
            return i;
    return -1;
}

static bool exclude(const bool given[ENTRIES], const char *one, const char *other, struct diag *d)
{
    return !given[find_entry(one)] || !given[find_entry(other)] ||
           usage(d, "--%s and --%s exclude each other", one, other);
}

static bool consistent(const struct evolve_options *o, const bool given[ENTRIES], struct diag *d)
{
    if (!o->scene)
        return usage(d, "--scene is missing%s%s", "", "; see --help");
    if (!exclude(given, "start", "from-scratch", d) || !exclude(given, "resume", "samples", d) ||
        !exclude(given, "resume", "start", d) || !exclude(given, "resume", "from-scratch", d) ||
        !exclude(given, "resume", "seeds", d))
        return false;
    if (given[find_entry("checkpoint-every")] && !o->checkpoint)
        return usage(d, "--checkpoint-every needs %s%s", "--checkpoint", "");
    if (given[find_entry("log-every")] && !o->log)
        return usage(d, "--log-every needs %s%s", "--log", "");
    if (given[find_entry("time-limit")] && !(o->time_limit > 0))
        return usage(d, "--time-limit 0 is out of range%s%s", "", "");
    return true;
}

static void set_paper(struct evolve_options *o)
{
    o->generations = 3000;
    o->islands = 5;
    o->population = 200;
    o->breeding = BREED_PAPER;
    o->cost = COST_PAPER;
    o->growth = GROWTH_NO;
    o->selection = SELECT_ROULETTE;
    o->parsimony = 0;
    o->topology = TOPOLOGY_RING;
    o->migrate_every = 10;
    o->migrate_fraction = 0.1;
}

/* The command line over a base; a preset lies between them. */
static bool read_over(int argc, char **argv, const struct evolve_options *base, struct evolve_options *o,
                      bool given[ENTRIES], struct diag *d)
{
    *o = *base;
    if (!read_all(argc, argv, o, given, d))
        return false;
    if (given[find_entry("preset")]) {
        *o = *base;
        set_paper(o);
        read_all(argc, argv, o, given, d);
    }
    return true;
}

bool evolve_options_read(int argc, char **argv, struct evolve_options *o, struct diag *d)
{
    bool given[ENTRIES] = {false};
    if (!read_over(argc, argv, &standard, o, given, d))
        return false;
    if (!given[find_entry("root")])
        o->root = root_default();
    /* What the command line leaves out, a checkpoint may have: that is checked when it was read. */
    return o->action != ACTION_EVOLVE || o->resume
               ? exclude(given, "resume", "start", d) && exclude(given, "resume", "from-scratch", d)
               : consistent(o, given, d);
}

/* An option's value as the command line would have it; false where there is none. */
static bool value_text(const struct evolve_options *o, const struct entry *e, char *text, size_t n)
{
    uint64_t seed;
    size_t whole;
    double number;
    int index;
    const char *name;
    switch (e->kind) {
    case TEXT:
        memcpy(&name, member_of(o, e), sizeof name);
        return name && snprintf(text, n, "%s", name) < (int)n;
    case SEED:
        memcpy(&seed, member_of(o, e), sizeof seed);
        return snprintf(text, n, "%llu", (unsigned long long)seed) > 0;
    case WHOLE:
        memcpy(&whole, member_of(o, e), sizeof whole);
        return snprintf(text, n, "%zu", whole) > 0;
    case FRACTION:
    case TIME:
        memcpy(&number, member_of(o, e), sizeof number);
        return snprintf(text, n, "%.17g", number) > 0;
    case CHOICE:
        memcpy(&index, member_of(o, e), sizeof index);
        return snprintf(text, n, "%s", e->choice[index]) > 0;
    default:
        return false;
    }
}

enum { VALUE = 1100 };

void evolve_options_facts(const struct evolve_options *o, char *text, size_t n)
{
    char value[VALUE];
    size_t used = strlen(text);
    for (int i = 0; i < ENTRIES; i++)
        if (entry[i].role != PASSING && value_text(o, &entry[i], value, sizeof value) && used < n)
            used += (size_t)snprintf(text + used, n - used, "%s %s\n", entry[i].name, value);
}

/* Lines whose key is no option are for others. */
static bool read_facts(char *facts, struct evolve_options *o, struct diag *d)
{
    *o = standard;
    for (char *line = facts; *line;) {
        char *end = line + strcspn(line, "\n"), *next = end + (*end == '\n');
        char *space = line + strcspn(line, " \n");
        *end = '\0';
        if (*space == ' ') {
            *space = '\0';
            const int at = find_entry(line);
            if (at >= 0 && entry[at].role != PASSING && !read_value(&entry[at], space + 1, o, d))
                return false;
        }
        line = next;
    }
    return true;
}

bool evolve_options_resume(int argc, char **argv, char *facts, struct evolve_options *o, struct diag *d)
{
    struct evolve_options base;
    bool given[ENTRIES] = {false};
    if (!read_facts(facts, &base, d))
        return false;
    if (!read_over(argc, argv, &base, o, given, d))
        return false;
    for (int i = 0; i < ENTRIES; i++) {
        char before[VALUE], now[VALUE];
        if (entry[i].role == FIXED && value_text(&base, &entry[i], before, sizeof before) &&
            value_text(o, &entry[i], now, sizeof now) && strcmp(before, now) != 0) {
            diag_at(d, "footpoint-evolve", 0, 0, "--%s %s contradicts the checkpoint, which has %s", entry[i].name, now,
                    before);
            d->code = EXIT_USAGE;
            return false;
        }
    }
    return consistent(o, given, d);
}
