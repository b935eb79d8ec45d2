/* A sample: one segment, one slave node and its certain foot point.  Sets of them are what scenes are made of. */
#ifndef FOOTPOINT_SAMPLE_H
#define FOOTPOINT_SAMPLE_H

#include "../../codegen/genome/segment_kind.h"

#include <stddef.h>

struct sample {
    /* Nodes and normals in the order of the segment's kind, of quad4 the corners A, B, C, D at (xi,eta) = (-1,-1),
     * (1,-1), (1,1), (-1,1); any length unit.  0 beyond what the kind has. */
    double x[SEGMENT_VECTORS][3];
    double xs[3];   /* slave node; same unit */
    double xi, eta; /* foot point, dimensionless */
    double gap;     /* (xs - r(xi,eta)) . n, n the unit normal there, right-handed in xi, eta; same unit as x */
};

struct sample_set {
    struct sample *s; /* owned */
    size_t n, room;
    size_t real; /* of a mesh: the first ones, whose slave nodes are the mesh's own */
};

/** Bands of |gap| over the shortest edge between the corners of the segment: to 1e-3, to 1e-2, to 1e-1, and beyond. */
enum { GAP_BANDS = 4 };
extern const char *const gap_band_name[GAP_BANDS];
double sample_shortest_edge(const struct sample *s, size_t corners);
int sample_gap_band(const struct sample *s, size_t corners);

void sample_set_add(struct sample_set *set, const struct sample *s);
void sample_set_free(struct sample_set *set);

/** Which of a scene's samples.  No two share a configuration. */
enum sample_part {
    PART_TRAINING,       /* what evolution sees */
    PART_HELDOUT,        /* lattice and mesh: the rest of the same points; random: a second stream */
    PART_HELDOUT_RANDOM, /* off the grid: drawn at random from the same ranges */
    PART_HELDOUT_EVEN,   /* ordinary shapes: another distribution in the same limits, to which nothing is fitted */
    PART_VALIDATION,     /* as many as for training, drawn at random: what champions are chosen by */
    PART_TRAINING_RANDOM /* off the grid, what programs see besides; of lattices that ask for it */
};

enum { HELDOUT_PARTS = 3 };
/** The parts held out, and what notes and samples call them: "heldout", "heldout_random", "heldout_even". */
extern const struct heldout_part {
    enum sample_part part;
    const char *name;
} heldout_part[HELDOUT_PARTS];

enum { DRAWN_LINES = 4, DRAWN_LENGTH = 240 };

#endif
