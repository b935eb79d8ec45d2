/* No bound that a generated header claims is below an error, at a million random points of its region each. */
#include "../../codegen/compile/compile.h"
#include "../support/genome_text.h"
#include "../support/rounding_subject.h"

#include <dirent.h>
#include <math.h>

/* The header that is made from a file of genomes. */
static char *read_header(const char *file)
{
    char path[600], *text;
    snprintf(path, sizeof path, "generated/footpoint_%.*s.h", (int)(strlen(file) - strlen(".gen")), file);
    for (char *c = path; *c; c++)
        *c = *c == '-' ? '_' : *c;
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    fseek(f, 0, SEEK_END);
    const size_t size = (size_t)ftell(f);
    text = new_array(size + 1, 1);
    rewind(f);
    assert_int_equal(fread(text, 1, size, f), size);
    fclose(f);
    return text;
}

/* The bound that a header claims for an output of a genome; infinite if it claims none. */
static double claimed_bound(const char *header, const struct genome *g, size_t output)
{
    char start[200], line[200];
    snprintf(start, sizeof start, "_%s\n *   operations:", g->name);
    snprintf(line, sizeof line, " %s <= ", g->out[output].name);
    const char *banner = strstr(header, start);
    assert_non_null(banner);
    banner = strstr(banner, "\n *   rounding:");
    assert_non_null(banner);
    const char *end = strstr(banner, "points)"), *claim = strstr(banner, line);
    return claim && end && claim < end ? strtod(claim + strlen(line), NULL) : INFINITY;
}

/* The text with all declarations that follow one another side by side, as headers have them as far as there is room. */
static char *joined(const char *text)
{
    static const char *const between[] = {";\n    const double ", ";\n    double "};
    char *copy = new_array(strlen(text) + 1, 1), *end = copy;
    while (*text) {
        size_t n = 0;
        for (int k = 0; k < 2; k++)
            n = strncmp(text, between[k], strlen(between[k])) == 0 ? strlen(between[k]) : n;
        end = stpcpy(end, n ? ", " : (const char[]){*text, '\0'});
        text += n ? n : 1;
    }
    return copy;
}

static bool holds(const char *header, const char *statements)
{
    char *in = joined(header), *what = joined(statements);
    const bool found = strstr(in, what) != NULL;
    free(in);
    free(what);
    return found;
}

static void check_genome(const struct genome_file *f, size_t k, const char *header)
{
    const struct compile_options o = compile_defaults();
    const struct genome *g = &f->genome[k];
    struct compiled c;
    struct diag d = {0};
    char *text = NULL;
    size_t size = 0;
    bool claims = false;
    for (size_t i = 0; i < g->outs; i++)
        claims = claims || claimed_bound(header, g, i) < INFINITY;
    if (!claims)
        return;
    FILE *copy = open_memstream(&text, &size);
    genome_print(f, copy);
    fclose(copy);
    assert_true(compile_genome(f, g, &o, &c, &d));
    const bool single = strstr(header, "precision: float");
    assert_true(single || holds(header, c.text));
    struct subject s = subject_new(text, read_program(f, k, c.text));
    if (single)
        subject_in_float(&s);
    double *worst = new_array(g->outs, sizeof *worst);
    worst_errors(&s, worst);
    for (size_t i = 0; i < g->outs; i++) {
        const double bound = claimed_bound(header, g, i);
        print_message("%s %s %s: bound %g, worst error %g\n", f->path, g->name, g->out[i].name, bound, worst[i]);
        assert_true(!(worst[i] > bound));
    }
    free(worst);
    subject_free(&s);
    compiled_free(&c);
    free(text);
}

/* No bound that a header claims is below an error. */
static void test_headers(void **state)
{
    (void)state;
    static const char folder[] = "evolve/genomes";
    struct dirent **entry;
    if (!getenv("FOOTPOINT_LONG")) {
        puts("# SKIP header bounds, which compile every function anew: make check-long");
        return;
    }
    const int n = scandir(folder, &entry, NULL, alphasort);
    assert_true(n > 0);
    for (int i = 0; i < n; i++) {
        char path[600];
        struct diag d = {0};
        snprintf(path, sizeof path, "%s/%s", folder, entry[i]->d_name);
        struct genome_file *f = strstr(path, ".gen") ? genome_read(path, &d) : NULL;
        char *header = f ? read_header(entry[i]->d_name) : NULL;
        for (size_t k = 0; f && k < f->genomes; k++)
            check_genome(f, k, header);
        free(header);
        genome_file_free(f);
        free(entry[i]);
    }
    free(entry);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_headers),
    };
    return cmocka_run_group_tests_name("header bounds", tests, NULL, NULL);
}
