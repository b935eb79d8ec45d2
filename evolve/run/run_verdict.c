/* The last word of a run; see run_verdict.h. */
#include "run_verdict.h"

#include "../eval/frame.h"
#include "../write/archive_write.h"
#include "run_files.h"

#include <stdlib.h>

/* Some of the samples held out, as columns of the bare program. */
static struct columns some_heldout(const struct genome_file *program, const struct sample_set *set)
{
    enum { MOST = 20000 };
    const size_t stride = (set->n + MOST - 1) / MOST, n = stride > 0 ? set->n / stride : 0;
    struct sample *chosen = new_array(n, sizeof *chosen);
    for (size_t i = 0; i < n; i++)
        chosen[i] = set->s[i * stride];
    const struct columns table = frame_columns(program, chosen, n);
    free(chosen);
    return table;
}

void run_verdict(const struct call *call, const struct problem *p, const struct heldout *heldout)
{
    char path[1024];
    struct diag d = {.code = EXIT_DONE};
    if (call->options->generations == 0 || !run_files_of_kind(call, p->scene, path))
        return;
    struct genome_file *program = frame_program(call->options->root, p->scene, path, &d);
    struct archive *shipped = program ? archive_new(p->scene, program, path, true, &d) : NULL;
    if (!shipped)
        return;
    struct objective *training = objective_new(shipped->program, &p->table, p->scene->norm);
    training->decimal = true;
    archive_measure(shipped, &p->plan, training);
    objective_free(training);
    struct columns table = some_heldout(shipped->program, &heldout->part[0]);
    struct objective *judge = objective_new(shipped->program, &table, p->scene->norm);
    judge->decimal = true;
    bool any = false;
    for (size_t i = 0; i < shipped->quests; i++)
        any = any || (quest_of_programs(&shipped->quest[i]) && shipped->quest[i].champion.genes.length > 0);
    if (any)
        archive_verdict(p->archive, shipped, judge, stdout);
    objective_free(judge);
    columns_free(&table);
    archive_free(shipped);
}
