/* Answers of checked functions with a proof. */
#ifndef FOOTPOINT_HEADER_PROMISE_H
#define FOOTPOINT_HEADER_PROMISE_H

#include "header_lines.h"

/* How functions of a unit prove their answers, in double: of plane triangles, which are exact but for rounding; of bilinear
 * segments with corners in any order, in float, too, by steps from what bred programs find, and with corners in an order
 * that is assumed, in the closed segment, the box of xi and eta; of faces of six to nine nodes, by steps of their polynomial
 * surface; of patches, by steps on them from what bred programs find.  Others prove nothing. */
enum promise_kind { PROMISE_NONE, PROMISE_LINEAR, PROMISE_BILINEAR, PROMISE_BOX, PROMISE_CURVED, PROMISE_PATCH };

enum promise_kind promise_kind_of(const struct unit *u);

/** Returns KIND of the templates of answers and of loops over arrays: that of the segment, or "quad4_box". */
const char *promise_answers(const struct unit *u);

/** Whether searches can begin with the last answer: NAME_from. */
bool promise_follows(const struct unit *u);

/** The largest error of xi and eta, relative to max(1, |xi|, |eta|), that FOOTPOINT_OK of a function allows; 0: it has no
 *  proof. */
double promise_of(const struct unit *u, const struct function *f);

/** Defines the macro that says it, NAME_PROMISE, if there is a proof. */
void promise_define(const struct unit *u, const struct function *f, FILE *out);

/** The function that NAME begins with, itself or a cheaper one: steps that are proved do the rest. */
const struct function *promise_start(const struct unit *u, const struct function *f);

/** Whether the checked function of any genome begins with f. */
bool promise_starts(const struct unit *u, const struct function *f);

/** lines_words() with KIND of promise_answers(), and PROMISE, the macro, or 0.0, in float -1.0; START, the function that NAME begins with; STEPS, those of it in loops over
 *  arrays. */
struct words promise_words(const struct unit *u, const struct function *f);

/** NAME_detail_prove, if functions begin with f: from its xi and eta steps, their proof and the gap; see "quad4_steps" of the
 *  templates.  It takes what the search has computed, as gap_print does. */
void promise_print(const struct unit *u, const struct function *f, FILE *out);

#endif
