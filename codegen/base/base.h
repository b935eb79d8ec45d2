/* Shared by every tool of the project: one-line diagnostics, values of options, memory allocation. Uses only the C
 * library. */
#ifndef FOOTPOINT_BASE_H
#define FOOTPOINT_BASE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define FOOTPOINT_VERSION "0.3.0"

/** Exit codes of every program. */
enum exit_code { EXIT_DONE = 0, EXIT_INPUT = 1, EXIT_USAGE = 2, EXIT_SYSTEM = 3 };

/** A diagnostic, ready to print: "file:line:column: error: ...". */
struct diag {
    enum exit_code code; /* EXIT_INPUT: the text is wrong; EXIT_SYSTEM: the machine failed */
    char text[512];
};

/** Fills *d with "file:line:column: error: message"; line 0 and column 0 are left out. Returns false, so that a reader
 *  can `return diag_at(...)`. */
bool diag_at(struct diag *d, const char *file, int line, int column, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/** Fills *d for a failed system call on a file: "file: error: what: strerror(errno)", code EXIT_SYSTEM. Returns
 *  false. */
bool diag_system(struct diag *d, const char *file, const char *what);

/** Returns true if all standard output was written; otherwise false with *d filled. */
bool stdout_written(struct diag *d);

/** Returns the exit status of main(): flushes standard output, and prints the diagnostic unless all is good. */
int exit_status(bool good, struct diag *d);

/** Reads a text of digits. Returns false for other text and for values of 2^64 or more. */
bool text_whole(const char *text, unsigned long long *value);

/** Returns the index of a word in `words`, which must end with NULL, or -1. */
int text_word(const char *text, const char *const *words);

/** Returns a zeroed array of n elements. If memory is exhausted, prints a line and exits with EXIT_SYSTEM. Free it with
 *  free(). */
void *new_array(size_t n, size_t size);

/** Arrays that are freed together. */
struct arena {
    struct arena_array *last; /* owned, with the arrays before it */
};

/** Returns an array like new_array(), in an arena, which arena_free() empties. */
void *arena_array(struct arena *a, size_t n, size_t size);
void arena_free(struct arena *a);

/** Grows *array (n elements used, *room allocated) so that another fits; exits like new_array. */
void grow_array(void *array, size_t n, size_t *room, size_t size);

/** A new last element of an array that grow_array() grows; the value assigned must not use n. */
#define APPEND(array, n, room) (*(grow_array(&(array), (n), &(room), sizeof *(array)), &(array)[(n)++]))

/** Returns a NUL-terminated copy of n characters; exits like new_array. */
char *new_text(const char *text, size_t n);

/** Returns a whole file as NUL-terminated text (*size without the NUL), or NULL with *d filled. Free it with free(). */
char *read_text(const char *path, size_t *size, struct diag *d);

/** Writes the SHA-256 of `size` bytes as 64 hexadecimal digits and a NUL. */
void sha256_hex(const void *data, size_t size, char hex[65]);

#endif
