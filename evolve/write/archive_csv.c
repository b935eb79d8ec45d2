/* The fronts as a table; see archive_write.h.  Errors held out are those of SAMPLES of the samples at most, evenly chosen, so
 * that all values of the frame can be there at once; of both outputs of a program together. */
#include "archive_write.h"

#include "../../codegen/base/outfile.h"
#include "../common/decimal.h"
#include "../eval/frame.h"
#include "../genotype/lines_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 65536, PARTS = 2 };

/* A held-out part, ready to be measured on. */
struct part {
    struct columns table;
    struct objective *objective;
};

static struct part part_new(const struct archive *a, const struct sample_set *set)
{
    const size_t stride = (set->n + SAMPLES - 1) / SAMPLES, n = stride > 0 ? set->n / stride : 0;
    struct sample *chosen = new_array(n, sizeof *chosen);
    for (size_t i = 0; i < n; i++)
        chosen[i] = set->s[i * stride];
    const struct columns table = frame_columns(a->program, chosen, n);
    free(chosen);
    return (struct part){table, NULL};
}

static void print_errors(const struct archive *a, struct part *p, const struct member *m, const struct quest *q,
                         FILE *stream)
{
    static const enum scene_norm norm[] = {NORM_MEAN, NORM_P99, NORM_MAX};
    fprintf(stream, ",%zu", p->table.n);
    for (int i = 0; i < 3; i++) {
        if (p->table.n == 0) {
            fputc(',', stream);
            continue;
        }
        p->objective->norm = norm[i];
        fprintf(stream, ",%.3e", archive_bare_error(a, p->objective, q, &m->genes));
    }
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

static void print_member(const struct archive *a, struct part part[PARTS], const struct quest *q,
                         const struct member *m, FILE *stream)
{
    const struct operation_count o = archive_operations(a, q, &m->genes, NULL);
    fprintf(stream, "%s,%s,%g,%u,%u,%u,%u,%s,%.3e", q->own->name, frame_output[q->output], m->cost, o.mul, o.add, o.div,
            o.other, origin_name[m->origin], m->error);
    for (int k = 0; k < PARTS; k++)
        print_errors(a, &part[k], m, q, stream);
    print_expression(a, q, &m->genes, stream);
}

bool archive_is_list(const char *path)
{
    const size_t length = strlen(path);
    return length > 4 && strcmp(path + length - 4, ".csv") == 0;
}

bool archive_write_csv(const struct archive *a, const char *path, const struct heldout *heldout, struct diag *d)
{
    struct outfile out;
    struct part part[PARTS];
    if (!outfile_open(&out, path, d))
        return false;
    fputs(
        "tier,output,cost,mul,add,div,other,origin,training,n,mean,p99,max,n_random,mean_random,p99_random,max_random,"
        "tree\n",
        out.stream);
    for (int k = 0; k < PARTS; k++) {
        part[k] = part_new(a, &heldout->part[k]);
        part[k].objective = objective_new(a->program, &part[k].table, NORM_MAX);
        part[k].objective->decimal = true;
    }
    for (const struct quest *q = a->quest; q < a->quest + a->quests; q++)
        for (size_t c = 0; c <= q->front->limit; c++)
            if (q->front->member[c].genes.length > 0)
                print_member(a, part, q, &q->front->member[c], out.stream);
    for (int k = 0; k < PARTS; k++) {
        objective_free(part[k].objective);
        columns_free(&part[k].table);
    }
    return outfile_commit(&out, d);
}
