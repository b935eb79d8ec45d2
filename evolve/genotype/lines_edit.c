/* Changes of programs; see lines_edit.h. Each change builds the program anew. It copies the old program unchanged
 * (`clean`), computes new values from its lines, then copies the answers again with the new values substituted. So no
 * line can come to depend on itself. */
#include "lines_edit.h"

#include "../common/decimal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TRIES = 16 };

struct line_editor *line_editor_new(const struct line_rules *r)
{
    struct line_editor *e = new_array(1, sizeof *e);
    *e = (struct line_editor){.rules = r, .from = lines_new(r), .mate = lines_new(r), .to = lines_new(r)};
    return e;
}

void line_editor_free(struct line_editor *e)
{
    if (!e)
        return;
    lines_free(e->from);
    lines_free(e->mate);
    lines_free(e->to);
    arena_free(&e->arena);
    free(e);
}

static void reserve(struct line_editor *e, size_t lines)
{
    if (lines <= e->room)
        return;
    arena_free(&e->arena);
    e->room = 2 * lines;
    e->map = arena_array(&e->arena, e->room, sizeof *e->map);
    e->clean = arena_array(&e->arena, e->room, sizeof *e->clean);
    e->image = arena_array(&e->arena, e->room, sizeof *e->image);
    e->power = arena_array(&e->arena, e->room, sizeof *e->power);
    e->mate_power = arena_array(&e->arena, e->room, sizeof *e->mate_power);
    e->depends = arena_array(&e->arena, e->room, sizeof *e->depends);
}

static void none(int *map, size_t n)
{
    for (size_t i = 0; i < n; i++)
        map[i] = -1;
}

/* Loads a program to be changed. */
static void load(struct line_editor *e, const struct genes *t)
{
    lines_load(e->from, t, -1, LINES_INNER);
    reserve(e, e->from->lines);
    lines_powers(e->from, e->power);
    lines_images(e->from, e->image);
    lines_begin(e->to);
    none(e->map, e->from->lines);
    none(e->clean, e->from->lines);
}

static bool store(struct line_editor *e, const struct genes *t, size_t max, struct genes *child)
{
    for (int k = 0; k < 2; k++)
        e->to->root[k] = lines_take(e->to, e->from, e->from->root[k], e->map);
    return lines_store(e->to, max, child) && !genes_equal(t, child);
}

static int clean(struct line_editor *e, int operand)
{
    return operand >= LINE_GENE ? lines_symbol(e->to, operand - LINE_GENE)
                                : lines_take(e->to, e->from, operand, e->clean);
}

static int scaled(struct line_editor *e, int x, double c)
{
    if (c == -1)
        return lines_operation(e->to, GENE_NEG, x, -1);
    return lines_operation(e->to, GENE_MUL, x, lines_number(e->to, c));
}

/* Adds the value of an edit and returns its line. */
static int value_of(struct line_editor *e, const struct line_edit *edit)
{
    switch (edit->kind) {
    case EDIT_VALUE:
        return scaled(e, clean(e, edit->x), edit->c);
    case EDIT_NUMBER:
        return lines_number(e->to, edit->c);
    case EDIT_OPERATION:
        return lines_operation(e->to, edit->gene, clean(e, edit->x), edit->y < 0 ? -1 : clean(e, edit->y));
    case EDIT_TERM:
    case EDIT_QUOTIENT:
        break;
    }
    int term = clean(e, edit->x);
    if (edit->kind == EDIT_QUOTIENT) {
        const int one = lines_number(e->to, 1), part = scaled(e, term, edit->c);
        const int divisor = lines_operation(e->to, GENE_SUB, one, part);
        const int guard = lines_operation(e->to, GENE_MAX, divisor, lines_number(e->to, 0.25));
        return lines_operation(e->to, GENE_DIV, clean(e, edit->line), guard);
    }
    if (edit->y >= 0)
        term = lines_operation(e->to, GENE_MUL, term, clean(e, edit->y));
    if (edit->c == -1)
        return lines_operation(e->to, GENE_SUB, clean(e, edit->line), term);
    return lines_operation(e->to, GENE_ADD, clean(e, edit->line), scaled(e, term, edit->c));
}

static int image_of(const struct line_editor *e, int operand)
{
    if (operand < 0)
        return operand;
    return operand >= LINE_GENE ? LINE_GENE + GENE_SYMBOL + (int)e->rules->partner[operand - LINE_GENE - GENE_SYMBOL]
                                : e->image[operand];
}

/* Returns false if an operand has no image or the edit is its own image. */
static bool find_image(const struct line_editor *e, const struct line_edit *edit, struct line_edit *image)
{
    *image = *edit;
    image->line = image_of(e, edit->line);
    image->x = edit->kind == EDIT_NUMBER ? -1 : image_of(e, edit->x);
    image->y = image_of(e, edit->y);
    return image->line >= 0 && image->line != edit->line && (edit->kind == EDIT_NUMBER || image->x >= 0) &&
           (edit->y < 0 || image->y >= 0);
}

static bool apply(struct line_editor *e, const struct genes *t, const struct line_edit *edit, bool both, size_t max,
                  struct genes *child)
{
    struct line_edit image;
    e->map[edit->line] = value_of(e, edit);
    if (both && find_image(e, edit, &image))
        e->map[image.line] = value_of(e, &image);
    return store(e, t, max, child);
}

bool lines_apply(struct line_editor *e, const struct genes *t, const struct line_edit *edit, bool both, size_t max,
                 struct genes *child)
{
    load(e, t);
    return apply(e, t, edit, both, max, child);
}

void lines_dependents(const struct lines *c, int n, bool *depends)
{
    for (size_t i = 0; i < c->lines; i++) {
        const struct line *x = &c->line[i];
        depends[i] = (int)i == n || (x->a >= 0 && depends[x->a]) || (x->b >= 0 && depends[x->b]);
    }
}

/* ---- random changes ---- */

static size_t below(gsl_rng *rng, size_t n)
{
    return gsl_rng_uniform_int(rng, n);
}

static bool may_change(const struct lines *c, size_t i)
{
    return c->needed[i] && line_is_operation(&c->line[i]) && !line_is_guard(c, i);
}

/* Returns a random needed operation that is not a guard, or -1. */
static int random_operation(gsl_rng *rng, const struct lines *c)
{
    size_t n = 0;
    for (size_t i = 0; i < c->lines; i++)
        n += may_change(c, i);
    if (n == 0)
        return -1;
    size_t k = below(rng, n);
    for (size_t i = 0;; i++)
        if (may_change(c, i) && k-- == 0)
            return (int)i;
}

/* Returns a random line or symbol with this power of length that does not depend on the edited line, or -1. */
static int random_value(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, int power)
{
    const struct lines *c = e->from;
    for (int tries = 0; tries < TRIES; tries++) {
        const size_t k = below(rng, c->lines + genes->symbols);
        if (k >= c->lines) {
            const int gene = genes->symbol[k - c->lines];
            if (e->rules->power[gene - GENE_SYMBOL] == power)
                return LINE_GENE + gene;
        } else if (c->needed[k] && !e->depends[k] && e->power[k] == power && c->line[k].gene != LINE_NUMBER) {
            return (int)k;
        }
    }
    return -1;
}

static bool divides(int gene)
{
    return gene == GENE_DIV || gene == GENE_PDIV;
}

/* Chooses another operand of an operation, but never another divisor. */
static bool choose_operand(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, struct line_edit *edit)
{
    const struct line *x = &e->from->line[edit->line];
    const bool second = x->b >= 0 && !divides(x->gene) && below(rng, 2);
    const int old = second ? x->b : x->a;
    lines_dependents(e->from, edit->line, e->depends);
    const int fresh = random_value(e, rng, genes, e->power[old]);
    *edit = (struct line_edit){EDIT_OPERATION, edit->line, x->gene, second ? x->a : fresh, second ? fresh : x->b, 1};
    return fresh >= 0;
}

/* Replaces an operation by one of its operands, another value of the same power, 0 or 1. */
static bool choose_shortcut(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, struct line_edit *edit)
{
    const struct line *x = &e->from->line[edit->line];
    const int operand = x->b >= 0 && below(rng, 2) ? x->b : x->a, power = e->power[edit->line];
    const size_t way = below(rng, 4);
    *edit = (struct line_edit){EDIT_VALUE, edit->line, 0, operand, -1, 1};
    if (way < 2 && e->power[operand] == power)
        return true;
    if (way == 3) {
        edit->kind = EDIT_NUMBER;
        edit->c = power == 0 ? (double)below(rng, 2) : 0;
        return true;
    }
    lines_dependents(e->from, edit->line, e->depends);
    edit->x = random_value(e, rng, genes, power);
    return edit->x >= 0;
}

static bool choose_operator(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, struct line_edit *edit)
{
    const struct line *x = &e->from->line[edit->line];
    const bool sum = x->gene == GENE_ADD || x->gene == GENE_SUB || x->gene == GENE_MIN || x->gene == GENE_MAX;
    const int gene = genes->operations ? genes->operation[below(rng, genes->operations)] : GENE_ADD;
    const bool fresh_sum = gene == GENE_ADD || gene == GENE_SUB || gene == GENE_MIN || gene == GENE_MAX;
    *edit = (struct line_edit){EDIT_OPERATION, edit->line, gene, x->a, x->b, 1};
    return x->b >= 0 && gene != x->gene && !divides(gene) && !divides(x->gene) &&
           (sum == fresh_sum || (e->power[x->a] == 0 && e->power[x->b] == 0));
}

/* Chooses a term to add, with or without a coefficient. */
static bool choose_term(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, struct line_edit *edit)
{
    const int n = edit->line, power = e->power[n];
    lines_dependents(e->from, n, e->depends);
    e->depends[n] = false; /* the line itself may be a factor */
    const int part = (int)below(rng, 9) - 4;
    const int y = below(rng, 3) ? random_value(e, rng, genes, part) : -1;
    const int x = random_value(e, rng, genes, y >= 0 ? power - part : power);
    static const double factor[] = {1, -1, 2, -2, 0.5, -0.5, 0.25, 0.01, -0.01, 0.1, -0.1};
    *edit = (struct line_edit){EDIT_TERM, n, 0, x, y, factor[below(rng, sizeof factor / sizeof *factor)]};
    return x >= 0 && power != ANY_POWER;
}

/* Replaces x / a and y / b by x b r and y a r with r = 1 / (a b). */
static bool share_division(struct line_editor *e, gsl_rng *rng, const struct genes *t, size_t max, struct genes *child)
{
    const struct lines *c = e->from;
    for (int tries = 0; tries < TRIES; tries++) {
        const int i = random_operation(rng, c), j = random_operation(rng, c);
        if (i < 0 || i >= j || c->line[i].gene != GENE_DIV || c->line[j].gene != GENE_DIV)
            continue;
        lines_dependents(c, i, e->depends);
        const int at[2] = {i, j}, of[2] = {c->line[i].b, c->line[j].b};
        if (e->depends[j] || of[0] == of[1])
            continue;
        const int product = lines_operation(e->to, GENE_MUL, clean(e, of[0]), clean(e, of[1]));
        const int r = lines_operation(e->to, GENE_DIV, lines_number(e->to, 1), product);
        for (int k = 0; k < 2; k++) {
            const int own = lines_operation(e->to, GENE_MUL, r, clean(e, of[1 - k]));
            e->map[at[k]] = lines_operation(e->to, GENE_MUL, clean(e, c->line[at[k]].a), own);
        }
        return store(e, t, max, child);
    }
    return false;
}

/* Grafts a value of the mate; also its image, if both programs have images. */
static bool graft(struct line_editor *e, gsl_rng *rng, const struct genes *t, const struct genes *mate, size_t max,
                  struct genes *child)
{
    lines_load(e->mate, mate, -1, LINES_INNER);
    reserve(e, e->mate->lines);
    load(e, t);
    const size_t lines = e->mate->lines;
    int *map = new_array(2 * lines, sizeof *map), *image = map + lines;
    lines_powers(e->mate, e->mate_power);
    lines_images(e->mate, image);
    none(map, lines);
    const int n = random_operation(rng, e->from);
    bool good = false;
    for (int tries = 0; n >= 0 && !good && tries < TRIES; tries++) {
        const int m = below(rng, 4) ? (int)below(rng, lines) : e->mate->root[below(rng, 2)];
        if (!e->mate->needed[m] || e->mate_power[m] != e->power[n] || e->mate->line[m].gene == LINE_NUMBER)
            continue;
        e->map[n] = lines_take(e->to, e->mate, m, map);
        const int own = e->image[n], other = image[m];
        if (below(rng, 4) && own >= 0 && own != n && other >= 0)
            e->map[own] = lines_take(e->to, e->mate, other, map);
        good = true;
    }
    free(map);
    return good && store(e, t, max, child);
}

static bool call_somewhere(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, const struct genes *t,
                           size_t max, struct genes *child)
{
    if (genes->functions == 0)
        return false;
    const int function = genes->operation[genes->operations + below(rng, genes->functions)] - GENE_FUNCTION;
    int at[2] = {e->from->root[0], e->from->root[1]};
    const int n = random_operation(rng, e->from);
    if (below(rng, 2) && n >= 0 && e->power[n] == 0 && e->image[n] >= 0 && e->image[n] != n) {
        at[0] = n;
        at[1] = e->image[n];
    }
    int x[2] = {clean(e, at[0]), clean(e, at[1])};
    lines_call(e->to, function, x);
    e->map[at[0]] = x[0];
    e->map[at[1]] = x[1];
    return store(e, t, max, child);
}

bool lines_edit(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, const struct genes *t,
                const struct genes *mate, size_t max, struct genes *child)
{
    enum { GRAFT, OPERAND, SHORTCUT, OPERATOR, TERM, CALL, SHARE, MOVES };
    static const double rate[MOVES] = {0.25, 0.25, 0.2, 0.05, 0.15, 0.07, 0.03};
    double at = gsl_rng_uniform(rng);
    int move = 0;
    while (move + 1 < MOVES && (at -= rate[move]) >= 0)
        move++;
    if (move == GRAFT)
        return graft(e, rng, t, mate, max, child);
    load(e, t);
    if (move == CALL)
        return call_somewhere(e, rng, genes, t, max, child);
    if (move == SHARE)
        return share_division(e, rng, t, max, child);
    struct line_edit edit = {.line = random_operation(rng, e->from)};
    if (edit.line < 0)
        return false;
    const bool good = move == OPERAND    ? choose_operand(e, rng, genes, &edit)
                      : move == SHORTCUT ? choose_shortcut(e, rng, genes, &edit)
                      : move == OPERATOR ? choose_operator(e, rng, genes, &edit)
                                         : choose_term(e, rng, genes, &edit);
    return good && apply(e, t, &edit, below(rng, 2), max, child);
}
