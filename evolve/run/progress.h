/* Progress of a run on stderr: one line that updates itself on a terminal, plain lines now and then in a log. */
#ifndef FOOTPOINT_PROGRESS_H
#define FOOTPOINT_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

struct progress {
    bool shown, open;          /* open: the terminal's cursor stands behind a line */
    int terminal;              /* that shows stderr; -1: none */
    size_t first, generations; /* begins after, ends with */
    size_t logged;             /* of the last line in a log */
    double start, last;        /* seconds */
    struct progress_mark {
        size_t generation;
        double at;
    } mark[2]; /* two of those passed: the last quarter or half of the run so far, whose pace is that of what is left */
    double silence; /* longest time between lines of a log: seconds, longer with each */
    double until;   /* seconds_now() at which time is up; 0: never */
};

/** On a terminal: what is being done before and after the generations; "" clears the line. */
void progress_phase(bool shown, const char *text);

struct progress progress_start(bool shown, size_t first, size_t generations, double until);

/** Show how far the run is.
 *  @param[in] best   what the best are, one line
 *  @param[in] brief  the same in short, for terminals that are too narrow
 *  @param[in] work   genes times samples evaluated since the start, on all processes */
void progress_show(struct progress *p, size_t generation, const char *best, const char *brief, double work);

enum { NUMBER_TEXT = 16 };
/** "1.2e-3": two digits, no zeros in the exponent. */
void number_text(double value, char text[NUMBER_TEXT]);

/** Leave the line as it is, so that others may write to stderr. */
void progress_break(struct progress *p);

#endif
