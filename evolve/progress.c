/* Progress lines; see progress.h. */
#include "progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

enum { LOG_LINES = 20 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

struct progress progress_start(bool shown, size_t generations)
{
    const double t = now();
    return (struct progress){shown, isatty(STDERR_FILENO) == 1, generations, 0, t, t - 1};
}

void progress_show(struct progress *p, size_t generation, const char *best, double work)
{
    const double t = now(), spent = t - p->start, per_second = spent > 0 ? work / spent : 0;
    const bool last = generation >= p->generations;
    const double left = generation > 0 ? spent * (double)(p->generations - generation) / (double)generation : 0;
    if (!p->shown || (p->terminal && !last && t - p->last < 0.2) ||
        (!p->terminal && !last && (generation - p->logged) * LOG_LINES < p->generations))
        return;
    p->last = t;
    p->logged = generation;
    fprintf(stderr, "%sgeneration %zu/%zu  %.1e genes x samples/s  %.0f s left  %s%s%s", p->terminal ? "\r" : "",
            generation, p->generations, per_second, left, best, p->terminal ? "\033[K" : "",
            p->terminal && !last ? "" : "\n");
    fflush(stderr);
}
