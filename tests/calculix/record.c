/* Wraps CalculiX's search (ld --wrap=attach_2d_): counts calls and their time, and records their inputs, for one
 * thread. At exit "calls SECONDS" go to $SEARCH_TIMES, and records to $SEARCH_RECORDS: the number of nodes as a double,
 * their coordinates, and the slave node's. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { RECORDS = 40000, EVERY = 5 };

void __real_attach_2d_(double (*pneigh)[3], double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                       double *etl);
void __wrap_attach_2d_(double (*pneigh)[3], double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                       double *etl);

static long calls, kept;
static double seconds;
static FILE *records;

static void finish(void)
{
    const char *const path = getenv("SEARCH_TIMES");
    FILE *const f = path ? fopen(path, "w") : NULL;
    if (f) {
        fprintf(f, "%ld %.6f\n", calls, seconds);
        fclose(f);
    }
    if (records)
        fclose(records);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void keep(double (*pneigh)[3], const double *pnode, int nterms)
{
    const double nodes = nterms;
    fwrite(&nodes, sizeof nodes, 1, records);
    fwrite(pneigh, sizeof *pneigh, (size_t)nterms, records);
    fwrite(pnode, sizeof *pnode, 3, records);
}

void __wrap_attach_2d_(double (*pneigh)[3], double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                       double *etl)
{
    if (calls == 0) {
        const char *const path = getenv("SEARCH_RECORDS");
        records = path ? fopen(path, "wb") : NULL;
        atexit(finish);
    }
    if (records && calls % EVERY == 0 && kept++ < RECORDS)
        keep(pneigh, pnode, *nterms);
    calls++;
    const double start = now();
    __real_attach_2d_(pneigh, pnode, nterms, ratio, dist, xil, etl);
    seconds += now() - start;
}
