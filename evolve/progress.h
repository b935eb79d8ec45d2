/* Progress of a run on stderr: one line that updates itself on a terminal, about twenty lines in a log. */
#ifndef FOOTPOINT_PROGRESS_H
#define FOOTPOINT_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

struct progress {
    bool shown, terminal;
    size_t generations, logged; /* to do; of the last line in a log */
    double start, last;         /* seconds */
};

struct progress progress_start(bool shown, size_t generations);

/** Show how far the run is.
 *  @param[in] best  what the best are, one line
 *  @param[in] work  genes times samples evaluated so far, on all processes */
void progress_show(struct progress *p, size_t generation, const char *best, double work);

#endif
