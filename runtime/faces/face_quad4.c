/* Faces of kind quad4; see face_kind.h. */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad4_derivatives.h"

#include "face_kind.h"

SEARCH(start, quad4, accurate, 4)
TRACK(quad4, accurate, 4)
KIND(quad4, full, 4, start)
