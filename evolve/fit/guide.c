/* Guided insertion; see guide.h. Let r be the residuals of xi and eta, w = 1 / (|r| + s) weights that turn their
 * squares into the mean norm, and J = d answer / d line. Adding a term c z to the line changes the sum of w r^2 by 2 c
 * sum(w r J z) + c^2 sum(w J^2 z^2), summed over both answers. */
#include "guide.h"

#include "../../codegen/base/simd.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCKS = 4,
    ROWS = BLOCKS * TAPE_BLOCK,
    CANDIDATES = 500 /* terms tried */
};

struct guide {
    const struct columns *table; /* not owned */
    struct lines_run *run;       /* owned, as are the following */
    struct line_editor *editor;
    struct arena arena; /* of the following arrays */
    double *value;      /* indexed by pool entry, ROWS each */
    signed char *power; /* indexed by pool entry */
    bool *depends;
    size_t rows, lines, room; /* lines: of the program; the set's symbols follow */
    int pool;
    double residual[2][ROWS], slope[2][ROWS]; /* of xi and eta: residual, and derivative by the line that gets a term */
    double first[ROWS], second[ROWS];         /* sums over both answers of w r J and w J^2 */
    double total;                             /* sum of w r^2 */
    double one[ROWS];                         /* the number 1 as a column */
};

struct guide *guide_new(const struct line_rules *r, const struct columns *table)
{
    struct guide *g = new_array(1, sizeof *g);
    *g = (struct guide){.table = table, .run = lines_run_new(r, table), .editor = line_editor_new(r)};
    g->rows = table->n / TAPE_BLOCK * TAPE_BLOCK; /* whole blocks only */
    g->rows = g->rows > ROWS ? ROWS : g->rows;
    for (size_t k = 0; k < ROWS; k++)
        g->one[k] = 1;
    return g;
}

void guide_free(struct guide *g)
{
    if (!g)
        return;
    lines_run_free(g->run);
    line_editor_free(g->editor);
    arena_free(&g->arena);
    free(g);
}

static void reserve(struct guide *g, size_t pool)
{
    if (pool <= g->room)
        return;
    arena_free(&g->arena);
    g->room = 2 * pool;
    g->value = arena_array(&g->arena, g->room * ROWS, sizeof(double));
    g->power = arena_array(&g->arena, g->room, sizeof *g->power);
    g->depends = arena_array(&g->arena, g->room, sizeof *g->depends);
}

/* Stores the residuals of a block and the slopes by line n. */
static void keep_answers(struct guide *g, size_t row, int half, int n)
{
    const struct lines *c = g->run->code;
    const double *root = g->run->value[c->root[half]], *by = g->run->slope[n];
    const double *goal = columns_at(g->table, g->table->count - 2 + (size_t)half) + row;
    for (size_t k = 0; k < TAPE_BLOCK; k++) {
        g->residual[half][row + k] = root[k] - goal[k];
        g->slope[half][row + k] = by ? by[k] : 0;
    }
}

/* Returns the sum of the residuals' magnitudes. */
static double sum_residuals(const struct guide *g)
{
    double sum = 0;
    for (int h = 0; h < 2; h++)
        for (size_t k = 0; k < g->rows; k++)
            sum += fabs(g->residual[h][k]);
    return sum;
}

static void sum_answers(struct guide *g, double scale)
{
    g->total = 0;
    memset(g->first, 0, sizeof g->first);
    memset(g->second, 0, sizeof g->second);
    for (int h = 0; h < 2; h++)
        for (size_t k = 0; k < g->rows; k++) {
            const double r = g->residual[h][k], w = 1 / (fabs(r) + scale), j = g->slope[h][k];
            g->first[k] += w * r * j;
            g->second[k] += w * j * j;
            g->total += w * r * r;
        }
}

/* Takes the program that the editor has loaded. Computes the values of its inner lines and of the symbols, and the sums
 * for line n. Returns false if all residuals are 0 or any is not finite. */
static bool take(struct guide *g, const struct gene_set *genes, const struct genes *t, int last, int n)
{
    struct lines *c = g->run->code;
    lines_run_load(g->run, t, last, n);
    g->lines = g->editor->from->lines;
    g->pool = (int)(g->lines + genes->symbols);
    reserve(g, c->lines + genes->symbols);
    for (size_t row = 0; row < g->rows; row += TAPE_BLOCK) {
        lines_values(g->run, row);
        for (size_t i = 0; i < g->lines; i++)
            if (c->needed[i])
                memcpy(g->value + i * ROWS + row, g->run->value[i], TAPE_BLOCK * sizeof(double));
        for (int h = 0; h < 2; h++) {
            lines_slopes(g->run, h);
            keep_answers(g, row, h, n);
        }
    }
    lines_powers(c, g->power);
    for (size_t i = 0; i < genes->symbols; i++) {
        const size_t symbol = (size_t)(genes->symbol[i] - GENE_SYMBOL);
        memcpy(g->value + (g->lines + i) * ROWS, columns_at(g->table, symbol), g->rows * sizeof(double));
        g->power[g->lines + i] = g->editor->rules->power[symbol];
    }
    const double sum = sum_residuals(g);
    if (!(sum > 0 && isfinite(sum)))
        return false;
    sum_answers(g, 0.3 * sum / (double)(2 * g->rows));
    return true;
}

static const double *value_at(const struct guide *g, int entry)
{
    return g->value + (size_t)entry * ROWS;
}

static int operand_of(const struct guide *g, const struct gene_set *genes, int entry)
{
    return (size_t)entry < g->lines ? entry : LINE_GENE + genes->symbol[(size_t)entry - g->lines];
}

/* Returns true if an entry may replace line n or be an operand of its replacement. */
static bool may_use(const struct guide *g, int entry)
{
    if ((size_t)entry >= g->lines)
        return true;
    return g->run->code->needed[entry] && !g->depends[entry] && g->run->code->line[entry].gene != LINE_NUMBER;
}

/* Returns a random operation that the answers need, or an answer, or -1. */
static int random_line(const struct guide *g, gsl_rng *rng)
{
    const struct lines *c = g->editor->from;
    for (int tries = 0; tries < 64; tries++) {
        const size_t i = gsl_rng_uniform_int(rng, c->lines);
        const bool answer = (int)i == c->root[0] || (int)i == c->root[1];
        if (c->needed[i] && (answer || line_is_operation(&c->line[i])) && !line_is_guard(c, i))
            return (int)i;
    }
    return -1;
}

/* Returns the nearest structural number, such as 1 or 0.5, if it is close enough; otherwise c. */
static double nice(double c, double near)
{
    static const double known[] = {0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 6, 8};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (fabs(fabs(c) / known[i] - 1) < near)
            return c < 0 ? -known[i] : known[i];
    return c;
}

struct promise {
    struct line_edit edit;
    double gain;
};

WIDE static void moments(const double *first, const double *second, const double *x, const double *y, size_t n,
                         double *num, double *den)
{
    double a[WIDE_LANES] = {0}, b[WIDE_LANES] = {0};
    for (size_t k = 0; k + WIDE_LANES <= n; k += WIDE_LANES)
        for (size_t j = 0; j < WIDE_LANES; j++) {
            const double z = x[k + j] * y[k + j];
            a[j] += first[k + j] * z;
            b[j] += second[k + j] * z * z;
        }
    *num = *den = 0;
    for (size_t j = 0; j < WIDE_LANES; j++) {
        *num += a[j];
        *den += b[j];
    }
}

static void try_term(const struct guide *g, const struct gene_set *genes, gsl_rng *rng, int n, int x, int y,
                     struct promise *best)
{
    double num, den;
    moments(g->first, g->second, value_at(g, x), y < 0 ? g->one : value_at(g, y), g->rows, &num, &den);
    const double gain = num * num / den;
    if (!(den > 0) || !(gain > best->gain) || !isfinite(gain))
        return;
    const double c = -num / den, near = gsl_rng_uniform(rng) < 0.5 ? 0.2 : 0.02;
    *best = (struct promise){
        {EDIT_TERM, n, 0, operand_of(g, genes, x), y < 0 ? -1 : operand_of(g, genes, y), nice(c, near)}, gain};
}

static void look_for_terms(struct guide *g, const struct gene_set *genes, gsl_rng *rng, int n, struct promise *best)
{
    lines_dependents(g->run->code, n, g->depends);
    g->depends[n] = false; /* the line itself may be a factor */
    const int power = g->power[n];
    if (power == ANY_POWER)
        return;
    for (int x = 0; x < g->pool; x++)
        if (may_use(g, x) && g->power[x] == power && x != n)
            try_term(g, genes, rng, n, x, -1, best);
    for (int i = 0; i < CANDIDATES; i++) {
        const int x = (int)gsl_rng_uniform_int(rng, (unsigned long)g->pool);
        const int y = (int)gsl_rng_uniform_int(rng, (unsigned long)g->pool);
        if (may_use(g, x) && may_use(g, y) && g->power[x] + g->power[y] == power)
            try_term(g, genes, rng, n, x, y, best);
    }
}

static bool divides(const struct gene_set *genes)
{
    for (size_t i = 0; i < genes->operations; i++)
        if (genes->operation[i] == GENE_DIV)
            return true;
    return false;
}

/* Divides a line instead of adding a multiple of itself, in random cases. */
static void divide_for(const struct gene_set *genes, gsl_rng *rng, struct line_edit *edit)
{
    const int other = edit->x == edit->line ? edit->y : edit->y == edit->line ? edit->x : -1;
    if (other >= 0 && divides(genes) && gsl_rng_uniform(rng) < 0.5)
        *edit = (struct line_edit){EDIT_QUOTIENT, edit->line, 0, other, -1, edit->c};
}

bool guide_insert(struct guide *g, gsl_rng *rng, const struct gene_set *genes, const struct genes *t, int last,
                  size_t max, struct genes *child)
{
    struct promise best = {.gain = 0};
    if (g->rows == 0)
        return false;
    lines_load(g->editor->from, t, -1, LINES_INNER);
    const int n = random_line(g, rng);
    if (n < 0 || !take(g, genes, t, last, n))
        return false;
    look_for_terms(g, genes, rng, n, &best);
    if (!(best.gain > 1e-3 * g->total))
        return false;
    divide_for(genes, rng, &best.edit);
    return lines_apply(g->editor, t, &best.edit, gsl_rng_uniform(rng) < 0.7, max, child);
}
