/* Faces of kind quad8; see face_kind.h. */
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad8_derivatives.h"

#include "face_kind.h"

KIND(quad8, full, 8, locate)
