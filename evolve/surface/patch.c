/* Patches; see patch.h. */
#include "patch.h"

#include <string.h>

int patch_points(enum patch_kind kind, const double x[][3], struct footpoint_gregory *patch)
{
    if (kind == PATCH_GREGORY)
        return footpoint_gregory_points(x, x + PATCH_NORMALS, patch);
    struct footpoint_bezier net;
    const int status = footpoint_bezier_points(x, x + PATCH_NORMALS, &net);
    if (status != FOOTPOINT_OK)
        return status;
    patch->net = net;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            memcpy(patch->twin[i][j], net.p[1 + i][1 + j], sizeof net.p[0][0]);
    return FOOTPOINT_OK;
}
