/* Champions and their file; see archive.h.  Measured notes are measured anew on every writing, and provenance is
 * carried over with the expression it belongs to, so that a run that finds nothing better writes the same bytes again.
 */
#include "archive.h"

#include "frame.h"
#include "scene_region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GRID = 100 }; /* constants -GRID..GRID times 0.05 */

static const char *const norm_name[] = {[NORM_MEAN] = "mean", [NORM_P99] = "p99", [NORM_MAX] = "max"};

static const struct genome *find_genome(const struct genome_file *f, const char *name)
{
    for (size_t i = 0; f && i < f->genomes; i++)
        if (strcmp(f->genome[i].name, name) == 0)
            return &f->genome[i];
    return NULL;
}

static void crown(struct champion *c, const struct tree *t, double error)
{
    free(c->tree.gene);
    c->tree.gene = new_array(t->length, sizeof *t->gene);
    tree_copy(t, &c->tree);
    c->error = error;
}

static bool read_champion(struct archive *a, size_t tier, int output, struct diag *d)
{
    const struct genome *g = find_genome(a->start, a->scene->tier[tier].name);
    for (size_t i = 0; g && i < g->outs; i++) {
        const struct genome_expr *e = &g->out[i];
        if (strcmp(e->name, frame_output[output]) != 0)
            continue;
        struct champion *c = &a->champion[tier][output];
        c->tree = (struct tree){new_array(e->length, sizeof *e->gene), e->length};
        c->length_before = e->length;
        return frame_rebind(a->start, e, a->program, c->tree.gene, d);
    }
    return true;
}

struct archive *archive_new(const struct scene *s, struct genome_file *program, const char *start, struct diag *d)
{
    struct archive *a = new_array(1, sizeof *a);
    *a = (struct archive){.scene = s, .program = program, .champion = new_array(s->tiers, sizeof *a->champion)};
    a->start = start ? genome_read(start, d) : NULL;
    bool good = a->start || !start;
    for (size_t i = 0; good && i < s->tiers; i++)
        for (int k = 0; good && k < 2; k++)
            good = read_champion(a, i, k, d);
    if (good)
        return a;
    archive_free(a);
    return NULL;
}

void archive_free(struct archive *a)
{
    if (!a)
        return;
    for (size_t i = 0; i < a->scene->tiers; i++)
        for (int k = 0; k < 2; k++)
            free(a->champion[i][k].tree.gene);
    free(a->champion);
    genome_file_free(a->start);
    genome_file_free(a->program);
    free(a);
}

void archive_judge(struct archive *a, struct judge *j)
{
    for (size_t i = 0; i < a->scene->tiers; i++)
        for (int k = 0; k < 2; k++) {
            struct champion *c = &a->champion[i][k];
            if (c->tree.length > 0)
                c->error = judge_error(j, &c->tree, frame_target(a->program, k), INFINITY);
            c->error_before = c->error;
        }
}

/* Insert by value; each value once. */
static void add_constant(const struct genome_file *program, struct gene_set *s, int gene)
{
    const double value = program->constant[-1 - gene].value;
    size_t at = s->constants;
    while (at > 0 && program->constant[-1 - s->constant[at - 1]].value > value)
        at--;
    if (at > 0 && program->constant[-1 - s->constant[at - 1]].value == value)
        return;
    memmove(s->constant + at + 1, s->constant + at, (s->constants - at) * sizeof *s->constant);
    s->constant[at] = gene;
    s->constants++;
}

struct gene_set archive_genes(struct archive *a, size_t tier, bool rational)
{
    static const int operation[] = {GENE_ADD, GENE_SUB, GENE_MUL, GENE_PDIV};
    const struct tier *t = &a->scene->tier[tier];
    const struct champion *c = a->champion[tier];
    struct gene_set s = {.symbols = t->terminals, .operations = rational ? 4 : 3};
    s.operation = new_array(s.operations, sizeof *s.operation);
    memcpy(s.operation, operation, s.operations * sizeof *operation);
    s.symbol = new_array(t->terminals, sizeof *s.symbol);
    for (size_t i = 0; i < t->terminals; i++)
        s.symbol[i] = GENE_SYMBOL + (int)genome_find_symbol(a->program, t->terminal[i]);
    s.constant = new_array(2 * GRID + 1 + c[0].tree.length + c[1].tree.length, sizeof *s.constant);
    for (int k = -GRID; k <= GRID; k++) {
        char text[32];
        frame_number(k * 5 / 100.0, text);
        add_constant(a->program, &s, -1 - (int)genome_add_constant(a->program, text));
    }
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < c[k].tree.length; i++)
            if (c[k].tree.gene[i] < 0)
                add_constant(a->program, &s, c[k].tree.gene[i]);
    return s;
}

const struct tree *archive_seed(const struct archive *a, size_t tier, int output, size_t max_length)
{
    const struct tier *t = &a->scene->tier[tier];
    const struct tree *tree = &a->champion[tier][output].tree;
    if (tree->length == 0 || tree->length > max_length)
        return NULL;
    for (size_t i = 0; i < tree->length; i++) {
        bool known = tree->gene[i] < GENE_SYMBOL;
        for (size_t k = 0; !known && k < t->terminals; k++)
            known = genome_find_symbol(a->program, t->terminal[k]) == tree->gene[i] - GENE_SYMBOL;
        if (!known)
            return NULL;
    }
    return tree;
}

void archive_offer(struct archive *a, const struct plan *plan, size_t tier, int output, const struct tree *t,
                   double error)
{
    struct champion *c = &a->champion[tier][output];
    const double demerit = plan_demerit(plan, error, t->length);
    if (c->tree.length > 0 && (error > c->error || !(demerit < plan_demerit(plan, c->error, c->tree.length))))
        return;
    crown(c, t, error);
    c->bred = true;
}

/* What the error tables hold for. */
static void note_range(struct genome_file *f, const struct scene *s)
{
    const double degree = acos(-1) / 180;
    const struct shapes *p = &s->shapes;
    const char *slash = s->source == SOURCE_MESH ? strrchr(s->mesh.file, '/') : NULL;
    double lo[2], hi[2];
    scene_box(s, lo, hi);
#define NOTE(...) genome_add_note(&f->note, &f->notes, &f->note_room, "range", __VA_ARGS__)
    if (s->source == SOURCE_RANDOM)
        NOTE("aspect <= %g, skew <= %g deg, taper <= %g, warp <= %g deg, |gap| <= %g of the shortest edge", p->aspect,
             p->skew / degree, p->taper, p->warp / degree, p->gap);
    else if (s->source == SOURCE_MESH)
        NOTE("contact pairs of %s within %g mesh lengths", slash ? slash + 1 : s->mesh.file, s->mesh.distance);
    else
        NOTE("A = (0,0,0), B = (1,0,0); |x|, |y| <= %g, |z| <= %g", s->lattice.xy_max, s->lattice.z_max);
    NOTE("%g < xi <= %g, %g < eta <= %g", lo[0], hi[0], lo[1], hi[1]);
#undef NOTE
}

static void add_file_notes(struct genome_file *f, const struct scene *s)
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
        frame_number(s->reference[k], reference[k]);
#define NOTE(...) genome_add_note(&f->note, &f->notes, &f->note_room, __VA_ARGS__)
    NOTE("footpoint", "%s", FOOTPOINT_VERSION);
    NOTE("scene", "%s", s->name);
    NOTE("scene_sha256", "%s", s->sha256);
    note_range(f, s);
    NOTE("frames", "%s", frames);
    NOTE("reference", "xi %s eta %s", reference[0], reference[1]);
#undef NOTE
}

/* Notes that this program writes are "<what>_xi" and "<what>_eta"; others are somebody's remarks. */
static const char *const measured[] = {"found", "training", "heldout", "heldout_random"};

static void note_key(const char *what, int output, char key[40])
{
    snprintf(key, 40, "%s_%s", what, frame_output[output]);
}

static bool is_remark(const char *key)
{
    char own[40];
    for (size_t i = 0; i < sizeof measured / sizeof *measured; i++)
        for (int k = 0; k < 2; k++) {
            note_key(measured[i], k, own);
            if (strcmp(key, own) == 0)
                return false;
        }
    return true;
}

#define NOTE(...) genome_add_note(&g->note, &g->notes, &g->note_room, __VA_ARGS__)

/* Provenance: carried over with an expression of the start file, new for one that this run found.  Remarks are about
 * the whole genome and stay as long as it stays. */
static void add_provenance(struct genome *g, const struct champion champion[2], const struct genome *before,
                           const struct run_facts *run)
{
    for (size_t i = 0; before && !champion[0].bred && !champion[1].bred && i < before->notes; i++)
        if (is_remark(before->note[i].key))
            NOTE(before->note[i].key, "%s", before->note[i].text);
    for (int k = 0; k < 2; k++) {
        char key[40];
        note_key("found", k, key);
        const char *old = before ? genome_find_note(before->note, before->notes, key) : NULL;
        if (champion[k].bred)
            NOTE(key, "seed %llu generations %zu islands %zu", (unsigned long long)run->seed, run->generations,
                 run->islands);
        else if (old)
            NOTE(key, "%s", old);
    }
}

static void add_errors(struct genome *g, struct kernel *kernel, const struct archive *a,
                       const struct champion champion[2], const struct sample_set heldout[2])
{
    char key[40];
    for (int k = 0; k < 2; k++) {
        note_key("training", k, key);
        NOTE(key, "genes %zu %s %.3e", champion[k].tree.length, norm_name[a->scene->norm], champion[k].error);
    }
    for (int part = 0; part < 2; part++)
        for (int k = 0; k < 2; k++) {
            const struct errors e = errors_measure(kernel, a->program, &champion[k].tree, k, &heldout[part]);
            note_key(part ? "heldout_random" : "heldout", k, key);
            NOTE(key, "n %zu mean %.3e p99 %.3e max %.3e", e.n, e.mean, e.p99, e.max);
        }
}

static void add_tier(struct archive *a, struct kernel *kernel, size_t tier, const struct run_facts *run,
                     const struct sample_set heldout[2])
{
    const struct champion *c = a->champion[tier];
    const char *name = a->scene->tier[tier].name;
    struct genome *g = genome_add(a->program, name);
    add_provenance(g, c, find_genome(a->start, name), run);
    add_errors(g, kernel, a, c, heldout);
    for (int k = 0; k < 2; k++)
        genome_add_expr(&g->out, &g->outs, &g->out_room, frame_output[k], c[k].tree.gene, c[k].tree.length);
}

#undef NOTE

bool archive_write(struct archive *a, const char *path, const struct run_facts *run, const struct sample_set heldout[2],
                   struct diag *d)
{
    struct outfile f;
    if (!outfile_open(&f, path, d))
        return false;
    struct kernel *kernel = kernel_new_widest();
    add_file_notes(a->program, a->scene);
    for (size_t i = 0; i < a->scene->tiers; i++)
        add_tier(a, kernel, i, run, heldout);
    kernel_free(kernel);
    scene_region_add(a->program, heldout, 2);
    genome_print(a->program, f.stream);
    return outfile_commit(&f, d);
}

void archive_table(const struct archive *a, FILE *stream)
{
    fprintf(stream, "%-24s %-6s %10s    %-10s %6s    %-6s\n", "tier", "output", "error", "", "genes", "");
    for (size_t i = 0; i < a->scene->tiers; i++)
        for (int k = 0; k < 2; k++) {
            const struct champion *c = &a->champion[i][k];
            char error[16] = "-", length[16] = "-";
            if (c->length_before > 0) {
                snprintf(error, sizeof error, "%.3e", c->error_before);
                snprintf(length, sizeof length, "%zu", c->length_before);
            }
            fprintf(stream, "%-24s %-6s %10s -> %-10.3e %6s -> %-6zu%s\n", a->scene->tier[i].name, frame_output[k],
                    error, c->error, length, c->tree.length, c->bred ? "" : "unchanged");
        }
}
