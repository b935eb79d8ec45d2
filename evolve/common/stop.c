/* Signals; see stop.h. */
#include "stop.h"

#include <signal.h>
#include <unistd.h>

static volatile sig_atomic_t noted;

static void note(int signal)
{
    const enum stop_reason reason = signal == SIGINT    ? STOP_INTERRUPTED
                                    : signal == SIGTERM ? STOP_TERMINATED
                                                        : STOP_WARNED;
    if (signal == SIGINT && noted == STOP_INTERRUPTED)
        _exit(128 + SIGINT);
    if ((int)reason > noted)
        noted = (sig_atomic_t)reason;
}

void stop_listen(void)
{
    struct sigaction action = {.sa_handler = note, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    sigaction(SIGUSR1, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGINT, &action, NULL);
    signal(SIGXFSZ, SIG_IGN);
}

enum stop_reason stop_noted(void)
{
    return (enum stop_reason)noted;
}

const char *stop_name(enum stop_reason reason)
{
    static const char *const name[STOP_REASONS] = {"done", "time limit", "SIGUSR1", "SIGTERM", "SIGINT"};
    return name[reason];
}

int stop_status(enum stop_reason reason)
{
    return reason == STOP_INTERRUPTED ? 128 + SIGINT : reason == STOP_TERMINATED ? 128 + SIGTERM : 0;
}
