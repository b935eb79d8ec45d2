/* Command line of footpoint-perceptron: long options only, each checked. */
#include "perceptron_options.h"

#include "../common/data_root.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

const char perceptron_help[] =
    "usage: footpoint-perceptron --scene NAME -o FILE [options]\n"
    "Train multi-layer perceptrons for xi and eta of a scene, from the eight values of the similarity frame, as in "
    "the\n"
    "neural-network approach of Oishi and Yoshimura (2007), and write them as genomes.\n"
    "\n"
    "  --scene NAME|FILE    evolve/scenes/NAME.scene, or a file; its training samples are used\n"
    "  --root DIR           folder that holds evolve/ (default: . or what is installed)\n"
    "  -o, --output FILE    genomes to write: hidden_N_... for each network\n"
    "  --hidden N[,N...]    neurons of the hidden layers; a network for each time it is given (default: 8)\n"
    "  --iterations N       steps of Levenberg and Marquardt's method at most (default: 200)\n"
    "  --samples N          training samples at most (default: all)\n"
    "  --seed N             of the first weights (default: 1)\n"
    "  --quiet              nothing on stderr\n"
    "  --help, --version\n"
    "\n"
    "Exit status: 0 done; 1 input rejected; 2 wrong usage; 3 out of memory or unreadable or unwritable file.\n";

static bool usage(struct diag *d, const char *format, const char *option, const char *argument)
{
    diag_at(d, "footpoint-perceptron", 0, 0, format, option, argument);
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

/* "16,16": a network more. */
static bool read_hidden(const char *text, struct perceptron_options *o, struct diag *d)
{
    char list[100], *rest;
    if (o->networks == PERCEPTRONS || strlen(text) >= sizeof list)
        return usage(d, "--%s %s is too much", "hidden", text);
    snprintf(list, sizeof list, "%s", text);
    struct perceptron *p = &o->network[o->networks++];
    *p = (struct perceptron){1, {PERCEPTRON_INPUTS}};
    for (char *one = strtok_r(list, ",", &rest); one; one = strtok_r(NULL, ",", &rest)) {
        if (p->layers == PERCEPTRON_LAYERS - 1)
            return usage(d, "--%s %s has too many layers", "hidden", text);
        if (!read_whole("hidden", one, 1, PERCEPTRON_WIDTH, &p->size[p->layers++], d))
            return false;
    }
    if (p->layers == 1)
        return usage(d, "--%s needs whole numbers, not '%s'", "hidden", text);
    p->size[p->layers++] = 2;
    for (size_t i = 0; i + 1 < o->networks; i++)
        if (memcmp(&o->network[i], p, sizeof *p) == 0)
            return usage(d, "--%s %s is given twice", "hidden", text);
    return true;
}

enum { SCENE = 256, ROOT, HIDDEN, ITERATIONS, SAMPLES, SEED, QUIET, HELP, VERSION };
static const struct option options[] = {{"scene", required_argument, NULL, SCENE},
                                        {"root", required_argument, NULL, ROOT},
                                        {"output", required_argument, NULL, 'o'},
                                        {"hidden", required_argument, NULL, HIDDEN},
                                        {"iterations", required_argument, NULL, ITERATIONS},
                                        {"samples", required_argument, NULL, SAMPLES},
                                        {"seed", required_argument, NULL, SEED},
                                        {"quiet", no_argument, NULL, QUIET},
                                        {"help", no_argument, NULL, HELP},
                                        {"version", no_argument, NULL, VERSION},
                                        {NULL, 0, NULL, 0}};

static bool read_option(int code, const char *text, struct perceptron_options *o, struct diag *d)
{
    switch (code) {
    case SCENE:
        o->scene = text;
        return true;
    case ROOT:
        o->root = text;
        return true;
    case 'o':
        o->output = text;
        return true;
    case HIDDEN:
        return read_hidden(text, o, d);
    case ITERATIONS:
        return read_whole("iterations", text, 0, 1000000, &o->iterations, d);
    case SAMPLES:
        return read_whole("samples", text, 1, SIZE_MAX, &o->samples, d);
    case SEED:
        return read_whole("seed", text, 0, SIZE_MAX, &o->seed, d);
    case QUIET:
        return o->quiet = true;
    default:
        o->action = code == HELP ? PERCEPTRON_HELP : PERCEPTRON_VERSION;
        return true;
    }
}

bool perceptron_options_read(int argc, char **argv, struct perceptron_options *o, struct diag *d)
{
    *o = (struct perceptron_options){.root = root_default(), .iterations = 200, .samples = SIZE_MAX, .seed = 1};
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
    if (o->action == PERCEPTRON_TRAIN && (!o->scene || !o->output))
        return usage(d, "--%s is missing%s", o->scene ? "output" : "scene", "; see --help");
    return o->networks > 0 || read_hidden("8", o, d);
}
