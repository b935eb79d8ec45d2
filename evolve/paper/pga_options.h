/* Command line of footpoint-pga. */
#ifndef FOOTPOINT_PGA_OPTIONS_H
#define FOOTPOINT_PGA_OPTIONS_H

#include "../input/scene.h"
#include "pga.h"

enum coefficients { COEFFICIENTS_SQUARES, COEFFICIENTS_MEAN, COEFFICIENTS_WORST };
enum pga_action { PGA_SEARCH, PGA_HELP, PGA_VERSION };

enum { PGA_LIMITS = 16 };

struct pga_options {
    enum pga_action action;
    const char *scene, *root, *tier, *output, *log, *name, *terms; /* not owned; NULL: not given */
    size_t order, generations;
    struct pga_plan plan;     /* without terms and stream */
    size_t limit[PGA_LIMITS]; /* a search for each: N of equation (40), 0: no restriction */
    size_t limits;            /* at least 1 */
    enum coefficients coefficients;
    bool quiet;
};

/** False with *d "footpoint-pga: error: ..." (code EXIT_USAGE). */
bool pga_options_read(int argc, char **argv, struct pga_options *o, struct diag *d);

/** The text of --help. */
extern const char pga_help[];

#endif
