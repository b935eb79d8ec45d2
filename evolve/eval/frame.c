/* Frames; see frame.h. A program is assembled from their statements. Lets are evaluated column by column, like
 * programs. */
#include "frame.h"

#include "../../codegen/base/text.h"
#include "../common/decimal.h"
#include "lines_run.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { NAME = 300 };

const char *const frame_output[TIER_OUTPUTS] = {"xi", "eta", "both"};

/* Lets whose values come from the scene: the reference point and the box of its contact points. */
enum { FROM_SCENE = 6 };
static const char *const scene_let[FROM_SCENE] = {"xi0", "eta0", "xi_lo", "xi_hi", "eta_lo", "eta_hi"};

static void scene_values(const struct scene *s, const struct tier *t, double value[FROM_SCENE])
{
    double lo[2], hi[2];
    scene_box(s, lo, hi);
    for (int k = 0; k < 2; k++) {
        value[k] = t->at ? t->reference[k] : s->reference[k];
        value[2 + 2 * k] = lo[k];
        value[3 + 2 * k] = hi[k];
    }
}

bool frame_rebind(const struct genome_file *from, const struct genome_expr *e, struct genome_file *to, int *gene,
                  struct diag *d)
{
    for (size_t i = 0; i < e->length; i++) {
        gene[i] = e->gene[i];
        if (gene[i] < 0) {
            gene[i] = -1 - (int)genome_add_constant(to, from->constant[-1 - gene[i]].text);
        } else if (gene[i] >= GENE_SYMBOL) {
            const char *name = genome_symbol_name(from, (size_t)(gene[i] - GENE_SYMBOL));
            const long k = genome_find_symbol(to, name);
            if (k < 0)
                return diag_at(d, from->path, e->line, 0, "'%s' uses '%s', which no frame of the scene defines",
                               e->name, name);
            gene[i] = GENE_SYMBOL + (int)k;
        }
    }
    return true;
}

/* Returns a statement of the frame with the scene's values, and with separate names if the tier has its own reference
 * point. The caller frees it. */
static char *statement_of_tier(const struct genome_file *frame, size_t k, const struct scene *s, const struct tier *t)
{
    char suffix[16], number[32];
    double value[FROM_SCENE];
    const char *name = frame->statement[k].name;
    tier_suffix(t, suffix);
    scene_values(s, t, value);
    for (int i = 0; i < FROM_SCENE; i++)
        if (strcmp(name, scene_let[i]) == 0) {
            number_shortest(value[i], number);
            return new_format("let %s%s = %s", name, suffix, number);
        }
    return genome_statement_suffixed(frame, k, suffix);
}

/* Returns true if the text may join the line of the program's last statement, which must be of the same type. */
static bool may_join(const struct genome_file *program, const char *text)
{
    const char *last = program->statements > 0 ? program->statement[program->statements - 1].text : "";
    return strncmp(last, text, strcspn(text, " ") + 1) == 0;
}

/* Adds a statement to the program, unless another frame of the scene has the same statement. */
static bool add_statement(const struct genome_file *frame, size_t k, const struct scene *s, const struct tier *t,
                          struct genome_file *program, struct diag *d)
{
    char name[NAME], suffix[16], *text = statement_of_tier(frame, k, s, t);
    tier_suffix(t, suffix);
    snprintf(name, sizeof name, "%s%s", frame->statement[k].name, suffix);
    const struct genome_statement *known = genome_find_statement(program, name);
    const bool joined = frame->statement[k].joined && may_join(program, text);
    const bool good =
        known ? strcmp(known->text, text) == 0 || diag_at(d, frame->path, frame->statement[k].line, 0,
                                                          "'%s' has another value in another frame of the scene", name)
              : genome_read_statement(program, text, d);
    if (good && !known)
        program->statement[program->statements - 1].joined = joined;
    free(text);
    return good;
}

/* Returns the program's index of a frame value, which may have another name in the tier. */
static size_t same_symbol(const struct genome_file *frame, size_t symbol, const struct tier *t,
                          const struct genome_file *program)
{
    char name[NAME], suffix[16];
    tier_suffix(t, suffix);
    snprintf(name, sizeof name, "%s%s", genome_symbol_name(frame, symbol), symbol < frame->inputs ? "" : suffix);
    return (size_t)genome_find_symbol(program, name);
}

/* Adds an exchange of inputs, which must agree between frames. */
static bool add_exchange(const struct genome_file *frame, const size_t pair[2], const struct tier *t,
                         struct genome_file *program, struct diag *d)
{
    const size_t a = same_symbol(frame, pair[0], t, program), b = same_symbol(frame, pair[1], t, program);
    for (size_t i = 0; i < program->exchanges; i++) {
        const size_t *other = program->exchange[i];
        if ((other[0] == a && other[1] == b) || (other[0] == b && other[1] == a))
            return true;
        if (other[0] == a || other[1] == a || other[0] == b || other[1] == b)
            return diag_at(d, frame->path, 0, 0,
                           "'%s' or '%s' is exchanged differently in another frame of the "
                           "scene",
                           genome_symbol_name(frame, pair[0]), genome_symbol_name(frame, pair[1]));
    }
    genome_add_exchange(program, a, b);
    return true;
}

static bool has_function(const struct genome_file *frame, const struct tier *t, const char *name)
{
    char suffix[16], *own = new_text(name, strlen(name));
    tier_suffix(t, suffix);
    own[strlen(name) - strlen(suffix)] = '\0';
    const bool found = line_function(frame, own) >= 0;
    free(own);
    return found;
}

/* Checks that names in a tier's list are operators or functions. */
static bool check_functions(const struct genome_file *frame, const struct scene *s, const struct tier *t,
                            struct diag *d)
{
    for (size_t i = 0; i < t->functions; i++)
        if (t->program && gene_of_name(t->function[i]) >= 0 && gene_arity(gene_of_name(t->function[i])) != 2)
            return diag_at(d, s->path, t->line, 0, "tier '%s': '%s' is unary; programs take binary operators", t->name,
                           t->function[i]);
    for (size_t i = 0; i < t->functions; i++)
        if (gene_of_name(t->function[i]) < 0 && !has_function(frame, t, t->function[i]))
            return diag_at(d, s->path, t->line, 0, "tier '%s': '%s' is not a function of frame '%s'", t->name,
                           t->function[i], t->frame);
    if (t->last && !has_function(frame, t, t->last))
        return diag_at(d, s->path, t->line, 0, "tier '%s': '%s' is not a function of frame '%s'", t->name, t->last,
                       t->frame);
    return true;
}

static bool frame_is_new(const struct scene *s, size_t tier)
{
    for (size_t i = 0; i < tier; i++)
        if (strcmp(s->tier[i].frame, s->tier[tier].frame) == 0 && s->tier[i].at == s->tier[tier].at)
            return false;
    return true;
}

/* "affine, bezier, ..." */
static void list_frames(const char *root, char *text, size_t size)
{
    char pattern[1024];
    glob_t found;
    size_t n = 0;
    snprintf(pattern, sizeof pattern, "%s/evolve/frames/*.gen", root);
    snprintf(text, size, "none in %.200s/evolve/frames", root);
    if (glob(pattern, 0, NULL, &found) != 0)
        return;
    for (size_t i = 0; i < found.gl_pathc && n < size; i++) {
        const char *name = strrchr(found.gl_pathv[i], '/') + 1;
        n += (size_t)snprintf(text + n, size - n, "%s%.*s", i ? ", " : "", (int)(strlen(name) - strlen(".gen")), name);
    }
    globfree(&found);
}

static bool add_frame(const char *root, const struct scene *s, size_t tier, struct genome_file *program, struct diag *d)
{
    char path[FRAME_PATH];
    const struct tier *t = &s->tier[tier];
    tier_frame_path(root, t, path);
    if (access(path, R_OK) != 0) {
        char known[300];
        list_frames(root, known, sizeof known);
        return diag_at(d, s->path, t->frame_line, t->frame_column, "tier '%s': no frame '%s'; available: %s", t->name,
                       t->frame, known);
    }
    struct genome_file *frame = genome_read(path, d);
    if (!frame)
        return false;
    if (program->inputs == 0) {
        program->format = frame->format;
        genome_add_segment(program, s->segment, s->order);
    }
    bool good = frame->genomes == 0 || diag_at(d, path, frame->genome[0].line, 0, "a frame must not contain genomes");
    if (good && frame->segment && frame->segment != s->segment)
        good = diag_at(d, s->path, t->frame_line, t->frame_column, "tier '%s': frame '%s' is for segment %s", t->name,
                       t->frame, frame->segment->name);
    if (good && frame->format != program->format)
        good = diag_at(d, path, 0, 0, "format version %d differs from version %d of another frame of the scene",
                       frame->format, program->format);
    for (size_t i = 0; good && i < frame->statements && frame_is_new(s, tier); i++)
        good = add_statement(frame, i, s, t, program, d);
    for (size_t i = 0; good && i < frame->exchanges && frame_is_new(s, tier); i++)
        good = add_exchange(frame, frame->exchange[i], t, program, d);
    good = good && check_functions(frame, s, t, d);
    for (size_t i = 0; good && i < 2 * t->starts; i++)
        if (genome_find_symbol(program, t->start[i / 2][i % 2]) < 0)
            good = diag_at(d, s->path, t->line, 0, "tier '%s': '%s' is not a value of frame '%s'", t->name,
                           t->start[i / 2][i % 2], t->frame);
    for (size_t i = 0; good && i < t->terminals; i++)
        if (genome_find_symbol(program, t->terminal[i]) < 0)
            good = diag_at(d, s->path, t->line, 0, "tier '%s': '%s' is not a value of frame '%s'", t->name,
                           t->terminal[i], t->frame);
    genome_file_free(frame);
    return good;
}

struct genome_file *frame_program(const char *root, const struct scene *s, const char *path, struct diag *d)
{
    struct genome_file *program = genome_file_new(path);
    for (size_t i = 0; i < s->tiers; i++)
        if (!add_frame(root, s, i, program, d)) {
            genome_file_free(program);
            return NULL;
        }
    return program;
}

size_t frame_target(const struct genome_file *program, int output)
{
    return program->inputs + program->lets + (size_t)output;
}

struct columns frame_columns_in(const struct genome_file *program, const struct sample *s, size_t n, bool single)
{
    struct columns c = columns_new(n, frame_target(program, 2));
    c.single = single;
    const size_t inputs = program->inputs, slave = inputs - 3;
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < inputs; j++)
            columns_at(&c, j)[i] = j < slave ? s[i].x[j / 3][j % 3] : s[i].xs[j - slave];
        columns_at(&c, frame_target(program, 0))[i] = s[i].xi;
        columns_at(&c, frame_target(program, 1))[i] = s[i].eta;
    }
    for (size_t j = 0; j < program->lets; j++) {
        const struct genome_expr *let = &program->let[j];
        table_values(&c, program->constant, let->gene, let->length, columns_at(&c, program->inputs + j));
    }
    return c;
}

struct columns frame_columns(const struct genome_file *program, const struct sample *s, size_t n)
{
    return frame_columns_in(program, s, n, false);
}
