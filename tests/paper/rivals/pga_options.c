/* Reads the command line of footpoint-pga. */
#include "pga_options.h"

#include "../../../evolve/common/data_root.h"

#include <ctype.h>
#include <string.h>

static bool read_limits(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                        struct diag *d)
{
    struct pga_options *o = values;
    o->limits = option_wholes(t, r, text, o->limit, PGA_LIMITS, d);
    if (o->limits > PGA_LIMITS)
        return options_refuse(t, d, "error: --restrict %s has too many numbers", text);
    return o->limits > 0;
}

/* Reads a name in the syntax of genome text. */
static bool read_name(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                      struct diag *d)
{
    bool good = isalpha((unsigned char)text[0]) && strlen(text) < 60;
    for (const char *c = text; *c; c++)
        good = good && (isalnum((unsigned char)*c) || *c == '_');
    ((struct pga_options *)values)->name = text;
    return good || options_refuse(t, d, "error: --%s needs letters, digits and _, not '%s'", r->name, text);
}

static const char *const coefficients[] = {"squares", "mean", "worst", NULL};

#define AT(member) offsetof(struct pga_options, member)
static const struct option_row rows[] = {
    {"scene", 0, OPTION_TEXT, AT(scene), "NAME|FILE",
     .help = "evolve/scenes/NAME.scene, or a file; a tier's terminals are the polynomials' variables"},
    {"tier", 0, OPTION_TEXT, AT(tier), "NAME", .help = "which tier (default: the first)"},
    {"root", 0, OPTION_TEXT, AT(root), "DIR",
     .help = "folder that holds evolve/ (default: ., or else what is installed)"},
    {"output", 'o', OPTION_TEXT, AT(output), "FILE", .help = "genome to write"},
    {"name", 0, OPTION_OWN, AT(name), "NAME", .read = read_name, .help = "of the genome (default: pga)"},
    {"order", 0, OPTION_WHOLE, AT(order), "N", 1, MONOMIAL_DEGREE, .help = "of the polynomials, 1 to 4 (default: 3)"},
    {"generations", 0, OPTION_WHOLE, AT(generations), "N", 0, 100000000, .help = "of a search (default: 3000)"},
    {"population", 0, OPTION_WHOLE, AT(plan.population), "N", 2, 100000, .help = "individuals (default: 100)"},
    {"restrict", 0, OPTION_OWN, AT(limit), "N[,N...]", 0, 100000, .read = read_limits,
     .help = "terms above which equation (40) punishes, 0: no restriction (default); a search for each, a genome "
             "NAME_N for each if there are several"},
    {"crossover", 0, OPTION_PART, AT(plan.crossover), "X", 0, 1,
     .help = "part of the pairs that exchange a range of genes (default: 0.7)"},
    {"mutation", 0, OPTION_PART, AT(plan.mutation), "X", 0, 1,
     .help = "part of the individuals of which a gene is changed (default: 0.3)"},
    {"seed", 0, OPTION_SEED, AT(plan.seed), "N",
     .help = "same seed, same result on any number of processes (default: 1)"},
    {"log", 0, OPTION_TEXT, AT(log), "FILE", .help = "CSV, a line for each output and generation"},
    {"quiet", 0, OPTION_FLAG, AT(quiet), .help = "no times on stderr"},
    {.kind = OPTION_TITLE, .help = "beyond the paper"},
    {"exchange", 0, OPTION_FLAG, AT(plan.exchange),
     .help = "improve each new best by exchanging terms, forward and backward"},
    {"terms", 0, OPTION_TEXT, AT(terms), "FILE",
     .help = "no search: the terms of this file, a line \"xi = yd, xs, xc ys, 1\" for each output"},
    {"coefficients", 0, OPTION_CHOICE, AT(coefficients), .choice = coefficients,
     .help = "what the coefficients of what is written minimise: the squares of the errors, their mean, or the largest "
             "(default: squares)"}};

const struct option_table pga_option_table = {
    .program = "footpoint-pga",
    .usage = "usage: footpoint-pga --scene NAME -o FILE [options]\n"
             "Search polynomials for xi and eta of a scene by the genetic algorithm of Oishi and Yoshimura (2008), "
             "sections\n"
             "3.2 and 5.2; alone or under mpirun, where rank 0 breeds and all ranks evaluate.\n",
    .notes =
        "Exit status: 0 done; 1 input rejected; 2 wrong usage; 3 out of memory or unreadable or unwritable file.\n",
    .row = rows,
    .rows = sizeof rows / sizeof *rows};

enum options_outcome pga_options_read(int argc, char **argv, struct pga_options *o, struct diag *d)
{
    const struct option_table *t = &pga_option_table;
    *o = (struct pga_options){.root = root_default(),
                              .name = "pga",
                              .order = 3,
                              .generations = 3000,
                              .limits = 1,
                              .plan = pga_plan_default()};
    const enum options_outcome outcome = options_read(t, argc, argv, o, NULL, d);
    if (outcome != OPTIONS_READ)
        return outcome;
    return options_need(t, "scene", o->scene, d) && options_need(t, "output", o->output, d) ? outcome : OPTIONS_WRONG;
}
