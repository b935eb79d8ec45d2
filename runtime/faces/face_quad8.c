/* Faces of kind quad8; see face_kind.h. */
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad8_derivatives.h"

#define IS_CLOSEST is_closest
#include "face_kind.h"

TRACK(quad8, full, 8)
CURVED_KIND(quad8, full, 8, FOOTPOINT_QUAD8_FULL_PROMISE)
