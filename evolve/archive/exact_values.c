/* Expressions that need no evolution: values of a frame that are right to rounding, and those of one gene; see
 * archive.h. */
#include "archive.h"

#include "../eval/frame.h"

#include <math.h>

/* Gene of the cheapest terminal of a tier that is within `tolerance` on all samples; 0: none. */
static int exact_value(const struct archive *a, struct objective *worst, const struct tier *t, int output,
                       double tolerance)
{
    int exact = 0;
    double least = t->budget > 0 ? t->budget : INFINITY;
    for (size_t i = 0; i < t->terminals; i++) {
        int gene = GENE_SYMBOL + (int)genome_find_symbol(a->program, t->terminal[i]);
        const struct genes value = {&gene, 1};
        const double cost = frame_cost_of(a->frame, &value);
        if (cost > least || (exact && cost == least) ||
            !(objective_tree_error(worst, &value, frame_target(a->program, output), INFINITY) <= tolerance))
            continue;
        exact = gene;
        least = cost;
    }
    return exact;
}

void archive_find_exact(struct archive *a, const struct plan *plan, const struct columns *table, double tolerance)
{
    struct objective *worst = objective_new(a->program, table, NORM_MAX);
    if (!a->frame)
        a->frame = frame_cost_new(a->program, &plan->prices);
    for (size_t i = 0; i < a->scene->tiers; i++)
        for (int k = tier_first(&a->scene->tier[i]); k < TIER_BOTH; k++) {
            struct champion *c = &a->champion[i][k];
            const struct genes value = {&c->exact, 1};
            c->exact = exact_value(a, worst, &a->scene->tier[i], k, tolerance);
            if (c->exact)
                archive_add_seed(a, (long)i, k, &value);
        }
    objective_free(worst);
}

void archive_choose_values(struct archive *a, size_t tier, bool anew)
{
    const struct tier *t = &a->scene->tier[tier];
    for (int k = 0; k < TIER_BOTH; k++) {
        struct champion *c = &a->champion[tier][k];
        c->chosen = true;
        for (size_t i = 0; i < t->terminals && (anew || c->genes.length == 0); i++) {
            int gene = GENE_SYMBOL + (int)genome_find_symbol(a->program, t->terminal[i]);
            archive_add_seed(a, (long)tier, k, &(struct genes){&gene, 1});
        }
    }
}

bool archive_is_exact(const struct archive *a, size_t tier)
{
    return a->champion[tier][0].exact && a->champion[tier][1].exact;
}

void archive_print_exact(const struct archive *a, FILE *stream)
{
    size_t exact = 0;
    for (size_t i = 0; i < a->scene->tiers; i++)
        exact += archive_is_exact(a, i) ? 1 : 0;
    if (exact == a->scene->tiers)
        fputs(": nothing to evolve, the formula is exact", stream);
    else if (exact > 0)
        fputs(": nothing to evolve for", stream);
    for (size_t i = 0; i < a->scene->tiers && exact < a->scene->tiers; i++)
        if (archive_is_exact(a, i))
            fprintf(stream, " %s", a->scene->tier[i].name);
    fputc('\n', stream);
}
