/* Prints the verdict of a run: the functions to call, beside the functions that ship for the kind of face; see archive_write.h. */
#include "archive_write.h"

#include <stdlib.h>
#include <string.h>

static const double worth = 0.9; /* an error above this part of the old error is no gain */

/* A tier's function of this run and the shipped function, on the same samples. */
struct row {
    const char *tier; /* not owned */
    double error, cost, shipped_error, shipped_cost;
    double gain; /* ratio of errors, or of costs if right to rounding; at most 1: no gain */
};

static double gain_of(const struct row *r, double rounding)
{
    if (r->cost > r->shipped_cost / worth)
        return 1;
    return r->shipped_error > rounding ? r->shipped_error / r->error : r->shipped_cost / r->cost;
}

static struct row row_of(const struct archive *a, const struct archive *shipped, struct objective *judge, size_t quest)
{
    const struct quest *own = &a->quest[quest], *old = &shipped->quest[quest];
    struct row r = {.tier = own->own->name, .cost = own->champion.cost, .shipped_cost = old->champion.cost};
    if (!quest_of_programs(own) || own->champion.genes.length == 0 || old->champion.genes.length == 0)
        return r;
    r.error = archive_bare_error(shipped, judge, old, &own->champion.genes);
    r.shipped_error = archive_bare_error(shipped, judge, old, &old->champion.genes);
    r.gain = gain_of(&r, objective_rounding(a->scene->norm));
    return r;
}

static void print_name(const char *scene, const char *tier, FILE *stream)
{
    fputs("footpoint_", stream);
    for (const char *c = scene; *c; c++)
        fputc(*c == '-' ? '_' : *c, stream);
    fprintf(stream, "_%s", tier);
}

/* Returns the gain that at most five rows exceed. */
static double least_told(const struct row *row, size_t n)
{
    enum { LINES = 5 };
    double least = 1 / worth;
    for (size_t i = 0; i < n; i++) {
        size_t better = 0;
        for (size_t k = 0; k < n; k++)
            better += row[k].gain > row[i].gain || (row[k].gain == row[i].gain && k < i);
        if (better == LINES && row[i].gain > least)
            least = row[i].gain;
    }
    return least;
}

void archive_verdict(const struct archive *a, const struct archive *shipped, struct objective *judge, FILE *stream)
{
    const char *kind = a->scene->segment->name;
    struct row *row = new_array(a->quests, sizeof *row);
    size_t told = 0;
    for (size_t i = 0; i < a->quests; i++)
        row[i] = row_of(a, shipped, judge, i);
    const double least = least_told(row, a->quests);
    for (size_t i = 0; i < a->quests; i++) {
        if (!(row[i].gain > least))
            continue;
        fputs("use ", stream);
        print_name(a->scene->name, row[i].tier, stream);
        fprintf(stream, ": error %.1e at cost %.0f; ", row[i].error, row[i].cost);
        print_name(kind, row[i].tier, stream);
        fprintf(stream, " has %.1e at %.0f\n", row[i].shipped_error, row[i].shipped_cost);
        told++;
    }
    if (told == 0)
        fprintf(stream, "nothing found that is better than the functions of footpoint_%s.h: use these\n", kind);
    free(row);
}
