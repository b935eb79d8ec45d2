/* Fits for islands; see fits.h. */
#include "fits.h"

#include "fit_lines.h"
#include "guide.h"

#include <stdlib.h>

enum { ROWS = 2048, FEW = 1, MANY = 6 };      /* iterations of a fit */
static const double guided_insertions = 0.08; /* fraction of the changes of programs */

struct fits {
    struct objective *objective; /* not owned */
    struct columns thin;         /* owned: about ROWS of the samples */
    struct lines_run *lines;     /* owned: on `thin` */
    struct guide *guide;         /* owned */
    struct line_editor *editor;  /* owned */
};

static bool fit(struct fits *f, const struct genes *in, int last, bool thoroughly, struct genes *out)
{
    return lines_fit(f->lines, in, last, f->objective->norm, thoroughly ? MANY : FEW, out);
}

/* Changes a program. Rejects results that depend on the unit of length. */
static bool change(struct fits *f, gsl_rng *rng, const struct gene_set *genes, const struct genes *t,
                   const struct genes *mate, int last, size_t max_length, struct genes *child)
{
    if (!(gsl_rng_uniform(rng) < guided_insertions ? guide_insert(f->guide, rng, genes, t, last, max_length, child)
                                                   : lines_edit(f->editor, rng, genes, t, mate, max_length, child)))
        return false;
    lines_load(f->lines->code, child, -1, LINES_INNER);
    return lines_keep_powers(f->lines->code);
}

struct fits *fits_new(struct objective *objective)
{
    const size_t stride = objective->table->n / ROWS;
    struct fits *f = new_array(1, sizeof *f);
    *f = (struct fits){objective, columns_thin(objective->table, stride > 1 ? stride : 1), NULL, NULL, NULL};
    f->lines = lines_run_new(objective->rules, &f->thin);
    f->guide = guide_new(objective->rules, &f->thin);
    f->editor = line_editor_new(objective->rules);
    return f;
}

void fits_free(struct fits *f)
{
    if (!f)
        return;
    lines_run_free(f->lines);
    guide_free(f->guide);
    line_editor_free(f->editor);
    columns_free(&f->thin);
    free(f);
}

struct fitting fits_hooks(struct fits *f)
{
    return (struct fitting){f, fit, change};
}
