/* Genome text: printed text reads back as the same program, and random text ends in a program or a diagnostic. */
#include "../../codegen/genome/genome.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char sample[] = "footpoint-genome 1\n"
                             "note scene made up # not a comment\n"
                             "input x y\n"
                             "input z\n"
                             "let s = + x\n"
                             "   y # a comment\n"
                             "let t = sqrt abs s\n"
                             "exchange x y\n"
                             "function step x y s t\n"
                             "genome one\n"
                             "note error 0.5\n"
                             "r = % * t -1.5e-2 min x max y 0.25\n"
                             "q = neg z\n"
                             "end\n";

static const char vectors[] = "footpoint-genome 2\n"
                              "segment tri3 any\n"
                              "let ab = - B A, unused = * 2 ab\n"
                              "function step u vector w -> un normal # a comment\n"
                              "    let normal = cross w\n"
                              "      ab\n"
                              "    let un = dot * u w normal # another\n"
                              "end\n"
                              "function twice u -> c n\n"
                              "    let b m = step u S, c n = step + b 1 - m A\n"
                              "end\n"
                              "let r n = twice xS\n"
                              "genome one\n"
                              "xi = r\n"
                              "eta = nx\n"
                              "end\n";

static const char region[] = "footpoint-genome 2\n"
                             "segment tri3 any\n"
                             "region\n"
                             "input vector A vector ex vector ey\n"
                             "input t xi eta\n"
                             "range A 0 0 0 0 0 0, t -1 2.5\n"
                             "let B = ex\n"
                             "let C = + ey * t ex\n"
                             "let S = + * xi B * eta C\n"
                             "require - 1 + xi eta\n"
                             "end\n"
                             "let s = - S A\n"
                             "let u = dot s s, s2 = sqrt u\n"
                             "require - 0.5 abs - u xi, - 0.25 abs - * u s2 eta, - 3 u\n"
                             "genome one\n"
                             "xi = u, eta = xS\n"
                             "end\n";

static char *print(const struct genome_file *f, size_t *size)
{
    char *text;
    FILE *stream = open_memstream(&text, size);
    genome_print(f, stream);
    fclose(stream);
    return text;
}

static void printed_text_reads_back(void **state)
{
    (void)state;
    struct diag d;
    size_t size, again;
    struct genome_file *f = genome_parse("sample", sample, sizeof sample - 1, &d);
    assert_non_null(f);
    char *text = print(f, &size);
    struct genome_file *g = genome_parse("printed", text, size, &d);
    assert_non_null(g);
    char *twice = print(g, &again);
    assert_string_equal(text, twice);
    assert_int_equal(f->inputs, 3);
    assert_int_equal(f->lets, 2);
    assert_int_equal(g->exchanges, 1);
    assert_int_equal(genome_find_function(g, "step"), 0);
    assert_int_equal(g->function[0].result[1].gene, GENE_LOCAL + 3);
    assert_int_equal(g->genome[0].outs, 2);
    assert_int_equal(g->genome[0].out[0].length, f->genome[0].out[0].length);
    for (size_t i = 0; i < f->genome[0].out[0].length; i++)
        assert_int_equal(g->genome[0].out[0].gene[i], f->genome[0].out[0].gene[i]);
    assert_string_equal(genome_find_note(g->note, g->notes, "scene"), "made up # not a comment");
    free(text);
    free(twice);
    genome_file_free(f);
    genome_file_free(g);
}

/* Checks the genes of a let, as text. */
static void assert_let(const struct genome_file *f, size_t k, const char *text)
{
    char *let = genome_expr_text(f, f->let[k].name, &f->let[k]);
    assert_string_equal(let, text);
    free(let);
}

static void functions_are_expanded(void **state)
{
    (void)state;
    struct diag d;
    struct genome_file *f = genome_parse("vectors", vectors, sizeof vectors - 1, &d);
    assert_non_null(f);
    assert_int_equal(f->inputs, 12);
    assert_int_equal(f->lets, 3 + 3 + 4 + 1 + 3 + 4);
    assert_let(f, 0, "abx - xB xA");
    assert_let(f, 5, "unusedz * 2 abz");
    assert_let(f, 6, "r.mx - * yS abz * zS aby");
    assert_let(f, 7, "r.my - * zS abx * xS abz");
    assert_let(f, 9, "r.b + + * * xS xS r.mx * * xS yS r.my * * xS zS r.mz");
    assert_let(f, 10, "r.argument + r.b 1");
    assert_let(f, 11, "r.argument - r.mx xA");
    assert_let(f, 14, "nx - * r.argument abz * r.argument aby");
    assert_string_equal(f->let[17].name, "r");
    genome_file_free(f);
}

/* Prints a file's needed parts and reads them back. */
static struct genome_file *read_needed(const struct genome_file *f, char **text)
{
    struct diag d;
    size_t size;
    FILE *stream = open_memstream(text, &size);
    genome_print_needed(f, stream);
    fclose(stream);
    struct genome_file *g = genome_parse("needed", *text, size, &d);
    assert_non_null(g);
    return g;
}

/* The text printed for a genome contains exactly its needs. */
static void only_needed_parts_are_printed(void **state)
{
    (void)state;
    struct diag d;
    char *text;
    struct genome_file *f = genome_parse("vectors", vectors, sizeof vectors - 1, &d);
    assert_non_null(f);
    struct genome_file *g = read_needed(f, &text);
    assert_null(strstr(text, "unused"));
    assert_int_equal(g->lets, f->lets - 3);
    assert_int_equal(g->functions, 2);
    free(text);
    genome_file_free(f);
    genome_file_free(g);
}

/* A function's local names do not require later lets with the same name. */
static void local_names_need_no_later_let(void **state)
{
    (void)state;
    static const char own[] = "footpoint-genome 2\ninput x\nfunction f u -> w\nlet v = * u u\nlet w = + v u\nend\n"
                              "let e = f x\nlet h = + x 2\nlet v = + h x\ngenome g\nz = e\nend\n";
    struct diag d;
    char *text;
    struct genome_file *f = genome_parse("own", own, sizeof own - 1, &d);
    assert_non_null(f);
    struct genome_file *g = read_needed(f, &text);
    assert_int_equal(g->statements, 2);
    free(text);
    genome_file_free(f);
    genome_file_free(g);
}

/* Every name of the file that statements define gets the suffix, also as the stem of a component. */
static void suffixes_reach_every_name(void **state)
{
    (void)state;
    static const char text[] = "footpoint-genome 2\nsegment tri3 any\nlet e = - B A\nlet c = + ex xA\n"
                               "function f u -> v\n    let w = * u e\n    let v = + wy c\nend\nlet r = f c\n";
    static const char *const expected[] = {"let e_1 = - B A", "let c_1 = + e_1x xA",
                                           "function f_1 u -> v\nlet w = * u e_1\nlet v = + wy c_1\nend",
                                           "let r_1 = f_1 c_1"};
    struct diag d;
    struct genome_file *f = genome_parse("suffix", text, sizeof text - 1, &d);
    assert_non_null(f);
    assert_int_equal(f->statements, 4);
    for (size_t i = 0; i < 4; i++) {
        char *other = genome_statement_suffixed(f, i, "_1");
        assert_string_equal(other, expected[i]);
        assert_true(genome_read_statement(f, other, &d));
        free(other);
    }
    genome_file_free(f);
}

/* Names on one line stay on one line if they are needed and fit; requires share lines. */
static void lists_stay_on_one_line(void **state)
{
    (void)state;
    static const char text[] =
        "footpoint-genome 2\nsegment tri3 any\nlet a = + xA 1, b = + xB 1, unused = - xA 1, c = * a b\n"
        "let d = + c 1\nexchange a b, c d\nleast / c d, c\n"
        "require a, - b 2\nrequire - 3 abs c\ngenome g\nxi = c\neta = d\nend\n";
    static const char expected[] =
        "footpoint-genome 2\nsegment tri3 any\nlet a = + xA 1, b = + xB 1, c = * a b\nlet d = + c 1\n"
        "require a, - b 2, - 3 abs c\n\ngenome g\nxi = c, eta = d\nend\n";
    struct diag d;
    char *needed, *all;
    size_t size;
    struct genome_file *f = genome_parse("lists", text, sizeof text - 1, &d);
    assert_non_null(f);
    assert_int_equal(f->exchanges, 2);
    assert_int_equal(f->leasts, 2);
    assert_int_equal(f->requires, 3);
    struct genome_file *g = read_needed(f, &needed);
    assert_string_equal(needed, expected);
    all = print(f, &size);
    assert_non_null(strstr(all, "\nleast / c d, c\n"));
    free(needed);
    free(all);
    genome_file_free(f);
    genome_file_free(g);
}

static void long_expressions_wrap(void **state)
{
    (void)state;
    enum { N = 5001 };
    struct diag d;
    size_t size;
    int gene[N];
    struct genome_file *f = genome_file_new("long");
    genome_add_input(f, "a_rather_long_name");
    for (int i = 0; i < N; i++)
        gene[i] = i < N / 2 ? GENE_ADD : GENE_SYMBOL;
    struct genome *g = genome_add(f, "g");
    genome_add_expr(&g->out, &g->outs, &g->out_room, "r", gene, N);
    char *text = print(f, &size);
    for (const char *line = text; *line;) {
        const char *end = strchr(line, '\n');
        assert_true(end - line <= 120);
        line = end + 1;
    }
    struct genome_file *h = genome_parse("long", text, size, &d);
    assert_non_null(h);
    assert_memory_equal(h->genome[0].out[0].gene, gene, sizeof gene);
    free(text);
    genome_file_free(f);
    genome_file_free(h);
}

static void spans_end_at_the_last_gene(void **state)
{
    (void)state;
    const int gene[] = {GENE_ADD, GENE_MUL, -1, GENE_SYMBOL, GENE_NEG, GENE_SYMBOL};
    assert_int_equal(gene_span(gene, 6), 6);
    assert_int_equal(gene_span(gene + 1, 5), 3);
    assert_int_equal(gene_span(gene + 4, 2), 2);
    assert_int_equal(gene_span(gene, 5), 0);
    assert_int_equal(gene_span(gene, 0), 0);
}

static void malformed_functions_are_refused(void **state)
{
    (void)state;
    static const char *const bad[][2] = {
        {"exchange x", "4:11: error: expected a value"},
        {"exchange x 1", "4:12: error: '1' is not a value"},
        {"exchange x y z", "4:14: error: unexpected 'z'"},
        {"exchange x y\nexchange z y", "5:12: error: 'y' or its partner is exchanged already"},
        {"function", "4:9: error: function needs a name"},
        {"function x x y s s", "4:10: error: name 'x' is defined already"},
        {"function halves x y s s", "4:10: error: function 'halves' is defined already"},
        {"function f x y s", "4:17: error: expected a value"},
        {"function f x y s u", "4:18: error: unknown gene 'u'"},
        {"function f x y s s\nfunction f x y s s", "5:10: error: function 'f' is defined already"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char text[200], wanted[100];
        struct diag d;
        snprintf(text, sizeof text, "footpoint-genome 1\ninput x y z\nlet s = + x y\n%s\n", bad[i][0]);
        snprintf(wanted, sizeof wanted, "frame:%s", bad[i][1]);
        assert_null(genome_parse("frame", text, strlen(text), &d));
        assert_string_equal(d.text, wanted);
    }
}

/* A region block reads as it is printed; only the requires after it know its inputs. */
static void region_blocks_read_back(void **state)
{
    (void)state;
    static const char *const bad[][2] = {
        {"region\nlet x = 1\nend", "3:1: error: region must define 'y'"},
        {"region\ninput x y\n", "3:1: error: region has no 'end'"},
        {"region\ninput x y\nend\nregion\nend", "6:1: error: a second 'region'"},
        {"region\ninput x y\nnote a b\nend", "5:1: error: 'note' must not be inside the region"},
        {"region\ninput x y t\nend\nlet u = * x t", "6:13: error: unknown gene 't'"},
        {"region\ninput x y t\nend\nrequire - 1 abs - x t step 2",
         "6:23: error: unexpected gene 'step' after a complete expression"},
        {"range x 0 1,\nrange y 0 1", "3:13: error: range needs an input"},
        {"genome g\nr = x,\nend", "4:7: error: expected an output after the comma"}};
    struct diag d;
    size_t size, again;
    struct genome_file *f = genome_parse("region", region, sizeof region - 1, &d);
    assert_non_null(f);
    assert_int_equal(f->region->inputs, 12);
    assert_int_equal(genome_region_symbol(f, 0), 0);
    assert_int_equal(f->require[0].gene[f->require[0].length - 1], GENE_LOCAL + 10);
    char *text = print(f, &size);
    struct genome_file *g = genome_parse("printed", text, size, &d);
    assert_non_null(g);
    char *second = print(g, &again);
    assert_string_equal(text, second);
    genome_file_free(f);
    genome_file_free(g);
    free(text);
    free(second);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char whole[200], wanted[200];
        snprintf(whole, sizeof whole, "footpoint-genome 2\ninput x y\n%s\n", bad[i][0]);
        snprintf(wanted, sizeof wanted, "frame:%s", bad[i][1]);
        assert_null(genome_parse("frame", whole, strlen(whole), &d));
        assert_string_equal(d.text, wanted);
    }
}

/* Every truncation and thousands of mutations of a text end in a program or in one line. */
static void check_hostile(const char *sane, size_t length)
{
    uint64_t seed = 1;
    char *text = malloc(length + 1);
    for (size_t n = 0; n < length + 20000; n++) {
        struct diag d = {0};
        const size_t size = n < length ? n : length;
        memcpy(text, sane, length + 1);
        for (int k = 0; n >= length && k < 3; k++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            const char *const letters = "+-*/% \n#=x1.e\0\xff"
                                        "end";
            text[(seed >> 33) % size] = letters[(seed >> 20) % 18];
        }
        struct genome_file *f = genome_parse("hostile", text, size, &d);
        assert_true(f != NULL ||
                    (d.code == EXIT_INPUT && strncmp(d.text, "hostile:", 8) == 0 && !strchr(d.text, '\n')));
        genome_file_free(f);
    }
    free(text);
}

static void hostile_text_is_refused_in_one_line(void **state)
{
    (void)state;
    check_hostile(sample, sizeof sample - 1);
    check_hostile(vectors, sizeof vectors - 1);
    check_hostile(region, sizeof region - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(printed_text_reads_back),
        cmocka_unit_test(functions_are_expanded),
        cmocka_unit_test(only_needed_parts_are_printed),
        cmocka_unit_test(local_names_need_no_later_let),
        cmocka_unit_test(suffixes_reach_every_name),
        cmocka_unit_test(lists_stay_on_one_line),
        cmocka_unit_test(long_expressions_wrap),
        cmocka_unit_test(spans_end_at_the_last_gene),
        cmocka_unit_test(malformed_functions_are_refused),
        cmocka_unit_test(region_blocks_read_back),
        cmocka_unit_test(hostile_text_is_refused_in_one_line),
    };
    return cmocka_run_group_tests_name("genome", tests, NULL, NULL);
}
