/* Calls footpoint_robust on 1000 cases of a family, seed 1, to count instructions: count_main FAMILY; see long/robust_cost.sh. */
#include "../../runtime/footpoint.h"
#include "hard.h"

#include <stdlib.h>

int main(int argc, char **argv)
{
    static struct hard_case h[1000];
    const int family = argc > 1 ? atoi(argv[1]) : 0;
    double sum = 0.0;
    for (int i = 0; i < 1000; i++)
        hard_draw(family, 1, (uint64_t)i, &h[i]);
    for (int i = 0; i < 1000; i++) {
        double loc[2], dist;
        (void)footpoint_robust(h[i].x[0], h[i].x[1], h[i].x[2], h[i].x[3], h[i].x[4], loc, &dist);
        sum += dist;
    }
    return sum == 77.25;
}
