/* Samples on patches: the paper's data set of section 7.2, configurations of its lattice, each with several random sets
 * of node normals; and samples on meshes of smooth bodies, as contact searches on smoothed surfaces meet them. */
#ifndef FOOTPOINT_PATCH_SAMPLES_H
#define FOOTPOINT_PATCH_SAMPLES_H

#include "../input/scene.h"
#include "../surface/sample.h"

struct lattice_gregory {
    const struct scene *scene; /* the scene of the lattice; not owned */
    size_t configurations;     /* largest number of the part's configurations; 0: all */
    int normal_sets;           /* sets of normals per configuration; the paper has 20 */
    double tangent; /* tangent of the largest angle between a node normal and the facet's normal; 0.2 in the paper */
    enum patch_kind kind;
};

/** Counts of a part's samples. */
struct lattice_gregory_count {
    size_t configurations, drawn, kept; /* drawn: configurations times sets; kept: the foot point lies in the box */
};

/** Appends the samples whose foot points on the patch and on the facet lie in the scene's box, ordered by configuration
 *  of the grid, then by set. The tangent of a tilt is uniform in a disc. Returns false with *d filled on errors. *count
 *  may be NULL. */
bool lattice_gregory_samples(const struct lattice_gregory *l, enum sample_part part, struct sample_set *set,
                             struct lattice_gregory_count *count, struct diag *d);

struct smooth {
    uint64_t seed;
    double gap; /* |gap| over the shortest edge, 0..gap */
    enum patch_kind kind;
};

/** Appends `count` samples of the part on smooth bodies. They depend only on seed, gap, kind and part; different parts
 *  share no sample. */
void smooth_samples(const struct smooth *smooth, enum sample_part part, size_t count, struct sample_set *set);

#endif
