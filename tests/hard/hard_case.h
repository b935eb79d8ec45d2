/* A segment and a slave node on which searches may fail. */
#ifndef FOOTPOINT_HARD_CASE_H
#define FOOTPOINT_HARD_CASE_H

#include <stdint.h>

/** Nodes A, B, C, D and the slave node. */
struct hard_case {
    double x[5][3];
};

#endif
