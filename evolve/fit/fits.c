/* Fits for islands; see fits.h. */
#include "fits.h"

#include "fit_linear.h"
#include "fit_twin.h"

#include <stdlib.h>

enum { ROWS = 2048, ITERATIONS = 6, TUNING = 1 };

struct fits {
    struct objective *objective; /* not owned */
    struct columns thin;         /* owned: about ROWS of the samples */
    struct fitter *fitter;       /* owned: to `thin` */
    struct twin_run *twin;       /* owned: the same for twin trees */
};

static bool root_terms(struct fits *f, const struct tree *in, size_t target, size_t max_length, struct tree *out)
{
    return !objective_takes_both(f->objective, target) && fit_root_terms(f->fitter, in, target, max_length, out);
}

static bool tune(struct fits *f, const struct tree *in, size_t target, size_t max_length, struct tree *out)
{
    (void)max_length;
    if (objective_takes_both(f->objective, target))
        return twin_fit(f->twin, in, f->objective->norm, TUNING, out);
    tape_load(f->fitter->tape, in);
    fitter_descend_norm(f->fitter, target, f->objective->norm, TUNING);
    tape_store(f->fitter->tape, out);
    return true;
}

static bool constants(struct fits *f, const struct tree *in, size_t target, size_t max_length, struct tree *out)
{
    double error;
    (void)max_length;
    if (objective_takes_both(f->objective, target))
        return twin_fit(f->twin, in, f->objective->norm, ITERATIONS, out);
    return fit_constants(f->fitter, f->objective, in, target, ITERATIONS, out, &error);
}

struct fits *fits_new(struct objective *objective)
{
    const size_t stride = objective->table->n / ROWS;
    struct fits *f = new_array(1, sizeof *f);
    *f = (struct fits){objective, columns_thin(objective->table, stride > 1 ? stride : 1), NULL, NULL};
    f->fitter = fitter_new(&f->thin);
    f->twin = twin_run_new(objective->twins, &f->thin);
    return f;
}

void fits_free(struct fits *f)
{
    if (!f)
        return;
    fitter_free(f->fitter);
    twin_run_free(f->twin);
    columns_free(&f->thin);
    free(f);
}

struct fitting fits_hooks(struct fits *f)
{
    return (struct fitting){f, root_terms, tune, constants};
}
