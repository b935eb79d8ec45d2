/* Command line of footpoint-evolve. */
#ifndef FOOTPOINT_EVOLVE_OPTIONS_H
#define FOOTPOINT_EVOLVE_OPTIONS_H

#include "island.h"

enum functions { FUNCTIONS_OF_TIER, FUNCTIONS_POLYNOMIAL, FUNCTIONS_RATIONAL };
enum action { ACTION_EVOLVE, ACTION_BENCHMARK, ACTION_HELP, ACTION_VERSION };

struct evolve_options {
    enum action action;
    const char *scene, *root, *start, *output; /* not owned; NULL: not given */
    bool from_scratch, quiet;
    bool paper; /* the paper's preset */
    uint64_t seed;
    size_t generations, islands, population, migrate_every;
    size_t max_length; /* 0: each tier's own */
    double parsimony, migrate_fraction;
    enum functions functions;
    enum selection selection;
};

/** False with *d "footpoint-evolve: error: ..." (code EXIT_USAGE) on unknown, contradictory or out-of-range options. */
bool evolve_options_read(int argc, char **argv, struct evolve_options *o, struct diag *d);
/** The text of --help. */
extern const char evolve_help[];

#endif
