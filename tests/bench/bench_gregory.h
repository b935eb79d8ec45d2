/* The methods of the bench of Gregory patches. */
#ifndef FOOTPOINT_BENCH_GREGORY_H
#define FOOTPOINT_BENCH_GREGORY_H

#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../rivals/rivals_gregory.h"

/** Stands for xi and eta where a method gives none; finite, for code compiled without infinities. */
#define GREGORY_NO_ANSWER 1e300

struct gregory_input {
    double x[4][3], n[4][3], xs[3];
};

/** Patches made before, of the same inputs. */
struct gregory_ready {
    const struct rival_patch *patch;
    const struct footpoint_gregory *plain;
};

struct gregory_method {
    const char *name;
    /* Search all of `in`; on ready patches unless that is NULL. */
    void (*search)(const struct gregory_input *in, const struct gregory_ready *ready, size_t count,
                   enum rival_start start, double (*found)[2]);
};
extern const struct gregory_method gregory_methods[];
extern const int gregory_method_count;

#endif
