/* A judge of answers on the faces of curved_cases.h: it takes Newton's steps in quadruple precision, of shape functions, and
 * shares no code with what it judges. */
#ifndef FOOTPOINT_TESTS_JUDGED_FACES_H
#define FOOTPOINT_TESTS_JUDGED_FACES_H

#include "curved_cases.h"

#include <stdbool.h>

/** Returns the face in another unit of length, so that quadruple precision suffices. */
struct curved_case judged_unit(const struct curved_case *f);

/** Returns whether an answer that is OK is as near to a minimum as promised: to `known`, which is one if *is_known, or to another
 *  that is found now from it, or from about it. */
bool judged_holds(const struct curved_case *f, const double loc[2], double promise, wide known[2], bool *is_known);

#endif
