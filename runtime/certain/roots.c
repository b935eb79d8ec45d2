/* Isolates roots by Descartes' rule of signs and halving (Vincent, Collins and Akritas; in Bernstein's basis, Lane and
 * Riesenfeld 1981).  A polynomial has at most as many roots in ]0,1[ as its coefficients change sign, and fewer only by an even
 * number.  So no change proves that there is no root, and one change that there is one.  Signs count only beyond the error of the
 * coefficient.  Halving takes means, of coefficients and of the bounds on their errors alike.  Its own rounding, 5 x 2^-101 of
 * the means of sizes each time, is part of the bounds from the start. */
#include "roots.h"

enum { HALVINGS = 64, LAST = ROOTS_DEGREE };

#define LEAST 0x1p-100 /* width */

#define FIRST (67.0 / 128.0) /* place of the first cut: later cuts then miss the roots that symmetry makes frequent */

enum verdict { NO_ROOT, ONE_ROOT, SOME_ROOTS, NOTHING_KNOWN };

/* Returns 1, -1, or 0 if the sign is undecided. */
static int sign_of(const struct roots_polynomial *p, int k)
{
    return p->c[k].high > p->error[k] ? 1 : p->c[k].high < -p->error[k] ? -1 : 0;
}

/* An undecided sign between two signs that differ is one change; elsewhere it might be two. */
static enum verdict judge(const struct roots_polynomial *p)
{
    int changes = 0, unknown = 0, last = 0, known = 0, doubt = 0;
    for (int k = 0; k <= LAST; k++) {
        const int sign = sign_of(p, k);
        if (sign == 0) {
            unknown++;
            continue;
        }
        known++;
        doubt |= unknown > 0 && sign == last;
        changes += last != 0 && sign != last;
        last = sign;
        unknown = 0;
    }
    if (known == 0)
        return NOTHING_KNOWN;
    if (doubt || sign_of(p, 0) == 0 || sign_of(p, LAST) == 0)
        return SOME_ROOTS;
    return changes == 0 ? NO_ROOT : changes == 1 ? ONE_ROOT : SOME_ROOTS;
}

static struct twofold between(struct twofold a, struct twofold b, double at)
{
    if (at == 0.5)
        return twofold_scale(0.5, twofold_add(a, b));
    return twofold_add(a, twofold_multiply(twofold_of(at), twofold_subtract(b, a)));
}

/* Splits by de Casteljau's scheme at a point of [0,1]: p keeps the right part, `left` gets the left part. */
static void split(struct roots_polynomial *p, double at, struct roots_polynomial *left)
{
    for (int n = 0; n <= LAST; n++) {
        left->c[n] = p->c[0];
        left->error[n] = p->error[0];
        for (int k = 0; k < LAST - n; k++) {
            p->c[k] = between(p->c[k], p->c[k + 1], at);
            p->error[k] += at * (p->error[k + 1] - p->error[k]);
        }
    }
}

static struct twofold after(struct twofold low, double width)
{
    return twofold_add(low, twofold_of(width));
}

static double bound(const struct roots_polynomial *p)
{
    double most = 0.0;
    for (int k = 0; k <= LAST; k++)
        most = fmax(most, fabs(p->c[k].high) + 2.0 * p->error[k]);
    return most;
}

/* Appends an interval.  Undecided neighbours become a single interval; the last interval takes all that do not fit. */
static int append(struct roots_interval *interval, int count, struct twofold low, double width, int single,
                  const struct roots_polynomial *p)
{
    struct roots_interval *const last = interval + count - 1, *const new = interval + count;
    if (count == ROOTS_MOST ||
        (!single && count > 0 && !last->single && twofold_subtract(low, after(last->low, last->width)).high <= 0.0)) {
        last->most = fmax(last->most, count == ROOTS_MOST ? INFINITY : bound(p)); /* unknown between them */
        last->width = twofold_subtract(after(low, width), last->low).high;
        last->single = 0;
        return count;
    }
    new->low = low;
    new->width = width;
    new->single = single;
    new->most = bound(p);
    if (single)
        new->local = *p;
    return count + 1;
}

int footpoint_roots_isolate(const struct roots_polynomial *whole, struct roots_interval interval[ROOTS_MOST])
{
    struct {
        struct roots_polynomial p;
        struct twofold low;
        double width;
        int depth;
    } stack[HALVINGS + 2]; /* right parts that wait, at most one at each depth */
    int top = 0, count = 0;
    stack[0].p = *whole;
    stack[0].low = twofold_of(0.0);
    stack[0].width = 1.0;
    stack[0].depth = 0;
    while (top >= 0) {
        const enum verdict verdict = judge(&stack[top].p);
        const struct twofold low = stack[top].low;
        const double width = stack[top].width, at = stack[top].depth == 0 ? FIRST : 0.5;
        if (verdict == SOME_ROOTS && stack[top].depth < HALVINGS) {
            stack[top + 1].low = low;
            stack[top + 1].width = at * width;
            stack[top + 1].depth = ++stack[top].depth;
            stack[top].low = after(low, at * width);
            stack[top].width = (1.0 - at) * width;
            split(&stack[top].p, at, &stack[top + 1].p);
            top++;
            continue;
        }
        if (verdict != NO_ROOT)
            count = append(interval, count, low, width, verdict == ONE_ROOT, &stack[top].p);
        top--;
    }
    return count;
}

/* Keeps the part of a single interval, cut at `at`, that contains the root.  Returns 0 if the value there is nearer to 0 than `errors`
 * of its bounds. */
static int cut(struct roots_interval *interval, double at, double errors)
{
    struct roots_polynomial right = interval->local, left;
    split(&right, at, &left);
    if (!(fabs(right.c[0].high) > errors * right.error[0]))
        return 0;
    if ((right.c[0].high > 0.0) == (left.c[0].high > 0.0)) {
        interval->low = after(interval->low, at * interval->width);
        interval->width *= 1.0 - at;
        interval->local = right;
    } else {
        interval->width *= at;
        interval->local = left;
    }
    interval->most = bound(&interval->local);
    return 1;
}

/* Halves an interval, or, if the root is in the middle or next to it, cuts off the quarters at its ends. */
static int halve(struct roots_interval *interval)
{
    return cut(interval, 0.5, 1.0) || (cut(interval, 0.25, 1.0) && cut(interval, 0.625, 1.0));
}

void footpoint_roots_narrow(struct roots_interval *interval, double width)
{
    while (interval->single && interval->width > width && halve(interval))
        ;
}

struct twofold footpoint_roots_middle(const struct roots_interval *interval)
{
    struct roots_interval rest = *interval;
    while (rest.single && rest.width > LEAST && cut(&rest, 0.5, 0.0))
        ;
    return after(rest.low, 0.5 * rest.width);
}
