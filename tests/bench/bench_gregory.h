/* The methods of the bench of Gregory patches. */
#ifndef FOOTPOINT_BENCH_GREGORY_H
#define FOOTPOINT_BENCH_GREGORY_H

#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../rivals/rivals_gregory.h"

/** Replaces xi and eta if a method has no answer; finite, because code may be compiled without infinities. */
#define GREGORY_NO_ANSWER 1e300

struct gregory_input {
    double x[4][3], n[4][3], xs[3];
};

/** Patches prepared from the same inputs. */
struct gregory_ready {
    const struct rival_patch *patch;
    const struct footpoint_gregory *plain;
};

struct gregory_method {
    const char *name;
    /* Searches all of `in`, on prepared patches unless `ready` is NULL. */
    void (*search)(const struct gregory_input *in, const struct gregory_ready *ready, size_t count,
                   enum rival_start start, double (*found)[2]);
};
extern const struct gregory_method gregory_methods[];
extern const int gregory_method_count;

#endif
