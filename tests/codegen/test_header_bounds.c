/* At a million random points of its region, no error exceeds a bound that a generated header claims. The worst samples
 * that it reports are not far below the errors found there. */
#include "../../codegen/compile/compile.h"
#include "../support/genome_text.h"
#include "../support/rounding_subject.h"

#include <dirent.h>
#include <math.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

static const char searches[] = "evolve/genomes";

/* Makes the header of a file of genomes. */
static char *read_header(const char *file, const char *suffix)
{
    char path[600], *text;
    snprintf(path, sizeof path, "generated/footpoint_%.*s%s.h", (int)(strlen(file) - strlen(".gen")), file, suffix);
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

/* Returns the banner's line about a genome's rounding errors. The caller must free it. */
static char *rounding_line(const char *header, const char *name)
{
    static const char fold[] = "\n *     ";
    char start[200];
    snprintf(start, sizeof start, "_%s\n *   operations:", name);
    const char *banner = strstr(header, start);
    assert_non_null(banner);
    banner = strstr(banner, "\n *   rounding:");
    assert_non_null(banner);
    const char *end = strchr(banner, '('); /* number of points */
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

/* Returns the error that a header claims for outputs of a genome: the number before `mark`, " proved" or " sampled";
 * infinite if it has none. */
static double claimed_error(const char *header, const struct genome *g, const char *output, const char *mark)
{
    char name[100], *line = rounding_line(header, g->name);
    snprintf(name, sizeof name, " %s ", output);
    char *claim = strstr(line, name), *end = claim ? strpbrk(claim, ";(") : NULL;
    double error = INFINITY;
    assert_non_null(claim);
    if (end)
        *end = '\0';
    char *at = strstr(claim, mark);
    if (at) {
        while (at > claim && at[-1] != ' ')
            at--;
        error = strtod(at, NULL);
    }
    free(line);
    return error;
}

/* Joins consecutive declarations, as headers do if there is room. */
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

enum { OUTPUTS = 16, ROWS = 1000, FUNCTIONS = 1000 };

/* A function, and its bounds over the worst errors found, indexed by output; 0: no bound. */
struct claimant {
    const char *path;
    const struct genome *genome;
    const char *header;
    double *ratio;
};

/* The outputs' names, several of which may be elements of a row, and the row of each output; SIZE_MAX: a value that the
 * function tests. */
struct claims {
    size_t outputs, row[ROWS];
    char name[OUTPUTS][60];
    double bound[OUTPUTS], sampled[OUTPUTS], worst[OUTPUTS], rows[ROWS];
};

static struct claims find_claims(const struct claimant *c)
{
    const struct genome *g = c->genome;
    struct claims all = {0};
    assert_true(g->outs <= ROWS);
    for (size_t i = 0; i < g->outs; i++) {
        char name[60];
        size_t k = 0;
        snprintf(name, sizeof name, "%.*s", (int)strcspn(g->out[i].name, "["), g->out[i].name);
        if (strncmp(g->out[i].name, "require[", strlen("require[")) == 0) {
            all.row[i] = SIZE_MAX;
            continue;
        }
        while (k < all.outputs && strcmp(all.name[k], name) != 0)
            k++;
        if (k == all.outputs) {
            assert_true(all.outputs < OUTPUTS);
            memcpy(all.name[k], name, sizeof name);
            all.sampled[all.outputs] = claimed_error(c->header, g, name, " sampled");
            all.bound[all.outputs++] = claimed_error(c->header, g, name, " proved");
        }
        all.row[i] = k;
    }
    return all;
}

/* Attacks the claims for all outputs. */
static void check_claims(struct subject *s, const struct claimant *c)
{
    struct claims all = find_claims(c);
    worst_errors(s, all.rows);
    for (size_t i = 0; i < c->genome->outs; i++)
        if (all.row[i] < SIZE_MAX)
            all.worst[all.row[i]] = fmax(all.worst[all.row[i]], all.rows[i]);
    for (size_t k = 0; k < all.outputs; k++) {
        print_message("%s: %s %s: bound %g, sampled %g, worst error %g\n", c->path, c->genome->name, all.name[k],
                      all.bound[k], all.sampled[k], all.worst[k]);
        assert_true(!(all.worst[k] > all.bound[k]));
        assert_true(all.bound[k] == INFINITY || all.bound[k] <= 101 * all.sampled[k]); /* both rounded up */
        assert_true(all.worst[k] <= 3 * all.sampled[k]);
        if (all.bound[k] < INFINITY && all.worst[k] > 0)
            c->ratio[k] = all.bound[k] / all.worst[k];
    }
}

static void check_genome(const struct genome_file *f, size_t k, const char *header, double *ratio)
{
    const struct compile_options o = compile_defaults();
    const struct genome *g = &f->genome[k];
    const struct claimant claimant = {f->path, g, header, ratio};
    struct compiled c;
    struct diag d = {0};
    char *text = NULL;
    size_t size = 0;
    FILE *copy = open_memstream(&text, &size);
    genome_print(f, copy);
    fclose(copy);
    assert_true(compile_genome(f, g, &o, &c, &d));
    const bool single = strstr(header, "precision: float");
    assert_true(single || strstr(f->path, searches) != f->path || holds(header, c.text));
    struct subject s = subject_new(text, read_program(f, k, c.text));
    if (single)
        subject_in_float(&s);
    check_claims(&s, &claimant);
    subject_free(&s);
    compiled_free(&c);
    free(text);
}

struct share {
    long job, jobs, number; /* tests every `jobs`-th function, from number `job` on; `number` counts the functions */
    double *ratio;
};

static void check_folder(struct share *s, const char *folder, const char *suffix)
{
    struct dirent **entry;
    const int n = scandir(folder, &entry, NULL, alphasort);
    assert_true(n > 0);
    for (int i = 0; i < n; i++) {
        char path[600];
        struct diag d = {0};
        snprintf(path, sizeof path, "%s/%s", folder, entry[i]->d_name);
        struct genome_file *f = strstr(path, ".gen") ? genome_read(path, &d) : NULL;
        char *header = f ? read_header(entry[i]->d_name, suffix) : NULL;
        for (size_t k = 0; f && k < f->genomes; k++, s->number++)
            if (s->number % s->jobs == s->job) {
                assert_true(s->number < FUNCTIONS);
                check_genome(f, k, header, s->ratio + OUTPUTS * s->number);
            }
        free(header);
        genome_file_free(f);
        free(entry[i]);
    }
    free(entry);
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Compares all bounds with the errors found. The largest ratio belongs to the weakest attack, so it is printed but not limited;
 * check_claims() limits each bound to 101 times the worst sample. */
static void check_ratios(double *ratio)
{
    const size_t most = (size_t)OUTPUTS * FUNCTIONS;
    size_t none = 0, near = 0;
    qsort(ratio, most, sizeof *ratio, compare);
    while (none < most && ratio[none] == 0)
        none++;
    for (size_t i = none; i < most; i++)
        near += ratio[i] <= 100;
    assert_true(none < most);
    print_message("%zu bounds over the worst error: median %.3g, %zu within 100, largest %.3g\n", most - none,
                  ratio[(most + none) / 2], near, ratio[most - 1]);
    assert_true(ratio[(most + none) / 2] <= 30);
}

/* Runs JOBS processes, each of which attacks a share of the functions. */
static void claimed_bounds_hold(void **state)
{
    (void)state;
    const size_t size = OUTPUTS * FUNCTIONS * sizeof(double);
    const char *text = getenv("JOBS");
    const long asked = text ? strtol(text, NULL, 10) : 1, jobs = asked > 0 ? asked : 1;
    int status = 0, failed = 0;
    if (!getenv("FOOTPOINT_LONG")) {
        puts("# SKIP header bounds, which compile every function anew: make check-long");
        return;
    }
    double *ratio = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    assert_true(ratio != MAP_FAILED);
    fflush(stdout);
    for (long job = 0; job < jobs; job++)
        if (fork() == 0) {
            struct share share = {job, jobs, 0, ratio};
            check_folder(&share, searches, "");
            check_folder(&share, "codegen/derivatives", "_derivatives");
            fflush(stdout); /* needed if a check fails and main returns */
            _exit(0);
        }
    while (wait(&status) > 0)
        failed += status != 0;
    assert_int_equal(failed, 0);
    check_ratios(ratio);
    munmap(ratio, size);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(claimed_bounds_hold),
    };
    return cmocka_run_group_tests_name("header bounds", tests, NULL, NULL);
}
