/* Answers of checked functions with a proof. */
#ifndef FOOTPOINT_HEADER_PROMISE_H
#define FOOTPOINT_HEADER_PROMISE_H

#include "header_lines.h"

/* How functions of a unit prove their answers.
 *   LINEAR: plane triangles, which are exact but for rounding.
 *   BILINEAR: four-node segments with corners in any order, by steps from bred programs.
 *   BOX: four-node segments with an assumed order of corners, in the closed segment, the box of xi and eta; in double.
 *   CURVED: faces of six to nine nodes, by steps on their polynomial surface.
 *   PATCH: patches, by steps from bred programs, in double.
 *   NONE: others; nothing is proved. */
enum promise_kind { PROMISE_NONE, PROMISE_LINEAR, PROMISE_BILINEAR, PROMISE_BOX, PROMISE_CURVED, PROMISE_PATCH };

enum promise_kind promise_kind_of(const struct unit *u);

/** Returns KIND for the templates of answers and of loops over arrays: the segment's kind, or "quad4_box". */
const char *promise_answers(const struct unit *u);

/** Returns true if searches can begin with the last answer (NAME_from). */
bool promise_follows(const struct unit *u);

/** Returns the largest error of xi and eta, relative to max(1, |xi|, |eta|), that FOOTPOINT_OK of a function allows; 0
 *  if it has no proof. */
double promise_of(const struct unit *u, const struct function *f);

/** Prints the definition of the macro NAME_PROMISE if there is a proof. */
void promise_define(const struct unit *u, const struct function *f, FILE *out);

/** Prints a curved face as a polynomial, in a precision, and starts of steps on it. */
void promise_print_terms(const struct unit *u, enum precision precision, FILE *out);

/** Returns the function that starts NAME, itself or a cheaper one; proved steps follow. */
const struct function *promise_start(const struct unit *u, const struct function *f);

/** Returns true if the checked function of any genome, on patches its loop over arrays, starts with f. */
bool promise_starts(const struct unit *u, const struct function *f);

/** Returns true if NAME_at takes steps on the patch from another function's xi and eta, and is not the genome. */
bool promise_walks(const struct unit *u, const struct function *f);

/** Returns lines_words() with KIND from promise_answers(), and PROMISE: the macro, or 0.0, in float -1.0; START: the
 *  function that starts NAME; STEPS: its steps in loops over arrays. For patches STEPS is of calls; ONCE and ONCE_STEPS
 *  are of loops and closest points, whose first proof must succeed, WALKED and WALK_STEPS of NAME_at. */
struct words promise_words(const struct unit *u, const struct function *f);

/** Prints NAME_detail_prove if functions start with f. It takes steps from the xi and eta of f and computes their proof
 *  and the gap; see the template "quad4_steps". Like gap_print, it uses values that the search has computed. */
void promise_print(const struct unit *u, const struct function *f, FILE *out);

#endif
