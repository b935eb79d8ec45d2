/* Progress lines; see progress.h. */
#include "progress.h"

#include "../../codegen/base/console.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LOG_LINES = 20, LINE = 400 };
/* Seconds between lines: minimum on a terminal; maximum in a log, at first and later. */
static const double blink = 0.2, first_silence = 10, last_silence = 600;

void progress_phase(bool shown, const char *text)
{
    const int terminal = shown ? console_find() : -1;
    console_line(terminal, text);
    console_leave(terminal);
}

struct progress progress_start(bool shown, size_t first, size_t generations, double until)
{
    const double t = seconds_now();
    return (struct progress){.shown = shown,
                             .terminal = shown ? console_find() : -1,
                             .first = first,
                             .generations = generations,
                             .logged = first,
                             .start = t,
                             .last = t - blink,
                             .mark = {{first, t}, {first, t}},
                             .silence = first_silence,
                             .until = until};
}

static bool due(const struct progress *p, size_t generation, double t)
{
    if (generation >= p->generations)
        return true;
    if (p->terminal >= 0)
        return t - p->last >= blink;
    return (generation - p->logged) * LOG_LINES >= p->generations - p->first || t - p->last >= p->silence;
}

void number_text(double value, char text[NUMBER_TEXT])
{
    snprintf(text, NUMBER_TEXT, "%.1e", value);
    char *zero = strchr(text, 'e');
    if (!zero)
        return;
    zero += zero[1] == '-' ? 2 : 1;
    const size_t zeros = strspn(zero, "+0"), length = strlen(zero);
    memmove(zero, zero + zeros - (zeros == length), length - zeros + 1 + (zeros == length));
}

/* The first generations predict later ones poorly, as do generations on a machine shared with others. So pace is
 * measured from the mark before the last, and a mark is set whenever the number of generations has doubled. */
static void set_mark(struct progress *p, size_t generation, double t)
{
    if (generation - p->first < 2 * (p->mark[1].generation - p->first) || generation == p->mark[1].generation)
        return;
    p->mark[0] = p->mark[1];
    p->mark[1] = (struct progress_mark){generation, t};
}

/* Returns the seconds until the last generation, or until the time limit, in which case *limited is true. */
static double time_left(const struct progress *p, size_t generation, double t, bool *limited)
{
    const struct progress_mark *from = &p->mark[0];
    const double left =
        (t - from->at) * (double)(p->generations - generation) / (double)(generation - from->generation);
    *limited = p->until > 0 && p->until - t < left;
    return *limited ? fmax(p->until - t, 0) : left;
}

void progress_show(struct progress *p, size_t generation, const char *best, const char *brief, double work)
{
    const double t = seconds_now(), spent = t - p->start;
    char line[LINE], rest[TIME_TEXT], speed[NUMBER_TEXT];
    bool limited;
    if (!p->shown || generation == p->first)
        return;
    set_mark(p, generation, t);
    if (!due(p, generation, t))
        return;
    time_text(time_left(p, generation, t, &limited), rest);
    number_text(spent > 0 ? work / spent : 0, speed);
    p->last = t;
    p->logged = generation;
    p->silence = fmin(2 * p->silence, last_silence);
    const int n = snprintf(line, sizeof line, "generation %zu/%zu  %s left%s  %s genes x samples/s  %s", generation,
                           p->generations, rest, limited ? " (limit)" : "", speed, best);
    const int width = p->terminal >= 0 ? console_columns(p->terminal) : LINE - 1;
    if (n > width)
        snprintf(line, sizeof line, "%zu/%zu  %s left  %s/s  %s", generation, p->generations, rest, speed, brief);
    if (p->terminal >= 0)
        fprintf(stderr, "\r%.*s\033[K", width, line);
    else
        fprintf(stderr, "%s\n", line);
    p->open = p->terminal >= 0;
    if (generation >= p->generations)
        progress_break(p);
    fflush(stderr);
}

void progress_break(struct progress *p)
{
    if (p->open)
        fputc('\n', stderr);
    p->open = false;
}
