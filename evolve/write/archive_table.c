/* Prints tables of the changes of a run; see archive_write.h. */
#include "archive_write.h"

#include "../eval/frame.h"

#include <math.h>

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
