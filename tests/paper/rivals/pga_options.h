/* Reads the command line of footpoint-pga. */
#ifndef FOOTPOINT_PGA_OPTIONS_H
#define FOOTPOINT_PGA_OPTIONS_H

#include "../../../codegen/base/options.h"
#include "../../../evolve/input/scene.h"
#include "pga.h"

enum coefficients { COEFFICIENTS_SQUARES, COEFFICIENTS_MEAN, COEFFICIENTS_WORST };

enum { PGA_LIMITS = 16 };

struct pga_options {
    const char *scene, *root, *tier, *output, *log, *name, *terms; /* not owned; NULL: not given */
    size_t order, generations;
    struct pga_plan plan;     /* without terms and stream */
    size_t limit[PGA_LIMITS]; /* a search for each: N of equation (40), 0: unrestricted */
    size_t limits;            /* at least 1 */
    enum coefficients coefficients;
    bool quiet;
};

extern const struct option_table pga_option_table;

/** Reads the command line.  Returns OPTIONS_WRONG with *d "footpoint-pga: error: ...". */
enum options_outcome pga_options_read(int argc, char **argv, struct pga_options *o, struct diag *d);

#endif
