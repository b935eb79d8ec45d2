/* All functions whose answers are certain, put to many cases; see certain.c. */
#ifndef FOOTPOINT_CERTAIN_H
#define FOOTPOINT_CERTAIN_H

#include <stdint.h>

/** n cases in all of all families, or of one if `only` is not NULL, from number `first` of each on; a table as CSV on
 *  stdout, in which cases that went wrong are lines beginning with #.
 *  @return 1 if nothing was wrong */
int certain_run(long n, uint64_t seed, long first, const char *only);

#endif
