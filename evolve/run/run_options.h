/* Reads the command line of footpoint-evolve. */
#ifndef FOOTPOINT_RUN_OPTIONS_H
#define FOOTPOINT_RUN_OPTIONS_H

#include "../../codegen/base/options.h"
#include "../../codegen/genome/segment_kind.h"
#include "../island/island.h"
#include "../island/topology.h"

enum functions { FUNCTIONS_OF_TIER, FUNCTIONS_POLYNOMIAL, FUNCTIONS_RATIONAL };
enum cost_model { COST_THROUGHPUT, COST_PAPER }; /* as codegen's --cost */

struct evolve_options {
    const char *scene, *root, *start, *output; /* not owned, like all texts; NULL: not given */
    const char *checkpoint, *resume, *log;
    const char *seeds, *front, *samples, *page;
    const struct segment_kind *print_scene; /* NULL: not asked for */
    bool from_scratch, quiet, benchmark;
    uint64_t seed;
    size_t generations, islands, population, migrate_every, log_every;
    size_t max_length; /* 0: each tier's own */
    size_t members;    /* limit for each tier on `front`; 0: all */
    double parsimony, migrate_fraction;
    double checkpoint_every, time_limit; /* seconds; time_limit 0: unlimited */
    enum functions functions;
    enum breeding breeding;
    enum selection selection;
    enum cost_model cost;
    enum topology topology;
    int preset;
};

extern const struct option_table evolve_option_table;

/** Reads the command line.  Returns OPTIONS_WRONG with *d "footpoint-evolve: error: ..." on unknown, contradictory or out-of-range
 *  options. */
enum options_outcome evolve_options_read(int argc, char **argv, struct evolve_options *o, struct diag *d);

/** Appends to text[0..n-1] the options that a checkpoint keeps: "name value" for each option on which the run's result depends, or
 *  that a resumed run takes over unless it is given again. */
void evolve_options_facts(const struct evolve_options *o, char *text, size_t n);
/** Reads the options of a resumed run: from the facts, overridden by the command line.  facts must outlive *o, and loses its line
 *  ends.  Returns false with *d filled if a value is invalid, or if the command line contradicts (code EXIT_USAGE). */
bool evolve_options_resume(int argc, char **argv, char *facts, struct evolve_options *o, struct diag *d);

#endif
