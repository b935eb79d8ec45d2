/* The fronts as a table; see archive_write.h. Errors of programs pool both outputs. */
#include "archive_write.h"

#include "../../codegen/base/outfile.h"
#include "../common/decimal.h"
#include "../eval/frame.h"
#include "../genotype/lines_text.h"
#include "measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTS = 2 };

/* A row of the table. */
struct row {
    const struct archive *a; /* not owned, as is: */
    const struct quest *quest;
    const struct member *member;
    struct errors found[PARTS]; /* n is 0 if the scene lacks the part */
};

static struct row *list_rows(const struct archive *a, size_t *n)
{
    struct row *row = NULL;
    size_t room = 0;
    *n = 0;
    for (const struct quest *q = a->quest; q < a->quest + a->quests; q++)
        for (size_t c = 0; c <= q->front->limit; c++)
            if (q->front->member[c].genes.length > 0)
                APPEND(row, *n, room) = (struct row){.a = a, .quest = q, .member = &q->front->member[c]};
    return row;
}

static size_t outputs_of(const struct row *row)
{
    return quest_of_programs(row->quest) ? 2 : 1;
}

/* Opens an objective that measures rows on a few samples: errors of xi, then of eta, in `scratch`. */
static struct objective *judge_new(const struct archive *a, const struct sample *s, size_t n, struct columns *table)
{
    *table = frame_columns(a->program, s, n);
    struct objective *o = objective_new(a->program, table, NORM_MAX);
    o->decimal = true;
    return o;
}

/* Adds the errors of all rows on a few samples to the tallies, indexed by row. */
static void take_piece(const struct archive *a, const struct row *row, size_t n, const struct sample *s, size_t samples,
                       struct tally *t)
{
    struct columns table;
    struct objective *o = judge_new(a, s, samples, &table);
    for (size_t i = 0; i < n; i++) {
        archive_bare_error(a, o, row[i].quest, &row[i].member->genes);
        tally_take(&t[i], o->scratch, outputs_of(&row[i]) * samples);
    }
    objective_free(o);
    columns_free(&table);
}

/* ---- climbing ---- */

/* Computes the larger error of both outputs. */
static void errors_of_row(const void *of, const struct sample *s, size_t n, double **error)
{
    const struct row *r = of;
    struct columns table;
    struct objective *o = judge_new(r->a, s, n, &table);
    archive_bare_error(r->a, o, r->quest, &r->member->genes);
    for (size_t i = 0; i < n; i++)
        error[0][i] = fmax(o->scratch[i], outputs_of(r) == 2 ? o->scratch[n + i] : 0);
    objective_free(o);
    columns_free(&table);
}

/* Climbs from a row's worst samples and returns the largest error. In a piece of n samples with pooled outputs, errors
 * have the indices 0 to 2 n - 1. */
static double climb_row(const struct row *row, size_t at, struct sampler *p, struct tally *t)
{
    const size_t outs = outputs_of(row), piece = outs * HELDOUT_PIECE, all = t->n / outs;
    struct largest start[TALLY_WORST];
    size_t n = 0;
    tally_sort(t);
    double worst = t->kept > 0 ? t->largest[0].error : 0;
    for (; n < t->kept && n < TALLY_WORST; n++) {
        const size_t first = t->largest[n].sample / piece * HELDOUT_PIECE, left = all - first;
        const size_t samples = left < HELDOUT_PIECE ? left : HELDOUT_PIECE;
        start[n] = (struct largest){t->largest[n].error, first + t->largest[n].sample % piece % samples};
    }
    climb_from(p, &(struct climb_goal){errors_of_row, row, 1, NULL, NULL}, at, start, n, &worst);
    return worst;
}

static bool measure_rows(const struct archive *a, struct row *row, size_t n, struct sampler *p, int part, size_t most,
                         struct diag *d)
{
    struct sample *s = new_array(HELDOUT_PIECE, sizeof *s);
    struct tally *t = new_array(n, sizeof *t);
    size_t at = 0, samples;
    bool good;
    for (size_t i = 0; i < n; i++)
        tally_open(&t[i], 2 * p->count);
    while ((good = heldout_piece(p, most, &at, s, &samples, d)) && samples > 0)
        take_piece(a, row, n, s, samples, t);
    for (size_t i = 0; i < n; i++) {
        const double climbed = good && climb_can(p) && most == SIZE_MAX ? climb_row(&row[i], i, p, &t[i]) : 0;
        row[i].found[part] = tally_close(&t[i]);
        row[i].found[part].n = at;
        row[i].found[part].climbed = climbed;
    }
    free(t);
    free(s);
    return good;
}

static void print_errors(const struct errors *e, FILE *stream)
{
    if (e->n == 0)
        fputs(",0,,,", stream);
    else
        fprintf(stream, ",%zu,%.3e,%.3e,%.3e", e->n, e->mean, e->p99, fmax(e->max, e->climbed));
}

static void print_expression(const struct archive *a, const struct quest *q, const struct genes *t, FILE *stream)
{
    char number[DECIMAL_TEXT];
    if (quest_of_programs(q)) {
        char *text = lines_print(a->lines, t, q->last);
        fprintf(stream, ",%s\n", text);
        free(text);
        return;
    }
    fputc(',', stream);
    for (size_t i = 0; i < t->length; i++) {
        const int gene = t->gene[i];
        if (gene < 0)
            decimal_text(gene, number);
        fprintf(stream, "%s%s", i ? " " : "",
                gene < 0              ? number
                : gene >= GENE_SYMBOL ? genome_symbol_name(a->program, (size_t)(gene - GENE_SYMBOL))
                                      : gene_name(gene));
    }
    fputc('\n', stream);
}

static void print_row(const struct row *r, FILE *stream)
{
    const struct quest *q = r->quest;
    const struct member *m = r->member;
    const struct operation_count o = archive_operations(r->a, q, &m->genes, NULL);
    fprintf(stream, "%s,%s,%g,%u,%u,%u,%u,%s,%.3e", q->own->name, frame_output[q->output], m->cost, o.mul, o.add, o.div,
            o.other, origin_name[m->origin], m->error);
    for (int k = 0; k < PARTS; k++)
        print_errors(&r->found[k], stream);
    print_expression(r->a, q, &m->genes, stream);
}

bool archive_is_list(const char *path)
{
    const size_t length = strlen(path);
    return length > 4 && strcmp(path + length - 4, ".csv") == 0;
}

bool archive_write_csv(const struct archive *a, const char *path, const struct heldout *heldout, size_t most,
                       struct diag *d)
{
    struct outfile out;
    size_t n;
    bool good = true;
    if (!outfile_open(&out, path, d))
        return false;
    struct row *row = list_rows(a, &n);
    for (int k = 0; k < PARTS && good; k++)
        if (heldout->part[k])
            good = measure_rows(a, row, n, heldout->part[k], k, most, d);
    fputs(
        "tier,output,cost,mul,add,div,other,origin,training,n,mean,p99,max,n_random,mean_random,p99_random,max_random,"
        "tree\n",
        out.stream);
    for (size_t i = 0; i < n; i++)
        print_row(&row[i], out.stream);
    free(row);
    if (good)
        return outfile_commit(&out, d);
    outfile_discard(&out);
    return false;
}
