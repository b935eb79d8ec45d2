/* Patches of kind bezier; see patch_kind.h. */
#include "../../generated/footpoint_bezier.h"
#include "../../generated/footpoint_bezier_derivatives.h"

#include "patch_kind.h"

PATCH(bezier, full)
