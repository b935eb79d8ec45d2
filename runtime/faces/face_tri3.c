/* Faces of kind tri3; see face_kind.h. */
#include "../../generated/footpoint_tri3.h"
#include "../../generated/footpoint_tri3_derivatives.h"

#ifdef FOOTPOINT_TRI3_EXACT_PROMISE
#define PROMISE FOOTPOINT_TRI3_EXACT_PROMISE
#endif
#include "face_kind.h"

SEARCH(track, tri3, exact, 3)
KIND(tri3, exact, 3, locate)
