/* Regions of the committed genomes contain the scenes' own segments that were not used to find them. */
#include "../../codegen/region/region.h"
#include "../../evolve/region/shape_region.h"
#include "../../evolve/samples/samples.h"
#include "../support/long_cases.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char *const name[] = {"quad4", "punch-quad4", "blocks-quad4", "plane-quad4",
                                   "tri3",  "tri6",        "quad8",        "quad9"};

/* Places a sample; values are indexed by variable of the region. */
static void place(const struct region *r, const struct shape *shape, const struct sample *s, double *at)
{
    double number[SHAPE_NUMBERS];
    struct sample placed;
    shape_measure(shape, s, number, &placed);
    const size_t fixed = r->known->inputs - shape_numbers(shape);
    for (size_t k = 0; k < r->known->variables; k++)
        at[k] = number[r->known->input[k] - fixed];
}

static void check_scene(const char *named)
{
    char path[100];
    struct diag d;
    struct sample_set set = {0};
    struct scene *s = scene_read("", named, &d);
    assert_non_null(s);
    s->training = (size_t)long_cases(200, 20000);
    snprintf(path, sizeof path, "evolve/genomes/%s.gen", named);
    struct genome_file *f = genome_read(path, &d);
    assert_non_null(f);
    assert_true(scene_samples(s, PART_VALIDATION, &set, &d));
    struct program *p = program_new(f, 0);
    struct region *r = region_new(f, p, true);
    struct shape *shape = shape_new(f->segment);
    double *at = new_array(r->known->variables, sizeof *at);
    struct interval *box = new_array(r->known->variables, sizeof *box);
    size_t inside = 0;
    for (size_t i = 0; i < set.n; i++) {
        place(r, shape, &set.s[i], at);
        for (size_t k = 0; k < r->known->variables; k++)
            box[k] = interval_point(at[k]);
        inside += region_holds(r, box);
    }
    print_message("%s: of %zu segments %zu are in the region\n", named, set.n, inside);
    assert_true(set.n > 0 && 100 * inside >= 99 * set.n);
    free(at);
    free(box);
    free(shape);
    region_free(r);
    program_free(p);
    genome_file_free(f);
    sample_set_free(&set);
    scene_free(s);
}

static void regions_contain_unseen_samples(void **state)
{
    (void)state;
    if (!getenv("FOOTPOINT_LONG"))
        puts("# SKIP region: 200, not 20,000, segments of each scene: make check-long");
    for (size_t i = 0; i < sizeof name / sizeof *name; i++)
        check_scene(name[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(regions_contain_unseen_samples),
    };
    return cmocka_run_group_tests_name("region", tests, NULL, NULL);
}
