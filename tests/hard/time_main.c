/* Measures the price of certainty: nanoseconds of processor time a search, the least of many runs in turn, for each family, as
 * CSV. Exits 1 if on ordinary segments footpoint_robust takes more than twice as long as the bare expression. */
#include "../../generated/footpoint_quad4.h"
#include "../../runtime/footpoint.h"
#include "hard.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

enum { CASES = 2000, RUNS = 40, METHODS = 5 };

static struct hard_case cases[CASES];
static volatile double sink;

static const char *const names[METHODS] = {"expression", "locate", "robust", "newton", "certify"};

static void search(int method, const struct hard_case *h)
{
    double loc[2] = {0, 0}, dist = 0, rho[2] = {0, 0};
    const double *const a = h->x[0], *const b = h->x[1], *const c = h->x[2], *const d = h->x[3], *const s = h->x[4];
    if (method == 0)
        (void)footpoint_quad4_accurate(a, b, c, d, s, loc, &dist);
    else if (method == 1)
        (void)footpoint_locate(a, b, c, d, s, loc, &dist);
    else if (method == 2)
        (void)footpoint_robust(a, b, c, d, s, loc, &dist);
    else if (method == 3)
        (void)footpoint_newton(a, b, c, d, s, 20, 1e-12, loc, &dist, NULL);
    else
        (void)footpoint_certify(a, b, c, d, s, loc, rho);
    sink = loc[0] + dist + rho[0];
}

static double time_of(int method)
{
    const clock_t start = clock();
    for (int i = 0; i < CASES; i++)
        search(method, &cases[i]);
    return 1e9 * (double)(clock() - start) / CLOCKS_PER_SEC / CASES;
}

int main(void)
{
    int good = 1;
    printf("family");
    for (int m = 0; m < METHODS; m++)
        printf(",%s", names[m]);
    printf("\n");
    for (int family = 0; family < hard_family_count; family++) {
        double least[METHODS];
        for (int i = 0; i < CASES; i++)
            hard_draw(family, 1, (uint64_t)i, &cases[i]);
        for (int m = 0; m < METHODS; m++)
            least[m] = HUGE_VAL;
        for (int run = 0; run < RUNS; run++)
            for (int m = 0; m < METHODS; m++)
                least[m] = fmin(least[m], time_of(m));
        printf("%s", hard_families[family].name);
        for (int m = 0; m < METHODS; m++)
            printf(",%.1f", least[m]);
        printf("\n");
        good = good && (family > 0 || least[2] <= 2 * least[0]);
    }
    return !good;
}
