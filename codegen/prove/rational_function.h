/* Rational functions over Q in a fixed number of variables, on FLINT's multivariate polynomials, within a work limit.
 *
 * A value is a rational times a product of powers, positive or negative, of primitive polynomials.  Products and
 * quotients merely add exponents; a sum takes out what its terms share, and only the rest is multiplied out.  The form
 * is not unique, as the polynomials may have factors in common; ratio_equal does not mind. */
#ifndef FOOTPOINT_RATIONAL_FUNCTION_H
#define FOOTPOINT_RATIONAL_FUNCTION_H

#include <flint/fmpq_mpoly.h>
#include <stdbool.h>
#include <stddef.h>

struct power {
    size_t base; /* of the ring */
    slong exponent;
};

struct ratio {
    fmpq_t content;
    struct power *power; /* owned: by increasing base; empty for 0 */
    size_t n, room;
};

struct ring {
    fmpq_mpoly_ctx_t context;
    fmpz_mpoly_struct *base; /* owned: primitive, leading coefficient positive, no two equal; variables are the first */
    size_t bases, base_room;
    slong variables, used; /* all, and those that ratio_set_new_variable gave out */
    double work;           /* spent */
    bool stopped;          /* too much work, too many variables, or a division by 0: results are void from here on */
};

void ring_init(struct ring *g, slong variables);
void ring_clear(struct ring *g);

void ratio_init(struct ratio *r); /* 0 */
void ratio_clear(struct ratio *r);
void ratio_set(struct ratio *r, const struct ratio *a);
void ratio_set_rational(struct ratio *r, const fmpq *q);
void ratio_set_variable(struct ratio *r, slong variable);
/** r = the next variable that is not in use; its number. */
slong ratio_set_new_variable(struct ring *g, struct ratio *r);

/** r must be neither a nor b. */
void ratio_add(struct ring *g, struct ratio *r, const struct ratio *a, const struct ratio *b, bool subtract);
void ratio_multiply(struct ring *g, struct ratio *r, const struct ratio *a, const struct ratio *b, bool divide);

bool ratio_is_zero(const struct ratio *r);
/** Whether a is a constant multiple of b, neither 0: a->content / b->content times b. */
bool ratio_proportional(struct ring *g, const struct ratio *a, const struct ratio *b);
bool ratio_equal(struct ring *g, const struct ratio *a, const struct ratio *b);
/** True if r is a constant, *q then. */
bool ratio_get_rational(struct ring *g, fmpq *q, const struct ratio *r);
/** Terms of the longest polynomial in r. */
slong ratio_length(const struct ring *g, const struct ratio *r);

#endif
