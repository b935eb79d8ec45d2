/* A sample: one segment, one slave node and its certain foot point. Scenes consist of sets of samples. */
#ifndef FOOTPOINT_SAMPLE_H
#define FOOTPOINT_SAMPLE_H

#include "../../codegen/genome/segment_kind.h"

#include <stddef.h>

struct sample {
    /* Nodes and normals in the order of the segment's kind, in any unit of length; 0 beyond the kind's vectors. For
     * quad4, the corners A, B, C, D at (xi,eta) = (-1,-1), (1,-1), (1,1), (-1,1). */
    double x[SEGMENT_VECTORS][3];
    double xs[3];   /* slave node; same unit */
    double xi, eta; /* foot point, dimensionless */
    double gap;     /* (xs - r(xi,eta)) . n, with the unit normal n there, right-handed in xi, eta; same unit as x */
};

/** Patches on four corners and their unit normals. */
enum patch_kind { PATCH_GREGORY, PATCH_BEZIER };
enum { PATCH_NORMALS = 4 }; /* index of the first normal among a sample's vectors, after the corners */

struct sample_set {
    struct sample *s; /* owned */
    size_t n, room;
    size_t real; /* number of first samples whose slave nodes are nodes of the mesh */
};

/** Bands of |gap| over the shortest edge between corners: up to 1e-3, 1e-2, 1e-1, and beyond. */
enum { GAP_BANDS = 4 };
extern const char *const gap_band_name[GAP_BANDS];
double sample_shortest_edge(const struct sample *s, size_t corners);
int sample_gap_band(const struct sample *s, size_t corners);

void sample_set_add(struct sample_set *set, const struct sample *s);
void sample_set_free(struct sample_set *set);

/** Parts of a scene's samples. They share no configuration. */
enum sample_part {
    PART_TRAINING,       /* seen by evolution */
    PART_HELDOUT,        /* lattice and mesh: the rest of the same points; random: a second stream */
    PART_HELDOUT_RANDOM, /* off the grid: random in the same ranges */
    PART_HELDOUT_EVEN,   /* ordinary shapes: another distribution in the same limits, to which nothing is fitted */
    PART_VALIDATION,     /* as many as for training, random: they decide the champions */
    PART_TRAINING_RANDOM /* off the grid, seen by programs in addition; only for lattices whose scene asks for it */
};

enum { HELDOUT_PARTS = 3 };
/** Held-out parts, and their names in notes and samples: "heldout", "heldout_random", "heldout_even". */
extern const struct heldout_part {
    enum sample_part part;
    const char *name;
} heldout_part[HELDOUT_PARTS];

enum { DRAWN_LINES = 4, DRAWN_LENGTH = 240 };

#endif
