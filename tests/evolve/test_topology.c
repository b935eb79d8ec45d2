/* Topologies of migration: permutations without fixed points, whose sources and targets correspond. */
#include "../../evolve/island/topology.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>

#include <cmocka.h>

static struct migration of(enum topology topology, size_t places, size_t number)
{
    return (struct migration){.topology = topology, .seed = 3, .ring = 1, .places = places, .number = number};
}

static void sources_and_targets_belong_together(void **state)
{
    (void)state;
    for (int t = TOPOLOGY_RING; t <= TOPOLOGY_NONE; t++)
        for (size_t places = 1; places <= 40; places++)
            for (size_t number = 1; number <= 4; number++) {
                const struct migration m = of((enum topology)t, places, number);
                for (size_t i = 0; i < places; i++) {
                    const size_t target = topology_target(&m, i);
                    assert_true(target < places);
                    assert_int_equal(topology_source(&m, target), i);
                    assert_int_equal(target == i, t == TOPOLOGY_NONE || places == 1);
                }
            }
}

/* Returns how many islands a genome has reached after some migrations. */
static size_t reached(enum topology topology, size_t places, size_t migrations)
{
    bool here[64] = {true}, next[64];
    size_t n = 0;
    for (size_t k = 1; k <= migrations; k++) {
        const struct migration m = of(topology, places, k);
        for (size_t i = 0; i < places; i++)
            next[i] = here[i] || here[topology_source(&m, i)];
        for (size_t i = 0; i < places; i++)
            here[i] = next[i];
    }
    for (size_t i = 0; i < places; i++)
        n += here[i];
    return n;
}

static void genomes_get_about(void **state)
{
    (void)state;
    assert_int_equal(reached(TOPOLOGY_RING, 36, 10), 11);
    assert_int_equal(reached(TOPOLOGY_TORUS, 36, 10), 36);
    assert_true(reached(TOPOLOGY_RANDOM, 36, 10) > 30);
    assert_int_equal(reached(TOPOLOGY_NONE, 36, 10), 1);
}

static void random_circles_are_single_and_redrawn(void **state)
{
    (void)state;
    size_t differ = 0;
    for (size_t number = 1; number <= 20; number++) {
        const struct migration m = of(TOPOLOGY_RANDOM, 17, number), later = of(TOPOLOGY_RANDOM, 17, number + 1);
        size_t at = 0, steps = 0;
        do {
            differ += topology_target(&m, at) != topology_target(&later, at);
            at = topology_target(&m, at);
            steps++;
        } while (at != 0);
        assert_int_equal(steps, 17);
    }
    assert_true(differ > 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sources_and_targets_belong_together),
        cmocka_unit_test(genomes_get_about),
        cmocka_unit_test(random_circles_are_single_and_redrawn),
    };
    return cmocka_run_group_tests_name("topology", tests, NULL, NULL);
}
