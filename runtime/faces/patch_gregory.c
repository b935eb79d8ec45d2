/* Patches of kind gregory; see patch_kind.h. */
#include "../../generated/footpoint_gregory.h"
#include "../../generated/footpoint_gregory_derivatives.h"

#include "patch_kind.h"

PATCH(gregory, full)
