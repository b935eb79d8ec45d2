/* Edges of kind edge2; see face_edge.h. */
#include "../../generated/footpoint_edge2.h"

#include "face_edge.h"

EDGE_KIND(edge2, exact, 2)
