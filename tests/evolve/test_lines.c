/* Programs and functions of frames: values against genome text, derivatives against differences, operations counted by
 * hand, changes, hand-written methods among the seeds, and evolution from them. */
#include "../../evolve/archive/archive.h"
#include "../../evolve/common/decimal.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/eval/errors.h"
#include "../../evolve/eval/frame.h"
#include "../../evolve/fit/compose.h"
#include "../../evolve/fit/fit_lines.h"
#include "../../evolve/fit/fits.h"
#include "../../evolve/genotype/lines_edit.h"
#include "../../evolve/genotype/lines_text.h"
#include "../../evolve/genotype/tree.h"
#include "../../evolve/island/island.h"
#include "../../evolve/island/population.h"
#include "../../evolve/samples/samples.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { LONGEST = 2 + LINE_GENES * 150 };

struct fixture {
    struct scene *scene;
    struct archive *archive;
    struct genome_file *program; /* owned by the archive */
    struct sample_set set;
    struct columns table;
    struct objective *objective;
    struct gene_set genes;
    struct plan plan;
    struct lines *lines;
    int last; /* place */
};

static int setup(void **state)
{
    struct fixture *f = new_array(1, sizeof *f);
    struct diag d;
    f->scene = scene_read(".", "tests/scenes/steps.scene", &d);
    assert_non_null(f->scene);
    f->program = frame_program(".", f->scene, "steps", &d);
    assert_non_null(f->program);
    f->archive = archive_new(f->scene, f->program, NULL, false, &d);
    assert_true(f->archive && scene_samples(f->scene, PART_TRAINING, &f->set, &d));
    f->table = frame_columns(f->program, f->set.s, f->set.n);
    f->objective = objective_new(f->program, &f->table, NORM_MEAN);
    f->objective->decimal = true;
    f->genes = archive_genes(f->archive, 0, false);
    f->plan = plan_default();
    f->lines = lines_new(f->objective->rules);
    f->last = line_function(f->program, "place");
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    gene_set_free(&f->genes);
    lines_free(f->lines);
    objective_free(f->objective);
    columns_free(&f->table);
    sample_set_free(&f->set);
    archive_free(f->archive);
    scene_free(f->scene);
    free(f);
    return 0;
}

/* Reads a program of two answers after its own lets; the caller owns the genes. Length 0: it is not a program. */
static struct genes read_program(const struct fixture *f, const char *lets, const char *xi, const char *eta,
                                 bool called)
{
    char *text = NULL;
    size_t size;
    struct diag d;
    FILE *stream = open_memstream(&text, &size);
    genome_print(f->program, stream);
    fprintf(stream, "%s\ngenome one\nxi = %s\neta = %s\nend\n", lets, xi, eta);
    fclose(stream);
    struct genome_file *g = genome_parse("text", text, size, &d);
    assert_non_null(g);
    const struct genome_expr *const out[2] = {&g->genome[0].out[0], &g->genome[0].out[1]};
    struct genes t = {new_array(LONGEST, sizeof *t.gene), 0};
    if (!lines_read(f->lines, g, out, &f->genes, called, LONGEST, &t))
        t.length = 0;
    genome_file_free(g);
    free(text);
    return t;
}

/* A chain of functions from p, q: "let u v = newton p q\nlet ..." */
static struct genes program_of(const struct fixture *f, const char *lets, const char *xi, const char *eta)
{
    const struct genes t = read_program(f, lets, xi, eta, false);
    assert_true(t.length > 0 && lines_valid(f->objective->rules, t.gene, t.length));
    return t;
}

static double error_of(const struct fixture *f, const struct genes *t)
{
    return objective_error(f->objective, t, f->last, INFINITY);
}

static double cost_of(const struct fixture *f, const struct genes *t)
{
    struct lines_counter *c = lines_counter_new(f->objective->rules);
    const struct operation_count o = count_lines(c, t, -1);
    lines_counter_free(c);
    return operations_price(&o, &f->plan.prices);
}

/* Compares the errors of a program, bit by bit or both infinite, with those of its expressions in a copy of the frame,
 * from which the same program is read again. */
static void check_against_text(const struct fixture *f, const struct genes *t)
{
    const size_t n = f->set.n;
    double *error = new_array(2 * n, sizeof *error), *value = new_array(n, sizeof *value);
    char *text = NULL;
    size_t size;
    struct diag d;
    struct genes out[2];
    FILE *stream = open_memstream(&text, &size);
    genome_print(f->program, stream);
    fclose(stream);
    struct genome_file *copy = genome_parse("copy", text, size, &d);
    assert_non_null(copy);
    lines_expand(f->lines, t, f->last, copy, "value", out);
    struct columns table = frame_columns(copy, f->set.s, n);
    lines_errors(f->objective->lines, t, f->last, INFINITY, error);
    for (size_t half = 0; half < 2; half++) {
        table_values(&table, copy->constant, out[half].gene, out[half].length, value);
        for (size_t i = 0; i < n; i++) {
            const double e = fabs(value[i] - columns_at(&table, frame_target(copy, (int)half))[i]);
            assert_true(isnan(e) ? error[half * n + i] == INFINITY : error[half * n + i] == e);
        }
    }
    const struct genome_expr answer[2] = {{.name = "xi", .gene = out[0].gene, .length = out[0].length},
                                          {.name = "eta", .gene = out[1].gene, .length = out[1].length}};
    const struct genome_expr *const both[2] = {&answer[0], &answer[1]};
    struct genes again = {new_array(LONGEST, sizeof *again.gene), 0};
    assert_true(lines_read(f->lines, copy, both, &f->genes, true, LONGEST, &again) && genes_equal(t, &again));
    free(again.gene);
    free(out[0].gene);
    free(out[1].gene);
    columns_free(&table);
    genome_file_free(copy);
    free(text);
    free(error);
    free(value);
}

/* Changed programs are valid, equal to their text, and in the same powers of a length as their parents. */
static void changed_programs_match_their_text(void **state)
{
    const struct fixture *f = *state;
    struct line_editor *e = line_editor_new(f->objective->rules);
    struct fits *fits = fits_new(f->objective);
    const struct fitting hooks = fits_hooks(fits);
    struct genes mate = program_of(f, "let u v = newton_kept ut vt", "u", "v");
    struct genes t = program_of(f, "let us1 vs1 = newton p q\nlet u v = solve_u us1 vs1", "u", "v");
    struct genes child = {new_array(LONGEST, sizeof *child.gene), 0};
    const struct genes parents[2] = {t, mate};
    struct genes now = {new_array(LONGEST, sizeof *now.gene), 0};
    gsl_rng *rng = stream_new();
    size_t changed = 0;
    for (uint64_t k = 0; k < 400; k++) {
        stream_key(rng, 7, k, 0, 0);
        if (k % 8 == 0)
            genes_copy(&parents[k / 8 % 2], &now);
        if (!hooks.change(fits, rng, &f->genes, &now, &mate, f->last, LONGEST, &child))
            continue;
        assert_true(lines_valid(f->objective->rules, child.gene, child.length) && child.length <= LONGEST);
        signed char power[4 * LONGEST];
        lines_load(f->lines, &child, -1, LINES_INNER);
        lines_powers(f->lines, power);
        assert_true(lines_keep_powers(f->lines));
        for (int h = 0; h < 2; h++)
            assert_true(power[f->lines->root[h]] == 0 || power[f->lines->root[h]] == ANY_POWER);
        if (k % 4 == 0)
            check_against_text(f, &child);
        genes_copy(&child, &now);
        changed++;
    }
    assert_true(changed > 200);
    gsl_rng_free(rng);
    fits_free(fits);
    line_editor_free(e);
    free(t.gene);
    free(mate.gene);
    free(child.gene);
    free(now.gene);
}

/* Equal values occur once, and unused values are dropped. */
static void equal_values_occur_once(void **state)
{
    const struct fixture *f = *state;
    static const char *const equal[][4] = {
        {"", "+ p 0", "* 1 q", ""},
        {"let a1 = * d1 e11\nlet a2 = * e11 d1", "+ p - a1 a2", "q", ""},
        {"let u v = solve_u p q\nlet un2 vn2 = solve_u u v", "un2", "vn2", "let u v = solve_u p q"},
        {"let b1 = - d1 d1", "+ p * b1 e22", "/ q 1", ""}};
    for (size_t i = 0; i < sizeof equal / sizeof *equal; i++) {
        struct genes a = program_of(f, equal[i][0], equal[i][1], equal[i][2]);
        struct genes b = *equal[i][3] ? program_of(f, equal[i][3], "u", "v") : program_of(f, "", "p", "q");
        assert_true(genes_equal(&a, &b) && genes_hash(&a) == genes_hash(&b));
        free(a.gene);
        free(b.gene);
    }
}

/* The last function is removed when programs are read, and only then. */
static void last_functions_are_removed_on_reading(void **state)
{
    const struct fixture *f = *state;
    struct genes inner = program_of(f, "let u v = newton p q", "u", "v");
    struct genes whole = read_program(f, "let u v = newton p q\nlet x y = place u v", "x", "y", true);
    struct genes other = read_program(f, "let u v = newton p q\nlet x = * 2 u", "x", "v", true);
    struct genes unknown = read_program(f, "", "xB", "q", false);
    assert_true(genes_equal(&inner, &whole));
    assert_int_equal(other.length, 0);
    assert_int_equal(unknown.length, 0);
    assert_true(objective_error(f->objective, &inner, -1, INFINITY) != error_of(f, &inner));
    free(inner.gene);
    free(whole.gene);
    free(other.gene);
    free(unknown.gene);
}

/* Invalid genes are refused, for example from checkpoints. */
static void invalid_genes_are_refused(void **state)
{
    const struct fixture *f = *state;
    const struct line_rules *r = f->objective->rules;
    const int symbol = f->genes.symbol[0];
    const int good[] = {LINE_GENE, LINE_GENE + 1, GENE_ADD, symbol, -1, GENE_NEG, LINE_GENE, -1};
    assert_true(lines_valid(r, good, 8));
    for (size_t at = 0; at < 8; at++)
        for (int k = 0; k < 5; k++) {
            const int wrong[] = {LINE_GENE + 2, GENE_OPERATORS, GENE_SYMBOL + (int)r->symbols, GENE_SYMBOL - 1,
                                 -2147483647 - 1};
            int gene[8];
            memcpy(gene, good, sizeof gene);
            gene[at] = wrong[k];
            assert_false(lines_valid(r, gene, 8));
        }
    for (size_t n = 0; n < 8; n++)
        assert_true(lines_valid(r, good, n) == false);
}

/* d root / d number agrees with central differences, sample by sample. */
static void derivatives_match_differences(void **state)
{
    const struct fixture *f = *state;
    static const char *const text[][3] = {
        {"", "* 0.93 p", "* 0.93 q"},
        {"let u v = newton_kept * 0.83 ut * 0.83 vt\nlet ui vi = inside u v", "+ ui 0.023", "- vi 0.031"},
        {"let u v = solve_v - p 0.051 - q 0.051\nlet us vs = solve_u u v", "max -0.213 + 0.103 us", "vs"},
        {"let u v = newton p q\nlet us vs = newton * 0.71 u * 0.71 v", "us", "vs"}};
    const double step = 1e-6;
    struct lines_run *r = lines_run_new(f->objective->rules, &f->table);
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        struct genes t = program_of(f, text[i][0], text[i][1], text[i][2]);
        lines_run_load(r, &t, f->last, -1);
        assert_true(r->code->numbers > 0);
        for (size_t k = 0; k < r->code->numbers; k++)
            for (int half = 0; half < 2; half++) {
                double *number = &r->code->line[r->code->number[k]].number, slope[TAPE_BLOCK] = {0},
                       value[2][TAPE_BLOCK];
                const double kept = *number;
                size_t far = 0;
                lines_values(r, 0);
                lines_slopes(r, half);
                if (r->slope[r->code->number[k]])
                    memcpy(slope, r->slope[r->code->number[k]], sizeof slope);
                for (int side = 0; side < 2; side++) {
                    *number = kept + (side ? step : -step);
                    lines_values(r, 0);
                    memcpy(value[side], r->value[r->code->root[half]], sizeof *value);
                }
                *number = kept;
                for (size_t j = 0; j < TAPE_BLOCK; j++)
                    far += !(fabs((value[1][j] - value[0][j]) / (2 * step) - slope[j]) < 1e-3 * (1 + fabs(slope[j])));
                assert_true(far <= TAPE_BLOCK / 20); /* kinks and poles */
            }
        free(t.gene);
    }
    lines_run_free(r);
}

static double cost_of_text(const struct fixture *f, const char *lets, const char *xi, const char *eta)
{
    struct genes t = program_of(f, lets, xi, eta);
    const double cost = cost_of(f, &t);
    free(t.gene);
    return cost;
}

/* Costs: a product or a sum 1, a quotient 8. */
static void costs_are_as_counted(void **state)
{
    const struct fixture *f = *state;
    /* (d1 + v (cd - (e12 + v c2))) / (e11 + v (c1 + (c1 + v cc))): 4 products, 6 sums and a quotient. c1, c2, cc and
     * cd, which p does not need, are 12 products and 8 sums. 3 products and a sum made p, which is no longer needed. */
    assert_true(cost_of_text(f, "let u v = solve_u p q", "u", "v") - cost_of_text(f, "", "p", "q") ==
                4 + 6 + 8 + 12 + 8 - 3 - 1);
    /* A second step costs as much as its lines. */
    const double one = cost_of_text(f, "let us1 vs1 = newton p q", "us1", "vs1"),
                 two = cost_of_text(f, "let us1 vs1 = newton p q\nlet u2n v2n = newton us1 vs1", "u2n", "v2n");
    assert_true(two - one == 2 + 2 + 3 + 1 + 3 + 3 + 3 + 4 + 4 + 3 + 8 + 4 + 4); /* line by line of the frame */
}

/* For the cost of each truncated iteration that a programmer would write, a seed is as accurate. */
static void seeds_match_truncated_iterations(void **state)
{
    const struct fixture *f = *state;
    static const char *const method[][3] = {
        {"", "p", "q"},
        {"let u v = inside p q", "u", "v"},
        {"let u v = newton_kept p q", "u", "v"},
        {"let u0 v0 = inside ut vt\nlet us1 vs1 = newton_kept u0 v0\nlet u v = inside us1 vs1", "u", "v"},
        {"let us1 vs1 = newton_kept p q\nlet u v = newton_kept us1 vs1", "u", "v"},
        {"let u0 v0 = inside ut vt\nlet us1 vs1 = solve_u u0 v0\nlet u v = solve_v us1 vs1", "u", "v"}};
    struct front *found = front_new(f->plan.front_limit, LONGEST);
    compose_programs(&f->scene->tier[0], &f->genes, f->objective, f->last, &f->plan.prices, found);
    struct lines_counter *c = lines_counter_new(f->objective->rules);
    for (size_t i = 0; i < sizeof method / sizeof *method; i++) {
        struct genes t = program_of(f, method[i][0], method[i][1], method[i][2]);
        const struct operation_count o = count_lines(c, &t, f->last);
        assert_true(front_error(found, operations_price(&o, &f->plan.prices)) <= error_of(f, &t));
        free(t.gene);
    }
    lines_counter_free(c);
    front_free(found);
}

/* Evolution keeps all seeds, improves some, and keeps the whole front. */
static void evolution_keeps_and_improves_seeds(void **state)
{
    const struct fixture *f = *state;
    struct front *found = front_new(f->plan.front_limit, LONGEST);
    struct fits *fits = fits_new(f->objective);
    const struct fitting hooks = fits_hooks(fits);
    struct plan plan = f->plan;
    plan.population = 60;
    plan.migrants = 0;
    compose_programs(&f->scene->tier[0], &f->genes, f->objective, f->last, &plan.times, found);
    struct genes *seed = new_array(front_count(found), sizeof *seed);
    for (size_t i = 0; i < front_count(found); i++)
        seed[i] = front_member(found, i)->genes;
    const struct goal goal = {
        .program = true, .last = f->last, .max_length = LONGEST, .genes = &f->genes, .fit = &hooks};
    struct island *is = island_new(&plan, &goal, f->objective);
    island_start(is, seed, front_count(found));
    for (int k = 0; k < 15; k++)
        island_step(is);
    const struct front *all = is->front;
    size_t better = 0;
    for (size_t i = 0; i < front_count(found); i++) {
        const struct member *m = front_member(found, i);
        assert_true(front_error(all, m->cost) <= m->error);
        better += front_error(all, m->cost) < 0.9 * m->error;
    }
    assert_true(better >= 3);
    for (size_t i = 0; i + 1 < front_count(all); i++) {
        const struct member *m = front_member(all, i), *next = front_member(all, i + 1);
        assert_true(m->cost < next->cost && m->error > next->error && m->error == error_of(f, &m->genes));
    }
    unsigned char *saved = new_array(island_state_size(is), 1);
    island_save(is, saved);
    assert_true(island_load(is, saved));
    free(saved);
    island_free(is);
    fits_free(fits);
    free(seed);
    front_free(found);
}

/* A program is charged for errors beyond their limits. */
static void tails_are_charged(void **state)
{
    const struct fixture *f = *state;
    struct genes t = program_of(f, "", "ut", "vt");
    const double error = error_of(f, &t);
    const struct tails own = objective_tails(f->objective, &t, f->last), any = {.p99 = 0, .max = 0};
    const struct tails less = {.p99 = own.p99 / 2, .max = own.max / 3}, more = {.p99 = 2 * own.p99, .max = 3 * own.max};
    assert_true(own.max >= own.p99 && own.p99 >= error);
    assert_true(objective_error_in_tails(f->objective, &t, f->last, &own, INFINITY) == error);
    assert_true(objective_error_in_tails(f->objective, &t, f->last, &any, INFINITY) == error);
    assert_true(objective_error_in_tails(f->objective, &t, f->last, &more, INFINITY) == error);
    assert_true(fabs(objective_error_in_tails(f->objective, &t, f->last, &less, INFINITY) / error - 6) < 1e-9);
    assert_true(objective_error_in_tails(f->objective, &t, f->last, &less, 6.1 * error) < INFINITY);
    assert_true(objective_error_in_tails(f->objective, &t, f->last, &less, 5.9 * error) == INFINITY);
    assert_true(objective_error_in_tails(f->objective, &t, f->last, &less, 2.9 * error) == INFINITY);
    free(t.gene);
}

/* On samples with bands of the gap, a program is charged for its worst band, and is worse than another if it is worse
 * in both halves of a band. */
static void the_worst_band_is_charged(void **state)
{
    struct fixture *f = *state;
    struct genes t = program_of(f, "", "ut", "vt");
    f->table.band = new_array(f->table.n, sizeof *f->table.band);
    for (size_t i = 0; i < f->table.n; i++)
        f->table.band[i] = (unsigned char)(i % (GAP_BANDS - 1)); /* the last band has no sample */
    const double error = error_of(f, &t);
    struct tails tails = objective_tails(f->objective, &t, f->last);
    assert_true(objective_error_in_tails(f->objective, &t, f->last, &tails, INFINITY) == error);
    tails.band[1] /= 2;
    tails.band[2] /= 3;
    assert_true(fabs(objective_error_in_tails(f->objective, &t, f->last, &tails, INFINITY) / error - 3) < 1e-9);

    struct outputs than = objective_outputs(f->objective, &t, f->last);
    assert_true(objective_no_worse(f->objective, &t, f->last, &than));
    than.mean[1][2] /= 2;
    assert_true(objective_no_worse(f->objective, &t, f->last, &than));
    than.p99[1][3] /= 2;
    assert_true(objective_no_worse(f->objective, &t, f->last, &than));
    than.mean[1][3] /= 2;
    assert_false(objective_no_worse(f->objective, &t, f->last, &than));
    free(f->table.band);
    f->table.band = NULL;
    free(t.gene);
}

static int ascending(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

/* The 99 % of errors equals the result of sorting, for all sizes, few and many, equal and infinite errors. */
static void p99_matches_sorting(void **state)
{
    enum { MOST = 20000 };
    (void)state;
    double *error = new_array(MOST, sizeof *error), *sorted = new_array(MOST, sizeof *sorted);
    gsl_rng *rng = stream_new();
    const uint64_t arrays = getenv("FOOTPOINT_LONG") ? 400 : 80;
    for (uint64_t k = 0; k < arrays; k++) {
        stream_key(rng, 9, k, 0, 0);
        const size_t n = 1 + gsl_rng_uniform_int(rng, k % 2 ? 300 : MOST);
        const double power = (double)(k % 5) * 10, kept = k % 3 ? 1 : 0.985;
        for (size_t i = 0; i < n; i++) {
            const double x = gsl_rng_uniform(rng);
            error[i] = x > kept ? INFINITY : k % 7 ? pow(x, power) : (double)(i % 70 == 0);
        }
        memcpy(sorted, error, n * sizeof *error);
        qsort(sorted, n, sizeof *sorted, ascending);
        const double p99 = sorted[(99 * n + 99) / 100 - 1], least = k % 4 ? 0.9 * p99 : 1.1 * p99;
        assert_true(errors_p99_within(error, n, p99) && (p99 == 0 || !errors_p99_within(error, n, nextafter(p99, 0))));
        memcpy(sorted, error, n * sizeof *error);
        assert_true(errors_p99(sorted, n) == p99);
        assert_true(errors_p99_above(error, n, least) == fmax(p99, least));
    }
    gsl_rng_free(rng);
    free(error);
    free(sorted);
}

/* Fits recover the best numbers in each norm; numbers that stand for a structure stay. */
static void fits_recover_numbers(void **state)
{
    const struct fixture *f = *state;
    struct genes fitted = {new_array(LONGEST, sizeof *fitted.gene), 0};
    struct genes t = program_of(f, "let u v = inside + 0.1001 p - q 0.1001", "* 0.5101 u", "* 0.5101 v");
    struct lines_run *r = lines_run_new(f->objective->rules, &f->table);
    for (enum scene_norm norm = NORM_MEAN; norm <= NORM_MAX; norm++) {
        f->objective->norm = norm;
        assert_true(lines_fit(r, &t, f->last, norm, 20, &fitted));
        assert_int_equal(fitted.length, t.length);
        assert_true(error_of(f, &fitted) < 0.9 * error_of(f, &t));
    }
    f->objective->norm = NORM_MEAN;
    struct genes none = program_of(f, "let u v = newton p q", "* 0.5 u", "* 2 v");
    assert_false(lines_fit(r, &none, f->last, NORM_MEAN, 5, &fitted));
    free(none.gene);
    lines_run_free(r);
    free(t.gene);
    free(fitted.gene);
}

/* Trees of one output find |x| and a clamp by minima and maxima. */
static void clamps_are_found(void **state)
{
    const struct fixture *f = *state;
    const struct gene_set genes = archive_genes(f->archive, 1, false);
    int gene[LONGEST];
    struct genes t = {gene, 0};
    size_t clamps = 0;
    gsl_rng *rng = stream_new();
    assert_true(genes.operations == 5 && genes.functions == 0);
    for (uint64_t k = 0; k < 50; k++) {
        stream_key(rng, 8, k, 0, 0);
        tree_random(rng, &genes, 4, true, LONGEST, &t);
        for (size_t i = 0; i < t.length; i++)
            clamps += t.gene[i] == GENE_MIN || t.gene[i] == GENE_MAX;
    }
    assert_true(clamps > 100);
    gsl_rng_free(rng);
    struct gene_set set = genes;
    gene_set_free(&set);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(changed_programs_match_their_text),
                                       cmocka_unit_test(equal_values_occur_once),
                                       cmocka_unit_test(last_functions_are_removed_on_reading),
                                       cmocka_unit_test(invalid_genes_are_refused),
                                       cmocka_unit_test(derivatives_match_differences),
                                       cmocka_unit_test(costs_are_as_counted),
                                       cmocka_unit_test(seeds_match_truncated_iterations),
                                       cmocka_unit_test(tails_are_charged),
                                       cmocka_unit_test(p99_matches_sorting),
                                       cmocka_unit_test(the_worst_band_is_charged),
                                       cmocka_unit_test(fits_recover_numbers),
                                       cmocka_unit_test(clamps_are_found),
                                       cmocka_unit_test(evolution_keeps_and_improves_seeds)};
    return cmocka_run_group_tests(tests, setup, teardown);
}
