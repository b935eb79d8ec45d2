/* The search for the cheapest form: over the shapes that a genome was given, and over Horner's choices in each. */
#ifndef FOOTPOINT_SEARCH_H
#define FOOTPOINT_SEARCH_H

#include "../graph/cost.h"
#include "../schedule/lower.h"

/** A genome of more nodes is compiled as it is written: no other shapes of it, and lowered once. */
enum { SEARCH_MOST_NODES = 100000 };

/** A pass that is left out, to measure what it is worth; in the order of the words of --without. */
enum left_out {
    WITHOUT_NOTHING,
    WITHOUT_COMBINE,
    WITHOUT_DISSOLVE,
    WITHOUT_FACTOR,
    WITHOUT_JOIN,
    WITHOUT_DIFFERENCES,
    WITHOUT_EARLY,
    WITHOUT_HORNER,
    WITHOUT_SHARING,
    WITHOUT_DISTRIBUTE,
    WITHOUT_SCALES,
    WITHOUT_GROUPS,
    WITHOUT_MULTIPLES
};

struct compile_options {
    struct cost_model cost;
    int without; /* enum left_out */
    unsigned long seed;
    long effort;           /* work that the search may do, in units of about a millisecond; same effort, same bytes */
    FILE *explain;         /* one line per pass with its counts, or NULL */
    const char *explained; /* not owned: after this pass the graph in infix, too; or NULL */
};

struct form_search;

struct form_search *search_new(const struct genome_file *f, const struct compile_options *o);
void search_free(struct form_search *s);

/** Another shape of the same outputs; the graph becomes the search's.  `what` says in a few words how it was made.  It is
 *  given up if its first estimate is not below `behind` times that of the first shape. */
void search_add(struct form_search *s, struct dag *g, double behind, const char *what);

/** Gives up all shapes but the n that are cheapest at first. */
void search_select(struct form_search *s, size_t n);

/** The shape that was added first. */
const struct dag *search_first(const struct form_search *s);

/** The cheapest program found with the options' effort, NULL if there is none, and how many singularities it removed.
 *  l->program is the caller's. */
struct removed search_run(struct form_search *s, struct lowered *l);

#endif
