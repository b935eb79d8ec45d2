/* Reads the queries from standard input, without footpoint's code: counts them, and those with several closest points. */
#include <stdio.h>
#include <string.h>

int main(void)
{
    static const char *const kinds[] = {"tri3", "quad4", "tri6", "quad8", "quad9"};
    static const int nodes[] = {3, 4, 6, 8, 9};
    char kind[8], family[16];
    int minima, region, queries = 0, several = 0;
    while (scanf("%7s %15s %d %d", kind, family, &minima, &region) == 4) {
        double x[30], distance, loc[2];
        int k = 0;
        while (k < 5 && strcmp(kind, kinds[k]) != 0)
            k++;
        for (int i = 0; k < 5 && i < 3 * (nodes[k] + 1); i++) /* nodes, then the slave node */
            if (scanf("%lf", &x[i]) != 1)
                return 1;
        if (k == 5 || scanf("%lf", &distance) != 1)
            return 1;
        for (int i = 0; i < minima; i++)
            if (scanf("%lf %lf", &loc[0], &loc[1]) != 2)
                return 1;
        queries++;
        several += minima > 1;
    }
    return printf("%d queries, %d with several closest points\n", queries, several) < 0 || !feof(stdin);
}
