/* Command line of footpoint-evolve. */
#ifndef FOOTPOINT_RUN_OPTIONS_H
#define FOOTPOINT_RUN_OPTIONS_H

#include "../../codegen/base/options.h"
#include "../../codegen/genome/segment_kind.h"
#include "../island/island.h"
#include "../island/topology.h"

enum functions { FUNCTIONS_OF_TIER, FUNCTIONS_POLYNOMIAL, FUNCTIONS_RATIONAL };
enum cost_model { COST_THROUGHPUT, COST_PAPER }; /* as codegen's --cost */

struct evolve_options {
    const char *scene, *root, *start, *output; /* not owned, as are all texts; NULL: not given */
    const char *checkpoint, *resume, *log;
    const char *seeds, *front, *samples, *page;
    const struct segment_kind *print_scene; /* NULL: not asked for */
    bool from_scratch, quiet, benchmark;
    uint64_t seed;
    size_t generations, islands, population, migrate_every, log_every;
    size_t max_length; /* 0: each tier's own */
    size_t members;    /* of each tier on `front`; 0: all */
    double parsimony, migrate_fraction;
    double checkpoint_every, time_limit; /* seconds; a limit of 0: none */
    enum functions functions;
    enum breeding breeding;
    enum selection selection;
    enum cost_model cost;
    enum topology topology;
    int preset;
};

extern const struct option_table evolve_option_table;

/** OPTIONS_WRONG with *d "footpoint-evolve: error: ..." on unknown, contradictory or out-of-range options. */
enum options_outcome evolve_options_read(int argc, char **argv, struct evolve_options *o, struct diag *d);

/** Append to text[0..n-1] what a checkpoint keeps: "name value" for each option that the run's result depends on, or
 *  that a resumed run takes over where it is not given anew. */
void evolve_options_facts(const struct evolve_options *o, char *text, size_t n);
/** The options of a resumed run: those of the facts, over them those of the command line.  facts must outlive *o, and
 *  loses its line ends.  False with *d where a value is none, or where the command line contradicts (code EXIT_USAGE).
 */
bool evolve_options_resume(int argc, char **argv, char *facts, struct evolve_options *o, struct diag *d);

#endif
