/* Command line of footpoint-perceptron. */
#ifndef FOOTPOINT_PERCEPTRON_OPTIONS_H
#define FOOTPOINT_PERCEPTRON_OPTIONS_H

#include "perceptron.h"

enum perceptron_action { PERCEPTRON_TRAIN, PERCEPTRON_HELP, PERCEPTRON_VERSION };

enum { PERCEPTRONS = 16, PERCEPTRON_INPUTS = 8 };

struct perceptron_options {
    enum perceptron_action action;
    const char *scene, *root, *output; /* not owned; NULL: not given */
    struct perceptron network[PERCEPTRONS];
    size_t networks; /* at least 1 */
    size_t iterations, samples, seed;
    bool quiet;
};

/** False with *d "footpoint-perceptron: error: ..." (code EXIT_USAGE). */
bool perceptron_options_read(int argc, char **argv, struct perceptron_options *o, struct diag *d);

/** The text of --help. */
extern const char perceptron_help[];

#endif
