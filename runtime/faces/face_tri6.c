/* Faces of kind tri6; see face_kind.h. */
#include "../../generated/footpoint_tri6.h"
#include "../../generated/footpoint_tri6_derivatives.h"

#define IS_CLOSEST is_closest
#include "face_kind.h"

TRACK(tri6, accurate, 6)
CURVED_KIND(tri6, accurate, 6, FOOTPOINT_TRI6_ACCURATE_PROMISE)
