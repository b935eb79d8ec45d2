/* The pipeline of passes; see compile.h. */
#include "compile.h"

#include "horner.h"
#include "share.h"
#include "simplify.h"

#include <stdlib.h>

long operations_cost(const struct operations *ops)
{
    return ops->mul + ops->add + 8 * (ops->div + ops->sqrt) + ops->compare;
}

static bool cheaper(const struct operations *a, const struct operations *b)
{
    const long x = operations_cost(a), y = operations_cost(b);
    return x < y || (x == y && a->mul < b->mul);
}

static struct emission run_passes(const struct genome_file *f, const struct dag *g, const struct compile_options *o,
                                  bool factor)
{
    const struct horner_policy policy = {0};
    struct dag *shaped = factor ? horner_factor(g, &policy, NULL) : NULL;
    struct emission e;
    if (!shaped)
        shaped = dag_copy(g);
    share_pairs(shaped);
    struct schedule *s = schedule_new(shaped, &o->cost);
    emit_statements(f, s, &e);
    schedule_free(s);
    dag_free(shaped);
    return e;
}

struct compile_options compile_defaults(void)
{
    struct diag d;
    struct compile_options o = {.seed = 1, .effort = 1000};
    cost_model_find("throughput", &o.cost, &d);
    return o;
}

bool compile_genome(const struct genome_file *f, const struct genome *genome, const struct compile_options *o,
                    struct compiled *c, struct diag *d)
{
    *c = (struct compiled){0};
    for (int variant = 0; variant < 4; variant++) {
        struct dag *g = simplify_genome(f, genome, variant & 1 ? KEEP_ALL : KEEP_QUOTIENTS, d);
        if (!g)
            return false;
        struct emission e = run_passes(f, g, o, variant < 2);
        const size_t removed = g->removed;
        dag_free(g);
        if (!c->emission.text || cheaper(&e.ops, &c->emission.ops)) {
            free(c->emission.text);
            c->emission = e;
            c->removed = removed;
        } else
            free(e.text);
    }
    if (c->emission.out_of_range) {
        free(c->emission.text);
        c->emission.text = NULL;
        return diag_at(d, f->path, genome->line, 1, "genome '%s' needs a constant out of the range of double",
                       genome->name);
    }
    return true;
}
