/* Prints tables of the changes of a run, and its verdict: the functions to call, beside the functions that ship for the kind of
 * face; see archive_write.h. */
#include "archive_write.h"

#include "../eval/frame.h"

#include <math.h>
#include <stdlib.h>

/* Formats an error as "1.234e-05", or in words. */
static void error_text(double error, char text[16])
{
    snprintf(text, 16, error < INFINITY ? "%.3e" : "not finite", error);
}

/* Prints the gain of a program's tier: the error at its cost, and the cost at its error. */
static void print_gain(const struct front *f, const struct champion *c, double rounding, FILE *stream)
{
    size_t cost = 0;
    if (c->error_before <= rounding) {
        fprintf(stream, "right to rounding as before, at cost %.0f, %.0f before", c->cost, c->cost_before);
        return;
    }
    while (cost < f->limit && !(f->lowest[cost] <= c->error_before))
        cost++;
    if (!(c->error_before < INFINITY))
        return;
    fprintf(stream, "%.2f times less error; as good as before from cost %zu on, %.0f before",
            c->error_before / c->error, cost, c->cost_before);
}

void archive_table(const struct archive *a, FILE *stream)
{
    fprintf(stream, "%-24s %-6s %10s    %-10s %6s    %-6s\n", "tier", "output", "error", "", "genes", "");
    for (const struct quest *q = a->quest; q < a->quest + a->quests; q++) {
        const struct champion *c = &q->champion;
        char error[16] = "-", now[16], length[16] = "-";
        if (!archive_has(a, q->tier))
            continue;
        if (c->length_before > 0) {
            error_text(c->error_before, error);
            snprintf(length, sizeof length, "%zu", c->length_before);
        }
        error_text(c->error, now);
        fprintf(stream, "%-24s %-6s %10s -> %-10s %6s -> %-6zu%s", q->own->name, frame_output[q->output], error, now,
                length, c->genes.length, c->bred ? "" : "unchanged");
        if (quest_of_programs(q) && c->bred && c->length_before > 0)
            print_gain(q->front, c, objective_rounding(a->scene->norm), stream);
        fputc('\n', stream);
    }
}

void archive_front_table(const struct archive *a, FILE *stream)
{
    fprintf(stream, "%-24s %-6s %6s %10s %10s  %s\n", "front", "output", "cost", "old", "new", "from");
    for (const struct quest *q = a->quest; q < a->quest + a->quests; q++)
        for (size_t c = 0; c <= q->front->limit; c++) {
            const struct member *m = &q->front->member[c];
            const double old = q->old->lowest[c];
            char text[16] = "-";
            if (m->genes.length == 0)
                continue;
            if (old < INFINITY)
                snprintf(text, sizeof text, "%.3e", old);
            fprintf(stream, "%-24s %-6s %6g %10s %10.3e  %s\n", q->own->name, frame_output[q->output], m->cost, text,
                    m->error, origin_name[m->origin]);
        }
}

/* ---- the verdict ---- */

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
    if (told == 0 && rivals > 0)
        fprintf(stream, "nothing found that is better than the functions of footpoint_%s.h: use these\n",
                a->scene->segment->name);
    free(own);
    free(old);
    free(row);
}
