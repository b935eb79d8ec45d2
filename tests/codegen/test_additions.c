/* The fewest additions for the vectors of a segment: the additions found compute the vectors and are as few as known;
 * and code for such a segment adds only differences of coordinates. */
#include "../../codegen/compile/compile.h"
#include "../../codegen/passes/addition_chain.h"
#include "../../codegen/program/evaluate.h"
#include "../../codegen/prove/prove.h"
#include "../support/genome_text.h"

#include <stdio.h>

enum { POINTS = 5, ROUNDS = 40 };

/* Every value equals its addition, of points or of differences; all wanted values are among them. */
static void check_found(const struct additions *x, const struct vector *wanted, int n)
{
    for (int i = 0; i < x->points; i++)
        for (int k = 0; k < x->points; k++)
            assert_int_equal(x->value[i].of[k], i == k);
    for (int i = x->points; i < x->values; i++) {
        const struct addition *s = &x->addition[i];
        long weight = 0;
        assert_true(s->a < i && s->b < i && s->d != 0 && (s->a < x->points) == (s->b < x->points));
        for (int k = 0; k < x->points; k++) {
            weight += x->value[i].of[k];
            assert_int_equal(s->d * x->value[i].of[k], s->p * x->value[s->a].of[k] + s->q * x->value[s->b].of[k]);
        }
        assert_int_equal(weight, 0);
    }
    for (int i = 0; i < n; i++) {
        int k = x->points;
        while (k < x->values && !vector_equal(&x->value[k], &wanted[i]))
            k++;
        assert_true(k < x->values);
    }
}

/* Corners A, B, C, D and the slave node: base vectors at the centre, the vector from there to the slave node, the mixed
 * derivative. */
static void quad4_takes_the_fewest_additions(void **state)
{
    (void)state;
    static const struct vector wanted[] = {{{1, -1, -1, 1}}, {{1, 1, -1, -1}}, {{1, 1, 1, 1, -4}}, {{1, -1, 1, -1}}};
    struct additions x;
    assert_true(additions_find(POINTS, wanted, 3, 12, &x));
    check_found(&x, wanted, 3);
    assert_int_equal(x.values - POINTS, 8);
    assert_int_equal(x.multiplications, 1);
    assert_false(additions_find(POINTS, wanted, 3, 7, &x));
    assert_true(additions_find(POINTS, wanted, 4, 12, &x));
    check_found(&x, wanted, 4);
    assert_int_equal(x.values - POINTS, 9);
}

/* Eight nodes and the slave node: base vectors, second and third derivatives, the vector to the slave node. */
static void quad8_takes_the_fewest_additions(void **state)
{
    (void)state;
    enum { WANTED = 8, SEEDS = 12 };
    static const struct vector wanted[WANTED] = {{{0, 0, 0, 0, 0, 1, 0, -1}},
                                                 {{0, 0, 0, 0, 1, 0, -1}},
                                                 {{1, 1, 1, 1, -2, 0, -2}},
                                                 {{1, 1, 1, 1, 0, -2, 0, -2}},
                                                 {{1, -1, 1, -1}},
                                                 {{1, 1, -1, -1, -2, 0, 2}},
                                                 {{1, -1, -1, 1, 0, 2, 0, -2}},
                                                 {{1, 1, 1, 1, -2, -2, -2, -2, 4}}};
    int least = ADDITIONS_VALUES;
    assert_false(additions_few(9, WANTED));
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        struct additions x;
        assert_true(additions_along_tree(9, wanted, WANTED, seed, &x));
        check_found(&x, wanted, WANTED);
        const int cost = x.values - x.points + x.multiplications;
        least = cost < least ? cost : least;
    }
    assert_true(least <= 25); /* sums of coordinates would allow 19 additions and 5 multiplications */
}

/* Random vectors, made by additions, are found again in at most as many additions. */
static void hidden_additions_are_found_again(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int round = 0; round < ROUNDS; round++) {
        enum { ADDITIONS = 5, WANTED = 2 };
        struct vector value[ADDITIONS] = {{{0}}};
        struct additions x;
        long divisor;
        for (int i = 0; i < ADDITIONS; i++) {
            const size_t a = random_next(&seed) % POINTS, b = (a + 1 + random_next(&seed) % (POINTS - 1)) % POINTS;
            const long factor = random_next(&seed) % 2 ? 1 : 2;
            if (i < 3) {
                value[i].of[a]++;
                value[i].of[b]--;
            }
            for (int k = 0; i >= 3 && k < POINTS; k++)
                value[i].of[k] = value[i - 1].of[k] - factor * value[i - 3].of[k];
        }
        if (!vector_reduce(&value[3], &divisor) || !vector_reduce(&value[4], &divisor) ||
            vector_equal(&value[3], &value[4]))
            continue;
        assert_true(additions_find(POINTS, &value[3], WANTED, ADDITIONS, &x));
        check_found(&x, &value[3], WANTED);
    }
}

/* One Gauss-Newton step from the centre of a segment, with plain vectors. */
static const char step[] =
    "footpoint-genome 1\ninput xA yA zA xB yB zB xC yC zC xD yD zD xS yS zS\nsegment quad4 any\n"
    "let ux = - + xB xC + xA xD\nlet uy = - + yB yC + yA yD\nlet uz = - + zB zC + zA zD\n"
    "let vx = - + xC xD + xA xB\nlet vy = - + yC yD + yA yB\nlet vz = - + zC zD + zA zB\n"
    "let dx = - * 4 xS + + + xA xB xC xD\nlet dy = - * 4 yS + + + yA yB yC yD\nlet dz = - * 4 zS + + + zA zB zC zD\n"
    "let uu = + + * ux ux * uy uy * uz uz\nlet uv = + + * ux vx * uy vy * uz vz\nlet vv = + + * vx vx * vy vy * vz vz\n"
    "let ud = + + * ux dx * uy dy * uz dz\nlet vd = + + * vx dx * vy dy * vz dz\n"
    "let det = - * uu vv * uv uv\n"
    "genome step\nxi = / - * vv ud * uv vd det\neta = / - * uu vd * uv ud det\nend\n";

static void code_adds_only_differences(void **state)
{
    (void)state;
    struct compiled c;
    struct proof how;
    struct diag d = {0};
    struct compile_options o = compile_defaults();
    o.effort = 20;
    struct genome_file *f = parse(step);
    if (!compile_genome(f, &f->genome[0], &o, &c, &d))
        fail_msg("%s", d.text);
    struct program *p = read_program(f, 0, c.text);
    assert_true(prove_equal(f, &f->genome[0], p, &how, &d));
    assert_int_equal(c.ops.div, 1);
    assert_true(c.ops.add <= 37 && c.ops.mul <= 26);
    for (size_t i = 0; i < p->ops; i++) {
        const struct op *op = &p->op[i];
        if (op->kind == OP_ADD)
            assert_true(p->op[op->a].kind != OP_INPUT && p->op[op->b].kind != OP_INPUT);
    }
    program_free(p);
    compiled_free(&c);
    genome_file_free(f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quad4_takes_the_fewest_additions),
        cmocka_unit_test(quad8_takes_the_fewest_additions),
        cmocka_unit_test(hidden_additions_are_found_again),
        cmocka_unit_test(code_adds_only_differences),
    };
    return cmocka_run_group_tests_name("additions", tests, NULL, NULL);
}
