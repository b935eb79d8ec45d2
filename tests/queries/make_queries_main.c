/* Writes queries: faces, slave nodes and their closest points, right to 1e-30.  See README.md for the format. */
#include "draw_queries.h"
#include "global_minimum.h"

#include <stdio.h>
#include <stdlib.h>

enum { DIGITS = 34, TRIES = 200 };

/* Computes xi or eta from s or t. */
static void local_of(enum query_kind kind, arb_t local, const arb_t z)
{
    arb_set(local, z);
    if (query_kind_corners[kind] == 4) {
        arb_mul_2exp_si(local, local, 1);
        arb_sub_si(local, local, 1, PRECISION);
    }
}

static void print_number(const arb_t x)
{
    if (arb_contains_zero(x)) {
        fputs(" 0", stdout);
        return;
    }
    char *const text = arb_get_str(x, DIGITS, ARB_STR_NO_RADIUS);
    printf(" %s", text);
    flint_free(text);
}

/* Returns 1 if all are known to 1e-32: local coordinates, and the distance relative to itself, or to `length` if it may be 0. */
static int is_sharp(const struct minima *found, arb_t distance, double length)
{
    int sharp = 1;
    for (int i = 0; i < found->n; i++)
        for (int k = 0; k < 2; k++)
            sharp &= mag_cmp_2exp_si(arb_radref(found->at[i].z[k]), -107) < 0;
    arb_sqrtpos(distance, found->at[0].square, PRECISION);
    return sharp && (arb_rel_accuracy_bits(distance) > 107 ||
                     (arb_contains_zero(distance) && mag_get_d(arb_radref(distance)) < 1e-32 * length));
}

static void print_query(enum query_kind kind, int family, const double *x, const struct minima *found,
                        const arb_t distance)
{
    arb_t local;
    arb_init(local);
    printf("%s %s %d %d", query_kind_name[kind], query_family_name[family], found->n, found->at[0].region);
    for (int i = 0; i < 3 * (query_kind_nodes[kind] + 1); i++)
        printf(" %a", x[i]);
    print_number(distance);
    for (int i = 0; i < found->n; i++)
        for (int k = 0; k < 2; k++) {
            local_of(kind, local, found->at[i].z[k]);
            print_number(local);
        }
    putchar('\n');
    arb_clear(local);
}

static double length_of(enum query_kind kind, const double *x)
{
    double length = 0;
    for (int i = 0; i < 3 * query_kind_nodes[kind]; i++) {
        const double off = x[i] - x[3 * query_kind_nodes[kind] + i % 3];
        length = off > length ? off : -off > length ? -off : length;
    }
    return length;
}

/* Draws until the closest points of a query are proved and sharp; returns the number of failures. */
static int write_query(enum query_kind kind, int family, uint64_t state, struct minima *found)
{
    arb_t distance;
    int tries = 0, good = 0;
    arb_init(distance);
    for (; tries < TRIES && !good; tries++) {
        double x[3 * (QUERY_NODES + 1)];
        draw_query(kind, family, &state, x);
        good = minima_find(kind, x, found) && (family != TIE || kind == QUERY_TRI3 || found->n > 1) &&
               is_sharp(found, distance, length_of(kind, x));
        if (good)
            print_query(kind, family, x, found, distance);
    }
    arb_clear(distance);
    return good ? tries - 1 : TRIES;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 0;
    const int count = argc > 2 ? atoi(argv[2]) : 0;
    if (argc != 3 || count <= 0)
        return fputs("usage: make_queries SEED COUNT       COUNT: of each kind of face and family\n", stderr), 2;
    struct minima found;
    minima_init(&found);
    for (int kind = 0; kind < QUERY_KINDS; kind++)
        for (int family = 0; family < FAMILIES; family++) {
            int again = 0;
            for (int i = 0; i < count; i++)
                again += write_query((enum query_kind)kind, family,
                                     seed * 0x2545f4914f6cdd1d + (uint64_t)(kind * FAMILIES + family) * 0x100000000 +
                                         (uint64_t)i,
                                     &found);
            if (again)
                fprintf(stderr, "%s %s: %d drawn again\n", query_kind_name[kind], query_family_name[family], again);
        }
    minima_clear(&found);
    return fflush(stdout) == EOF || ferror(stdout) ? 3 : 0;
}
