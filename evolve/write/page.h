/* A picture of a run's results on a mesh: errors by function and gap, and the shapes of the faces. */
#ifndef FOOTPOINT_PAGE_H
#define FOOTPOINT_PAGE_H

#include "../../codegen/base/base.h"
#include "../surface/sample.h"

/** Mean errors of a function in the bands of |gap|, and of its kind's shipped function; negative: no value. */
struct page_row {
    const char *tier; /* not owned */
    double own[GAP_BANDS], shipped[GAP_BANDS];
};

/** A measure of all samples. */
struct page_measure {
    const char *name; /* not owned; includes its unit */
    double *value;    /* owned by the caller */
    size_t n;
    double limit; /* range of the samples on which the shipped functions were bred; negative: no limit */
};

/** Writes the picture, an SVG legible at a width of 400 pixels, titled by `scene` and `kind`. `verdict`: lines, which
 *  are taken apart. Returns false, with *d filled, on failure. */
bool page_write(const char *path, const char *scene, const char *kind, char *verdict, const struct page_row *row,
                size_t rows, const struct page_measure *measure, size_t measures, struct diag *d);

#endif
