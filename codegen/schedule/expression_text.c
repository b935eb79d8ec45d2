/* Sums, products and functions as text; see expression_text.h. */
#include "expression_text.h"

#include "../graph/constant_text.h"

#include <stdlib.h>
#include <string.h>

enum { LINE_LENGTH = 116, MOST_SEARCHED = 64 /* constants; older ones are named anew */ };

/* ---- statements ---- */

void emitter_write(struct emitter *e, const char *head, const char *value)
{
    size_t column = 4;
    char *all = new_joined(head, value, ";\n");
    growing_add(&e->body, "    ");
    for (char *word = all; *word;) {
        char *end = word + 1;
        while (*end && *end != ' ')
            end++;
        const char kept = *end;
        *end = '\0';
        if (column + strlen(word) > LINE_LENGTH) {
            growing_add(&e->body, "\n       ");
            column = 7;
        }
        growing_add(&e->body, word);
        column += strlen(word);
        *end = kept;
        word = end;
    }
    free(all);
}

static void name_value(struct emitter *e, const char *type, char prefix, long number, const char *value, char name[32])
{
    char head[64];
    snprintf(name, 32, "%c%ld", prefix, number);
    snprintf(head, sizeof head, "%s %s = ", type, name);
    emitter_write(e, head, value);
    e->ops.temporaries++;
}

void emitter_name(struct emitter *e, char prefix, long number, const char *value, char name[32])
{
    name_value(e, "const double", prefix, number, value, name);
}

void emitter_name_constant(struct emitter *e, long number, const char *value, char name[32])
{
    name_value(e, "double", 'u', number, value, name);
}

/* ---- operations ---- */

/* As an operand of a product. */
static char *factor_text(const struct expression *t)
{
    if (!t->num)
        return new_joined("1.0", "", "");
    return t->level == SUM ? new_joined("(", t->num, ")") : new_joined(t->num, "", "");
}

char *expression_whole(const struct expression *t, enum precedence *level)
{
    *level = t->den ? PRODUCT : t->level;
    if (!t->den)
        return new_joined(t->num ? t->num : "1.0", "", "");
    char *num = factor_text(t), *all = new_joined(num, " / ", t->den);
    free(num);
    return all;
}

/* Numerator and denominator, and so their quotient, are far inside the range of double. */
static bool in_range(rational r)
{
    const fmpq *c = rational_value(r);
    return fmpz_bits(fmpq_numref(c)) < 1000 && fmpz_bits(fmpq_denref(c)) < 1000;
}

char *expression_numerator(struct emitter *e, int n)
{
    const rational c = rational_mul(e->s->scale[n], e->s->scale[e->s->dag->node[n].edge[0].node]);
    e->out_of_range |= !in_range(c);
    return c == ONE ? NULL : constant_text(rational_value(c));
}

/* x + x, or that of a name for x + x: additions without rounding error. */
static char *doubled_text(struct emitter *e, const char *x, int times)
{
    char name[32];
    char *left = new_joined("(", x, " + "), *twice = new_joined(left, x, ")");
    free(left);
    e->ops.add++;
    if (times > 1) {
        emitter_name(e, 'u', ++e->helpers, twice, name);
        free(twice);
        twice = doubled_text(e, name, times - 1);
    }
    return twice;
}

char *expression_scaled(struct emitter *e, rational coef, const struct expression *t)
{
    enum precedence level;
    const int doublings = schedule_doublings(e->s, coef);
    if (doublings > 0 && t->num && !t->den && t->level == ATOM && !strchr(t->num, '('))
        return doubled_text(e, t->num, doublings);
    if (coef == ONE)
        return t->den ? expression_whole(t, &level) : factor_text(t);
    char *c = constant_text(rational_value(coef)), *all;
    e->out_of_range |= !in_range(coef);
    if (!t->num) {
        all = t->den ? new_joined(c, " / ", t->den) : new_joined(c, "", "");
    } else {
        char *num = factor_text(t), *product = new_joined(c, " * ", num);
        e->ops.mul++;
        all = t->den ? new_joined(product, " / ", t->den) : new_joined(product, "", "");
        free(num);
        free(product);
    }
    free(c);
    return all;
}

/* ---- sums ---- */

/* size * node as a term of a sum; what several sums have is named once. */
static char *term_text(struct emitter *e, rational size, int node)
{
    char name[32];
    if (size == ONE || node == 0 || !schedule_shares_term(e->s, size, node))
        return expression_scaled(e, size, &e->text[node]);
    long *helper = &e->term_named[schedule_term(e->s->term, e->s->terms, size, node) - e->s->term];
    if (*helper) {
        if (e->text[node].den)
            e->ops.div--; /* a user that does not divide by itself after all */
        return new_format("u%ld", *helper);
    }
    char *text = expression_scaled(e, size, &e->text[node]);
    *helper = ++e->helpers;
    emitter_name(e, 'u', *helper, text, name);
    free(text);
    return new_joined(name, "", "");
}

/* Terms that share their coefficient but for signs, as size * (node +- node ...), with the sign of `first`, which comes
 * first. */
static char *group_text(struct emitter *e, const struct node *sum, const struct addend *group, size_t n,
                        const struct addend *first)
{
    struct growing inside = {0};
    if (n == 1)
        return term_text(e, first->size, sum->edge[first->edge].node);
    for (size_t k = 0; k < n; k++) {
        const struct addend *t = k == 0 ? first : &group[k - 1] < first ? &group[k - 1] : &group[k];
        char *text = expression_scaled(e, ONE, &e->text[sum->edge[t->edge].node]);
        if (k > 0) {
            growing_add(&inside, rational_sign(t->coef) != rational_sign(first->coef) ? " - " : " + ");
            e->ops.add++;
        }
        growing_add(&inside, text);
        free(text);
    }
    struct expression factor = {inside.text, NULL, SUM};
    if (schedule_doublings(e->s, first->size) > 0) { /* what is doubled is written twice: it needs a name */
        char name[32];
        emitter_name(e, 'u', ++e->helpers, inside.text, name);
        factor = (struct expression){new_joined(name, "", ""), NULL, ATOM};
        free(inside.text);
    }
    char *all = expression_scaled(e, first->size, &factor);
    free(factor.num);
    return all;
}

static bool is_negative(const struct addend *t)
{
    return rational_sign(t->coef) < 0;
}

/* The edge to begin with: a positive term, not a constant if there is another. */
static size_t first_edge(const struct node *sum, const struct addend *const *term)
{
    size_t first = 0;
    while (first < sum->edges && (is_negative(term[first]) || sum->edge[first].node == 0))
        first++;
    if (first == sum->edges)
        for (first = 0; first + 1 < sum->edges && is_negative(term[first]);)
            first++;
    return first;
}

void expression_sum(struct emitter *e, int n, struct expression *t)
{
    const struct node *node = &e->s->dag->node[n];
    struct addend *sorted = new_array(node->edges, sizeof *sorted);
    const struct addend **term = new_array(node->edges, sizeof *term); /* by edge */
    bool *done = new_array(node->edges, sizeof *done);                 /* by edge */
    struct growing all = {0};
    schedule_sort_addends(e->s, n, sorted);
    for (size_t i = 0; i < node->edges; i++)
        term[sorted[i].edge] = &sorted[i];
    const size_t first = first_edge(node, term);
    for (size_t turn = 0; turn < node->edges; turn++) {
        const size_t i = turn == 0 ? first : turn <= first ? turn - 1 : turn;
        const struct addend *from = term[i], *to = term[i] + 1;
        if (done[i])
            continue;
        while (from > sorted && from[-1].like == from->like && from->like)
            from--;
        while (to < sorted + node->edges && to->like == from->like && from->like)
            to++;
        for (const struct addend *like = from; like < to; like++)
            done[like->edge] = true;
        char *group = group_text(e, node, from, (size_t)(to - from), term[i]);
        if (all.size > 0) {
            growing_add(&all, is_negative(term[i]) ? " - " : " + ");
            e->ops.add++;
        } else if (is_negative(term[i])) {
            growing_add(&all, "-");
            e->negations++;
        }
        growing_add(&all, group);
        free(group);
    }
    t->num = all.text;
    t->level = node->edges > 1 || is_negative(term[0]) ? SUM : PRODUCT;
    free(sorted);
    free(term);
    free(done);
}

/* ---- products ---- */

void expression_product(struct emitter *e, int n, struct expression *t)
{
    const struct node *node = &e->s->dag->node[n];
    struct growing num = {0}, den = {0};
    long factors = 0, divisors = 0, written = 0;
    for (size_t i = 0; i < node->edges; i++)
        divisors += e->text[node->edge[i].node].den ? node->edge[i].power : 0;
    for (long i = 1; i < divisors; i++)
        growing_add(&den, "(");
    for (size_t i = 0; i < node->edges; i++) {
        const struct expression *part = &e->text[node->edge[i].node];
        for (int k = 0; k < node->edge[i].power; k++) {
            if (part->num || !part->den) {
                char *factor = factor_text(part);
                if (factors++)
                    growing_add(&num, " * ");
                growing_add(&num, factor);
                free(factor);
            }
            if (part->den && written++) {
                growing_add(&den, " * ");
                growing_add(&den, part->den);
                growing_add(&den, ")");
            } else if (part->den)
                growing_add(&den, part->den);
        }
    }
    t->num = num.text;
    t->den = den.text;
    e->ops.mul += factors > 1 ? factors - 1 : 0;
    if (divisors > 1) { /* divisions become one */
        e->ops.mul += divisors - 1;
        e->ops.div -= divisors - 1;
    }
    t->level = factors > 1 ? PRODUCT : ATOM;
}

/* ---- functions ---- */

/* An operand that is written twice: its name, or that of a helper that holds coef * it. */
static char *operand_name(struct emitter *e, int n, size_t i)
{
    const struct edge *edge = &e->s->dag->node[n].edge[i];
    const struct expression *t = &e->text[edge->node];
    rational coef = schedule_coefficient(e->s, n, i);
    char name[32];
    if (e->s->dag->node[n].kind == NODE_ABS)
        coef = rational_abs(coef);
    if (coef == ZERO)
        return new_joined("0.0", "", "");
    if (edge->node == 0)
        return constant_text(rational_value(coef));
    if (coef == ONE)
        return new_joined(t->num, "", "");
    char *product = expression_scaled(e, rational_abs(coef), t);
    char *value = new_joined(rational_sign(coef) < 0 ? "-" : "", product, "");
    e->negations += rational_sign(coef) < 0;
    emitter_name(e, 'u', ++e->helpers, value, name);
    free(product);
    free(value);
    return new_joined(name, "", "");
}

/* Name of a constant that is compared.  Its variable is not const, so that gcc's front end does not see through it: it
 * would turn the comparison round, and later passes would not find the one instruction that c < x ? c : x is. */
static char *constant_name(struct emitter *e, rational c)
{
    char name[32];
    size_t i = e->constants > MOST_SEARCHED ? e->constants - MOST_SEARCHED : 0;
    while (i < e->constants && e->constant[i].value != c)
        i++;
    if (i == e->constants) {
        grow_array(&e->constant, e->constants, &e->constant_room, sizeof *e->constant);
        char *value = constant_text(rational_value(c));
        e->constant[e->constants++] = (struct named_constant){c, ++e->helpers};
        emitter_name_constant(e, e->helpers, value, name);
        free(value);
    }
    return new_format("u%ld", e->constant[i].helper);
}

/* A constant comes first: c < x ? c : x passes on what is no number.  So does !(x >= c) ? x : c, which is better for
 * the second choice of a clamp on the way to an output: in a loop it needs fewer masks. */
static void expression_choice(struct emitter *e, int n, struct expression *t)
{
    const struct node *node = &e->s->dag->node[n];
    const bool least = node->kind == NODE_MIN, swap = node->edge[1].node == 0,
               constant = swap || node->edge[0].node == 0;
    char *b = operand_name(e, n, !swap);
    char *a = constant ? constant_name(e, schedule_coefficient(e->s, n, swap)) : operand_name(e, n, swap);
    if (constant && e->last[n] && node_chooses(&e->s->dag->node[node->edge[!swap].node]))
        t->num = new_format("(!(%s %s %s) ? %s : %s)", b, least ? ">=" : "<=", a, b, a);
    else
        t->num = new_format("(%s %s %s ? %s : %s)", a, least ? "<" : ">", b, a, b);
    free(a);
    free(b);
}

void expression_function(struct emitter *e, int n, struct expression *t)
{
    const enum node_kind kind = e->s->dag->node[n].kind;
    t->level = ATOM;
    e->ops.sqrt += kind == NODE_SQRT;
    e->ops.div += kind == NODE_PDIV;
    e->ops.compare += kind != NODE_SQRT;
    if (kind == NODE_MIN || kind == NODE_MAX) {
        expression_choice(e, n, t);
        return;
    }
    char *a = operand_name(e, n, 0), *b = kind == NODE_PDIV ? operand_name(e, n, 1) : NULL;
    if (kind == NODE_PDIV)
        t->num = new_format("(%s == 0.0 ? 1.0 : %s / %s)", b, a, b);
    else
        t->num = new_joined(kind == NODE_SQRT ? "sqrt(" : "fabs(", a, ")");
    free(a);
    free(b);
}
