/* Fits of a tree's constants; see fit_constants.h.  Every loss is met by reweighted least squares: a residual counts
 * with the weight (d loss / d r) / r, and a step solves (J'WJ + lambda diag J'WJ) step = J'W r.  The derivatives J of a
 * block of samples come from one backward pass over the tree; they are never stored for all samples. */
#include "fit_constants.h"

#include "../common/simd.h"
#include "../eval/errors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double first_damping = 1e-3, least_damping = 1e-9, most_damping = 1e7, settled = 1e-6, largest = 9e9;

struct divisor {
    double sign, low, sum; /* of its first value; least and sum of sign * value */
};

struct fitter *fitter_new(const struct columns *table)
{
    struct fitter *f = new_array(1, sizeof *f);
    f->table = table;
    f->tape = tape_new(table);
    return f;
}

static void discard(struct fitter *f)
{
    products_free(&f->products);
    free(f->panel);
    free(f->normal);
    free(f->work);
    free(f->step);
    free(f->kept);
}

void fitter_free(struct fitter *f)
{
    if (!f)
        return;
    discard(f);
    free(f->divisor);
    tape_free(f->tape);
    free(f);
}

/* Room for exactly the tape's constants and the residual. */
static void reserve(struct fitter *f)
{
    const size_t count = f->tape->constants + 1;
    if (f->room != count) {
        discard(f);
        f->room = count;
        f->products = products_new(count, count);
        f->panel = new_array(count * TAPE_BLOCK, sizeof *f->panel);
        f->normal = new_array(count * count, sizeof *f->normal);
        f->work = new_array(count * count, sizeof *f->work);
        f->step = new_array(count, sizeof *f->step);
        f->kept = new_array(count, sizeof *f->kept);
    }
    if (f->gene_room < f->tape->length) {
        free(f->divisor);
        f->gene_room = f->tape->length;
        f->divisor = new_array(f->gene_room, sizeof *f->divisor);
    }
}

static inline double power_of(double t, int n)
{
    double product = 1;
    for (; n > 0; n /= 2, t *= t)
        if (n % 2 == 1)
            product *= t;
    return product;
}

/* Loss of one residual; *weight as the heading says, but for a common factor. */
static inline double loss_of(const struct loss *l, double r, double *weight)
{
    if (l->kind == LOSS_SQUARES) {
        *weight = 1;
        return r * r;
    }
    if (l->kind == LOSS_ABSOLUTE) {
        const double size = sqrt(r * r + l->scale * l->scale);
        *weight = 1 / size;
        return size;
    }
    const double t = r * r / (l->scale * l->scale);
    if (l->kind == LOSS_MOST && t > 1) {
        *weight = 1 / (t * sqrt(t));
        return 1 + l->power * (1 - 1 / sqrt(t));
    }
    *weight = power_of(t, l->power / 2 - 1);
    return *weight * t;
}

/* Watch the divisors of a block, each in the sign that it has in the first sample. */
static void watch_divisors(struct fitter *f, size_t row, size_t n)
{
    const struct tape *t = f->tape;
    for (size_t i = 0; i < t->length; i++) {
        if (t->gene[i] != GENE_DIV && t->gene[i] != GENE_PDIV)
            continue;
        const double *v = t->value[t->operand[i]];
        struct divisor *d = &f->divisor[i];
        if (row == 0)
            *d = (struct divisor){v[0] < 0 ? -1 : 1, INFINITY, 0};
        for (size_t k = 0; k < n; k++) {
            const double size = v[k] * d->sign;
            d->low = size < d->low ? size : d->low;
            d->sum += size;
        }
    }
}

static bool divisors_are_guarded(const struct fitter *f)
{
    const struct tape *t = f->tape;
    for (size_t i = 0; i < t->length; i++)
        if ((t->gene[i] == GENE_DIV || t->gene[i] == GENE_PDIV) &&
            !(f->divisor[i].low >= f->guard * f->divisor[i].sum / (double)f->table->n && f->divisor[i].sum > 0))
            return false;
    return true;
}

/* sqrt(weight) times the derivatives by the constants, and then the residual, of one block into the panel. */
static void fill_panel(struct fitter *f, const double *residual, const double *root, size_t n)
{
    struct tape *t = f->tape;
    tape_slopes(t, false);
    for (size_t j = 0; j <= t->constants; j++) {
        const double *from = j < t->constants ? t->slope[t->constant[j]] : residual;
        double *to = f->panel + j * TAPE_BLOCK;
        for (size_t k = 0; k < n; k++)
            to[k] = from[k] * root[k];
        for (size_t k = n; k < TAPE_BLOCK; k++)
            to[k] = 0;
    }
}

/* One pass over the samples: the loss and, if asked for, the normal equations. */
static double pass(struct fitter *f, size_t target, const struct loss *loss, bool equations)
{
    const double *goal = columns_at(f->table, target);
    const size_t count = f->tape->constants + 1;
    double sum = 0;
    if (equations)
        products_clear(&f->products);
    for (size_t row = 0; row < f->table->n; row += TAPE_BLOCK) {
        const size_t left = f->table->n - row, n = left < TAPE_BLOCK ? left : TAPE_BLOCK;
        double residual[TAPE_BLOCK], root[TAPE_BLOCK], lost = 0;
        tape_values(f->tape, row);
        for (size_t k = 0; k < n; k++) {
            double weight;
            residual[k] = goal[row + k] - f->tape->value[0][k];
            lost += loss_of(loss, residual[k], &weight);
            root[k] = sqrt(weight);
        }
        sum += lost;
        if (!isfinite(sum))
            return INFINITY;
        if (f->guard > 0)
            watch_divisors(f, row, n);
        if (equations) {
            const struct panel panel = {f->panel, TAPE_BLOCK};
            fill_panel(f, residual, root, n);
            products_add(&f->products, panel, panel, TAPE_BLOCK, true);
        }
    }
    if (f->guard > 0 && !divisors_are_guarded(f))
        return INFINITY;
    if (equations) {
        products_sum(&f->products, true, f->normal);
        for (size_t i = 0; i < count * count; i++)
            if (!isfinite(f->normal[i]))
                return INFINITY;
    }
    return sum;
}

double fitter_loss(struct fitter *f, size_t target, const struct loss *loss)
{
    reserve(f);
    return pass(f, target, loss, false);
}

/* The damped step; false if there is none.  The second derivative of |r|^p by r is p - 1 times (d / dr) / r. */
static bool solve(struct fitter *f, const struct loss *loss, double damping)
{
    const double newton = loss->kind == LOSS_POWER || loss->kind == LOSS_MOST ? 1.0 / (loss->power - 1) : 1;
    const size_t k = f->tape->constants, count = k + 1;
    for (size_t i = 0; i < k; i++) {
        const double own = f->normal[i * count + i];
        for (size_t j = 0; j < i; j++)
            f->work[i * k + j] = f->normal[i * count + j];
        f->work[i * k + i] = own > 0 ? own * (1 + damping) : 1;
        f->step[i] = newton * f->normal[k * count + i];
    }
    if (!cholesky_factor(f->work, k, k))
        return false;
    cholesky_forward(f->work, k, k, f->step);
    cholesky_backward(f->work, k, k, f->step);
    return true;
}

/* Add the step to the kept numbers; false if a number leaves the range of decimals. */
static bool move(struct fitter *f)
{
    struct tape *t = f->tape;
    bool good = true;
    for (size_t i = 0; i < t->constants; i++) {
        t->number[t->constant[i]] = f->kept[i] + f->step[i];
        good = good && fabs(t->number[t->constant[i]]) < largest;
    }
    return good;
}

double fitter_descend(struct fitter *f, size_t target, const struct loss *loss, int iterations)
{
    struct tape *t = f->tape;
    reserve(f);
    double now = pass(f, target, loss, true), damping = first_damping;
    while (isfinite(now) && t->constants > 0 && iterations-- > 0 && damping < most_damping) {
        for (size_t i = 0; i < t->constants; i++)
            f->kept[i] = t->number[t->constant[i]];
        const double next = solve(f, loss, damping) && move(f) ? pass(f, target, loss, false) : INFINITY;
        if (next < now) {
            const bool done = now - next < settled * now;
            damping = fmax(0.1 * damping, least_damping);
            now = next;
            if (done || iterations == 0 || !isfinite(pass(f, target, loss, true)))
                break;
        } else {
            for (size_t i = 0; i < t->constants; i++)
                t->number[t->constant[i]] = f->kept[i];
            damping *= 8;
        }
    }
    return now;
}

/* Absolute errors of the tape's tree: their mean, and into error[]. */
static double measure(struct fitter *f, size_t target, double *error)
{
    const size_t n = f->table->n;
    double sum = 0;
    for (size_t row = 0; row < n; row += TAPE_BLOCK) {
        const size_t left = n - row;
        tape_values(f->tape, row);
        memcpy(error + row, f->tape->value[0], (left < TAPE_BLOCK ? left : TAPE_BLOCK) * sizeof *error);
    }
    errors_absolute(error, columns_at(f->table, target), n);
    for (size_t i = 0; i < n; i++)
        sum += error[i];
    return sum / (double)n;
}

void fitter_descend_norm(struct fitter *f, size_t target, enum scene_norm norm, int iterations)
{
    static const double nearness[] = {1, 0.3, 0.1};
    static const int most[] = {4, 8, 16, 32}, power[] = {4, 16, 64, 256};
    double *error = new_array(f->table->n, sizeof *error);
    const size_t steps = norm == NORM_MEAN ? sizeof nearness / sizeof *nearness : sizeof power / sizeof *power;
    for (size_t i = 0; i < steps; i++) {
        const double mean = measure(f, target, error);
        struct loss loss = {LOSS_ABSOLUTE, mean * nearness[norm == NORM_MEAN ? i : 0], 0};
        if (norm == NORM_P99)
            loss = (struct loss){LOSS_MOST, errors_p99(error, f->table->n), most[i]};
        else if (norm == NORM_MAX)
            loss = (struct loss){LOSS_POWER, errors_max(error, f->table->n), power[i]};
        if (!(isfinite(mean) && loss.scale > 0))
            break;
        fitter_descend(f, target, &loss, iterations);
    }
    free(error);
}

bool fit_constants(struct fitter *f, struct objective *objective, const struct tree *in, size_t target, int iterations,
                   struct tree *out, double *error)
{
    const double before = objective_error(objective, in, target, INFINITY);
    tape_load(f->tape, in);
    fitter_descend_norm(f, target, objective->norm, iterations);
    tape_store(f->tape, out);
    *error = objective_error(objective, out, target, INFINITY);
    if (*error < before)
        return true;
    tree_copy(in, out);
    *error = before;
    return false;
}

struct columns columns_thin(const struct columns *all, size_t stride)
{
    struct columns c = columns_new((all->n + stride - 1) / stride, all->count);
    for (size_t j = 0; j < c.count; j++)
        for (size_t i = 0; i < c.n; i++)
            columns_at(&c, j)[i] = columns_at(all, j)[i * stride];
    return c;
}
