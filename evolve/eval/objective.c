/* Training errors; see objective.h.  The mean comes fused from the kernel; the other norms need all values. */
#include "objective.h"

#include "errors.h"

#include <math.h>
#include <stdlib.h>

struct judge *judge_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm)
{
    struct judge *j = new_array(1, sizeof *j);
    *j = (struct judge){.table = table, .program = program, .norm = norm, .kernel = kernel_new_widest()};
    j->scratch = new_array(2 * table->n, sizeof *j->scratch);
    if (program) {
        j->twins = twins_new(program);
        j->twin = twin_run_new(j->twins, table);
    }
    if (norm == NORM_MEAN)
        j->single = columns_float_new(table);
    return j;
}

void judge_free(struct judge *j)
{
    if (!j)
        return;
    kernel_free(j->kernel);
    twin_run_free(j->twin);
    twins_free(j->twins);
    columns_float_free(&j->single);
    free(j->scratch);
    free(j);
}

static struct kernel_task task_of(const struct judge *j, const struct tree *t)
{
    return (struct kernel_task){t->gene, t->length, j->decimal ? NULL : j->program->constant, j->table};
}

bool judge_takes_both(const struct judge *j, size_t target)
{
    return target == j->table->count;
}

/* The same of all errors, those of xi and those of eta. */
static double twin_error(struct judge *j, const struct tree *t, double bound)
{
    const size_t n = 2 * j->table->n;
    if (j->norm == NORM_MEAN)
        return twin_error_sum(j->twin, t, bound * (double)n) / (double)n;
    twin_errors(j->twin, t, j->scratch);
    return j->norm == NORM_MAX ? errors_max(j->scratch, n) : errors_p99(j->scratch, n);
}

double judge_error(struct judge *j, const struct tree *t, size_t target, double bound)
{
    const struct kernel_task task = task_of(j, t);
    const size_t n = j->table->n;
    if (judge_takes_both(j, target))
        return twin_error(j, t, bound);
    if (j->norm == NORM_MEAN)
        return kernel_error_sum(j->kernel, &task, target, bound * (double)n) / (double)n;
    kernel_values(j->kernel, &task, j->scratch);
    errors_absolute(j->scratch, columns_at(j->table, target), n);
    return j->norm == NORM_MAX ? errors_max(j->scratch, n) : errors_p99(j->scratch, n);
}

double judge_rank(struct judge *j, const struct tree *t, size_t target, double bound)
{
    if (j->norm != NORM_MEAN || judge_takes_both(j, target))
        return judge_error(j, t, target, bound);
    const struct kernel_task task = task_of(j, t);
    const double n = (double)j->table->n;
    return kernel_error_sum_float(j->kernel, &task, &j->single, target, bound * n) / n;
}

double judge_work(const struct judge *j)
{
    return kernel_work(j->kernel) + (j->twin ? j->twin->work : 0);
}
