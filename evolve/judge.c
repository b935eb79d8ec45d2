/* Training errors; see judge.h.  The mean comes fused from the kernel; the other norms need all values. */
#include "judge.h"

#include "errors.h"

#include <math.h>
#include <stdlib.h>

struct judge *judge_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm)
{
    struct judge *j = new_array(1, sizeof *j);
    *j = (struct judge){.table = table, .program = program, .norm = norm, .kernel = kernel_new_widest()};
    j->scratch = new_array(table->n, sizeof *j->scratch);
    return j;
}

void judge_free(struct judge *j)
{
    if (!j)
        return;
    kernel_free(j->kernel);
    free(j->scratch);
    free(j);
}

double judge_error(struct judge *j, const struct tree *t, size_t target, double bound)
{
    const struct kernel_task task = {t->gene, t->length, j->decimal ? NULL : j->program->constant, j->table};
    const size_t n = j->table->n;
    if (j->norm == NORM_MEAN)
        return kernel_error_sum(j->kernel, &task, target, bound * (double)n) / (double)n;
    kernel_values(j->kernel, &task, j->scratch);
    errors_absolute(j->scratch, columns_at(j->table, target), n);
    return j->norm == NORM_MAX ? errors_max(j->scratch, n) : errors_p99(j->scratch, n);
}
