/* The genes of a tier's trees; see archive.h. */
#include "archive.h"

#include "../common/decimal.h"
#include "../genotype/line_program.h"

#include <string.h>

struct quest *archive_quests(const struct archive *a, size_t tier, size_t *n)
{
    size_t first = 0;
    while (a->quest[first].tier < tier)
        first++;
    *n = a->scene->tier[tier].program ? 1 : 2;
    return &a->quest[first];
}

enum { GRID = 100 }; /* constants -GRID..GRID times 0.05 */

/* Inserts a constant, sorted by value, if it is new. */
static void add_constant(struct gene_set *s, int gene)
{
    const double value = decimal_value(gene);
    size_t at = s->constants;
    while (at > 0 && decimal_value(s->constant[at - 1]) > value)
        at--;
    if (at > 0 && s->constant[at - 1] == gene)
        return;
    memmove(s->constant + at + 1, s->constant + at, (s->constants - at) * sizeof *s->constant);
    s->constant[at] = gene;
    s->constants++;
}

static int gene_of(const struct genome_file *program, const char *name)
{
    const int gene = gene_of_name(name);
    return gene >= 0 ? gene : GENE_FUNCTION + line_function(program, name);
}

/* Adds binary operators, then unary operators. */
static void add_operations(const struct archive *a, const struct tier *t, struct gene_set *s)
{
    s->operation = new_array(t->functions, sizeof *s->operation);
    for (int arity = 2; arity > 0; arity--)
        for (size_t i = 0; i < t->functions; i++) {
            const int gene = gene_of(a->program, t->function[i]);
            if (gene_arity(gene) == arity)
                s->operation[s->operations + s->functions] = gene;
            s->operations += gene_arity(gene) == arity && arity == 2;
            s->functions += gene_arity(gene) == arity && arity == 1;
        }
}

int *archive_symbols(const struct archive *a, size_t tier)
{
    const struct tier *t = &a->scene->tier[tier];
    int *symbol = new_array(t->terminals, sizeof *symbol);
    for (size_t i = 0; i < t->terminals; i++)
        symbol[i] = GENE_SYMBOL + (int)genome_find_symbol(a->program, t->terminal[i]);
    return symbol;
}

struct gene_set archive_genes(const struct archive *a, size_t tier, bool rational)
{
    const struct tier *t = &a->scene->tier[tier];
    const int operation[] = {GENE_ADD, GENE_SUB, GENE_MUL, t->program ? GENE_DIV : GENE_PDIV};
    size_t n, own = 0;
    const struct quest *quest = archive_quests(a, tier, &n);
    struct gene_set s = {.symbols = t->terminals};
    if (t->functions > 0) {
        add_operations(a, t, &s);
    } else {
        s.operations = rational ? 4 : 3;
        s.operation = new_array(s.operations, sizeof *s.operation);
        memcpy(s.operation, operation, s.operations * sizeof *operation);
    }
    s.symbol = archive_symbols(a, tier);
    for (const struct quest *q = quest; q < quest + n; q++)
        own += q->champion.genes.length;
    s.constant = new_array(2 * GRID + 1 + own, sizeof *s.constant);
    for (int k = -GRID; k <= GRID; k++)
        add_constant(&s, decimal_gene(k * 5 / 100.0));
    for (const struct quest *q = quest; q < quest + n; q++)
        for (size_t i = 0; !t->program && i < q->champion.genes.length; i++) {
            const int gene = q->champion.genes.gene[i];
            if (gene < 0)
                add_constant(&s, decimal_gene(a->program->constant[-1 - gene].value));
        }
    return s;
}
