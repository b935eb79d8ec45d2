/* Decisions of the pinball test; see contact_table.h. */
#include "contact_table.h"

#include "pinball.h"
#include "rivals_closed.h"

#include <stdlib.h>

static const double rounding = 1e-9;

/* Returns the root of the area that the pinball test uses. */
static double size_of(const struct sample *s)
{
    double ac[3], bd[3];
    for (int k = 0; k < 3; k++) {
        ac[k] = s->x[2][k] - s->x[0][k];
        bd[k] = s->x[3][k] - s->x[1][k];
    }
    return sqrt(rival_triangle(ac, bd) / 2);
}

struct contact_decisions contact_decide(const struct sample_set *set)
{
    struct contact_decisions c = {0};
    double *error = new_array(set->n, sizeof *error);
    size_t found = 0;
    for (size_t i = 0; i < set->n; i++) {
        const struct sample *s = &set->s[i];
        const double size = size_of(s), depth = rival_pinball_depth(s->x[0], s->x[1], s->x[2], s->x[3], s->xs);
        if (fabs(s->gap) <= rounding * size)
            continue;
        const bool contact = s->gap < 0 && fabs(s->xi) <= 1 && fabs(s->eta) <= 1;
        c.n++;
        c.contacts += contact;
        c.missed += contact && !(depth > 0);
        c.invented += !contact && depth > 0;
        if (contact && depth > 0)
            error[found++] = fabs(depth + s->gap) / size;
    }
    c.depth = error_stats_of(error, found);
    free(error);
    return c;
}

const char contact_table_head[] =
    "scene,sample,method,samples,contacts,right,missed,invented,mean_depth_error,p99_depth_error,max_depth_error";

static bool print_part(const struct scene *scene, enum sample_part part, const char *sample, struct diag *d)
{
    struct sample_set set = {0};
    if (!scene_samples(scene, part, &set, d))
        return false;
    const struct contact_decisions c = contact_decide(&set);
    const double n = (double)(c.n > 0 ? c.n : 1);
    printf("%s,%s,pinball,%zu,%zu,%.4f,%.4f,%.4f,%.3e,%.3e,%.3e\n", scene->name, sample, c.n, c.contacts,
           1 - (double)(c.missed + c.invented) / n, (double)c.missed / n, (double)c.invented / n, c.depth.mean,
           c.depth.p99, c.depth.max);
    sample_set_free(&set);
    return true;
}

bool contact_table(const struct scene *scene, struct diag *d)
{
    if (!scene->segment->bilinear) /* pinballs exist only for four-node segments */
        return true;
    return scene->source == SOURCE_RANDOM
               ? print_part(scene, PART_HELDOUT, "random", d)
               : print_part(scene, PART_HELDOUT, "grid", d) && print_part(scene, PART_HELDOUT_RANDOM, "random", d);
}
