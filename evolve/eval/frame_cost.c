/* Prices of lets; see frame_cost.h. Lets use only lets before them. */
#include "frame_cost.h"

#include <stdlib.h>
#include <string.h>

struct frame_cost {
    const struct genome_file *program; /* not owned */
    size_t lets;                       /* the program may get more */
    double *price;                     /* owned: by let; its own operations */
    bool *needed;                      /* owned scratch: by let */
};

struct frame_cost *frame_cost_new(const struct genome_file *program, const struct prices *prices)
{
    struct frame_cost *f = new_array(1, sizeof *f);
    *f = (struct frame_cost){.program = program, .lets = program->lets};
    f->price = new_array(f->lets, sizeof *f->price);
    f->needed = new_array(f->lets, sizeof *f->needed);
    struct counter *c = counter_new();
    for (size_t i = 0; i < f->lets; i++) {
        const struct genes t = {program->let[i].gene, program->let[i].length};
        const struct operation_count o = count_operations(c, &t, program->constant);
        f->price[i] = operations_price(&o, prices);
    }
    counter_free(c);
    return f;
}

void frame_cost_free(struct frame_cost *f)
{
    if (!f)
        return;
    free(f->price);
    free(f->needed);
    free(f);
}

/* Marks the lets that an expression names. */
static void need(struct frame_cost *f, const int *gene, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        const long let = (long)gene[i] - GENE_SYMBOL - (long)f->program->inputs;
        if (let >= 0 && let < (long)f->lets)
            f->needed[let] = true;
    }
}

double frame_cost_of(struct frame_cost *f, const struct genes *t)
{
    double price = 0;
    memset(f->needed, 0, f->lets * sizeof *f->needed);
    need(f, t->gene, t->length);
    for (size_t i = f->lets; i-- > 0;)
        if (f->needed[i]) {
            need(f, f->program->let[i].gene, f->program->let[i].length);
            price += f->price[i];
        }
    return price;
}
