/* What one island is to find, and the individuals that it breeds. */
#ifndef FOOTPOINT_GOAL_H
#define FOOTPOINT_GOAL_H

#include "../eval/objective.h"
#include "../fit/fitting.h"
#include "plan.h"

/** What one island is to find. */
struct goal {
    bool program;                 /* programs are bred, else trees */
    size_t column;                /* of trees: what they are measured against */
    int last;                     /* of programs: the function that they end in; -1: none */
    size_t max_length;            /* genes */
    const struct gene_set *genes; /* not owned */
    uint64_t ring, place;         /* key of its random streams: which ring, where in it */
    const struct fitting *fit;    /* not owned; of programs */
    size_t limit;                 /* largest cost that a front keeps; 0: the plan's */
    struct tails tails;           /* of programs: what their largest errors may be */
};

struct individual {
    struct genes genes; /* genes not owned: in the island's pool; constants are decimal numbers */
    double fitness;     /* what selection minimises, the paper's 1/fitness */
    double error;       /* INFINITY when not finite, or so bad that it was not evaluated to the end */
    double cost;        /* by the plan's model, with the values of the frame that it needs */
    uint64_t hash;      /* of its operations */
};

#endif
