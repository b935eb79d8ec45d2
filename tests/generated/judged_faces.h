/* Judges answers on the faces of curved_cases.h by Newton's steps in quadruple precision on shape functions. It shares
 * no code with the judged functions. */
#ifndef FOOTPOINT_TESTS_JUDGED_FACES_H
#define FOOTPOINT_TESTS_JUDGED_FACES_H

#include "curved_cases.h"

#include <stdbool.h>

/** Returns the face in another unit of length, for which quadruple precision suffices. */
struct curved_case judged_unit(const struct curved_case *f);

/** Returns true if an answer with status OK is as near to a minimum as promised: to `known`, which is a minimum if
 *  *is_known, or to another that is found from the answer or near it. */
bool judged_holds(const struct curved_case *f, const double loc[2], double promise, wide known[2], bool *is_known);

#endif
