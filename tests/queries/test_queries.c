/* Tests the library's searches on the public set of queries: with a status that promises it, the distance of
 * footpoint_face_robust is right for every query, and so are the closest point of tri3 and quad4 and the foot point of
 * footpoint_face_locate. */
#define _POSIX_C_SOURCE 200809L
#include "../../runtime/footpoint.h"
#include "../../runtime/footpoint_face.h"
#include "query_text.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

enum { QUERIES = 4000 };

static const enum footpoint_face face_of[] = {FOOTPOINT_TRI3, FOOTPOINT_QUAD4, FOOTPOINT_TRI6, FOOTPOINT_QUAD8,
                                              FOOTPOINT_QUAD9};

typedef int judge(const struct query_text *q);

/* Judges every query: 1 right, 0 refused, -1 wrong. */
static void judge_all(judge *of, int least_right)
{
    FILE *const file = popen("gzip -dc tests/queries/queries.txt.gz", "r");
    struct query_text q;
    int n = 0, right = 0, wrong = 0, got;
    assert_non_null(file);
    while ((got = query_read(file, &q)) == 1) {
        const int verdict = of(&q);
        n++;
        right += verdict > 0;
        wrong += verdict < 0;
        if (verdict < 0)
            fprintf(stderr, "query %d: %s %s\n", n, q.kind, q.family);
    }
    assert_int_equal(pclose(file), 0);
    assert_int_equal(got, 0);

    assert_int_equal(n, QUERIES);
    assert_int_equal(wrong, 0);
    assert_true(right >= least_right);
}

static int is_far_off(const struct query_text *q, const double loc[2], double distance)
{
    const double limit = 1e-10 * q->length;
    return !(fabs((double)(query_distance(q, loc) - q->distance)) <= limit) ||
           !(fabs(fabs(distance) - (double)q->distance) <= limit);
}

static int judge_robust(const struct query_text *q)
{
    double loc[2], distance;
    int region;
    const int status = footpoint_face_robust(face_of[q->index], q->x, loc, &distance, &region);
    const int unique = status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE;
    if (!unique && status != FOOTPOINT_NOT_UNIQUE && status != FOOTPOINT_NO_AREA)
        return 0;
    return is_far_off(q, loc, distance) || (unique && q->minima > 1) ? -1 : 1;
}

/* If the closest point is unique, xi and eta must be within the promise: 1e-12 for quad4, besides rounding. */
static int judge_closest(const struct query_text *q)
{
    double loc[2], distance;
    int region;
    if (q->nodes > 4 || footpoint_face_closest(face_of[q->index], q->x, loc, &distance, &region) != FOOTPOINT_OK)
        return 0;
    if (is_far_off(q, loc, distance))
        return -1;
    for (int k = 0; k < 2 && q->nodes == 4; k++)
        if (!(fabs((double)(loc[k] - q->loc[0][k])) < 1.001e-12) && q->minima == 1)
            return -1;
    return 1;
}

static int judge_foot(const struct query_text *q)
{
    double loc[2], gap;
    if (footpoint_face_locate(face_of[q->index], q->x, loc, &gap) != FOOTPOINT_OK)
        return 0;
    const double unit = fmax(1, fmax(fabs(loc[0]), fabs(loc[1]))), promise = q->nodes == 6 ? 1e-10 : 1e-12;
    return query_newton_step(q, loc) < 1.001 * promise * unit ? 1 : -1;
}

static void robust_distances_are_right(void **state)
{
    (void)state;
    judge_all(judge_robust, 3900);
}

static void closest_points_are_right(void **state)
{
    (void)state;
    judge_all(judge_closest, 1000);
}

static void foot_points_are_right(void **state)
{
    (void)state;
    judge_all(judge_foot, 2000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(robust_distances_are_right),
        cmocka_unit_test(closest_points_are_right),
        cmocka_unit_test(foot_points_are_right),
    };
    return cmocka_run_group_tests_name("queries", tests, NULL, NULL);
}
