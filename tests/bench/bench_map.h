/* Maps of our functions' errors over the segment, as files for ParaView. */
#ifndef FOOTPOINT_BENCH_MAP_H
#define FOOTPOINT_BENCH_MAP_H

#include "bench_measure.h"

/** Writes FOLDER/SCENE-FUNCTION.vtk for each of our bare searches: mean errors of xi and eta over squares of the box of
 *  contact points, and each square's number of samples (error 0 if it has no sample). Returns false with *d filled on
 *  errors. */
bool bench_map_write(const char *folder, const struct scene *scene, const struct bench_run *run, struct diag *d);

#endif
