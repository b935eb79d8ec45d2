/* Command line of footpoint-perceptron. */
#include "perceptron_options.h"

#include "../common/data_root.h"

#include <string.h>

/* "16,16": a network more. */
static bool read_hidden(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                        struct diag *d)
{
    struct perceptron_options *o = values;
    if (o->networks == PERCEPTRONS)
        return options_refuse(t, d, "error: --%s %s is too much", r->name, text);
    struct perceptron *p = &o->network[o->networks++];
    *p = (struct perceptron){1, {PERCEPTRON_INPUTS}};
    const size_t hidden = option_wholes(t, r, text, p->size + 1, PERCEPTRON_LAYERS - 2, d);
    if (hidden > PERCEPTRON_LAYERS - 2)
        return options_refuse(t, d, "error: --%s %s has too many layers", r->name, text);
    p->layers = hidden + 2;
    p->size[hidden + 1] = 2;
    for (size_t i = 0; hidden > 0 && i + 1 < o->networks; i++)
        if (memcmp(&o->network[i], p, sizeof *p) == 0)
            return options_refuse(t, d, "error: --%s %s is given twice", r->name, text);
    return hidden > 0;
}

#define AT(member) offsetof(struct perceptron_options, member)
static const struct option_row rows[] = {
    {"scene", 0, OPTION_TEXT, AT(scene), "NAME|FILE",
     .help = "evolve/scenes/NAME.scene, or a file; its training samples are used"},
    {"root", 0, OPTION_TEXT, AT(root), "DIR",
     .help = "folder that holds evolve/ (default: ., or else what is installed)"},
    {"output", 'o', OPTION_TEXT, AT(output), "FILE", .help = "genomes to write: hidden_N_... for each network"},
    {"hidden", 0, OPTION_OWN, AT(network), "N[,N...]", 1, PERCEPTRON_WIDTH, .read = read_hidden,
     .help = "neurons of the hidden layers; a network for each time it is given (default: 8)"},
    {"iterations", 0, OPTION_WHOLE, AT(iterations), "N", 0, 1000000,
     .help = "steps of Levenberg and Marquardt's method at most (default: 200)"},
    {"samples", 0, OPTION_WHOLE, AT(samples), "N", 1, OPTION_ANY, .help = "training samples at most (default: all)"},
    {"seed", 0, OPTION_WHOLE, AT(seed), "N", 0, OPTION_ANY, .help = "of the first weights (default: 1)"},
    {"quiet", 0, OPTION_FLAG, AT(quiet), .help = "nothing on stderr"}};

const struct option_table perceptron_option_table = {
    .program = "footpoint-perceptron",
    .usage = "usage: footpoint-perceptron --scene NAME -o FILE [options]\n"
             "Train multi-layer perceptrons for xi and eta of a scene, from the eight values of the similarity frame, "
             "as in\n"
             "the neural-network approach of Oishi and Yoshimura (2007), and write them as genomes.\n",
    .notes =
        "Exit status: 0 done; 1 input rejected; 2 wrong usage; 3 out of memory or unreadable or unwritable file.\n",
    .row = rows,
    .rows = sizeof rows / sizeof *rows};

enum options_outcome perceptron_options_read(int argc, char **argv, struct perceptron_options *o, struct diag *d)
{
    const struct option_table *t = &perceptron_option_table;
    *o = (struct perceptron_options){.root = root_default(), .iterations = 200, .samples = SIZE_MAX, .seed = 1};
    const enum options_outcome outcome = options_read(t, argc, argv, o, NULL, d);
    if (outcome != OPTIONS_READ)
        return outcome;
    if (!o->networks)
        o->network[o->networks++] = (struct perceptron){3, {PERCEPTRON_INPUTS, 8, 2}};
    return options_need(t, "scene", o->scene, d) && options_need(t, "output", o->output, d) ? outcome : OPTIONS_WRONG;
}
