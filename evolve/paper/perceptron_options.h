/* Command line of footpoint-perceptron. */
#ifndef FOOTPOINT_PERCEPTRON_OPTIONS_H
#define FOOTPOINT_PERCEPTRON_OPTIONS_H

#include "../../codegen/genome/options.h"
#include "perceptron.h"

enum { PERCEPTRONS = 16, PERCEPTRON_INPUTS = 8 };

struct perceptron_options {
    const char *scene, *root, *output; /* not owned; NULL: not given */
    struct perceptron network[PERCEPTRONS];
    size_t networks; /* at least 1 */
    size_t iterations, samples, seed;
    bool quiet;
};

extern const struct option_table perceptron_option_table;

/** OPTIONS_WRONG with *d "footpoint-perceptron: error: ...". */
enum options_outcome perceptron_options_read(int argc, char **argv, struct perceptron_options *o, struct diag *d);

#endif
