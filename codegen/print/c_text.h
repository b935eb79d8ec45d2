/* C text in double or in float: statements, and fixed text that serves both. */
#ifndef FOOTPOINT_C_TEXT_H
#define FOOTPOINT_C_TEXT_H

#include "../compile/compiled_file.h"

/** Prints `text` with @R for the real type, @F for the suffix of its constants, @I for the integer type of its width and
 *  @B for the number of its highest bit, @Z for the least normal number, @D for what begins the names of the
 *  helpers, @G for what ends the names of their guards, @N for `name`. */
void c_print(const char *text, enum precision precision, const char *name, FILE *out);

/** The statements of a function, indented. */
void c_print_statements(const struct unit *u, const struct function *f, FILE *out);

/** Whether the status compares with limits that go with the size of the segment: the header needs powers of |AB|. */
bool c_scales_status(const struct unit *u, const struct function *f);

/** `flaw`, an integer whose highest bit is set where a denominator is too near 0 or too large; with `poles` nearer than
 *  the proof's own threshold. */
void c_print_flaw(const struct unit *u, const struct function *f, bool poles, FILE *out);

/** Inside a comment: what a compiler needs to vectorise a loop over the function. */
void c_print_loop_note(const struct function *f, FILE *out);

/** "    (void)in_x;" for each parameter that the function does not read. */
void c_print_unused(const struct unit *u, const struct function *f, FILE *out);

#endif
