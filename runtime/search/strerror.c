/* Words for status codes; see footpoint.h. */
#include "../footpoint.h"

const char *footpoint_strerror(int status)
{
    static const char *const text[FOOTPOINT_STATUS_COUNT] = {
        [FOOTPOINT_OK] = "success",
        [FOOTPOINT_ERR_NOT_FINITE] = "a coordinate is not finite",
        [FOOTPOINT_ERR_DEGENERATE] = "the segment is degenerate",
        [FOOTPOINT_ERR_DOMAIN] = "outside the domain",
        [FOOTPOINT_ERR_NO_CONVERGENCE] = "the iteration did not converge",
        [FOOTPOINT_ERR_ARGUMENT] = "an argument is out of range",
        [FOOTPOINT_OUTSIDE] = "the closest point lies on the edge of the segment",
        [FOOTPOINT_NOT_UNIQUE] = "several points are equally near",
        [FOOTPOINT_UNPROVED] = "the answer could not be proved",
    };
    return status >= 0 && status < FOOTPOINT_STATUS_COUNT ? text[status] : "unknown status";
}
