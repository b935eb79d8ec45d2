/* The archive: the choice of champions from fronts, seeds from files, and the file of fronts. */
#include "../../evolve/common/decimal.h"
#include "../../evolve/eval/frame.h"
#include "../../evolve/write/archive_write.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#define START "/tmp/footpoint_archive_start.gen"
#define WRITTEN "/tmp/footpoint_archive_front.gen"

/* One tier, "steps", with terminals p and q. The champion's constant has more digits than a decimal gene. */
static const char start_text[] = "footpoint-genome 1\ninput xA yA zA xB yB zB xC yC zC xD yD zD xS yS zS\n"
                                 "let p = - xS xA\nlet q = - yS yA\n"
                                 "genome steps\nxi = + 0.12345678901 * p q\neta = q\nend\n"
                                 "genome other\nxi = * p * p q\nend\n";

static struct archive *archive_of(struct scene *s, const char *start)
{
    struct diag d;
    const size_t n = strlen(start_text);
    struct genome_file *program =
        genome_parse("program", start_text, (size_t)(strstr(start_text, "genome steps") - start_text), &d);
    FILE *f = fopen(START, "w");
    assert_true(program && f && fwrite(start_text, 1, n, f) == n && fclose(f) == 0);
    struct archive *a = archive_new(s, program, start, false, &d);
    assert_non_null(a);
    return a;
}

/* Makes random samples with xi = p q, eta = q. */
static struct columns table_of(struct sample_set *set)
{
    struct columns c = columns_new(set->n, 15 + 2 + 2);
    for (size_t i = 0; i < set->n; i++) {
        const double p = set->s[i].xs[0] - set->s[i].x[0][0], q = set->s[i].xs[1] - set->s[i].x[0][1];
        columns_at(&c, 15)[i] = p;
        columns_at(&c, 16)[i] = q;
        columns_at(&c, 17)[i] = p * q;
        columns_at(&c, 18)[i] = q;
    }
    return c;
}

struct fixture {
    struct scene scene;
    struct tier tier;
    struct sample_set set;
    struct columns table;
    struct objective *objective;
    struct plan plan;
};

static int setup(void **state)
{
    static char *terminal[] = {"p", "q"}, precision[] = "double";
    struct fixture *f = new_array(1, sizeof *f);
    f->tier = (struct tier){.name = "steps", .frame = "test", .terminal = terminal, .terminals = 2, .max_length = 9};
    f->scene = (struct scene){.name = "test",
                              .segment = segment_find("quad4"),
                              .norm = NORM_MEAN,
                              .precision = precision,
                              .tier = &f->tier,
                              .tiers = 1};
    f->set.s = new_array(100, sizeof *f->set.s);
    for (f->set.n = 0; f->set.n < 100; f->set.n++) {
        memcpy(f->set.s[f->set.n].x, (double[4][3]){{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 12 * sizeof(double));
        f->set.s[f->set.n].xs[0] = (double)f->set.n / 100;
        f->set.s[f->set.n].xs[1] = 1 - (double)(f->set.n % 7) / 3;
    }
    f->table = table_of(&f->set);
    f->objective = objective_new(NULL, &f->table, NORM_MEAN);
    f->objective->decimal = true;
    f->plan = plan_default();
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    objective_free(f->objective);
    columns_free(&f->table);
    sample_set_free(&f->set);
    free(f);
    unlink(START);
    unlink(WRITTEN);
    return 0;
}

enum { P = GENE_SYMBOL + 15, Q = GENE_SYMBOL + 16 };

static void offer(struct fixture *f, struct archive *a, const int *gene, size_t length)
{
    const struct genes t = {(int *)gene, length};
    const double error = objective_tree_error(f->objective, &t, 17, INFINITY);
    archive_offer(a, &f->plan, &a->quest[0], &t, error, ORIGIN_RANDOM);
}

/* If nothing is better, the champion keeps its genes; otherwise it is replaced, and the new constants are exact. */
static void champions_yield_only_to_better_members(void **state)
{
    struct fixture *f = *state;
    struct archive *a = archive_of(&f->scene, START);
    archive_measure(a, &f->plan, f->objective);
    const struct champion *c = &a->quest[0].champion;
    assert_true(fabs(c->error - 0.12345678901) < 1e-15 && c->cost == 4); /* p and q are differences */
    const int worse[] = {GENE_MUL, P, P}, better[] = {GENE_ADD, decimal_gene(0.125e-3), GENE_MUL, Q, P};
    offer(f, a, worse, 3);
    archive_choose_champions(a, &f->plan, f->objective, NULL);
    assert_false(c->bred);
    assert_string_equal(a->program->constant[-1 - c->genes.gene[1]].text, "0.12345678901");
    offer(f, a, better, 5);
    archive_choose_champions(a, &f->plan, f->objective, NULL);
    assert_true(c->bred && c->genes.length == 5);
    assert_string_equal(a->program->constant[-1 - c->genes.gene[1]].text, "0.000125");
    assert_true(fabs(c->error - 0.125e-3) < 1e-15);
    assert_false(a->quest[1].champion.bred);
    archive_free(a);
}

/* The lowest error within the budget wins, even over a better champion that exceeds the budget. */
static void budgets_decide(void **state)
{
    struct fixture *f = *state;
    const int cheap[] = {GENE_ADD, Q, decimal_gene(-0.1)}, free_of_cost[] = {Q};
    f->tier.budget = 2; /* q is a difference */
    struct archive *a = archive_of(&f->scene, START);
    archive_measure(a, &f->plan, f->objective);
    offer(f, a, free_of_cost, 1);
    offer(f, a, cheap, 3);
    archive_choose_champions(a, &f->plan, f->objective, NULL);
    const struct champion *c = &a->quest[0].champion;
    assert_true(c->bred && c->cost <= 2);
    assert_true(c->error == front_error(a->quest[0].front, 2));
    archive_free(a);
    f->tier.budget = 0;
}

/* Among members within the budget and right to rounding the cheapest wins, otherwise the lowest error. */
static void less_than_rounding_is_no_gain(void **state)
{
    struct fixture *f = *state;
    int dear[] = {GENE_ADD, GENE_MUL, P, P, GENE_MUL, P, GENE_SUB, Q, P}, cheap[] = {GENE_MUL, P, Q};
    const struct genes both[] = {{cheap, 3}, {dear, 9}};
    f->tier.budget = 100;
    for (int far = 0; far < 2; far++) {
        struct archive *a = archive_of(&f->scene, NULL);
        archive_measure(a, &f->plan, f->objective);
        archive_offer(a, &f->plan, &a->quest[0], &both[0], far ? 3e-16 : 2e-16, ORIGIN_RANDOM);
        archive_offer(a, &f->plan, &a->quest[0], &both[1], 5e-17, ORIGIN_RANDOM);
        archive_choose_champions(a, &f->plan, f->objective, NULL);
        assert_int_equal(a->quest[0].champion.genes.length, both[far].length);
        archive_free(a);
    }
    f->tier.budget = 0;
}

static void parsimony_decides_without_a_budget(void **state)
{
    struct fixture *f = *state;
    const int dear[] = {GENE_ADD, GENE_MUL, P, P, GENE_MUL, P, GENE_SUB, Q, P};
    f->plan.parsimony = 0.3;
    struct archive *a = archive_of(&f->scene, NULL);
    archive_measure(a, &f->plan, f->objective);
    offer(f, a, (const int[]){decimal_gene(0.3)}, 1);
    offer(f, a, (const int[]){GENE_MUL, P, Q}, 3);
    offer(f, a, dear, 9);
    archive_choose_champions(a, &f->plan, f->objective, NULL);
    assert_int_equal(a->quest[0].champion.genes.length, 3);
    assert_true(a->quest[0].champion.error == 0);
    archive_free(a);
}

static void seeds_go_where_they_fit(void **state)
{
    struct fixture *f = *state;
    struct diag d;
    struct genes *seed;
    struct archive *a = archive_of(&f->scene, START);
    assert_int_equal(archive_seeds(a, &a->quest[0], &seed), 1); /* the champion */
    assert_true(decimal_valid(seed[0].gene[1]) && decimal_value(seed[0].gene[1]) == 0.1234568);
    free(seed);
    assert_true(archive_read_seeds(a, START, &d));
    assert_int_equal(archive_seeds(a, &a->quest[0], &seed), 3); /* and both genomes of the file */
    free(seed);
    assert_int_equal(archive_seeds(a, &a->quest[1], &seed), 2);
    free(seed);
    f->tier.max_length = 4;
    assert_int_equal(archive_seeds(a, &a->quest[0], &seed), 0);
    f->tier.max_length = 9;
    free(seed);
    archive_add_seed(a, 0, 0, &(struct genes){(int[]){GENE_SYMBOL}, 1}); /* xA is not a terminal */
    assert_int_equal(archive_seeds(a, &a->quest[0], &seed), 3);
    free(seed);
    archive_measure(a, &f->plan, f->objective);
    assert_int_equal(front_count(a->quest[0].front), front_count(a->quest[0].old));
    assert_false(archive_read_seeds(a, "/nowhere/seeds.gen", &d));
    FILE *file = fopen(START, "w");
    fputs("footpoint-genome 1\ninput alien\ngenome g\nxi = alien\nend\n", file);
    fclose(file);
    assert_false(archive_read_seeds(a, START, &d));
    assert_non_null(strstr(d.text, "'xi' uses 'alien'"));
    archive_free(a);
}

/* eta equals q to rounding, xi equals no terminal. So only eta is not evolved, and the genome has a note of it. */
static void exact_values_are_taken(void **state)
{
    struct fixture *f = *state;
    struct diag d;
    struct sampler listed = {.listed = f->set, .count = f->set.n};
    const struct heldout heldout = {.part = {&listed, &listed}};
    const struct run_facts facts = {1, 0, 1};
    f->scene.shapes = (struct shapes){.aspect = 1};
    f->scene.source = SOURCE_RANDOM;
    columns_at(&f->table, 18)[7] += 1e-11;
    for (int known = 0; known < 2; known++) {
        struct archive *a = archive_of(&f->scene, known ? START : NULL);
        const struct champion *xi = &a->quest[0].champion, *eta = &a->quest[1].champion;
        archive_find_exact(a, &f->plan, &f->table, 1e-12);
        assert_true(xi->exact == 0 && eta->exact == 0);
        f->tier.budget = 0.5; /* q is a difference */
        archive_find_exact(a, &f->plan, &f->table, 1e-10);
        assert_int_equal(eta->exact, 0);
        f->tier.budget = 0;
        archive_find_exact(a, &f->plan, &f->table, 1e-10);
        assert_true(xi->exact == 0 && eta->exact == Q);
        archive_measure(a, &f->plan, f->objective);
        assert_true(eta->genes.length == 1 && eta->genes.gene[0] == Q && eta->cost == 1 && eta->bred == !known);
        const int product[] = {GENE_MUL, P, Q}, constant[] = {decimal_gene(0.1)};
        archive_offer(a, &f->plan, &a->quest[1], &(struct genes){(int *)constant, 1}, 0, ORIGIN_RANDOM);
        offer(f, a, product, 3);
        archive_choose_champions(a, &f->plan, f->objective, NULL);
        assert_true(eta->genes.length == 1 && eta->genes.gene[0] == Q && xi->genes.length == 3);
        if (!archive_write(a, WRITTEN, &facts, &heldout, SIZE_MAX, &d))
            fail_msg("%s", d.text);
        struct genome_file *g = genome_read(WRITTEN, &d);
        assert_non_null(g);
        assert_non_null(genome_find_note(g->genome[0].note, g->genome[0].notes, "exact_eta"));
        assert_null(genome_find_note(g->genome[0].note, g->genome[0].notes, "found_eta"));
        assert_null(genome_find_note(g->genome[0].note, g->genome[0].notes, "exact_xi"));
        genome_file_free(g);
        archive_free(a);
    }
}

/* The front's file contains a genome for each member, which reads back as the same expression. */
static void fronts_are_written(void **state)
{
    struct fixture *f = *state;
    struct diag d;
    struct sampler listed = {.listed = f->set, .count = f->set.n};
    const struct heldout heldout = {.part = {&listed, &listed}};
    struct archive *a = archive_of(&f->scene, START);
    f->scene.shapes = (struct shapes){.aspect = 1};
    f->scene.source = SOURCE_RANDOM;
    archive_measure(a, &f->plan, f->objective);
    offer(f, a, (const int[]){GENE_MUL, decimal_gene(0.5), Q}, 3);
    if (!archive_write_front(a, WRITTEN, &heldout, SIZE_MAX, NULL, 0, &d))
        fail_msg("%s", d.text);
    struct genome_file *g = genome_read(WRITTEN, &d);
    assert_non_null(g);
    const size_t xi = front_count(a->quest[0].front), eta = front_count(a->quest[1].front);
    assert_int_equal(g->genomes, xi + eta);
    for (size_t i = 0; i < xi; i++) {
        const struct member *m = front_member(a->quest[0].front, i);
        char name[40];
        snprintf(name, sizeof name, "steps_xi_c%.0f", m->cost);
        assert_string_equal(g->genome[i].name, name);
        assert_int_equal(g->genome[i].out[0].length, m->genes.length);
        assert_non_null(genome_find_note(g->genome[i].note, g->genome[i].notes, "heldout_random"));
    }
    genome_file_free(g);
    archive_free(a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(champions_yield_only_to_better_members, setup, teardown),
        cmocka_unit_test_setup_teardown(budgets_decide, setup, teardown),
        cmocka_unit_test_setup_teardown(less_than_rounding_is_no_gain, setup, teardown),
        cmocka_unit_test_setup_teardown(parsimony_decides_without_a_budget, setup, teardown),
        cmocka_unit_test_setup_teardown(seeds_go_where_they_fit, setup, teardown),
        cmocka_unit_test_setup_teardown(exact_values_are_taken, setup, teardown),
        cmocka_unit_test_setup_teardown(fronts_are_written, setup, teardown),
    };
    return cmocka_run_group_tests_name("archive", tests, NULL, NULL);
}
