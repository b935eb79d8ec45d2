/* Prints the C text of a function in double or in float: its statements, and the test of its denominators. */
#ifndef FOOTPOINT_C_TEXT_H
#define FOOTPOINT_C_TEXT_H

#include "../compile/compiled_file.h"
#include "../program/dialects.h"

/** Returns the statements of a function, which must be freed by c_code_clear() and printer_free(). */
struct c_code c_code_of(const struct unit *u, const struct function *f);

/** Prints the wanted statements (indexed by statement; NULL: all), indented, with short declarations side by side. */
void c_print_packed(const struct c_code *c, const bool *wanted, FILE *out);

/** Prints only the statements that set the operations marked in `needed` (indexed by operation).  The printer has the
 *  texts of all operations; caller frees. */
struct printer *c_print_needed(const struct unit *u, const struct function *f, const bool *needed, FILE *out);

/** Returns true if the status compares with limits that depend on the size of the segment: the header then needs powers of |AB|. */
bool c_scales_status(const struct unit *u, const struct function *f);

/** Returns an integer expression whose highest bit is set if a denominator is too near 0 or too large, with `poles` nearer than the
 *  proof's own threshold.  Caller frees. */
char *c_flaw(const struct unit *u, const struct function *f, bool poles);

/** Prints C text on lines of its own, breaking long lines. */
void c_print_broken(const char *text, FILE *out);

/** Prints statements that name unused parameters, so that no compiler warns. */
void c_print_unused(const struct unit *u, const struct function *f, FILE *out);

#endif
