/* Converts genomes to programs; see genome_program.h. */
#include "genome_program.h"

#include "../graph/constant_text.h"

#include <stdlib.h>

struct genome_program genome_program_start(const struct genome_file *f, size_t outputs)
{
    struct genome_program b = {.file = f, .program = program_new(f, outputs)};
    b.symbol = new_array(f->inputs + f->lets, sizeof *b.symbol);
    for (size_t i = 0; i < f->inputs; i++)
        b.symbol[i] = (int)i;
    return b;
}

struct program *genome_program_end(struct genome_program *b)
{
    free(b->symbol);
    return b->program;
}

static int add_number(struct program *p, const char *text)
{
    fmpq_t q;
    fmpq_init(q);
    constant_read(q, text);
    const int op = program_add_constant(p, q, false);
    fmpq_clear(q);
    return op;
}

static int add_gene(void *builder, int gene, int x, int y)
{
    struct genome_program *b = builder;
#define OPERATION(gene, ...) [GENE_##gene] = OP_##gene,
    static const enum op_kind kind[GENE_OPERATORS] = {GENES_OF_TWO(OPERATION) GENES_OF_ONE(OPERATION)};
    if (gene < 0)
        return add_number(b->program, b->file->constant[-1 - gene].text);
    if (gene >= GENE_LOCAL)
        return b->shape[gene - GENE_LOCAL];
    return gene >= GENE_SYMBOL ? b->symbol[gene - GENE_SYMBOL] : program_add(b->program, kind[gene], x, y);
}

int genome_program_add(struct genome_program *b, const struct genome_expr *e)
{
    return gene_fold(e->gene, e->length, add_gene, b);
}

/* Returns an operand of q as an operand of p. */
static int appended(const struct program *q, const int *input, int shift, int operand)
{
    if (operand < 0 || operand >= (int)q->inputs)
        return operand + (operand < 0 ? 0 : shift);
    return input ? input[operand] : operand;
}

int program_append(struct program *p, const struct program *q, const int *input)
{
    const int shift = (int)p->ops - (int)q->inputs;
    for (size_t i = q->inputs; i < q->ops; i++) {
        const struct op *o = &q->op[i];
        if (o->kind == OP_CONSTANT)
            program_add_constant(p, &q->constant[o->input], o->quotient);
        else
            program_add(p, o->kind, appended(q, input, shift, o->a), appended(q, input, shift, o->b));
    }
    return shift;
}
