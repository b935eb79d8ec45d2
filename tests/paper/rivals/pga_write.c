/* Writes genome text of polynomials; see pga_write.h. */
#include "pga_write.h"

#include "../../../codegen/base/outfile.h"
#include "../../../evolve/eval/errors.h"
#include "../../../evolve/eval/frame.h"
#include "../../../evolve/region/sampled_region.h"

#include <math.h>
#include <stdlib.h>

static const char *const coefficients_name[] = {"squares", "mean", "worst"};

bool pga_find_new(const struct polynomials *p, const struct pga_state *s, struct objective *objective, size_t target,
                  enum coefficients coefficients, struct pga_find *f)
{
    size_t *at = new_array(p->count, sizeof *at);
    double *coefficient = new_array(p->count, sizeof *coefficient);
    *f = (struct pga_find){.terms = polynomials_terms(p, s->best, at),
                           .condition = polynomials_condition(p, s->best),
                           .evaluations = s->evaluations,
                           .singular = s->singular};
    const bool good = polynomials_fit(p, s->best, coefficient) >= 0;
    if (good) {
        struct monomial *term = new_array(f->terms, sizeof *term);
        f->genes.gene = new_array(monomials_room(f->terms), sizeof *f->genes.gene);
        for (size_t i = 0; i < f->terms; i++)
            term[i] = p->term[at[i]];
        if (coefficients != COEFFICIENTS_SQUARES)
            polynomials_fit_norm(p, s->best, objective->norm, coefficient);
        monomials_tree(term, coefficient, f->terms, &f->genes);
        f->error = objective_tree_error(objective, &f->genes, target, INFINITY);
        free(term);
    }
    free(coefficient);
    free(at);
    return good;
}

void pga_find_free(struct pga_find *f)
{
    free(f->genes.gene);
}

#define NOTE(...) genome_add_note(&g->note, &g->notes, &g->note_room, __VA_ARGS__)

static void add_output(const struct pga_options *o, struct genome_file *program, struct genome *g, int k,
                       const struct pga_find *f, const struct sample_set heldout[2])
{
    static const char *const part_name[2] = {"heldout", "heldout_random"};
    struct genes bound = {new_array(f->genes.length, sizeof *bound.gene), 0};
    char key[40];
    genes_bind(program, &f->genes, &bound);
    snprintf(key, sizeof key, "found_%s", frame_output[k]);
    NOTE(key, "p-GA seed %llu generations %zu population %zu evaluations %zu%s", (unsigned long long)o->plan.seed,
         o->generations, o->plan.population, f->evaluations, o->plan.exchange ? " exchange" : "");
    snprintf(key, sizeof key, "terms_%s", frame_output[k]);
    NOTE(key, "%zu condition %.1e singular %zu", f->terms, f->condition, f->singular);
    snprintf(key, sizeof key, "training_%s", frame_output[k]);
    NOTE(key, "genes %zu coefficients %s %.4e", f->genes.length, coefficients_name[o->coefficients], f->error);
    for (int part = 0; part < 2; part++) {
        struct errors e;
        struct measurement m = measurement_open(program, &bound, &k, 1, heldout[part].n);
        measurement_take(&m, heldout[part].s, heldout[part].n);
        measurement_close(&m, &e);
        snprintf(key, sizeof key, "%s_%s", part_name[part], frame_output[k]);
        NOTE(key, "n %zu mean %.4e p99 %.3e max %.3e", e.n, e.mean, e.p99, e.max);
    }
    genome_add_expr(&g->out, &g->outs, &g->out_room, frame_output[k], bound.gene, bound.length);
    free(bound.gene);
}

bool pga_write(const struct pga_options *o, const struct scene *scene, struct genome_file *program,
               struct pga_find (*find)[2], const struct sample_set heldout[2], struct diag *d)
{
    struct outfile f;
    if (!outfile_open(&f, o->output, d))
        return false;
    genome_add_note(&program->note, &program->notes, &program->note_room, "footpoint", "%s", FOOTPOINT_VERSION);
    genome_add_note(&program->note, &program->notes, &program->note_room, "scene", "%s", scene->name);
    genome_add_note(&program->note, &program->notes, &program->note_room, "scene_sha256", "%s", scene->sha256);
    for (size_t i = 0; i < o->limits; i++) {
        char name[100];
        if (o->limits > 1)
            snprintf(name, sizeof name, "%s_%zu", o->name, o->limit[i]);
        else
            snprintf(name, sizeof name, "%s", o->name);
        struct genome *g = genome_add(program, name);
        for (int k = 0; k < 2; k++)
            add_output(o, program, g, k, &find[i][k], heldout);
    }
    struct region_survey *region = region_survey_new(program);
    for (int k = 0; k < 2; k++)
        region_survey_take(region, heldout[k].s, heldout[k].n);
    region_survey_add(region);
    genome_print_needed(program, f.stream);
    return outfile_commit(&f, d);
}
