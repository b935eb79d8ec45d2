/* Writes files of an archive; see archive_write.h.  Notes of measurements are measured again on every writing, and provenance is
 * carried over with its expression, so that a run that finds nothing better writes the same bytes again. */
#include "archive_write.h"

#include "../../codegen/base/outfile.h"
#include "../common/decimal.h"
#include "../eval/frame.h"
#include "../genotype/lines_text.h"
#include "measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const norm_name[] = {[NORM_MEAN] = "mean", [NORM_P99] = "p99", [NORM_MAX] = "max"};

/* Notes the shapes: "aspect <= 5, ...". */
static void note_shapes(struct genome_file *f, const struct scene *s)
{
    const double degree = acos(-1) / 180;
    const struct shapes *p = &s->shapes;
    char warps[60] = "", curves[60] = "";
    if (*s->segment->normals) {
        genome_add_note(&f->note, &f->notes, &f->note_room, "range",
                        "segments of smooth bodies, with the normals of their meshes, |gap| <= %g of the shortest edge",
                        p->gap);
        return;
    }
    if (!s->segment->triangle)
        snprintf(warps, sizeof warps, ", taper <= %g, warp <= %g deg", p->taper, p->warp / degree);
    if (strlen(s->segment->nodes) > s->segment->corners)
        snprintf(curves, sizeof curves, ", curve <= %g, shift <= %g", p->curve, p->shift);
    genome_add_note(&f->note, &f->notes, &f->note_room, "range",
                    "aspect <= %g, skew <= %g deg%s%s, |gap| <= %g of the shortest edge", p->aspect, p->skew / degree,
                    warps, curves, p->gap);
}

/* Notes the range for which the error tables hold. */
static void note_range(struct genome_file *f, const struct scene *s)
{
    const char *slash = s->source == SOURCE_MESH ? strrchr(s->mesh.file, '/') : NULL;
    double lo[2], hi[2];
    scene_box(s, lo, hi);
#define NOTE(...) genome_add_note(&f->note, &f->notes, &f->note_room, "range", __VA_ARGS__)
    if (s->source == SOURCE_RANDOM)
        note_shapes(f, s);
    else if (s->source == SOURCE_MESH)
        NOTE("contact pairs of %s within %g mesh lengths", slash ? slash + 1 : s->mesh.file, s->mesh.distance);
    else
        NOTE("A = (0,0,0), B = (1,0,0); |x|, |y| <= %g, |z| <= %g", s->lattice.xy.most, s->lattice.z.most);
    if (s->source == SOURCE_LATTICE && *s->segment->normals)
        NOTE("tangent of the angle between a normal and the facet's own <= %g", s->lattice.tilt);
    if (s->segment->triangle)
        NOTE("xi > %g, eta > %g, xi + eta <= %g", lo[0], lo[1], hi[0]);
    else
        NOTE("%g < xi <= %g, %g < eta <= %g", lo[0], hi[0], lo[1], hi[1]);
#undef NOTE
}

static void add_file_notes(struct genome_file *f, const struct scene *s, const struct heldout *heldout)
{
    char frames[512] = "", reference[2][32];
    for (size_t i = 0; i < s->tiers; i++) {
        bool seen = false;
        for (size_t j = 0; j < i; j++)
            seen = seen || strcmp(s->tier[j].frame, s->tier[i].frame) == 0;
        const size_t used = strlen(frames);
        if (!seen)
            snprintf(frames + used, sizeof frames - used, "%s%s", used ? " " : "", s->tier[i].frame);
    }
    for (int k = 0; k < 2; k++)
        number_shortest(s->reference[k], reference[k]);
#define NOTE(...) genome_add_note(&f->note, &f->notes, &f->note_room, __VA_ARGS__)
    NOTE("footpoint", "%s", FOOTPOINT_VERSION);
    NOTE("scene", "%s", s->name);
    NOTE("scene_sha256", "%s", s->sha256);
    if (strcmp(s->precision, "double") != 0)
        NOTE("precision", "%s", s->precision);
    note_range(f, s);
    for (size_t i = 0; i < heldout->lines; i++)
        NOTE("drawn", "%s", heldout->drawn[i]);
    NOTE("frames", "%s", frames);
    NOTE("reference", "xi %s eta %s", reference[0], reference[1]);
#undef NOTE
}

/* Notes of this program are "<kind>_xi" and "<kind>_eta"; all others are remarks. */
static const char *const measured[] = {"found",          "exact",        "training", "heldout",
                                       "heldout_random", "heldout_even", "gaps"};

static void note_key(const char *what, int output, char key[40])
{
    snprintf(key, 40, "%s_%s", what, frame_output[output]);
}

static bool is_remark(const char *key)
{
    char own[40];
    for (size_t i = 0; i < sizeof measured / sizeof *measured; i++)
        for (int k = 0; k < TIER_OUTPUTS; k++) {
            note_key(measured[i], k, own);
            if (strcmp(key, own) == 0)
                return false;
        }
    return true;
}

#define NOTE(...) genome_add_note(&g->note, &g->notes, &g->note_room, __VA_ARGS__)

/* Adds provenance: carried over with an expression of the start file, new for an expression that this run found.  Remarks are about
 * the whole genome and stay as long as it stays. */
static void add_provenance(struct genome *g, const struct quest *quest, size_t n, const struct genome *before,
                           const struct run_facts *run)
{
    const bool bred = quest[0].champion.bred || quest[n - 1].champion.bred;
    for (size_t i = 0; before && !bred && i < before->notes; i++)
        if (is_remark(before->note[i].key))
            NOTE(before->note[i].key, "%s", before->note[i].text);
    for (const struct quest *q = quest; q < quest + n; q++) {
        const struct champion *c = &q->champion;
        char key[40];
        note_key("found", q->output, key);
        const char *old = before ? genome_find_note(before->note, before->notes, key) : NULL;
        if (c->exact) {
            note_key("exact", q->output, key);
            NOTE(key, "nothing evolved, the frame's value is right to rounding");
        } else if (c->bred && c->chosen)
            NOTE(key, "nothing to evolve, chosen among the frame's values");
        else if (c->bred && c->seed && quest_of_programs(q))
            NOTE(key, "a seed, composed of the frame's functions or given");
        else if (c->bred)
            NOTE(key, "seed %llu generations %zu islands %zu", (unsigned long long)run->seed, run->generations,
                 run->islands);
        else if (old)
            NOTE(key, "%s", old);
    }
}

/* Writes lets and outputs of a tier's program and reads its text again.  Returns its number of genes. */
static size_t expand(const struct archive *a, const struct genes *t, const struct quest *q, struct genome_file *f,
                     const char *name, struct genes out[2])
{
    const struct tier *own = q->own;
    const struct gene_set genes = {.symbol = archive_symbols(a, q->tier), .symbols = own->terminals};
    struct genes again = {new_array(tier_genes(own), sizeof *again.gene), 0};
    const bool good = lines_respell(a->lines, t, &genes, tier_genes(own), &again);
    const struct genes *written = good ? &again : t;
    const size_t length = written->length;
    lines_expand(a->lines, written, q->last, f, name, out);
    free(again.gene);
    free(genes.symbol);
    return length;
}

/* Notes means of xi and eta in the bands of |gap|: "to 1e-3 1.0e-09 1.1e-09, to 1e-2 ..." of the shortest edge. */
static void add_bands(struct genome *g, const struct errors *e)
{
    char text[200] = "", key[40];
    for (int b = 0; b < GAP_BANDS; b++) {
        const size_t used = strlen(text);
        if (e[0].band[b] >= 0)
            snprintf(text + used, sizeof text - used, "%s%s %.1e %.1e", used ? ", " : "", gap_band_name[b],
                     e[0].band[b], e[1].band[b]);
    }
    note_key("gaps", TIER_BOTH, key);
    NOTE(key, "mean at |gap| over shortest edge %s", text);
}

/* Notes errors: the champions' on training samples; held-out errors are measured on the written program. */
static void add_errors(struct genome *g, const struct archive *a, const struct measured *m, size_t at)
{
    char key[40];
    for (int part = 0; part < HELDOUT_PARTS; part++)
        if (m->found[part]) {
            const struct errors *e = &m->found[part][at];
            char climbed[60] = "";
            if (e[0].climbed > 0 || e[1].climbed > 0)
                snprintf(climbed, sizeof climbed, " climbing %.3e %.3e", e[0].climbed, e[1].climbed);
            note_key(heldout_part[part].name, TIER_BOTH, key);
            NOTE(key, "n %zu mean %.3e %.3e p99 %.3e %.3e max %.3e %.3e%s", e[0].n, e[0].mean, e[1].mean, e[0].p99,
                 e[1].p99, e[0].max, e[1].max, climbed);
        }
    if (a->scene->source == SOURCE_MESH && m->found[0])
        add_bands(g, &m->found[0][at]);
}

/* Adds the genome of a tier, with all facts known before it is measured. */
static void add_tier(struct archive *a, size_t tier, const struct run_facts *run)
{
    const struct tier *t = &a->scene->tier[tier];
    size_t n;
    const struct quest *quest = archive_quests(a, tier, &n);
    struct genes out[2] = {quest[0].champion.genes, quest[n - 1].champion.genes};
    const size_t written = t->program ? expand(a, &quest->champion.genes, quest, a->program, t->name, out) : 0;
    struct genome *g = genome_add(a->program, t->name);
    add_provenance(g, quest, n, archive_start_genome(a, tier), run);
    for (const struct quest *q = quest; q < quest + n; q++) {
        char key[40];
        note_key("training", q->output, key);
        NOTE(key, "genes %zu %s %.3e", written ? written : q->champion.genes.length, norm_name[a->scene->norm],
             q->champion.error);
    }
    for (size_t k = 0; k < 2; k++) {
        genome_add_expr(&g->out, &g->outs, &g->out_room, frame_output[k], out[k].gene, out[k].length);
        if (t->program)
            free(out[k].gene);
    }
}

bool archive_write(struct archive *a, const char *path, const struct run_facts *run, const struct heldout *heldout,
                   size_t most, struct diag *d)
{
    struct outfile f;
    struct measured m;
    if (!outfile_open(&f, path, d))
        return false;
    add_file_notes(a->program, a->scene, heldout);
    for (size_t i = 0; i < a->scene->tiers; i++)
        if (archive_has(a, i))
            add_tier(a, i, run);
    const bool good = measure_genomes(a->program, 2, heldout, most, &m, d);
    for (size_t g = 0; g < a->program->genomes && good; g++)
        add_errors(&a->program->genome[g], a, &m, 2 * g);
    arena_free(&m.memory);
    if (!good) {
        outfile_discard(&f);
        return false;
    }
    genome_print_needed(a->program, f.stream);
    return outfile_commit(&f, d);
}

/* Adds the genome of a member, with its cost, origin and errors.  Programs, of which a front contains hundreds with lets of their own,
 * have only errors on the training samples. */
static void add_member(const struct archive *a, const struct member *m, const struct quest *q, struct genome_file *f)
{
    char name[300];
    struct genes out[2] = {{NULL, 0}, {NULL, 0}};
    size_t genes = m->genes.length;
    const bool both = quest_of_programs(q);
    const int first = both ? 0 : q->output, last = both ? 1 : q->output;
    snprintf(name, sizeof name, "%.250s_%s_c%.0f", q->own->name, frame_output[q->output], m->cost);
    if (both) {
        genes = expand(a, &m->genes, q, f, name, out);
    } else {
        out[q->output].gene = new_array(m->genes.length, sizeof *out[q->output].gene);
        genes_bind(f, &m->genes, &out[q->output]);
    }
    struct genome *g = genome_add(f, name);
    NOTE("cost", "%g", m->cost);
    NOTE("origin", "%s", origin_name[m->origin]);
    NOTE("training", "genes %zu %s %.3e", genes, norm_name[a->scene->norm], m->error);
    for (int k = first; k <= last; k++) {
        genome_add_expr(&g->out, &g->outs, &g->out_room, frame_output[k], out[k].gene, out[k].length);
        free(out[k].gene);
    }
}

/* Adds all members of a front; if the number of members is given, only programs that may become tiers. */
static void add_front(const struct archive *a, const struct quest *q, struct objective *judge, size_t most,
                      struct genome_file *f)
{
    const struct front *front = q->front;
    if (quest_of_programs(q) && most > 0 && judge) {
        const struct member **chosen = new_array(front->limit + 1, sizeof(struct member *));
        const size_t n = archive_members(a, judge, q, most, chosen);
        for (size_t i = 0; i < n; i++)
            add_member(a, chosen[i], q, f);
        free(chosen);
        return;
    }
    for (size_t c = 0; c <= front->limit; c++)
        if (front->member[c].genes.length > 0)
            add_member(a, &front->member[c], q, f);
}

/* Adds errors of the members of a single output. */
static void add_member_errors(struct genome_file *f, const struct measured *m)
{
    for (size_t i = 0, at = 0; i < f->genomes; i++) {
        struct genome *g = &f->genome[i];
        for (int part = 0; part < 2 && g->outs == 1; part++)
            if (m->found[part]) {
                const struct errors *e = &m->found[part][at];
                NOTE(heldout_part[part].name, "n %zu mean %.3e p99 %.3e max %.3e", e->n, e->mean, e->p99, e->max);
            }
        at += g->outs == 1;
    }
}

#undef NOTE

bool archive_write_front(const struct archive *a, const char *path, const struct heldout *heldout, size_t samples,
                         struct objective *judge, size_t most, struct diag *d)
{
    struct outfile out;
    struct measured m = {.n = 0};
    if (archive_is_list(path))
        return archive_write_csv(a, path, heldout, samples, d);
    struct genome_file *f = genome_parse(path, a->bare, strlen(a->bare), d);
    bool programs = false, good = true;
    for (size_t i = 0; i < a->scene->tiers; i++)
        programs = programs || a->scene->tier[i].program;
    if (!f || !outfile_open(&out, path, d)) {
        genome_file_free(f);
        return false;
    }
    add_file_notes(f, a->scene, heldout);
    for (const struct quest *q = a->quest; q < a->quest + a->quests; q++)
        add_front(a, q, judge, most, f);
    if (!programs || most > 0)
        good = measure_genomes(f, 1, heldout, samples, &m, d);
    if (good)
        add_member_errors(f, &m);
    arena_free(&m.memory);
    if (good)
        genome_print_needed(f, out.stream);
    else
        outfile_discard(&out);
    genome_file_free(f);
    return good && outfile_commit(&out, d);
}
