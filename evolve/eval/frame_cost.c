/* Prices of lets; see frame_cost.h. The set of lets that each let needs, itself included, is a bit set. */
#include "frame_cost.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 64 };

struct frame_cost {
    size_t inputs, lets, words;
    double *price;         /* owned: by let; its own operations */
    uint64_t *needs, *all; /* owned: by let, and of a tree; sets of lets, `words` words each */
};

/* Adds the lets that an expression needs to a set. */
static void need(const struct frame_cost *f, const int *gene, size_t length, uint64_t *set)
{
    for (size_t i = 0; i < length; i++) {
        if (gene[i] < GENE_SYMBOL + (int)f->inputs)
            continue;
        const size_t let = (size_t)(gene[i] - GENE_SYMBOL) - f->inputs;
        for (size_t w = 0; let < f->lets && w < f->words; w++)
            set[w] |= f->needs[let * f->words + w];
    }
}

struct frame_cost *frame_cost_new(const struct genome_file *program, const struct prices *prices)
{
    struct frame_cost *f = new_array(1, sizeof *f);
    size_t longest = 1;
    *f = (struct frame_cost){program->inputs, program->lets, (program->lets + BITS - 1) / BITS, NULL, NULL, NULL};
    f->price = new_array(f->lets, sizeof *f->price);
    f->needs = new_array(f->lets * f->words, sizeof *f->needs);
    f->all = new_array(f->words, sizeof *f->all);
    for (size_t i = 0; i < f->lets; i++)
        longest = program->let[i].length > longest ? program->let[i].length : longest;
    struct counter *c = counter_new(longest);
    for (size_t i = 0; i < f->lets; i++) {
        const struct genome_expr *e = &program->let[i];
        const struct genes t = {e->gene, e->length};
        const struct operation_count o = count_operations(c, &t, program->constant);
        f->price[i] = operations_price(&o, prices);
        need(f, e->gene, e->length, f->needs + i * f->words);
        f->needs[i * f->words + i / BITS] |= (uint64_t)1 << i % BITS;
    }
    counter_free(c);
    return f;
}

void frame_cost_free(struct frame_cost *f)
{
    if (!f)
        return;
    free(f->price);
    free(f->needs);
    free(f->all);
    free(f);
}

double frame_cost_of(struct frame_cost *f, const struct genes *t)
{
    double price = 0;
    if (f->lets == 0)
        return 0;
    memset(f->all, 0, f->words * sizeof *f->all);
    need(f, t->gene, t->length, f->all);
    for (size_t i = 0; i < f->lets; i++)
        if (f->all[i / BITS] >> i % BITS & 1)
            price += f->price[i];
    return price;
}
