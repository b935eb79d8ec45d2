/* What programs tell while they work, on stderr: one line that updates itself on a terminal, plain lines in a log. */
#ifndef FOOTPOINT_CONSOLE_H
#define FOOTPOINT_CONSOLE_H

#include <stdbool.h>
#include <stddef.h>

/** Seconds on a clock that never goes back. */
double seconds_now(void);

/** The terminal that shows stderr, of mpirun, too; -1: none. */
int console_find(void);
/** Let go of it. */
void console_leave(int terminal);

/** Replace the terminal's line, cut to its width; "" clears it. */
void console_line(int terminal, const char *text);
/** Characters that a line of it holds. */
int console_columns(int terminal);

enum { TIME_TEXT = 32 };
/** "12 s", "2:05 min", "1:02 h". */
void time_text(double seconds, char text[TIME_TEXT]);

/** A job of steps that take about equally long. */
struct steps {
    bool shown;
    int terminal;
    size_t total;
    double start, last; /* seconds */
};

struct steps steps_start(bool shown, size_t total);
/** On a terminal: what is being done, `done` steps being done, and the time left. */
void steps_show(const struct steps *s, size_t done, const char *what);
/** A piece of work is done: in a log, what, and how long it took.  Clears the line of a terminal. */
void steps_log(struct steps *s, const char *what);
void steps_end(struct steps *s);

#endif
