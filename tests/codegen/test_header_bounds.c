/* No bound that a generated header claims is below an error, at a million random points of its region each, and, of bounds on
 * a hull of values, at those points that belong to it. */
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

/* What a banner says of a genome's rounding errors, in one line.  Caller frees. */
static char *rounding_line(const char *header, const char *name)
{
    static const char fold[] = "\n *     ";
    char start[200];
    snprintf(start, sizeof start, "_%s\n *   operations:", name);
    const char *banner = strstr(header, start);
    assert_non_null(banner);
    banner = strstr(banner, "\n *   rounding:");
    assert_non_null(banner);
    const char *end = strchr(banner, '('); /* how many points */
    assert_non_null(end);
    char *line = new_array((size_t)(end - banner) + 1, 1), *to = line;
    for (; banner < end; banner++)
        if (strncmp(banner, fold, strlen(fold)) == 0) {
            *to++ = ' ';
            banner += strlen(fold) - 1;
        } else
            *to++ = *banner;
    return line;
}

/* The bound that a header claims for an output of a genome, all over the region (" proved") or " on the hull"; infinite if it
 * claims none. */
static double claimed_bound(const char *header, const struct genome *g, size_t output, const char *where)
{
    char name[100], *line = rounding_line(header, g->name);
    snprintf(name, sizeof name, " %s ", g->out[output].name);
    char *claim = strstr(line, name), *end = claim ? strpbrk(claim, ";(") : NULL;
    double bound = INFINITY;
    assert_non_null(claim);
    if (end)
        *end = '\0';
    char *at = strstr(claim, where);
    if (at) {
        while (at > claim && strncmp(at, "<= ", 3) != 0)
            at--;
        bound = strtod(at + 3, NULL);
    }
    free(line);
    return bound;
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

/* Attacks the claims for all outputs; true if there was one. */
static bool check_claims(struct subject *s, const struct genome *g, const char *header, const char *where)
{
    bool claims = false;
    for (size_t i = 0; i < g->outs; i++)
        claims = claims || claimed_bound(header, g, i, where) < INFINITY;
    if (!claims)
        return false;
    double *worst = new_array(g->outs, sizeof *worst);
    worst_errors(s, worst);
    for (size_t i = 0; i < g->outs; i++) {
        const double bound = claimed_bound(header, g, i, where);
        print_message("%s %s%s: bound %g, worst error %g\n", g->name, g->out[i].name, where, bound, worst[i]);
        assert_true(!(worst[i] > bound));
    }
    free(worst);
    return true;
}

/* Says how many points drawn anew belong to the hull. */
static void count_held(struct subject *s)
{
    enum { DRAWN = 4000 };
    uint64_t seed = 777;
    long held = 0, drawn = 0, tries = 100 * DRAWN;
    for (; drawn < DRAWN && region_draw(s->region, &seed, 0, true, &tries, s->at); drawn++)
        held += hull_holds(s->hull, s->at);
    print_message("hull of %ld points: %ld of %ld others belong to it\n", s->hull->points, held, drawn);
}

static void check_genome(const struct genome_file *f, size_t k, const char *header)
{
    enum { SAMPLES = 10000 }; /* of the default effort */
    const struct compile_options o = compile_defaults();
    const struct genome *g = &f->genome[k];
    struct compiled c;
    struct diag d = {0};
    char *text = NULL;
    size_t size = 0;
    FILE *copy = open_memstream(&text, &size);
    genome_print(f, copy);
    fclose(copy);
    assert_true(compile_genome(f, g, &o, &c, &d));
    const bool single = strstr(header, "precision: float");
    assert_true(single || holds(header, c.text));
    struct subject s = subject_new(text, read_program(f, k, c.text));
    if (single)
        subject_in_float(&s);
    print_message("%s\n", f->path);
    const bool region = check_claims(&s, g, header, " proved");
    struct hull *h = hull_new(s.region, s.program, SAMPLES, o.seed);
    s.hull = h;
    count_held(&s);
    const bool hull = check_claims(&s, g, header, " on the hull");
    if (!region && !hull)
        print_message("%s claims nothing\n", g->name);
    hull_free(h);
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
