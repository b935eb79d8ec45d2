/* Training errors; see objective.h.  The mean comes fused from the kernel; the other norms need all values. */
#include "objective.h"

#include "errors.h"

#include <math.h>
#include <stdlib.h>

struct objective *objective_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm)
{
    struct objective *o = new_array(1, sizeof *o);
    *o = (struct objective){.table = table, .program = program, .norm = norm, .kernel = kernel_new_widest()};
    o->scratch = new_array(2 * table->n, sizeof *o->scratch);
    if (program) {
        o->twins = twins_new(program);
        o->twin = twin_run_new(o->twins, table);
    }
    if (norm == NORM_MEAN)
        o->single = columns_float_new(table);
    return o;
}

void objective_free(struct objective *o)
{
    if (!o)
        return;
    kernel_free(o->kernel);
    twin_run_free(o->twin);
    twins_free(o->twins);
    columns_float_free(&o->single);
    free(o->scratch);
    free(o);
}

static struct kernel_task task_of(const struct objective *o, const struct tree *t)
{
    return (struct kernel_task){t->gene, t->length, o->decimal ? NULL : o->program->constant, o->table};
}

bool objective_takes_both(const struct objective *o, size_t target)
{
    return target == o->table->count;
}

/* The same of all errors, those of xi and those of eta. */
static double twin_error(struct objective *o, const struct tree *t, double bound)
{
    const size_t n = 2 * o->table->n;
    if (o->norm == NORM_MEAN)
        return twin_error_sum(o->twin, t, bound * (double)n) / (double)n;
    twin_errors(o->twin, t, o->scratch);
    return o->norm == NORM_MAX ? errors_max(o->scratch, n) : errors_p99(o->scratch, n);
}

double objective_error(struct objective *o, const struct tree *t, size_t target, double bound)
{
    const struct kernel_task task = task_of(o, t);
    const size_t n = o->table->n;
    if (objective_takes_both(o, target))
        return twin_error(o, t, bound);
    if (o->norm == NORM_MEAN)
        return kernel_error_sum(o->kernel, &task, target, bound * (double)n) / (double)n;
    kernel_values(o->kernel, &task, o->scratch);
    errors_absolute(o->scratch, columns_at(o->table, target), n);
    return o->norm == NORM_MAX ? errors_max(o->scratch, n) : errors_p99(o->scratch, n);
}

double objective_rank(struct objective *o, const struct tree *t, size_t target, double bound)
{
    if (o->norm != NORM_MEAN || objective_takes_both(o, target))
        return objective_error(o, t, target, bound);
    const struct kernel_task task = task_of(o, t);
    const double n = (double)o->table->n;
    return kernel_error_sum_float(o->kernel, &task, &o->single, target, bound * n) / n;
}

double objective_work(const struct objective *o)
{
    return kernel_work(o->kernel) + (o->twin ? o->twin->work : 0);
}
