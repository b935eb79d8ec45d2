/* Edges of kind edge3; see face_edge.h. */
#include "../../generated/footpoint_edge3.h"

#include "face_edge.h"

EDGE_KIND(edge3, accurate, 3)
