/* Lines on stderr; see console.h. */
#include "console.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

double seconds_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* mpirun connects its ranks by pipes, so the terminal is mpirun's own, if it runs on this host. */
int console_find(void)
{
    char path[64];
    if (isatty(STDERR_FILENO) == 1)
        return STDERR_FILENO;
    if (!getenv("OMPI_COMM_WORLD_RANK"))
        return -1;
    snprintf(path, sizeof path, "/proc/%ld/fd/2", (long)getppid());
    const int file = open(path, O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0 || isatty(file) == 1)
        return file;
    close(file);
    return -1;
}

void console_leave(int terminal)
{
    if (terminal >= 0 && terminal != STDERR_FILENO)
        close(terminal);
}

int console_columns(int terminal)
{
    struct winsize w;
    return ioctl(terminal, TIOCGWINSZ, &w) == 0 && w.ws_col > 1 ? w.ws_col - 1 : 79;
}

void console_line(int terminal, const char *text)
{
    if (terminal < 0)
        return;
    fprintf(stderr, "\r%.*s\033[K", console_columns(terminal), text);
    fflush(stderr);
}

void time_text(double seconds, char text[TIME_TEXT])
{
    const unsigned long s = (unsigned long)(seconds + 0.5);
    if (s < 100)
        snprintf(text, TIME_TEXT, "%lu s", s);
    else if (s < 3600)
        snprintf(text, TIME_TEXT, "%lu:%02lu min", s / 60, s % 60);
    else
        snprintf(text, TIME_TEXT, "%lu:%02lu h", s / 3600, s / 60 % 60);
}

struct steps steps_start(bool shown, size_t total)
{
    const double now = seconds_now();
    return (struct steps){shown, shown ? console_find() : -1, total, now, now};
}

void steps_show(const struct steps *s, size_t done, const char *what)
{
    char left[TIME_TEXT], line[400];
    if (s->terminal < 0)
        return;
    time_text((seconds_now() - s->start) * (double)(s->total - done) / (double)(done ? done : 1), left);
    if (done)
        snprintf(line, sizeof line, "%s ...  %s left", what, left);
    else
        snprintf(line, sizeof line, "%s ...", what);
    console_line(s->terminal, line);
}

void steps_log(struct steps *s, const char *what)
{
    char took[TIME_TEXT];
    const double now = seconds_now();
    time_text(now - s->last, took);
    s->last = now;
    console_line(s->terminal, "");
    if (s->shown && s->terminal < 0)
        fprintf(stderr, "%s, %s\n", what, took);
}

void steps_end(struct steps *s)
{
    console_line(s->terminal, "");
    console_leave(s->terminal);
    s->terminal = -1;
}
