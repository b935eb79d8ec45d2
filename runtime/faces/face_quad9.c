/* Faces of kind quad9; see face_kind.h. */
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_quad9_derivatives.h"

#include "face_kind.h"

KIND(quad9, full, 9, locate)
