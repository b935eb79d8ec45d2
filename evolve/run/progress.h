/* Progress of a run on stderr: one line that updates itself on a terminal, occasional plain lines in a log. */
#ifndef FOOTPOINT_PROGRESS_H
#define FOOTPOINT_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

struct progress {
    bool shown, open;          /* open: the terminal's cursor is after a line */
    int terminal;              /* the terminal on stderr, or -1 */
    size_t first, generations; /* first: the generation before the first */
    size_t logged;             /* generation of the last line in a log */
    double start, last;        /* seconds */
    struct progress_mark {
        size_t generation;
        double at;
    } mark[2];      /* two past marks: the last quarter or half of the run so far, whose pace is extrapolated */
    double silence; /* seconds, longest time between lines of a log; grows with each line */
    double until;   /* seconds_now() at the time limit; 0: no limit */
};

/** Shows, on a terminal, the current activity before and after the generations; "" clears the line. */
void progress_phase(bool shown, const char *text);

struct progress progress_start(bool shown, size_t first, size_t generations, double until);

/** Shows the progress of the run. @param[in] best   the best errors, in a line @param[in] brief  a shorter text for
 *  narrow terminals @param[in] work   genes times samples evaluated since the start, on all processes */
void progress_show(struct progress *p, size_t generation, const char *best, const char *brief, double work);

enum { NUMBER_TEXT = 16 };
/** Writes "1.2e-3": two digits, no zeros in the exponent. */
void number_text(double value, char text[NUMBER_TEXT]);

/** Ends the line, so that others may write to stderr. */
void progress_break(struct progress *p);

#endif
