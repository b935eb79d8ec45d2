/* Guided changes; see guide.h.  With the residuals r of xi and eta, weights w = 1 / (|r| + s) that make their squares the
 * mean norm, and J = d answer / d line:
 *
 *   line += c z        changes the sum of w r^2 by 2 c sum(w r J z) + c^2 sum(w J^2 z^2), both answers summed
 *   line := line'      changes the sum of |r| by sum(|r + J (line' - line)| - |r|), to first order */
#include "guide.h"

#include "../common/simd.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCKS = 4,
    ROWS = BLOCKS * TAPE_BLOCK,
    PLACES = 4,       /* lines looked at for one change */
    CANDIDATES = 500, /* of terms at a line */
    PRICE_OF_DIVISION = 8
};

struct guide {
    const struct columns *table; /* not owned */
    struct lines_run *run;       /* owned, as are these */
    struct line_editor *editor;
    double *value;    /* by pool entry, ROWS each */
    double *slope[2]; /* by line, ROWS each: of xi and of eta */
    double *residual[2], *weight[2];
    double *first, *second; /* sums over the answers of w r J and w J^2 */
    signed char *power;     /* by pool entry */
    bool *depends;
    int *uses;
    size_t rows, lines, room; /* lines: of the program; the set's symbols follow */
    int pool;
    double one[ROWS]; /* the number 1 as a column */
};

struct guide *guide_new(const struct line_rules *r, const struct columns *table)
{
    struct guide *g = new_array(1, sizeof *g);
    *g = (struct guide){.table = table, .run = lines_run_new(r, table), .editor = line_editor_new(r)};
    g->rows = table->n / TAPE_BLOCK * TAPE_BLOCK; /* whole blocks, if there is one */
    g->rows = g->rows > ROWS ? ROWS : g->rows;
    for (int h = 0; h < 2; h++) {
        g->residual[h] = new_array(ROWS, sizeof(double));
        g->weight[h] = new_array(ROWS, sizeof(double));
    }
    g->first = new_array(ROWS, sizeof(double));
    g->second = new_array(ROWS, sizeof(double));
    for (size_t k = 0; k < ROWS; k++)
        g->one[k] = 1;
    return g;
}

static void free_tables(struct guide *g)
{
    free(g->value);
    free(g->slope[0]);
    free(g->slope[1]);
    free(g->power);
    free(g->depends);
    free(g->uses);
}

void guide_free(struct guide *g)
{
    if (!g)
        return;
    lines_run_free(g->run);
    line_editor_free(g->editor);
    for (int h = 0; h < 2; h++) {
        free(g->residual[h]);
        free(g->weight[h]);
    }
    free(g->first);
    free(g->second);
    free_tables(g);
    free(g);
}

static void reserve(struct guide *g, size_t pool)
{
    if (pool <= g->room)
        return;
    free_tables(g);
    g->room = 2 * pool;
    g->value = new_array(g->room * ROWS, sizeof(double));
    g->slope[0] = new_array(g->room * ROWS, sizeof(double));
    g->slope[1] = new_array(g->room * ROWS, sizeof(double));
    g->power = new_array(g->room, sizeof *g->power);
    g->depends = new_array(g->room, sizeof *g->depends);
    g->uses = new_array(g->room, sizeof *g->uses);
}

static void keep_block(struct guide *g, size_t row, int half)
{
    const struct lines *c = g->run->code;
    const size_t bytes = TAPE_BLOCK * sizeof(double);
    for (size_t i = 0; i < g->lines; i++) {
        if (half == 0 && c->needed[i])
            memcpy(g->value + i * ROWS + row, g->run->value[i], bytes);
        double *to = g->slope[half] + i * ROWS + row;
        if (c->needed[i] && g->run->slope[i])
            memcpy(to, g->run->slope[i], bytes);
        else
            memset(to, 0, bytes);
    }
    const double *root = g->run->value[c->root[half]];
    const double *goal = columns_at(g->table, g->table->count - 2 + (size_t)half) + row;
    for (size_t k = 0; k < TAPE_BLOCK; k++)
        g->residual[half][row + k] = root[k] - goal[k];
}

/* Where the residual is 0 or means nothing, no weight. */
static void weigh(struct guide *g)
{
    double sum = 0;
    for (int h = 0; h < 2; h++)
        for (size_t k = 0; k < g->rows; k++)
            sum += fabs(g->residual[h][k]);
    const double scale = 0.3 * sum / (double)(2 * g->rows);
    for (int h = 0; h < 2; h++)
        for (size_t k = 0; k < g->rows; k++)
            g->weight[h][k] = 1 / (fabs(g->residual[h][k]) + scale);
}

/* Take a program: values and slopes of its inner lines, values of the symbols.  False where it is not finite. */
static bool take(struct guide *g, const struct gene_set *genes, const struct genes *t, int last)
{
    struct lines *c = g->run->code;
    if (g->rows == 0)
        return false;
    lines_load(g->editor->from, t, -1, LINES_INNER);
    lines_run_load(g->run, t, last, true);
    g->lines = g->editor->from->lines;
    g->pool = (int)(g->lines + genes->symbols);
    reserve(g, c->lines + genes->symbols);
    for (size_t row = 0; row < g->rows; row += TAPE_BLOCK) {
        lines_values(g->run, row);
        for (int h = 0; h < 2; h++) {
            lines_slopes(g->run, h);
            keep_block(g, row, h);
        }
    }
    lines_powers(c, g->power);
    for (size_t i = 0; i < genes->symbols; i++) {
        const size_t symbol = (size_t)(genes->symbol[i] - GENE_SYMBOL);
        memcpy(g->value + (g->lines + i) * ROWS, columns_at(g->table, symbol), g->rows * sizeof(double));
        g->power[g->lines + i] = g->editor->rules->power[symbol];
    }
    weigh(g);
    bool good = true;
    for (size_t k = 0; k < g->rows; k++)
        good = good && isfinite(g->residual[0][k]) && isfinite(g->residual[1][k]);
    return good;
}

static const double *value_at(const struct guide *g, int entry)
{
    return g->value + (size_t)entry * ROWS;
}

static int operand_of(const struct guide *g, const struct gene_set *genes, int entry)
{
    return (size_t)entry < g->lines ? entry : LINE_GENE + genes->symbol[(size_t)entry - g->lines];
}

/* Entries that may stand for, or in, line n. */
static bool may_use(const struct guide *g, int entry)
{
    if ((size_t)entry >= g->lines)
        return true;
    return g->run->code->needed[entry] && !g->depends[entry] && g->run->code->line[entry].gene != LINE_NUMBER;
}

static void sum_answers(struct guide *g, int n)
{
    const double *j0 = g->slope[0] + (size_t)n * ROWS, *j1 = g->slope[1] + (size_t)n * ROWS;
    for (size_t k = 0; k < g->rows; k++) {
        g->first[k] = g->weight[0][k] * g->residual[0][k] * j0[k] + g->weight[1][k] * g->residual[1][k] * j1[k];
        g->second[k] = g->weight[0][k] * j0[k] * j0[k] + g->weight[1][k] * j1[k] * j1[k];
    }
}

/* An operation that the answers need, or an answer; -1: none was found. */
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

/* The nearest number that stands for a structure, if it is near enough; or the number itself. */
static double nice(double c, double near)
{
    static const double known[] = {0.25, 1.0 / 3, 0.5, 2.0 / 3, 0.75, 1, 1.5, 2, 3, 4, 6, 8};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (fabs(fabs(c) / known[i] - 1) < near && line_number_is_kept(known[i]) && known[i] * 4 == rint(known[i] * 4))
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
    sum_answers(g, n);
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

/* Where a line gets a multiple of itself, it may be divided for it instead. */
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
    double total = 0;
    if (!take(g, genes, t, last))
        return false;
    for (int h = 0; h < 2; h++)
        for (size_t k = 0; k < g->rows; k++)
            total += g->weight[h][k] * g->residual[h][k] * g->residual[h][k];
    for (int i = 0; i < PLACES; i++) {
        const int n = random_line(g, rng);
        if (n >= 0)
            look_for_terms(g, genes, rng, n, &best);
    }
    if (!(best.gain > 1e-3 * total))
        return false;
    divide_for(genes, rng, &best.edit);
    return lines_apply(g->editor, t, &best.edit, gsl_rng_uniform(rng) < 0.7, max, child);
}

/* ---- pruning ---- */

/* Operations that nothing needs any more where line n is gone. */
static int saved(struct guide *g, int n)
{
    const struct lines *c = g->editor->from;
    const struct line *x = &c->line[n];
    int sum = x->gene == GENE_DIV || x->gene == GENE_PDIV ? PRICE_OF_DIVISION : 1;
    for (int k = 0; k < 2; k++) {
        const int from = k ? x->b : x->a;
        if (from >= 0 && line_is_operation(&c->line[from]) && --g->uses[from] == 0)
            sum += saved(g, from);
    }
    return sum;
}

/* What the sum of |r| grows by where line n becomes c m. */
WIDE static double growth(const struct guide *g, int n, const double *m, double c)
{
    const double *value = value_at(g, n);
    double sum = 0;
    for (int h = 0; h < 2; h++) {
        const double *j = g->slope[h] + (size_t)n * ROWS, *r = g->residual[h];
        for (size_t k = 0; k < g->rows; k++)
            sum += fabs(r[k] + j[k] * (c * m[k] - value[k])) - fabs(r[k]);
    }
    return sum;
}

static void try_value(const struct guide *g, int n, const double *m, int operand, double per, struct promise *best)
{
    const double *value = value_at(g, n);
    double num = 0, den = 0, c = 0;
    for (size_t k = 0; m && k < g->rows; k++) {
        num += g->second[k] * value[k] * m[k];
        den += g->second[k] * m[k] * m[k];
    }
    if (m && !(den > 0))
        return;
    if (m)
        c = nice(num / den, 0.05);
    const double more = m ? growth(g, n, m, c) : growth(g, n, value, 0), gain = -more / per;
    if (!isfinite(more) || !(gain > best->gain))
        return;
    *best = (struct promise){{operand < 0 ? EDIT_NUMBER : EDIT_VALUE, n, 0, operand, -1, c}, gain};
}

static void look_for_less(struct guide *g, const struct gene_set *genes, int n, struct promise *best)
{
    memset(g->uses, 0, g->editor->from->lines * sizeof *g->uses);
    lines_count_uses(g->editor->from, g->uses);
    const double per = saved(g, n);
    lines_dependents(g->run->code, n, g->depends);
    sum_answers(g, n);
    try_value(g, n, NULL, -1, per, best);
    if (g->power[n] == 0)
        try_value(g, n, g->one, -1, per, best);
    for (int x = 0; x < g->pool && g->power[n] != ANY_POWER; x++)
        if (may_use(g, x) && g->power[x] == g->power[n])
            try_value(g, n, value_at(g, x), operand_of(g, genes, x), per, best);
}

bool guide_prune(struct guide *g, gsl_rng *rng, const struct gene_set *genes, const struct genes *t, int last,
                 size_t max, struct genes *child)
{
    struct promise best = {.gain = -INFINITY};
    if (!take(g, genes, t, last))
        return false;
    for (int i = 0; i < PLACES; i++) {
        const int n = random_line(g, rng);
        if (n >= 0)
            look_for_less(g, genes, n, &best);
    }
    return best.gain > -INFINITY && lines_apply(g->editor, t, &best.edit, gsl_rng_uniform(rng) < 0.7, max, child);
}

/* ---- answers within ---- */

/* A line without a length whose values are near an answer, by chance; `itself`: the answer may be it. */
static int near_answer(const struct guide *g, gsl_rng *rng, int half, bool itself)
{
    const struct lines *c = g->editor->from;
    const double *answer = value_at(g, c->root[half]);
    int found = -1;
    size_t n = 0;
    for (size_t i = 0; i < g->lines; i++) {
        double off = 0, size = 0;
        if (!c->needed[i] || !line_is_operation(&c->line[i]) || g->power[i] != 0 ||
            (!itself && (int)i == c->root[half]))
            continue;
        for (size_t k = 0; k < g->rows; k++) {
            off += fabs(value_at(g, (int)i)[k] - answer[k]);
            size += fabs(answer[k]);
        }
        if (off < 0.3 * size && gsl_rng_uniform_int(rng, ++n) == 0)
            found = (int)i;
    }
    return found;
}

bool guide_restart(struct guide *g, gsl_rng *rng, const struct gene_set *genes, const struct genes *t,
                   const struct genes *mate, int last, size_t max, struct genes *child)
{
    int of[2] = {-1, -1}, at[2];
    const bool call = genes->functions > 0 && gsl_rng_uniform(rng) < 0.3;
    if (!call && gsl_rng_uniform(rng) < 0.5) {
        if (!take(g, genes, mate, last))
            return false;
        for (int h = 0; h < 2; h++)
            of[h] = near_answer(g, rng, h, true);
    }
    if (!take(g, genes, t, last))
        return false;
    for (int h = 0; h < 2; h++)
        if ((at[h] = near_answer(g, rng, h, call)) < 0)
            return false;
    if (at[0] == at[1])
        return false;
    if (!call)
        return lines_graft_answers(g->editor, t, at, mate, of, max, child);
    const int function = genes->operation[genes->operations + gsl_rng_uniform_int(rng, genes->functions)];
    return lines_insert_call(g->editor, t, at, function - GENE_FUNCTION, max, child);
}
