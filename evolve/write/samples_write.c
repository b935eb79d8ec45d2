/* Samples of a scene to a file, for whoever measures code on them; see archive_write.h. */
#include "archive_write.h"

#include "../input/scene_files.h"
#include "measure.h"

#include <string.h>

static void print_head(const struct segment_kind *kind, FILE *out)
{
    fputs("part", out);
    for (size_t i = 0; i < segment_inputs(kind); i++) {
        char name[5];
        segment_input_name(kind, i, name);
        fprintf(out, ",%s", name);
    }
    fputs(",xi,eta\n", out);
}

/* Where samples go. */
struct target {
    const struct segment_kind *kind; /* not owned, as is: */
    FILE *out;
    char part[40];
};

static void print_sample(void *to, const struct sample *s)
{
    const struct target *t = to;
    fputs(t->part, t->out);
    for (size_t k = 0; k <= segment_vectors(t->kind); k++) {
        const double *x = k < segment_vectors(t->kind) ? s->x[k] : s->xs;
        fprintf(t->out, ",%a,%a,%a", x[0], x[1], x[2]);
    }
    fprintf(t->out, ",%a,%a\n", s->xi, s->eta);
}

/* @param[in] f  genomes from whose worst samples to climb, or NULL */
static bool write_part(const struct scene *scene, enum sample_part part, const char *name, const struct genome_file *f,
                       FILE *out, struct diag *d)
{
    struct sampler *p = sampler_new(scene, part, d);
    struct target to = {scene->segment, out, ""};
    bool drawn = p != NULL;
    snprintf(to.part, sizeof to.part, "%s", name);
    for (size_t i = 0; drawn && i < p->count; i++) {
        struct sample s;
        drawn = sampler_take(p, i, &s, d);
        if (drawn)
            print_sample(&to, &s);
    }
    snprintf(to.part, sizeof to.part, "%s_climbing", name);
    if (drawn && f && climb_can(p))
        drawn = measure_climbed(f, p, strcmp(scene->precision, "float") == 0, print_sample, &to, d);
    sampler_free(p);
    return drawn;
}

bool samples_write(const char *root, const char *scene_name, size_t run, const char *genomes, const char *path,
                   struct diag *d)
{
    struct scene *scene = scene_read(root, scene_name, d);
    struct genome_file *climbed = scene && genomes ? genome_read(genomes, d) : NULL;
    struct outfile f;
    const struct file_use output = {"--samples", path, true, 0};
    bool good = scene && (!genomes || climbed) && scene_files_apart("footpoint-evolve", root, scene, &output, 1, d) &&
                outfile_open(&f, path, d);
    if (good) {
        scene->run = run;
        print_head(scene->segment, f.stream);
        for (int k = 0; k < HELDOUT_PARTS && good; k++)
            good = !scene_has(scene, heldout_part[k].part) ||
                   write_part(scene, heldout_part[k].part, heldout_part[k].name, climbed, f.stream, d);
        if (good)
            good = outfile_commit(&f, d);
        else
            outfile_discard(&f);
    }
    genome_file_free(climbed);
    scene_free(scene);
    return good;
}
