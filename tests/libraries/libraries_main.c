/* Judges and times searches of libraries on the same faces and slave nodes:
 *   libraries_main CASES LIBRARY.so...
 *
 * Each library is a shared object (library.h). Prints CSV lines
 *   version,LIBRARY,VERSION
 *   search,LIBRARY,SEARCH,KIND,QUESTION,NOTE
 *   family,FAMILY,KIND,LIBRARY,SEARCH,judged,ns,ns_again,right,wrong,refused,endless,crashed,off
 *   derivative,LIBRARY,SEARCH,cases,ns,failed,off,NOTE
 *
 * ns: a search on a new face, and another search on the same face; least processor time of the rounds, in which all
 * libraries take turns in one process. wrong: a wrong answer without a status; refused: a status although there is an
 * answer; endless: not finished in 0.2 s of processor time; crashed: the process died. off: median error of the
 * answers, in longest edges.
 *
 * Each search is judged in its own process, so an endless loop or a crash affects no other. */
#include "library_judge.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MOST_CASES = 2000, MOST_LIBRARIES = 32, MOST_SEARCHES = 96, ROUNDS = 15, LIMIT = 200000 /* microseconds */ };

#define SLOW 1e7   /* passes longer than this (ns) do not depend on caches */
#define ENOUGH 3e8 /* largest time (ns) of a search in a family's rounds; at least one round is run */

static const char *const kind_names[LIBRARY_KINDS] = {"quad4", "tri6", "quad8", "quad9"};
static const char *const question_names[] = {"foot", "inside", "closest", "point"};

/* Written by a child process. */
enum outcome { NOT_DONE, STARTED, DONE, ENDLESS, CRASHED };
struct result {
    int outcome, status;
    struct library_answer answer;
};
struct shared {
    struct result result[MOST_CASES];
    double ns[MOST_SEARCHES][2];
    double off[MOST_CASES];
    int failed[MOST_CASES];
};

static struct shared *shared;
static int cases;
static struct library_truth truths[MOST_CASES];

static const struct library *load(const char *path)
{
    void *const object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    const struct library *(*open_it)(void) = NULL;
    if (object)
        *(void **)&open_it = dlsym(object, "library_open");
    if (!open_it)
        fprintf(stderr, "libraries: %s\n", dlerror());
    return open_it ? open_it() : NULL;
}

static void hush(void)
{
    const int null = open("/dev/null", O_WRONLY);
    (void)dup2(null, STDOUT_FILENO);
    (void)dup2(null, STDERR_FILENO);
}

static void limit(int microseconds)
{
    const struct itimerval t = {{0, 0}, {0, microseconds}};
    (void)setitimer(ITIMER_PROF, &t, NULL);
}

/* ---- judging: a process for each search, and a new process from the case after an endless one ---- */

static void run_from(const void *search, int kind, int first)
{
    const struct library_search *const s = search;
    void *const work = s->open(kind);
    for (int i = first; work && i < cases; i++) {
        struct result *const r = &shared->result[i];
        r->outcome = STARTED;
        limit(LIMIT);
        s->set(work, truths[i].c.x[0]);
        r->status = s->find(work, truths[i].c.xs, &r->answer);
        limit(0);
        r->outcome = DONE;
    }
}

static int next_case(void)
{
    int i = 0;
    while (i < cases && shared->result[i].outcome > STARTED)
        i++;
    return i;
}

/* Runs `run` in a child process whose stdout and stderr are discarded. Returns the child's exit status, or -1. */
static int in_child(void (*run)(const void *, int, int), const void *what, int a, int b)
{
    int status = 0;
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        hush();
        run(what, a, b);
        _exit(0);
    }
    return child > 0 && waitpid(child, &status, 0) == child ? status : -1;
}

static void run_search(const struct library_search *s, int kind)
{
    for (int first = 0, before = -1; first < cases && first != before; first = next_case()) {
        before = first;
        const int status = in_child(run_from, s, kind, first), stopped = next_case();
        if (stopped < cases && shared->result[stopped].outcome == STARTED)
            shared->result[stopped].outcome = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF ? ENDLESS : CRASHED;
    }
}

struct tally {
    int judged, right, wrong, refused, endless, crashed;
    double off; /* median */
    char skip[MOST_CASES];
};

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x, int n)
{
    qsort(x, (size_t)n, sizeof *x, compare);
    return n > 0 ? x[n / 2] : NAN;
}

static void judge(const struct library_search *s, struct tally *t)
{
    static double off[MOST_CASES];
    int answers = 0;
    memset(t, 0, sizeof *t);
    for (int i = 0; i < cases; i++) {
        const struct result *const r = &shared->result[i];
        double away;
        t->skip[i] = r->outcome != DONE;
        if (r->outcome == ENDLESS || r->outcome != DONE) {
            t->endless += r->outcome == ENDLESS;
            t->crashed += r->outcome != ENDLESS;
            continue;
        }
        const enum library_verdict v = library_judge(s->question, &truths[i], r->status, &r->answer, &away);
        t->right += v == VERDICT_RIGHT;
        t->wrong += v == VERDICT_WRONG;
        t->refused += v == VERDICT_REFUSED;
        if (r->status == LIBRARY_ANSWER && v != VERDICT_NONE)
            off[answers++] = away;
    }
    t->judged = t->right + t->wrong + t->refused + t->endless + t->crashed;
    t->off = median(off, answers);
}

/* ---- timing: all libraries take turns in one process ---- */

static struct place {
    const struct library *library;
    const struct library_search *search;
    struct tally tally;
} places[MOST_SEARCHES];
static int place_count;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* Times searches of cases that end, with one workspace for all or one for each. */
static double time_round(const struct library_search *s, const char *skip, void **work, int again)
{
    static struct library_answer answer;
    int count = 0;
    const double start = now();
    for (int i = 0; i < cases; i++)
        if (!skip[i]) {
            if (!again)
                s->set(work[0], truths[i].c.x[0]);
            (void)s->find(work[again ? i : 0], truths[i].c.xs, &answer);
            count++;
        }
    return (now() - start) / count;
}

static void time_all(const void *unused, int kind, int none)
{
    static void *work[MOST_SEARCHES][MOST_CASES];
    double spent[MOST_SEARCHES] = {0};
    (void)unused;
    (void)none;
    for (int p = 0; p < place_count; p++)
        for (int i = 0; i < cases; i++) {
            work[p][i] = places[p].search->open(kind);
            if (!places[p].tally.skip[i])
                places[p].search->set(work[p][i], truths[i].c.x[0]);
        }
    for (int round = 0; round < ROUNDS; round++)
        for (int again = 1; again >= 0; again--)
            for (int p = 0; p < place_count; p++) {
                if ((spent[p] > ENOUGH && isfinite(shared->ns[p][again])) ||
                    places[p].tally.endless + places[p].tally.crashed == cases)
                    continue;
                for (int pass = 0; pass < 2; pass++) { /* the second pass finds code and data in the caches */
                    const double ns = time_round(places[p].search, places[p].tally.skip, work[p], again);
                    spent[p] += ns * cases;
                    shared->ns[p][again] = fmin(shared->ns[p][again], ns);
                    if (ns * cases > SLOW)
                        break;
                }
            }
}

/* ---- families ---- */

static int draw_family(int family, int kind)
{
    int good = 1;
    for (int i = 0; i < cases; i++) {
        struct library_case c;
        library_draw(family, kind, (unsigned long)i, &c);
        if (library_truth_find(kind, &c, &truths[i]))
            continue;
        fprintf(stderr, "libraries: %s %s %d: the references disagree\n", library_families[family].name,
                kind_names[kind], i);
        good = 0;
    }
    return good;
}

static void print_place(const char *family, int kind, int p)
{
    const struct tally *const t = &places[p].tally;
    printf("family,%s,%s,%s,%s,%d,%.1f,%.1f,%d,%d,%d,%d,%d,%.1e\n", family, kind_names[kind], places[p].library->name,
           places[p].search->name, t->judged, shared->ns[p][0], shared->ns[p][1], t->right, t->wrong, t->refused,
           t->endless, t->crashed, t->off);
}

static int run_family(int family, int kind, int libraries, const struct library **library)
{
    const struct library_family *const f = &library_families[family];
    const int good = draw_family(family, kind);
    place_count = 0;
    for (int l = 0; l < libraries; l++)
        for (int k = 0; k < library[l]->searches; k++) {
            const struct library_search *const s = &library[l]->search[k];
            struct place *const p = &places[place_count];
            if (!(s->kinds >> kind & 1) || (s->question == LIBRARY_POINT && !f->on_face) ||
                place_count == MOST_SEARCHES)
                continue;
            memset(shared, 0, sizeof *shared);
            run_search(s, kind);
            p->library = library[l];
            p->search = s;
            judge(s, &p->tally);
            place_count++;
        }
    for (int p = 0; p < place_count; p++)
        shared->ns[p][0] = shared->ns[p][1] = INFINITY;
    if (in_child(time_all, NULL, kind, 0) != 0)
        fprintf(stderr, "libraries: %s %s: not timed\n", f->name, kind_names[kind]);
    for (int p = 0; p < place_count; p++)
        print_place(f->name, kind, p);
    fflush(stdout);
    return good;
}

/* ---- derivatives ---- */

static void run_derivative(const void *derivative, int unused, int none)
{
    const struct library_derivative *const method = derivative;
    double least = INFINITY;
    (void)unused;
    (void)none;
    for (int i = 0; i < cases; i++)
        shared->failed[i] = 1;
    for (int round = 0; round < ROUNDS; round++) {
        double d[3][15], start = now();
        for (int i = 0; i < cases; i++) {
            const struct library_truth *const t = &truths[i];
            const double loc[2] = {(double)t->nearest.z[0], (double)t->nearest.z[1]};
            double x[15];
            memcpy(x, t->c.x, 12 * sizeof *x);
            memcpy(x + 12, t->c.xs, 3 * sizeof *x);
            const int good = method->differentiate(x, loc, d);
            if (round == 0) {
                shared->failed[i] = !good;
                shared->off[i] = good ? library_judge_derivatives(t, (const double(*)[15])d) : 0;
            }
        }
        if (round > 0)
            least = fmin(least, (now() - start) / cases);
    }
    shared->ns[0][0] = least;
}

static void run_derivatives(const struct library *library)
{
    for (int k = 0; k < library->derivatives; k++) {
        int failed = 0;
        double worst = 0;
        memset(shared, 0, sizeof *shared);
        if (in_child(run_derivative, &library->derivative[k], 0, 0) != 0)
            fprintf(stderr, "libraries: derivatives of %s: died\n", library->name);
        for (int i = 0; i < cases; i++) {
            failed += shared->failed[i];
            worst = fmax(worst, shared->off[i]);
        }
        printf("derivative,%s,%s,%d,%.1f,%d,%.1e,%s\n", library->name, library->derivative[k].name, cases,
               shared->ns[0][0], failed, worst, library->derivative[k].note);
    }
}

static void print_library(const struct library *library)
{
    printf("version,%s,%s\n", library->name, library->version);
    for (int k = 0; k < library->searches; k++) {
        const struct library_search *const s = &library->search[k];
        for (int kind = 0; kind < LIBRARY_KINDS; kind++)
            if (s->kinds >> kind & 1)
                printf("search,%s,%s,%s,%s,%s\n", library->name, s->name, kind_names[kind], question_names[s->question],
                       s->note);
    }
}

int main(int argc, char **argv)
{
    const struct library *library[MOST_LIBRARIES];
    int libraries = 0, good = 1;
    cases = argc > 2 ? atoi(argv[1]) : 0;
    if (cases < 1 || cases > MOST_CASES || argc - 2 > MOST_LIBRARIES) {
        fprintf(stderr, "usage: libraries_main CASES LIBRARY.so...\n");
        return 2;
    }
    shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED)
        return 3;
    for (int i = 2; i < argc; i++) {
        library[libraries] = load(argv[i]);
        if (!library[libraries])
            return 3;
        print_library(library[libraries++]);
    }
    for (int kind = 0; kind < LIBRARY_KINDS; kind++)
        for (int family = 0; family < library_family_count; family++)
            if (library_families[family].kinds >> kind & 1)
                good = run_family(family, kind, libraries, library) && good;
    good = draw_family(1, LIBRARY_QUAD4) && good;
    for (int l = 0; l < libraries; l++)
        run_derivatives(library[l]);
    return !good;
}
