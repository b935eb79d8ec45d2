/* The paper's data set of section 7.2: configurations of its lattice, each with several random sets of node normals. */
#ifndef FOOTPOINT_LATTICE_NORMALS_H
#define FOOTPOINT_LATTICE_NORMALS_H

#include "../input/scene.h"
#include "../surface/patch.h"
#include "../surface/sample.h"

#include <gsl/gsl_rng.h>

struct lattice_gregory {
    const struct scene *scene; /* of the configurations, a lattice; not owned */
    size_t configurations;     /* at most so many of the part's configurations; 0: all */
    int normal_sets;           /* for each configuration; the paper's are 20 */
    double tangent; /* of the largest tilt of a node normal off the facet's own at the corner; the paper's 0.2 */
    enum patch_kind kind;
};

/** How samples of a part came about. */
struct lattice_gregory_count {
    size_t configurations, drawn, kept; /* drawn: configurations times sets; kept: their foot point lies in the box */
};

/** Node normals of a configuration.
 *  @param[in] tangent  of their largest tilt */
void draw_normals(gsl_rng *stream, double tangent, struct sample *s);

/** Append the samples whose foot point on the patch lies, like that on the facet, in the scene's box: configuration by
 *  configuration of the grid, set by set.  A tilt's tangent is uniform in a disc.  *count may be NULL.  False with *d filled. */
bool lattice_gregory_samples(const struct lattice_gregory *l, enum sample_part part, struct sample_set *set,
                             struct lattice_gregory_count *count, struct diag *d);

#endif
