/* Progress on stderr: one line that updates itself on a terminal, plain lines in a log. */
#ifndef FOOTPOINT_CONSOLE_H
#define FOOTPOINT_CONSOLE_H

#include <stdbool.h>
#include <stddef.h>

/** Returns seconds on a monotonic clock. */
double seconds_now(void);

/** Returns the terminal on stderr, also that of mpirun, or -1. */
int console_find(void);
/** Releases the terminal. */
void console_leave(int terminal);

/** Replaces the terminal's line, cut to its width; "" clears it. */
void console_line(int terminal, const char *text);
/** Returns the number of characters in a line. */
int console_columns(int terminal);

enum { TIME_TEXT = 32 };
/** Writes "12 s", "2:05 min", "1:02 h". */
void time_text(double seconds, char text[TIME_TEXT]);

/** A job of steps that take about equally long. */
struct steps {
    bool shown;
    int terminal;
    size_t total;
    double start, last; /* seconds */
};

struct steps steps_start(bool shown, size_t total);
/** Shows, on a terminal, the current step, the number of steps done, and the time left. */
void steps_show(const struct steps *s, size_t done, const char *what);
/** Reports a finished step and its duration in a log; clears the line of a terminal. */
void steps_log(struct steps *s, const char *what);
void steps_end(struct steps *s);

#endif
