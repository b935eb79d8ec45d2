/* Writes the results of footpoint-pga as genome text with errors. */
#ifndef FOOTPOINT_PGA_WRITE_H
#define FOOTPOINT_PGA_WRITE_H

#include "../../../evolve/eval/objective.h"
#include "../../../evolve/surface/sample.h"
#include "pga.h"
#include "pga_options.h"

/** The search for an output. */
struct pga_find {
    struct genes genes; /* genes owned; constants are decimal numbers */
    double error;       /* in the objective's norm, as written */
    double condition;   /* of the normal equations, columns scaled */
    size_t terms, evaluations, singular;
};

/** Makes the polynomial of a search's best individual, with coefficients as the options ask; returns false if there is no best.
 *  @param[in] objective  of decimal numbers, in the norm that the coefficients minimise; the mean if that is squares */
bool pga_find_new(const struct polynomials *p, const struct pga_state *s, struct objective *objective, size_t target,
                  enum coefficients coefficients, struct pga_find *f);
void pga_find_free(struct pga_find *f);

/** Writes a genome for each limit, with xi and eta; errors on the two held-out parts. */
bool pga_write(const struct pga_options *o, const struct scene *scene, struct genome_file *program,
               struct pga_find (*find)[2], const struct sample_set heldout[2], struct diag *d);

#endif
