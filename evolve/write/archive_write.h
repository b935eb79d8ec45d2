/* Writes the results of a run, as files and as tables. */
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
 *  nothing else; worst errors include climbing (climb.h).
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
 *  that no function gains.
 *  @param[in] shipped  the archive of the same scene and of the genomes of its kind, measured
 *  @param[in] judge    of samples held out, on the bare program */
void archive_verdict(const struct archive *a, const struct archive *shipped, struct objective *judge, FILE *stream);

#endif
