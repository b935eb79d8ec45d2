/* A picture of what a run found on a mesh: errors by function and gap, and the shapes of the faces. */
#ifndef FOOTPOINT_PAGE_H
#define FOOTPOINT_PAGE_H

#include "../../codegen/base/base.h"
#include "../surface/sample.h"

/** Mean errors of a function in the bands of |gap|, and of the function of its kind; negative: there is none. */
struct page_row {
    const char *tier; /* not owned */
    double own[GAP_BANDS], shipped[GAP_BANDS];
};

/** A measure of all samples. */
struct page_measure {
    const char *name; /* not owned, with its unit */
    double *value;    /* owned by the caller; reordered */
    size_t n;
    double limit; /* of the samples that the functions of the kind were bred on; negative: none */
};

/** Writes the picture, SVG that is legible 400 pixels wide.  `scene` and `kind` name it.  False with *d filled. */
bool page_write(const char *path, const char *scene, const char *kind, const struct page_row *row, size_t rows,
                struct page_measure *measure, size_t measures, struct diag *d);

#endif
