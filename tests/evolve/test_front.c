/* A front against its definition: offers in any order end as the set of trees that no other tree beats. */
#include "../../evolve/common/stream.h"
#include "../../evolve/genotype/front.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>

enum { LIMIT = 20, OFFERS = 200, MAX_LENGTH = 3 };

struct offer {
    double error, cost;
};

/* Returns true if another offer costs no more and has no higher error, and is not a later twin. */
static bool outdone(const struct offer *o, int k)
{
    for (int i = 0; i < OFFERS; i++)
        if (i != k && round(o[i].cost) <= round(o[k].cost) &&
            (o[i].error < o[k].error || (o[i].error == o[k].error && (i < k || round(o[i].cost) < round(o[k].cost)))))
            return true;
    return o[k].cost >= LIMIT + 0.5;
}

static void check(const struct front *f, const struct offer *o)
{
    size_t members = 0;
    for (int k = 0; k < OFFERS; k++) {
        if (outdone(o, k))
            continue;
        const struct member *m = &f->member[front_place(f, o[k].cost)];
        members++;
        assert_true(m->genes.length == 1 && m->genes.gene[0] == k);
        assert_true(m->error == o[k].error && m->cost == o[k].cost);
        assert_true(front_error(f, o[k].cost) == o[k].error);
    }
    assert_int_equal(front_count(f), members);
    for (size_t k = 1; k < members; k++) {
        assert_true(front_member(f, k)->cost > front_member(f, k - 1)->cost);
        assert_true(front_member(f, k)->error < front_member(f, k - 1)->error);
    }
    assert_null(front_member(f, members));
}

static void fronts_keep_unbeaten_trees(void **state)
{
    (void)state;
    struct offer o[OFFERS];
    gsl_rng *rng = stream_new();
    struct front *f = front_new(LIMIT, MAX_LENGTH), *copy = front_new(LIMIT, MAX_LENGTH);
    for (uint64_t round = 0; round < 200; round++) {
        stream_key(rng, 8, round, 0, 0);
        front_clear(f);
        assert_true(front_error(f, LIMIT) == INFINITY && front_count(f) == 0);
        for (int k = 0; k < OFFERS; k++) {
            int gene = k;
            const struct genes t = {&gene, 1};
            o[k].cost = gsl_rng_uniform(rng) * (LIMIT + 4);
            o[k].error = (double)gsl_rng_uniform_int(rng, 300) / (1 + o[k].cost);
            const double before = front_error(f, o[k].cost);
            const struct member *m = front_offer(f, &t, o[k].error, o[k].cost);
            assert_true((m != NULL) == (front_place(f, o[k].cost) <= LIMIT && o[k].error < before));
        }
        check(f, o);
        front_copy(f, copy);
        check(copy, o);
    }
    front_free(f);
    front_free(copy);
    gsl_rng_free(rng);
}

static void nonfinite_numbers_are_refused(void **state)
{
    (void)state;
    int gene = 1;
    const struct genes t = {&gene, 1};
    struct front *f = front_new(LIMIT, MAX_LENGTH);
    assert_null(front_offer(f, &t, INFINITY, 1));
    assert_null(front_offer(f, &t, NAN, 1));
    assert_null(front_offer(f, &t, 1, INFINITY));
    assert_int_equal(front_count(f), 0);
    front_free(f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fronts_keep_unbeaten_trees),
        cmocka_unit_test(nonfinite_numbers_are_refused),
    };
    return cmocka_run_group_tests_name("front", tests, NULL, NULL);
}
