/* Writes the results of a run, as files, as tables and as a picture, and samples held out. */
#ifndef FOOTPOINT_ARCHIVE_WRITE_H
#define FOOTPOINT_ARCHIVE_WRITE_H

#include "../archive/archive.h"
#include "../samples/samples.h"

/** Facts about this run, for the provenance of its results. */
struct run_facts {
    uint64_t seed;
    size_t generations, islands;
};

/** Writes the file: notes, program, and a genome for each tier with its errors on the held-out parts, which serve for
 *  nothing else; worst errors include climbing (measure.h).
 *  @param[in] most  samples of a part; SIZE_MAX: all */
bool archive_write(struct archive *a, const char *path, const struct run_facts *run, const struct heldout *heldout,
                   size_t most, struct diag *d);
/** Writes the fronts: a genome of a single output for each member, <tier>_<output>_c<cost>, with its errors.  If the path
 *  ends in .csv: a line for each member of all fronts.
 *  @param[in] judge  of validation samples; NULL: no programs are bred
 *  @param[in] most   limit for archive_members() on each tier of programs; 0: all members */
bool archive_write_front(const struct archive *a, const char *path, const struct heldout *heldout, size_t samples,
                         struct objective *judge, size_t most, struct diag *d);
/** Returns true if the name of a front's file asks for lines. */
bool archive_is_list(const char *path);
/** Writes the lines; worst errors are only those on samples. */
bool archive_write_csv(const struct archive *a, const char *path, const struct heldout *heldout, size_t most,
                       struct diag *d);
/** Prints a table of tier, output, error and genes, before and after. */
void archive_table(const struct archive *a, FILE *stream);
/** Prints a table of the fronts, old against new, with the origin of each member. */
void archive_front_table(const struct archive *a, FILE *stream);

/** Prints the functions of the run to use, beside the functions of the kind of face: at most five lines, by largest gain; or
 *  that no function gains. Prints nothing if nothing is shipped.
 *  @param[in] shipped  the archive of the same scene and of the genomes of its kind, measured
 *  @param[in] judge    of samples held out, on the bare program */
void archive_verdict(const struct archive *a, const struct archive *shipped, struct objective *judge, FILE *stream);

/** Writes CSV: the line "part,<inputs of the segment>,xi,eta", then one for each sample, the part heldout,
 *  heldout_random or heldout_even, the numbers hexadecimal and exact.  `scene` as for scene_read.  Behind a part, as
 *  heldout_climbing or heldout_random_climbing, those that climbing from the worst samples of genomes ends at, of scenes in float
 *  by errors in float.
 *  @param[in] run      seed of the run that holds them out
 *  @param[in] genomes  path of the genomes to climb with, or NULL */
bool samples_write(const char *root, const char *scene, size_t run, const char *genomes, const char *path,
                   struct diag *d);

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
