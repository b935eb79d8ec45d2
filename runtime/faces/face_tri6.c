/* Faces of kind tri6; see face_kind.h. */
#include "../../generated/footpoint_tri6.h"
#include "../../generated/footpoint_tri6_derivatives.h"

#include "face_kind.h"

KIND(tri6, accurate, 6, locate)
