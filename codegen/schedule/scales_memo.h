/* Memo of scales, because different choices often lead a search to the same graph. */
#ifndef FOOTPOINT_SCALES_MEMO_H
#define FOOTPOINT_SCALES_MEMO_H

#include "schedule.h"

/** Of graphs under a single cost model. */
struct scales_memo;
struct scales_memo *scales_memo_new(void);
void scales_memo_free(struct scales_memo *m);

/** Restores the scales and the work of an equal schedule; returns false if the memo has no such schedule. `groups`:
 *  groups of operands were changed, too. */
bool scales_recall(struct scales_memo *m, struct schedule *s, bool groups);
void scales_remember(struct scales_memo *m, const struct schedule *s, bool groups);

#endif
