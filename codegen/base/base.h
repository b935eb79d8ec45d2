/* What every tool of the project shares: one-line diagnostics, values of options, the memory gateway.  A leaf: C library
 * only. */
#ifndef FOOTPOINT_BASE_H
#define FOOTPOINT_BASE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define FOOTPOINT_VERSION "0.3.0"

/** Exit codes of every program. */
enum exit_code { EXIT_DONE = 0, EXIT_INPUT = 1, EXIT_USAGE = 2, EXIT_SYSTEM = 3 };

/** One diagnostic, ready to print: "file:line:column: error: ...". */
struct diag {
    enum exit_code code; /* EXIT_INPUT: the text is at fault; EXIT_SYSTEM: the machine is */
    char text[512];
};

/** Fill *d with "file:line:column: error: message"; line 0 and column 0 leave their part out.  Returns false, so that a
 *  reader can `return diag_at(...)`. */
bool diag_at(struct diag *d, const char *file, int line, int column, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/** The same for a failed system call on a file: "file: error: what: strerror(errno)", code EXIT_SYSTEM. */
bool diag_system(struct diag *d, const char *file, const char *what);

/** Whether all that was printed on standard output has arrived; else false with *d filled. */
bool stdout_written(struct diag *d);

/** What main() returns at its end: writes out standard output, and prints the diagnostic unless all is good. */
int exit_status(bool good, struct diag *d);

/** The value of a text of digits; false if it is anything else, or 2^64 and more. */
bool text_whole(const char *text, unsigned long long *value);

/** Index of a word among `words`, which NULL ends; -1: it is none of them. */
int text_word(const char *text, const char *const *words);

/** Zeroed array of n elements; on lack of memory prints one line and exits with EXIT_SYSTEM. Free with free(). */
void *new_array(size_t n, size_t size);

/** Arrays that are freed together. */
struct arena {
    struct arena_array *last; /* owned, with those before it */
};

/** The same as new_array(), in an arena, which arena_free() empties. */
void *arena_array(struct arena *a, size_t n, size_t size);
void arena_free(struct arena *a);

/** Grow *array (n elements used, *room allocated) so that one more fits; exits like new_array. */
void grow_array(void *array, size_t n, size_t *room, size_t size);

/** A new last element of an array that grow_array() grows; what is put there may not use n. */
#define APPEND(array, n, room) (*(grow_array(&(array), (n), &(room), sizeof *(array)), &(array)[(n)++]))

/** Copy of n characters of text, NUL-terminated; exits like new_array. */
char *new_text(const char *text, size_t n);

/** Whole file as NUL-terminated text (*size without the NUL), or NULL with *d filled. Free with free(). */
char *read_text(const char *path, size_t *size, struct diag *d);

/** SHA-256 of `size` bytes as 64 hexadecimal digits and a NUL. */
void sha256_hex(const void *data, size_t size, char hex[65]);

#endif
