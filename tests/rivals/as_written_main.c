/* Prints the genomes of four-node segments as C functions that compute each value as the genome writes it: a statement
 * for each value, in its order and association; the compiler simplifies them. as_written_main FILE... prints genome
 * fast of quad4.gen as written_quad4_fast(xA, xB, xC, xD, xS, &xi, &eta). It skips files of other kinds. */
#include "../../codegen/genome/genome.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_symbol(const struct genome_file *f, size_t k)
{
    if (k < f->inputs)
        printf("x%c[%d]", f->input[k][1], f->input[k][0] - 'x');
    else
        printf("v%zu", k - f->inputs);
}

/* Prints the expression that begins at gene[0] and returns its end. */
static const int *print_expression(const struct genome_file *f, const int *gene)
{
    const int g = *gene++;
    if (g < 0)
        printf(strpbrk(f->constant[-1 - g].text, ".eE") ? "(%s)" : "(%s.0)", f->constant[-1 - g].text);
    else if (g >= GENE_SYMBOL)
        print_symbol(f, (size_t)(g - GENE_SYMBOL));
    else if (gene_arity(g) == 1) {
        printf("%s(", g == GENE_ABS ? "fabs" : g == GENE_NEG ? "-" : gene_name(g));
        gene = print_expression(f, gene);
        putchar(')');
    } else {
        const char *const call = g == GENE_MIN ? "written_min(" : g == GENE_MAX ? "written_max(" : "(";
        fputs(call, stdout);
        gene = print_expression(f, gene);
        printf(" %s ", *call == '(' ? gene_name(g) : ",");
        gene = print_expression(f, gene);
        putchar(')');
    }
    return gene;
}

static void print_genome(const struct genome_file *f, const char *scene, const struct genome *g)
{
    printf("FOOTPOINT_FN void written_%s_%s(const double xA[3], const double xB[3], const double xC[3],\n"
           "    const double xD[3], const double xS[3], double *xi, double *eta)\n{\n",
           scene, g->name);
    for (size_t i = 0; i < f->lets; i++) {
        printf("    const double v%zu = ", i);
        print_expression(f, f->let[i].gene);
        puts(";");
    }
    for (size_t o = 0; o < g->outs; o++) {
        printf("    *%s = ", g->out[o].name);
        print_expression(f, g->out[o].gene);
        puts(";");
    }
    puts("}\n");
}

int main(int argc, char **argv)
{
    puts("#define written_min(a, b) ((a) < (b) ? (a) : (b))\n#define written_max(a, b) ((a) > (b) ? (a) : (b))\n");
    for (int i = 1; i < argc; i++) {
        struct diag d;
        struct genome_file *f = genome_read(argv[i], &d);
        if (!f) {
            fprintf(stderr, "%s\n", d.text);
            return (int)d.code;
        }
        const char *slash = strrchr(argv[i], '/');
        char *scene = new_text(slash ? slash + 1 : argv[i], strlen(slash ? slash + 1 : argv[i]));
        scene[strcspn(scene, ".")] = '\0';
        for (char *c = scene; *c; c++)
            *c = *c == '-' ? '_' : *c;
        const bool four = f->segment && strcmp(f->segment->name, "quad4") == 0;
        for (size_t k = 0; four && k < f->genomes; k++)
            print_genome(f, scene, &f->genome[k]);
        free(scene);
        genome_file_free(f);
    }
    return 0;
}
