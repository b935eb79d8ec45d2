/* Faces of kind quad9; see face_kind.h. */
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_quad9_derivatives.h"

#define IS_CLOSEST is_closest
#include "face_kind.h"

TRACK(quad9, full, 9)
CURVED_KIND(quad9, full, 9, FOOTPOINT_QUAD9_FULL_PROMISE)
