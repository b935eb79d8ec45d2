/* Finds the files of a run and checks that they are compatible; see run.h. */
#include "run.h"

#include "../../codegen/base/text.h"
#include "../common/data_root.h"
#include "../input/scene_files.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

static void genomes_path(const struct call *call, const char *name, char path[1024])
{
    snprintf(path, 1024, "%.700s/evolve/genomes/%.250s.gen", call->options->root, name);
}

bool run_files_choose(const struct call *call, const struct scene *scene, struct run_files *f, struct diag *d)
{
    const struct evolve_options *o = call->options;
    for (int i = 0; i < 2; i++) {
        const char *path = i ? o->start : o->output;
        if (path && strlen(path) >= sizeof f->output)
            return diag_at(d, path, 0, 0, "path is too long");
    }
    if (root_is_installed(o->root))
        snprintf(f->output, sizeof f->output, "%.250s.gen", scene->name);
    else
        genomes_path(call, scene->name, f->output);
    if (o->output)
        snprintf(f->output, sizeof f->output, "%s", o->output);
    f->shipped = call->resume != NULL; /* decided when the run first started */
    if (call->resume)
        return !*call->resume->start || resume_start_file(call->resume, f->start, sizeof f->start, d);
    if (o->start)
        snprintf(f->start, sizeof f->start, "%s", o->start);
    else if (!o->from_scratch)
        genomes_path(call, scene->name, f->start);
    if (!o->start && access(f->start, F_OK) != 0)
        f->start[0] = '\0';
    return true;
}

void run_files_start_from_shipped(const struct call *call, const struct scene *scene, struct run_files *f)
{
    const struct evolve_options *o = call->options;
    if (f->start[0] || o->from_scratch || call->resume)
        return;
    genomes_path(call, scene->segment->name, f->start);
    f->shipped = access(f->start, F_OK) == 0 && strcmp(f->start, f->output) != 0;
    if (!f->shipped)
        f->start[0] = '\0';
}

bool run_files_of_kind(const struct call *call, const struct scene *scene, char path[1024])
{
    genomes_path(call, scene->segment->name, path);
    return strcmp(scene->name, scene->segment->name) != 0 && access(path, F_OK) == 0;
}

bool run_files_keep_start(struct run_files *f, struct diag *d)
{
    f->start_text = f->start[0] ? read_text(f->start, &f->start_bytes, d) : new_text("", 0);
    return f->start_text != NULL;
}

bool run_files_suit(const struct call *call, const struct scene *scene, const struct run_files *f, struct diag *d)
{
    enum { NONE, GENOMES, CHECKPOINTS };
    const struct evolve_options *o = call->options;
    const struct file_use file[] = {{"--output", f->output, true, GENOMES},
                                    {"--start", call->resume || !*f->start ? NULL : f->start, false, GENOMES},
                                    {"--checkpoint", o->checkpoint, true, CHECKPOINTS},
                                    {"--resume", o->resume, false, CHECKPOINTS},
                                    {"--front", o->front, true, NONE},
                                    {"--page", o->page, true, NONE},
                                    {"--log", o->log, true, NONE},
                                    {"--seeds", o->seeds, false, NONE}};
    return scene_files_apart("footpoint-evolve", o->root, scene, file, sizeof file / sizeof *file, d) &&
           outfile_probe(f->output, d) && outfile_probe(o->checkpoint, d) && outfile_probe(o->front, d) &&
           outfile_probe(o->page, d);
}
