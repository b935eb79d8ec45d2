/* Maps of the errors of our functions over the segment, as files that ParaView opens. */
#ifndef FOOTPOINT_BENCH_MAP_H
#define FOOTPOINT_BENCH_MAP_H

#include "bench_measure.h"

/** FOLDER/SCENE-FUNCTION.vtk for each of our bare searches: mean errors of xi and eta over squares of the box of contact
 *  points, and how many samples each square has (no sample: error 0).  False with *d filled. */
bool bench_map_write(const char *folder, const struct scene *scene, const struct bench_run *run, struct diag *d);

#endif
