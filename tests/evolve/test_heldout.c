/* Measurements on held-out samples that are not stored: they agree with a stored set of the same samples; climbing
 * finds at least its worst error, and its results are samples of the scene. */
#include "../../evolve/eval/frame.h"
#include "../../evolve/eval/lines_run.h"
#include "../../evolve/samples/samples.h"
#include "../../evolve/write/measure.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct scene *scene_of(const char *name, size_t heldout)
{
    struct diag d;
    struct scene *s = scene_read(".", name, &d);
    assert_non_null(s);
    s->heldout = heldout;
    return s;
}

static struct sampler *sampler_of(const struct scene *s, enum sample_part part)
{
    struct diag d;
    struct sampler *p = sampler_new(s, part, &d);
    if (!p)
        fail_msg("%s", d.text);
    return p;
}

static struct genome_file *genomes_of(const char *name)
{
    struct diag d;
    char path[100];
    snprintf(path, sizeof path, "evolve/genomes/%s.gen", name);
    struct genome_file *f = genome_read(path, &d);
    assert_non_null(f);
    return f;
}

/* Copies both outputs of a genome. */
static void outputs_of(const struct genome *g, struct genes t[2])
{
    for (int k = 0; k < 2; k++)
        t[k] = (struct genes){g->out[k].gene, g->out[k].length};
}

static int ascending(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}

/* Mean, 99 % and maximum agree to the last bit, in pieces of any size; here by sorting, not by selection. */
static void figures_are_those_of_a_set(void **state)
{
    enum { SAMPLES = 9973, PIECE = 1237 };
    static const int output[2] = {0, 1};
    struct genome_file *f = genomes_of("quad4");
    struct scene *s = scene_of("quad4", SAMPLES);
    struct diag d;
    struct sample_set set = {0};
    struct genes t[2];
    struct errors found[2];
    (void)state;
    assert_true(scene_samples(s, PART_HELDOUT, &set, &d) && set.n == SAMPLES);
    outputs_of(&f->genome[f->genomes / 2], t);
    struct measurement m = measurement_open(f, t, output, 2, SAMPLES);
    for (size_t at = 0; at < set.n; at += PIECE)
        measurement_take(&m, set.s + at, set.n - at < PIECE ? set.n - at : PIECE);
    measurement_close(&m, found);
    struct columns table = frame_columns(f, set.s, set.n);
    double *error = new_array(set.n, sizeof *error);
    for (int k = 0; k < 2; k++) {
        double sum = 0;
        table_values(&table, f->constant, t[k].gene, t[k].length, error);
        for (size_t i = 0; i < set.n; i++)
            sum += error[i] = fabs(error[i] - (k == 0 ? set.s[i].xi : set.s[i].eta));
        qsort(error, set.n, sizeof *error, ascending);
        assert_true(found[k].n == SAMPLES && found[k].mean == sum / SAMPLES && found[k].max == error[SAMPLES - 1]);
        assert_true(found[k].p99 == error[(99 * SAMPLES + 99) / 100 - 1]);
    }
    free(error);
    columns_free(&table);
    sample_set_free(&set);
    scene_free(s);
    genome_file_free(f);
}

static struct measurement measure(const struct genome_file *f, const struct genes *t, struct sampler *p)
{
    static const int output[2] = {0, 1};
    struct measurement m = measurement_open(f, t, output, 2, p->count);
    for (size_t i = 0; i < p->count; i++) {
        struct sample s;
        struct diag d;
        assert_true(sampler_take(p, i, &s, &d));
        measurement_take(&m, &s, 1);
    }
    return m;
}

/* On shapes, a mesh, a lattice and bodies, climbing finds at least the worst sample, and the same each time. */
static void climbing_finds_no_less(void **state)
{
    static const struct {
        const char *name;
        enum sample_part part;
        size_t samples;
    } of[] = {{"quad4", PART_HELDOUT, 500},
              {"punch-quad4", PART_HELDOUT, 3000},
              {"paper-quad4", PART_HELDOUT_RANDOM, 150},
              {"gregory", PART_HELDOUT, 20}};
    size_t higher = 0;
    (void)state;
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct genome_file *f = genomes_of(of[i].name);
        struct scene *s = scene_of(of[i].name, of[i].samples);
        struct sampler *p = sampler_of(s, of[i].part);
        struct genes t[2];
        struct errors found[2];
        outputs_of(&f->genome[1], t);
        struct measurement m = measure(f, t, p);
        double worst[2], again[2];
        climb(p, &m, 0, 2, worst, NULL, NULL);
        climb(p, &m, 0, 2, again, NULL, NULL);
        measurement_close(&m, found);
        for (int k = 0; k < 2; k++) {
            assert_true(worst[k] >= found[k].max && worst[k] < INFINITY && worst[k] == again[k]);
            higher += worst[k] > 1.1 * found[k].max;
        }
        sampler_free(p);
        scene_free(s);
        genome_file_free(f);
    }
    assert_true(higher >= 6);
}

/* A recorded tape makes its sample again. A changed tape makes no sample, or one with the foot point of the certain
 * search and within the scene's limits. */
static void neighbours_are_samples_of_the_scene(void **state)
{
    enum { SAMPLES = 300 };
    struct scene *s = scene_of("quad4", SAMPLES);
    const struct surface *f = surface_find(s->segment);
    struct sampler *p = sampler_of(s, PART_HELDOUT);
    double lo[2], hi[2];
    size_t made = 0;
    (void)state;
    scene_box(s, lo, hi);
    for (int k = 0; k < 2; k++) {
        lo[k] -= 1e-9;
        hi[k] += 1e-9;
    }
    for (size_t i = 0; i < SAMPLES; i++) {
        struct stream_tape tape;
        struct sample one, again;
        struct diag d;
        assert_true(sampler_take(p, i, &one, &d));
        sampler_record(p, i, &tape);
        assert_true(sampler_play(p, &tape, &again) && memcmp(&one, &again, sizeof one) == 0);
        tape.number[i % tape.n] ^= (uint64_t)1 << (63 - i % 8);
        if (!sampler_play(p, &tape, &one))
            continue;
        again = one;
        assert_true(f->foot(f, &again, lo, hi, NULL) && fabs(again.xi - one.xi) + fabs(again.eta - one.eta) < 1e-12);
        assert_true(fabs(one.gap) <= s->shapes.gap * sample_shortest_edge(&one, 4) * (1 + 1e-9));
        made++;
    }
    assert_true(made > SAMPLES / 4);
    sampler_free(p);
    scene_free(s);
}

/* Searches for a foot point find the same one from any start, or no foot point, even near several minima. */
static void guesses_change_nothing(void **state)
{
    static const char *const name[] = {"quad4", "tri6", "quad8", "gregory", "bezier"};
    enum { SAMPLES = 100 };
    gsl_rng *stream = stream_new();
    size_t found = 0, none = 0;
    (void)state;
    for (size_t kind = 0; kind < sizeof name / sizeof *name; kind++) {
        struct scene *s = scene_of(name[kind], SAMPLES);
        const struct surface *f = surface_find(s->segment);
        struct sampler *p = sampler_of(s, PART_HELDOUT);
        double lo[2], hi[2], near[2];
        scene_box(s, lo, hi);
        for (size_t i = 0; i < SAMPLES; i++) {
            struct sample one, other;
            struct diag d;
            assert_true(sampler_take(p, i, &one, &d));
            stream_key(stream, 1, kind, i, 0);
            for (int k = 0; k < 3; k++)
                one.xs[k] += gsl_ran_flat(stream, -1, 1) * sample_shortest_edge(&one, s->segment->corners);
            for (int k = 0; k < 2; k++)
                near[k] = gsl_ran_flat(stream, lo[k], hi[k]);
            other = one;
            const bool first = f->foot(f, &one, lo, hi, NULL), second = f->foot(f, &other, lo, hi, near);
            assert_true(first == second);
            assert_true(!first || fabs(one.xi - other.xi) + fabs(one.eta - other.eta) < 1e-9);
            found += first;
            none += !first;
        }
        sampler_free(p);
        scene_free(s);
    }
    assert_true(found > 50 && none > 50);
    gsl_rng_free(stream);
}

/* Seeds of the run change the held-out samples, but not the training samples. */
static void runs_hold_out_their_own(void **state)
{
    struct scene *s = scene_of("quad4", 10);
    struct diag d;
    (void)state;
    for (int k = 0; k < 2; k++) {
        const enum sample_part part = k ? PART_HELDOUT : PART_TRAINING;
        struct sampler *p = sampler_of(s, part);
        struct sample one, other;
        assert_true(sampler_take(p, 3, &one, &d));
        s->run = 2;
        assert_true(sampler_take(p, 3, &other, &d));
        s->run = 1;
        assert_true((memcmp(&one, &other, sizeof one) == 0) == (k == 0));
        sampler_free(p);
    }
    scene_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(figures_are_those_of_a_set),
        cmocka_unit_test(climbing_finds_no_less),
        cmocka_unit_test(neighbours_are_samples_of_the_scene),
        cmocka_unit_test(guesses_change_nothing),
        cmocka_unit_test(runs_hold_out_their_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
