/* Prints the verdict of a run: the functions to call, beside the functions that ship for the kind of face; see archive_write.h. */
#include "archive_write.h"

#include <math.h>
#include <stdlib.h>

static const double worth = 0.9; /* an error above this part of the old error is no gain */

/* A function on the samples. */
struct measured {
    const char *tier; /* not owned */
    double error, cost;
};

/* A function of this run, and the shipped function that takes its place. */
struct row {
    struct measured own, rival;
    double gain; /* ratio of errors; at most 1: no gain */
};

/* Returns the most accurate shipped function that is as cheap, or the cheapest of all. */
static const struct measured *rival_of(const struct measured *own, const struct measured *shipped, size_t n)
{
    const struct measured *cheapest = NULL, *accurate = NULL;
    for (const struct measured *s = shipped; s < shipped + n; s++) {
        if (!cheapest || s->cost < cheapest->cost)
            cheapest = s;
        if (s->cost <= own->cost && (!accurate || s->error < accurate->error))
            accurate = s;
    }
    return accurate ? accurate : cheapest;
}

/* Measures the programs of an archive; returns their number. */
static size_t measure_all(const struct archive *of, const struct archive *shipped, struct objective *judge,
                          struct measured *found)
{
    size_t n = 0;
    for (const struct quest *q = of->quest; q < of->quest + of->quests; q++)
        if (quest_of_programs(q) && q->champion.genes.length > 0)
            found[n++] = (struct measured){q->own->name, archive_bare_error(shipped, judge, q, &q->champion.genes),
                                           q->champion.cost};
    return n;
}

static void print_name(const char *scene, const char *tier, FILE *stream)
{
    fputs("footpoint_", stream);
    for (const char *c = scene; *c; c++)
        fputc(*c == '-' ? '_' : *c, stream);
    fprintf(stream, "_%s", tier);
}

static void print_row(const struct archive *a, const struct row *r, FILE *stream)
{
    fputs("use ", stream);
    print_name(a->scene->name, r->own.tier, stream);
    fprintf(stream, ": error %.1e at cost %.0f; ", r->own.error, r->own.cost);
    print_name(a->scene->segment->name, r->rival.tier, stream);
    fprintf(stream, " has %.1e at %.0f\n", r->rival.error, r->rival.cost);
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
    const double rounding = objective_rounding(a->scene->norm);
    struct measured *own = new_array(a->quests, sizeof *own), *old = new_array(shipped->quests, sizeof *old);
    struct row *row = new_array(a->quests, sizeof *row);
    const size_t n = measure_all(a, shipped, judge, own), rivals = measure_all(shipped, shipped, judge, old);
    for (size_t i = 0; i < n && rivals > 0; i++) {
        const struct measured *rival = rival_of(&own[i], old, rivals);
        row[i] = (struct row){own[i], *rival, fmax(rival->error, rounding) / fmax(own[i].error, rounding)};
    }
    const double least = least_told(row, n);
    size_t told = 0;
    for (size_t i = 0; i < n; i++)
        if (row[i].gain > least) {
            print_row(a, &row[i], stream);
            told++;
        }
    if (told == 0)
        fprintf(stream, "nothing found that is better than the functions of footpoint_%s.h: use these\n",
                a->scene->segment->name);
    free(own);
    free(old);
    free(row);
}
