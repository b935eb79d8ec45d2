/* Scales that were found for graphs met before: a search comes back to the same graphs by many choices. */
#ifndef FOOTPOINT_SCALES_MEMO_H
#define FOOTPOINT_SCALES_MEMO_H

#include "schedule.h"

/** Of graphs under one cost model. */
struct scales_memo;
struct scales_memo *scales_memo_new(void);
void scales_memo_free(struct scales_memo *m);

/** Sets the scales and the work of a schedule to those found for an equal one; returns false if none is remembered.
 *  `groups`: groups of operands were changed, too. */
bool scales_recall(struct scales_memo *m, struct schedule *s, bool groups);
void scales_remember(struct scales_memo *m, const struct schedule *s, bool groups);

#endif
