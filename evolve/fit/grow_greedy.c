/* Orthogonal forward selection; see grow_greedy.h.  With the products of all monomials at hand, each is kept as far as
 * it is orthogonal to the chosen ones: its square and its product with what is left of the target.  No pass over the
 * samples is needed but for the first and for the fits in the objective's norm. */
#include "grow_greedy.h"

#include "fit_constants.h"
#include "monomials.h"

#include <math.h>
#include <stdlib.h>

enum { POLISH_STEPS = 6 };

struct selection {
    const double *gram; /* products of the candidates and, last, the target; not owned */
    size_t count;       /* candidates */
    size_t *chosen;     /* owned */
    size_t n;
    double *along;          /* owned: row i: products of all candidates with the i-th orthonormal direction */
    double *square, *score; /* owned: of what is left of a candidate; with what is left of the target */
};

static struct selection selection_new(const double *gram, size_t count, size_t terms)
{
    struct selection s = {.gram = gram, .count = count};
    s.chosen = new_array(terms, sizeof *s.chosen);
    s.along = new_array(terms * count, sizeof *s.along);
    s.square = new_array(count, sizeof *s.square);
    s.score = new_array(count, sizeof *s.score);
    for (size_t j = 0; j < count; j++) {
        s.square[j] = gram[j * (count + 1) + j];
        s.score[j] = gram[j * (count + 1) + count];
    }
    return s;
}

static void selection_free(struct selection *s)
{
    free(s->chosen);
    free(s->along);
    free(s->square);
    free(s->score);
}

/* Choose the candidate that takes the most from the target; false if none is left that does. */
static bool choose(struct selection *s)
{
    static const double independent = 1e-9;
    const size_t count = s->count, none = count;
    size_t best = none;
    double most = 0;
    for (size_t j = 0; j < count; j++) {
        const double gain = s->score[j] * s->score[j] / s->square[j];
        if (s->square[j] > independent * s->gram[j * (count + 1) + j] && gain > most) {
            most = gain;
            best = j;
        }
    }
    if (best == none)
        return false;
    const double root = sqrt(s->square[best]), score = s->score[best] / root;
    double *along = s->along + s->n * count;
    for (size_t j = 0; j < count; j++) {
        along[j] = s->gram[best * (count + 1) + j];
        for (size_t i = 0; i < s->n; i++)
            along[j] -= s->along[i * count + best] * s->along[i * count + j];
        along[j] /= root;
        s->square[j] -= along[j] * along[j];
        s->score[j] -= along[j] * score;
    }
    s->square[best] = 0;
    s->chosen[s->n++] = best;
    return true;
}

/* The polynomial of the monomials chosen so far, with coefficients of least squares. */
static bool write_polynomial(const struct selection *s, const struct monomial *m, double *work, struct tree *t)
{
    struct monomial *term = new_array(s->n, sizeof *term);
    double *coefficient = new_array(s->n, sizeof *coefficient);
    for (size_t i = 0; i < s->n; i++)
        term[i] = m[s->chosen[i]];
    const bool good = products_fit(s->gram, s->count + 1, s->chosen, s->n, s->count, coefficient, work) >= 0;
    if (good)
        monomials_tree(term, coefficient, s->n, t);
    free(term);
    free(coefficient);
    return good;
}

static struct monomial *candidates(const struct greedy_plan *plan, size_t *count)
{
    size_t degree = plan->degree;
    struct monomial *m = monomials_new(plan->symbol, plan->symbols, degree, count);
    while (*count > GREEDY_MONOMIALS && degree > 1) {
        free(m);
        m = monomials_new(plan->symbol, plan->symbols, --degree, count);
    }
    return m;
}

void greedy_polynomials(const struct greedy_plan *plan, struct objective *objective, size_t target,
                        struct pareto *front)
{
    size_t count;
    struct monomial *m = candidates(plan, &count);
    const size_t terms = plan->max_terms < count ? plan->max_terms : count;
    double *gram = monomials_gram(m, count, objective->table, target), *work = new_array(terms * terms, sizeof *work);
    struct selection s = selection_new(gram, count, terms);
    struct fitter *fitter = fitter_new(objective->table);
    struct tree fitted = {new_array(monomials_room(terms), sizeof *fitted.gene), 0};
    struct tree polished = {new_array(monomials_room(terms), sizeof *polished.gene), 0};
    while (s.n < terms && choose(&s) && write_polynomial(&s, m, work, &fitted)) {
        double error;
        if (fitted.length > plan->max_length)
            break;
        fit_constants(fitter, objective, &fitted, target, POLISH_STEPS, &polished, &error);
        if (isfinite(error))
            pareto_offer(front, &polished, error);
    }
    free(fitted.gene);
    free(polished.gene);
    fitter_free(fitter);
    selection_free(&s);
    free(work);
    free(gram);
    free(m);
}
