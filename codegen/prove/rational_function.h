/* Rational functions over Q in a fixed number of variables, on FLINT's multivariate polynomials, within a work limit.
 *
 * A value is a rational times a product of powers, positive or negative, of primitive polynomials. Products and
 * quotients merely add exponents; a sum factors out what its terms share and multiplies out only the rest. The form is
 * not unique, because the polynomials may have common factors; ratio_equal accounts for this. */
#ifndef FOOTPOINT_RATIONAL_FUNCTION_H
#define FOOTPOINT_RATIONAL_FUNCTION_H

#include <flint/fmpq_mpoly.h>
#include <stdbool.h>
#include <stddef.h>

struct power {
    size_t base; /* index in the ring */
    slong exponent;
};

struct ratio {
    fmpq_t content;
    struct power *power; /* owned: by increasing base; empty for 0 */
    size_t n, room;
};

struct ring {
    fmpq_mpoly_ctx_t context;
    fmpz_mpoly_struct *base; /* owned: primitive, leading coefficient positive, all different; variables come first */
    size_t bases, base_room;
    slong variables, used; /* all, and those that ratio_set_new_variable issued */
    double work;           /* spent */
    bool stopped;          /* too much work, too many variables, or a division by 0: all results are void from then
                            * on */
};

void ring_init(struct ring *g, slong variables);
void ring_clear(struct ring *g);

void ratio_init(struct ratio *r); /* sets it to 0 */
void ratio_clear(struct ratio *r);
void ratio_set(struct ratio *r, const struct ratio *a);
void ratio_set_rational(struct ratio *r, const fmpq *q);
void ratio_set_variable(struct ratio *r, slong variable);
/** Sets r to the next unused variable; returns its number. */
slong ratio_set_new_variable(struct ring *g, struct ratio *r);

/** r must be neither a nor b. */
void ratio_add(struct ring *g, struct ratio *r, const struct ratio *a, const struct ratio *b, bool subtract);
void ratio_multiply(struct ring *g, struct ratio *r, const struct ratio *a, const struct ratio *b, bool divide);

bool ratio_is_zero(const struct ratio *r);
/** Returns true if a = (a->content / b->content) b, neither of them 0. */
bool ratio_proportional(struct ring *g, const struct ratio *a, const struct ratio *b);
bool ratio_equal(struct ring *g, const struct ratio *a, const struct ratio *b);
/** Returns true, and sets *q, if r is a constant. */
bool ratio_get_rational(struct ring *g, fmpq *q, const struct ratio *r);
/** Returns the number of terms of the longest polynomial in r. */
slong ratio_length(const struct ring *g, const struct ratio *r);

#endif
