/* Families of faces and slave nodes on which libraries are compared, each drawn from a seed; see cases.c. */
#ifndef FOOTPOINT_LIBRARY_CASES_H
#define FOOTPOINT_LIBRARY_CASES_H

#include "library.h"

struct library_case {
    double x[LIBRARY_NODES][3], xs[3];
};

struct library_family {
    const char *name, *what;
    const char *hard; /* family of tests/hard/hard.c with its four-node faces, or NULL */
    unsigned kinds;   /* bits 1 << kind */
    int on_face;      /* the slave node lies on the face */
};

extern const struct library_family library_families[];
extern const int library_family_count;

/** Draws case number `index` of a family, the same on every machine. */
void library_draw(int family, int kind, unsigned long index, struct library_case *c);

#endif
