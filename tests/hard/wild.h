/* Draws families of hard cases that no mesh should contain: nearly plane and folded, needles, of mixed scales; see wild.c. */
#ifndef FOOTPOINT_WILD_H
#define FOOTPOINT_WILD_H

#include "hard_case.h"

typedef void wild_family(uint64_t *stream, struct hard_case *h);

wild_family wild_flat, wild_flat_quad, wild_flat_crossing, wild_flat_needle, wild_flat_collapsed, wild_flat_pairs;
wild_family wild_scales4, wild_scales8, wild_scales16, wild_needle, wild_pitchfork, wild_on_corner, wild_on_edge;
wild_family wild_pinch, wild_worst;

#endif
