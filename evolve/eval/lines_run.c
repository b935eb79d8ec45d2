/* The evaluator; see lines_run.h. It runs line after line over blocks of samples. If only values are needed, a block is
 * reused once no later line reads it, so that live blocks stay in the first-level cache. All register widths give the
 * same bits: values, because every sample goes through the same rounded operations; sums, because they run in a fixed
 * number of lanes, sample i of a block in lane i modulo that number. */
#include "lines_run.h"

#include "tape_blocks.h"

#include <stdlib.h>
#include <string.h>

enum { SCREEN = 4 * TAPE_BLOCK }; /* samples that reveal hopeless programs */
static const double hopeless = 3;

struct lines_run *lines_run_new(const struct line_rules *t, const struct columns *table)
{
    struct lines_run *r = new_array(1, sizeof *r);
    *r = (struct lines_run){.table = table, .code = lines_new(t)};
    return r;
}

void lines_run_free(struct lines_run *r)
{
    if (!r)
        return;
    lines_free(r->code);
    arena_free(&r->arena);
    columns_free(&r->block);
    columns_free(&r->slopes);
    free(r);
}

static void reserve_blocks(struct columns *block, size_t blocks)
{
    if (blocks * TAPE_BLOCK <= block->n)
        return;
    columns_free(block);
    *block = columns_new((blocks + blocks / 2) * TAPE_BLOCK, 1);
}

static double *block_at(const struct columns *block, size_t k)
{
    return block->data + k * TAPE_BLOCK;
}

/* Sets last[i] to the last line that reads line i; roots are read at the end. */
static void find_last_uses(const struct lines *c, int *last)
{
    for (size_t i = 0; i < c->lines; i++) {
        const struct line *x = &c->line[i];
        last[i] = -1;
        if (!c->needed[i] || !line_is_operation(x))
            continue;
        last[x->a] = (int)i;
        if (x->b >= 0)
            last[x->b] = (int)i;
    }
    for (size_t i = 0; i < c->lines; i++)
        if (c->divides[i]) /* read at the end, like the answers */
            last[i] = (int)c->lines;
    last[c->root[0]] = last[c->root[1]] = (int)c->lines;
}

/* Assigns a block to each line that is not a symbol; returns the number of blocks. */
static size_t share_blocks(struct lines_run *r)
{
    const struct lines *c = r->code;
    int *last = new_array(c->lines, sizeof *last);
    size_t *idle = new_array(c->lines, sizeof *idle), n = 0, blocks = 0;
    find_last_uses(c, last);
    for (size_t i = 0; i < c->lines; i++) {
        const struct line *x = &c->line[i];
        if (!c->needed[i] || x->gene >= GENE_SYMBOL)
            continue;
        r->place[i] = n > 0 && !r->all && line_is_operation(x) ? idle[--n] : blocks++;
        for (int k = 0; k < 2 && line_is_operation(x); k++) { /* a line never writes to a block that it reads */
            const int from = k ? x->b : x->a;
            if (from < 0 || (k && x->b == x->a) || last[from] != (int)i || !line_is_operation(&c->line[from]))
                continue;
            idle[n++] = r->place[from];
        }
    }
    free(last);
    free(idle);
    return blocks;
}

/* Reserves memory for the program in r->code. */
static void reserve(struct lines_run *r)
{
    const struct lines *c = r->code;
    if (c->lines > r->room) {
        r->room = 2 * c->lines;
        arena_free(&r->arena);
        r->value = arena_array(&r->arena, r->room, sizeof *r->value);
        r->slope = arena_array(&r->arena, r->room, sizeof *r->slope);
        r->place = arena_array(&r->arena, r->room, sizeof *r->place);
        r->varies = arena_array(&r->arena, r->room, sizeof *r->varies);
        r->above = arena_array(&r->arena, r->room, sizeof *r->above);
        r->below = arena_array(&r->arena, r->room, sizeof *r->below);
    }
    reserve_blocks(&r->block, share_blocks(r));
}

static void take(struct lines_run *r, const struct genes *t, int last, enum lines_use use, bool all)
{
    r->all = all;
    lines_load(r->code, t, last, use);
    reserve(r);
}

WIDE static void fill_numbers(struct lines_run *r)
{
    for (size_t i = 0; i < r->code->lines; i++) {
        const struct line *x = &r->code->line[i];
        if (!r->code->needed[i] || x->gene >= 0)
            continue;
        double *to = block_at(&r->block, r->place[i]);
        EACH to[k] = x->number;
        r->value[i] = to;
    }
}

/* Rounds to 24 bits (Dekker); sums, products, quotients and roots are then those of float, short of its range. */
IN_WIDE void round_to_float(double *value)
{
    EACH
    {
        const double high = value[k] * (0x1p29 + 1);
        value[k] = high - (high - value[k]);
    }
}

WIDE static void run_block(struct lines_run *r, size_t row)
{
    const struct lines *c = r->code;
    for (size_t i = 0; i < c->lines; i++) {
        const struct line *x = &c->line[i];
        if (!c->needed[i] || x->gene < 0)
            continue;
        if (x->gene >= GENE_SYMBOL) {
            r->value[i] = columns_at(r->table, (size_t)(x->gene - GENE_SYMBOL)) + row;
            continue;
        }
        double *to = block_at(&r->block, r->place[i]);
        value_of(x->gene, r->value[x->a], x->b >= 0 ? r->value[x->b] : NULL, to);
        if (r->table->single)
            round_to_float(to);
        r->value[i] = to;
    }
}

/* Computes the absolute errors of a block, and adds them to the lanes. */
WIDE static void take_errors(const double *value, const double *goal, size_t n, double *error, double lane[WIDE_LANES])
{
    for (size_t k = 0; k < n; k++) {
        const double e = fabs(value[k] - goal[k]);
        error[k] = e <= INFINITY ? e : INFINITY;
    }
    size_t k = 0;
    for (; k + WIDE_LANES <= n; k += WIDE_LANES)
        for (size_t j = 0; j < WIDE_LANES; j++)
            lane[j] += error[k + j];
    for (; k < n; k++)
        lane[k % WIDE_LANES] += error[k];
}

WIDE static void count_signs(struct lines_run *r, size_t n)
{
    for (size_t i = 0; i < r->code->lines; i++) {
        size_t above = 0, below = 0;
        if (!r->code->divides[i])
            continue;
        for (size_t k = 0; k < n; k++) {
            above += r->value[i][k] > 0;
            below += r->value[i][k] < 0;
        }
        r->above[i] += above;
        r->below[i] += below;
    }
}

double lines_errors(struct lines_run *r, const struct genes *t, int last, double bound, double *error)
{
    const size_t all = r->table->n;
    double lane[WIDE_LANES] = {0}, sum = 0;
    take(r, t, last, LINES_WHOLE, false);
    fill_numbers(r);
    memset(r->above, 0, r->code->lines * sizeof *r->above);
    memset(r->below, 0, r->code->lines * sizeof *r->below);
    for (size_t row = 0; row < all; row += TAPE_BLOCK) {
        const size_t n = lines_rows(r, row);
        run_block(r, row);
        r->work += (double)r->code->lines * (double)n;
        for (size_t half = 0; half < 2; half++)
            take_errors(r->value[r->code->root[half]], columns_at(r->table, r->table->count - 2 + half) + row, n,
                        error + half * all + row, lane);
        count_signs(r, n);
        sum = 0;
        for (int j = 0; j < WIDE_LANES; j++)
            sum += lane[j];
        if (!(sum <= bound) || (row + n == SCREEN && sum > hopeless * bound * SCREEN / (double)all))
            return INFINITY;
    }
    return sum;
}

/* ---- trees ---- */

static void take_tree(struct lines_run *r, const int *gene, size_t length, const struct genome_constant *constant)
{
    r->all = false;
    lines_expression(r->code, gene, length, constant);
    reserve(r);
    fill_numbers(r);
}

void lines_tree_values(struct lines_run *r, const int *gene, size_t length, const struct genome_constant *constant,
                       double *value)
{
    take_tree(r, gene, length, constant);
    for (size_t row = 0; row < r->table->n; row += TAPE_BLOCK) {
        run_block(r, row);
        memcpy(value + row, r->value[r->code->root[0]], lines_rows(r, row) * sizeof *value);
    }
    r->work += (double)length * (double)r->table->n;
}

void table_values(const struct columns *table, const struct genome_constant *constant, const int *gene, size_t length,
                  double *value)
{
    struct lines_run *r = lines_run_new(NULL, table);
    lines_tree_values(r, gene, length, constant, value);
    lines_run_free(r);
}

/* Adds absolute errors to lanes that a block fills evenly. */
WIDE static void add_errors(const double *value, const double *goal, size_t n, double lane[TREE_LANES])
{
    for (size_t k = 0; k < n; k += TREE_LANES)
        for (size_t j = 0; j < TREE_LANES && k + j < n; j++)
            lane[j] += fabs(value[k + j] - goal[k + j]);
}

/* Returns the sum of lanes, added by halves, j + j + 32 and so on. */
static double sum_of_lanes(double lane[TREE_LANES])
{
    for (size_t half = TREE_LANES / 2; half > 0; half /= 2)
        for (size_t j = 0; j < half; j++)
            lane[j] += lane[j + half];
    return lane[0];
}

double lines_tree_error(struct lines_run *r, const int *gene, size_t length, const struct genome_constant *constant,
                        size_t target, double bound)
{
    const double *goal = columns_at(r->table, target);
    double sum = 0;
    take_tree(r, gene, length, constant);
    for (size_t row = 0; row < r->table->n;) {
        double lane[TREE_LANES] = {0};
        for (size_t end = row + SUM_BLOCK; row < end && row < r->table->n; row += TAPE_BLOCK) {
            run_block(r, row);
            add_errors(r->value[r->code->root[0]], goal + row, lines_rows(r, row), lane);
            r->work += (double)length * (double)lines_rows(r, row);
        }
        sum += sum_of_lanes(lane);
        if (!(sum <= bound))
            return INFINITY;
    }
    return isfinite(sum) ? sum : INFINITY;
}

/* ---- programs and their derivatives ---- */

bool lines_keep_signs(const struct lines_run *r)
{
    for (size_t i = 0; i < r->code->lines; i++)
        if (r->code->divides[i] && r->above[i] < r->table->n && r->below[i] < r->table->n)
            return false;
    return true;
}

void lines_run_load(struct lines_run *r, const struct genes *t, int last, int by)
{
    take(r, t, last, by < 0 ? LINES_APART : LINES_WHOLE, true);
    memset(r->varies, 0, r->code->lines * sizeof *r->varies);
    for (size_t i = 0; i < r->code->numbers; i++)
        r->varies[r->code->number[i]] = true;
    for (size_t i = 0; i < r->code->lines; i++) {
        const struct line *x = &r->code->line[i];
        if ((int)i == by)
            r->varies[i] = true;
        else if (line_is_operation(x))
            r->varies[i] = r->varies[x->a] || (x->b >= 0 && r->varies[x->b]);
    }
    reserve_blocks(&r->slopes, r->code->lines + 2);
}

void lines_values(struct lines_run *r, size_t row)
{
    fill_numbers(r);
    run_block(r, row);
}

WIDE static void add_block(struct lines_run *r, int line, const double *more)
{
    double *to = block_at(&r->slopes, (size_t)line + 2);
    if (r->slope[line])
        EACH to[k] += more[k];
    else
        EACH to[k] = more[k];
    r->slope[line] = to;
}

/* Computes the slopes of a line's operands in the first two blocks. */
WIDE static void pass_down(struct lines_run *r, size_t i)
{
    const struct line *x = &r->code->line[i];
    const int b = x->b >= 0 ? x->b : x->a;
    slope_of(x->gene, r->slope[i], r->value[i], r->value[x->a], r->value[b], block_at(&r->slopes, 0),
             block_at(&r->slopes, 1));
}

void lines_slopes(struct lines_run *r, int half)
{
    const struct lines *c = r->code;
    double one[TAPE_BLOCK];
    for (size_t k = 0; k < TAPE_BLOCK; k++)
        one[k] = 1;
    for (size_t i = 0; i < c->lines; i++)
        r->slope[i] = NULL;
    add_block(r, c->root[half], one);
    for (size_t i = c->lines; i-- > 0;) {
        const struct line *x = &c->line[i];
        if (!r->slope[i] || !r->varies[i] || !line_is_operation(x))
            continue;
        pass_down(r, i);
        if (r->varies[x->a])
            add_block(r, x->a, block_at(&r->slopes, 0));
        if (x->b >= 0 && r->varies[x->b])
            add_block(r, x->b, block_at(&r->slopes, 1));
    }
}
