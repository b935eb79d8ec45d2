/* Describes statuses in words; see footpoint.h. */
#include "../footpoint.h"

#define TEXT(status) [(status)-FOOTPOINT_STATUS_LEAST]

const char *footpoint_strerror(int status)
{
    static const char *const text[] = {
        TEXT(FOOTPOINT_OK) = "success",
        TEXT(FOOTPOINT_OUTSIDE) = "on the edge of the segment, or beyond it",
        TEXT(FOOTPOINT_NOT_UNIQUE) = "several points are equally good",
        TEXT(FOOTPOINT_NO_AREA) = "the segment has no area",
        TEXT(FOOTPOINT_UNPROVED) = "an answer that is not proved",
        TEXT(FOOTPOINT_ERR_NOT_FINITE) = "a coordinate is not finite",
        TEXT(FOOTPOINT_ERR_DEGENERATE) = "the segment is degenerate",
        TEXT(FOOTPOINT_ERR_DOMAIN) = "outside the domain",
        TEXT(FOOTPOINT_ERR_NO_CONVERGENCE) = "the iteration did not converge",
        TEXT(FOOTPOINT_ERR_ARGUMENT) = "an argument is out of range",
        TEXT(FOOTPOINT_ERR_UNPROVED) = "the proof failed",
    };
    const int known = status >= FOOTPOINT_STATUS_LEAST && status <= FOOTPOINT_STATUS_MOST;
    return known ? text[status - FOOTPOINT_STATUS_LEAST] : "unknown status";
}
