/* Genes and sets of them; see genotype.h. */
#include "genotype.h"

#include "../common/decimal.h"

#include <stdlib.h>
#include <string.h>

void gene_set_free(struct gene_set *s)
{
    free(s->symbol);
    free(s->constant);
    free(s->operation);
    *s = (struct gene_set){0};
}

void genes_copy(const struct genes *from, struct genes *to)
{
    memcpy(to->gene, from->gene, from->length * sizeof *to->gene);
    to->length = from->length;
}

bool genes_equal(const struct genes *a, const struct genes *b)
{
    return a->length == b->length && memcmp(a->gene, b->gene, a->length * sizeof *a->gene) == 0;
}

uint64_t genes_hash(const struct genes *t)
{
    uint64_t h = t->length;
    for (size_t i = 0; i < t->length; i++) {
        h = (h ^ (uint32_t)t->gene[i]) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
    }
    return h;
}

void genes_bind(struct genome_file *program, const struct genes *t, struct genes *bound)
{
    genes_copy(t, bound);
    for (size_t i = 0; i < t->length; i++)
        if (t->gene[i] < 0) {
            char text[DECIMAL_TEXT];
            decimal_text(t->gene[i], text);
            bound->gene[i] = -1 - (int)genome_add_constant(program, text);
        }
}
