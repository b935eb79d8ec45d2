/* Tiers that need no evolution: frame values that are right to rounding, and expressions of one gene; see archive.h. */
#include "archive.h"

#include "../eval/frame.h"

#include <math.h>

/* Returns the gene of a tier's cheapest terminal that is within `tolerance` on all samples, or 0. */
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
    for (struct quest *q = a->quest; q < a->quest + a->quests; q++) {
        struct champion *c = &q->champion;
        const struct genes value = {&c->exact, 1};
        c->exact = quest_of_programs(q) ? 0 : exact_value(a, worst, q->own, q->output, tolerance);
        if (c->exact)
            archive_add_seed(a, (long)q->tier, q->output, &value);
    }
    objective_free(worst);
}

void archive_choose_values(struct archive *a, size_t tier, bool anew)
{
    const struct tier *t = &a->scene->tier[tier];
    size_t n;
    for (struct quest *q = archive_quests(a, tier, &n), *end = q + n; q < end; q++) {
        struct champion *c = &q->champion;
        c->chosen = true;
        for (size_t i = 0; i < t->terminals && (anew || c->genes.length == 0); i++) {
            int gene = GENE_SYMBOL + (int)genome_find_symbol(a->program, t->terminal[i]);
            archive_add_seed(a, (long)tier, q->output, &(struct genes){&gene, 1});
        }
    }
}

bool archive_is_exact(const struct archive *a, size_t tier)
{
    size_t n;
    const struct quest *q = archive_quests(a, tier, &n);
    return q[0].champion.exact && q[n - 1].champion.exact;
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
