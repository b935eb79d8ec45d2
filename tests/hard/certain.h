/* Judges all functions with certain answers on many cases; see certain.c. */
#ifndef FOOTPOINT_CERTAIN_H
#define FOOTPOINT_CERTAIN_H

#include <stdint.h>

/** Judges n cases of all families together, or of one if `only` is not NULL, from number `first` of each on.  Prints a table as CSV
 *  to stdout, with failed cases as lines beginning with #.
 *  @return 1 if all answers were right */
int certain_run(long n, uint64_t seed, long first, const char *only);

#endif
