/* Values and derivatives of trees; see tape.h.  Branches are numbered as their first genes: operands have higher
 * numbers, so that values run backward through the genes and derivatives forward. */
#include "tape.h"

#include "../common/decimal.h"
#include "tape_blocks.h"

#include <stdlib.h>
#include <string.h>

struct tape *tape_new(const struct columns *table)
{
    struct tape *t = new_array(1, sizeof *t);
    t->table = table;
    return t;
}

static void discard(struct tape *t)
{
    free(t->gene);
    free(t->operand);
    free(t->constant);
    free(t->number);
    free(t->varies);
    free(t->block);
    free(t->value);
    free(t->slope);
}

void tape_free(struct tape *t)
{
    if (!t)
        return;
    discard(t);
    free(t);
}

static void reserve(struct tape *t, size_t length)
{
    if (length <= t->room)
        return;
    const size_t room = length + length / 2;
    discard(t);
    t->room = room;
    t->gene = new_array(room, sizeof *t->gene);
    t->operand = new_array(room, sizeof *t->operand);
    t->constant = new_array(room, sizeof *t->constant);
    t->number = new_array(room, sizeof *t->number);
    t->varies = new_array(room, sizeof *t->varies);
    t->block = new_array(2 * room * TAPE_BLOCK, sizeof *t->block);
    t->value = new_array(room, sizeof *t->value);
    t->slope = new_array(room, sizeof *t->slope);
}

void tape_load(struct tape *t, const struct tree *tree)
{
    reserve(t, tree->length);
    t->length = tree->length;
    memcpy(t->gene, tree->gene, tree->length * sizeof *t->gene);
    t->constants = 0;
    for (size_t i = 0; i < t->length; i++) {
        if (t->gene[i] < 0) {
            t->number[i] = decimal_value(t->gene[i]);
            t->constant[t->constants++] = i;
        }
    }
    for (size_t i = t->length; i-- > 0;) {
        const int arity = gene_arity(t->gene[i]);
        t->varies[i] = t->gene[i] < 0 || (arity > 0 && t->varies[i + 1]);
        if (arity == 2) {
            t->operand[i] = i + 1 + gene_span(t->gene + i + 1, t->length - i - 1);
            t->varies[i] = t->varies[i] || t->varies[t->operand[i]];
        }
    }
}

void tape_store(const struct tape *t, struct tree *tree)
{
    tree->length = t->length;
    for (size_t i = 0; i < t->length; i++)
        tree->gene[i] = t->gene[i] < 0 ? decimal_gene(t->number[i]) : t->gene[i];
}

WIDE void tape_values(struct tape *t, size_t row)
{
    for (size_t i = t->length; i-- > 0;) {
        const int gene = t->gene[i];
        if (gene >= GENE_SYMBOL) {
            t->value[i] = columns_at(t->table, (size_t)(gene - GENE_SYMBOL)) + row;
            continue;
        }
        double *to = t->block + i * TAPE_BLOCK;
        t->value[i] = to;
        if (gene < 0) {
            EACH to[k] = t->number[i];
        } else {
            value_of(gene, t->value[i + 1], gene_arity(gene) == 2 ? t->value[t->operand[i]] : NULL, to);
        }
    }
}

WIDE void tape_slopes(struct tape *t, bool all)
{
    double *blocks = t->block + t->room * TAPE_BLOCK, *root = blocks;
    EACH root[k] = 1;
    t->slope[0] = root;
    for (size_t i = 0; i < t->length; i++) {
        const int gene = t->gene[i], arity = gene_arity(gene);
        if (arity == 0 || !(all || t->varies[i]))
            continue;
        const size_t a = i + 1, b = arity == 2 ? t->operand[i] : a;
        double *sa = blocks + a * TAPE_BLOCK, *sb = blocks + b * TAPE_BLOCK;
        t->slope[a] = gene == GENE_ADD || gene == GENE_SUB ? t->slope[i] : sa;
        if (arity == 2)
            t->slope[b] = gene == GENE_ADD ? t->slope[i] : sb;
        if (gene != GENE_ADD)
            slope_of(gene, t->slope[i], t->value[i], t->value[a], t->value[b], sa, sb);
    }
}
