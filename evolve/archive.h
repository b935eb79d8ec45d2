/* The best expression known for each output of each tier: read from the start file, challenged by what the islands
 * find, written with its provenance. */
#ifndef FOOTPOINT_ARCHIVE_H
#define FOOTPOINT_ARCHIVE_H

#include "errors.h"
#include "island.h"
#include "judge.h"
#include "scene.h"

/** One output of one tier. */
struct champion {
    struct tree tree; /* genes owned; length 0: none yet */
    double error;     /* on the training samples, in the scene's norm */
    bool bred;        /* found by this run */
    double error_before;
    size_t length_before; /* 0: there was none */
};

/** What this run is, for the provenance of what it finds. */
struct run_facts {
    uint64_t seed;
    size_t generations, islands;
};

struct archive {
    const struct scene *scene;      /* not owned */
    struct genome_file *program;    /* owned: what the genes mean; the genomes are added on writing */
    struct genome_file *start;      /* owned; NULL: none */
    struct champion (*champion)[2]; /* owned: for each tier xi and eta */
};

/** Champions of the file `start`; none where it is NULL or has no genome of a tier's name.  Takes the program over (and
 *  adds constants to it) even when it returns NULL, with *d filled: the file cannot be read or uses a symbol that the
 *  program lacks. */
struct archive *archive_new(const struct scene *s, struct genome_file *program, const char *start, struct diag *d);
void archive_free(struct archive *a);
/** Measure the champions that were read. */
void archive_judge(struct archive *a, struct judge *j);

/** The genes of a tier: its terminals, + - * and, if rational, protected division, the paper's 201 constants
 *  -5.00..5.00 in steps of 0.05 and those of the tier's champions. */
struct gene_set archive_genes(struct archive *a, size_t tier, bool rational);
/** The champion where it may breed: it uses no other symbols than the tier's terminals and is not too long; or NULL. */
const struct tree *archive_seed(const struct archive *a, size_t tier, int output, size_t max_length);

/** Let a tree take the champion's place if it is better: no higher error, and a lower demerit by the plan. */
void archive_offer(struct archive *a, const struct plan *plan, size_t tier, int output, const struct tree *t,
                   double error);

/** Write the file: notes, program, and one genome for each tier with its errors on the two held-out parts, which serve
 *  for nothing else. */
bool archive_write(struct archive *a, const char *path, const struct run_facts *run, const struct sample_set heldout[2],
                   struct diag *d);
/** Table of tier, output, error and genes, before and after. */
void archive_table(const struct archive *a, FILE *stream);

#endif
