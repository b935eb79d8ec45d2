/* The search for the cheapest form, over the shapes of a genome and over Horner's choices in each. */
#ifndef FOOTPOINT_SEARCH_H
#define FOOTPOINT_SEARCH_H

#include "../graph/cost.h"
#include "../schedule/lower.h"

/** A genome with more nodes is compiled as written: no other shapes, lowered once. */
enum { SEARCH_MOST_NODES = 100000 };

/** A pass that is left out, to measure its worth; in the order of the words of --without. */
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
    long effort;           /* work limit of the search, in units of about a millisecond; same effort, same bytes */
    FILE *explain;         /* a line per pass with its counts; may be NULL */
    const char *explained; /* not owned: also print the graph in infix after this pass; may be NULL */
};

struct form_search;

struct form_search *search_new(const struct genome_file *f, const struct compile_options *o);
void search_free(struct form_search *s);

/** Adds another shape of the same outputs; the search takes over the graph. what: a short description. The shape is
 *  dropped unless its first estimate is below `behind` times that of the first shape. */
void search_add(struct form_search *s, struct dag *g, double behind, const char *what);

/** Drops all shapes except the n that start cheapest. */
void search_select(struct form_search *s, size_t n);

/** Returns the shape that was added first. */
const struct dag *search_first(const struct form_search *s);

/** Finds the cheapest program within the options' effort, may be NULL; returns how many singularities it removed.
 *  l->program is owned by the caller. */
struct removed search_run(struct form_search *s, struct lowered *l);

#endif
