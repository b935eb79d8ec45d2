/* Fuzzes all readers of a genome file: a file that is read must print, whole and without unused lines, as text that is read
 * and prints the same; small files also pass the compiler and the proof.  Built with clang -fsanitize=fuzzer by
 * tests/long/fuzz.sh. */
#include "../../codegen/compile/compile.h"
#include "../../codegen/prove/prove.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_GENES = 200, MOST_LETS = 6, MOST_INPUTS = 40 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(bool good, const char *what, const char *detail)
{
    if (good)
        return;
    fprintf(stderr, "%s: %s\n", what, detail);
    abort();
}

typedef void printer(const struct genome_file *f, FILE *stream);

static char *print(const struct genome_file *f, printer *how, size_t *size)
{
    char *text = NULL;
    FILE *stream = open_memstream(&text, size);
    require(stream != NULL, "open_memstream", "out of memory");
    how(f, stream);
    fclose(stream);
    return text;
}

static void print_and_read(const struct genome_file *f, printer *how)
{
    struct diag d = {0};
    size_t size_once, size_twice;
    char *once = print(f, how, &size_once);
    struct genome_file *again = genome_parse("printed", once, size_once, &d);
    require(again != NULL, "printed text is refused", d.text);
    char *twice = print(again, how, &size_twice);
    require(size_once == size_twice && memcmp(once, twice, size_once) == 0, "printed twice", once);
    genome_file_free(again);
    free(once);
    free(twice);
}

static size_t count_genes(const struct genome_expr *e, size_t n)
{
    size_t genes = 0;
    for (size_t i = 0; i < n; i++)
        genes += e[i].length;
    return genes;
}

static bool is_small(const struct genome_file *f)
{
    size_t genes = count_genes(f->let, f->lets);
    for (size_t i = 0; i < f->genomes; i++)
        genes += count_genes(f->genome[i].out, f->genome[i].outs);
    return genes <= MOST_GENES && f->lets <= MOST_LETS && f->inputs <= MOST_INPUTS;
}

static void compile_and_prove(const struct genome_file *f, const struct genome *genome)
{
    struct diag d = {0};
    struct compiled c;
    struct compile_options options = compile_defaults();
    struct proof how;
    options.effort = 0;
    if (!compile_genome(f, genome, &options, &c, &d)) {
        require(!strstr(d.text, "internal error"), "compiler", d.text);
        return;
    }
    require(prove_equal(f, genome, c.program, &how, &d), "proof", d.text);
    compiled_free(&c);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct diag d = {0};
    struct genome_file *f = genome_parse("fuzz", (const char *)data, size, &d);
    if (!f) {
        require(strncmp(d.text, "fuzz:", 5) == 0 && !strchr(d.text, '\n'), "diagnostic", d.text);
        return 0;
    }
    print_and_read(f, genome_print);
    print_and_read(f, genome_print_needed);
    for (size_t i = 0; i < f->genomes && is_small(f); i++)
        compile_and_prove(f, &f->genome[i]);
    genome_file_free(f);
    return 0;
}
