/* C text of a function in double or in float: its statements, and the test of its denominators. */
#ifndef FOOTPOINT_C_TEXT_H
#define FOOTPOINT_C_TEXT_H

#include "../compile/compiled_file.h"
#include "../program/dialects.h"

/** The statements of a function; c_code_clear() and printer_free() free them. */
struct c_code c_code_of(const struct unit *u, const struct function *f);

/** Prints the wanted statements (indexed as those; NULL: all), indented, short declarations side by side. */
void c_print_packed(const struct c_code *c, const bool *wanted, FILE *out);

/** Prints only the statements that set the operations marked in `needed` (indexed by operation).  The printer has the
 *  texts of all operations; caller frees. */
struct printer *c_print_needed(const struct unit *u, const struct function *f, const bool *needed, FILE *out);

/** Whether the status compares with limits that go with the size of the segment: the header needs powers of |AB|. */
bool c_scales_status(const struct unit *u, const struct function *f);

/** An expression, an integer whose highest bit is set where a denominator is too near 0 or too large; with `poles`
 *  nearer than the proof's own threshold.  Caller frees. */
char *c_flaw(const struct unit *u, const struct function *f, bool poles);

/** Prints text of C on lines of its own, broken where they get long. */
void c_print_broken(const char *text, FILE *out);

/** Names the parameters that the function does not read, so that no compiler complains. */
void c_print_unused(const struct unit *u, const struct function *f, FILE *out);

#endif
