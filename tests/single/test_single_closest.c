/* Checks closest points of faces of six, eight and nine nodes in float; 1e5 of each kind and group with FOOTPOINT_LONG. */
#define FOOTPOINT_PART static inline /* three kinds are compiled sooner */
#define FOOTPOINT_LOOP static inline
#include "footpoint_quad8_float.h"
#include "footpoint_quad9_float.h"
#include "footpoint_tri6_float.h"

#include "single_cases.h"

#define CLOSEST_FUNCTIONS "../single/single_closest.h"
#include "../generated/test_closest_curved.c"
