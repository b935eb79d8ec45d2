/* Prints a schedule as straight-line C.  A value that is used once and short is written where it is used; any other
 * gets a name.  Counting happens where printing happens, so the counts are those of the text. */
#include "emit.h"

#include <stdlib.h>
#include <string.h>

enum { INLINE_LENGTH = 56, LINE_LENGTH = 116, MOST_DIGITS = 64 };

enum precedence { ATOM, PRODUCT, SUM };

/* Text of a node: numerator, and denominator when it is a quotient not yet written out. */
struct text {
    char *num, *den;       /* owned; num NULL: 1; den NULL: none */
    enum precedence level; /* of num */
};

/* size * node, named. */
struct named_term {
    rational size;
    int node;
    char name[32];
};

struct emitter {
    const struct genome_file *file;
    const struct schedule *s;
    struct text *text; /* owned; by node */
    bool *named;       /* owned: must have a name, because it is written twice */
    struct emission *out;
    char *body; /* owned */
    size_t size, room;
    long helpers;            /* named operands that are no nodes */
    struct named_term *term; /* owned */
    size_t terms, term_room;
};

static char *join(const char *a, const char *b, const char *c)
{
    const size_t x = strlen(a), y = strlen(b), z = strlen(c);
    char *t = new_array(x + y + z + 1, 1);
    memcpy(t, a, x);
    memcpy(t + x, b, y);
    memcpy(t + x + y, c, z);
    return t;
}

/* *t += more */
static void append(char **t, const char *more)
{
    char *longer = join(*t ? *t : "", more, "");
    free(*t);
    *t = longer;
}

/* As a decimal number, which compilers round once, if it is one of not too many digits, else as a quotient. */
char *emit_rational(const fmpq_t c)
{
    fmpz_t den, scaled;
    int twos, fives;
    char *text;
    fmpz_init(den);
    fmpz_init(scaled);
    fmpz_set_ui(scaled, 2);
    twos = (int)fmpz_remove(den, fmpq_denref(c), scaled);
    fmpz_set_ui(scaled, 5);
    fives = (int)fmpz_remove(den, den, scaled);
    const int places = twos > fives ? twos : fives;
    const bool decimal = fmpz_is_one(den) && places <= MOST_DIGITS;
    if (decimal) {
        fmpz_set_ui(scaled, 10);
        fmpz_pow_ui(scaled, scaled, (unsigned long)places);
        fmpz_mul(scaled, scaled, fmpq_numref(c));
        fmpz_divexact(scaled, scaled, fmpq_denref(c));
    }
    if (decimal && fmpz_sizeinbase(scaled, 10) <= MOST_DIGITS) {
        const bool negative = fmpz_sgn(scaled) < 0;
        fmpz_abs(scaled, scaled);
        char *digits = fmpz_get_str(NULL, 10, scaled);
        const int n = (int)strlen(digits), pad = places + 1 > n ? places + 1 - n : 0;
        char *all = new_array((size_t)(n + pad) + 1, 1);
        memset(all, '0', (size_t)pad);
        memcpy(all + pad, digits, (size_t)n);
        text = new_array((size_t)(n + pad) + 5, 1);
        const int whole = n + pad - places;
        sprintf(text, "%s%.*s.%s", negative ? "-" : "", whole, all, places ? all + whole : "0");
        free(all);
        flint_free(digits);
    } else {
        char *n = fmpz_get_str(NULL, 10, fmpq_numref(c)), *d = fmpz_get_str(NULL, 10, fmpq_denref(c));
        char *left = join("(", n, ".0 / ");
        text = fmpz_is_one(fmpq_denref(c)) ? join(n, ".0", "") : join(left, d, ".0)");
        free(left);
        flint_free(n);
        flint_free(d);
    }
    fmpz_clear(den);
    fmpz_clear(scaled);
    return text;
}

static void write_body(struct emitter *e, const char *text)
{
    const size_t n = strlen(text);
    while (e->room < e->size + n + 1)
        grow_array(&e->body, e->room, &e->room, 1);
    memcpy(e->body + e->size, text, n + 1);
    e->size += n;
}

/* One statement; long ones are broken at spaces. */
static void write_statement(struct emitter *e, const char *head, const char *value)
{
    size_t column = 4;
    char *all = join(head, value, ";\n");
    write_body(e, "    ");
    for (char *word = all; *word;) {
        char *end = word + 1;
        while (*end && *end != ' ')
            end++;
        const char kept = *end;
        *end = '\0';
        if (column + strlen(word) > LINE_LENGTH) {
            write_body(e, "\n       ");
            column = 7;
        }
        write_body(e, word);
        column += strlen(word);
        *end = kept;
        word = end;
    }
    free(all);
}

static void name_value(struct emitter *e, char prefix, long number, const char *value, char name[32])
{
    char head[64];
    snprintf(name, 32, "%c%ld", prefix, number);
    snprintf(head, sizeof head, "const double %s = ", name);
    write_statement(e, head, value);
    e->out->ops.temporaries++;
}

/* `text` as an operand of a product. */
static char *factor_text(const struct text *t)
{
    if (!t->num)
        return join("1.0", "", "");
    return t->level == SUM ? join("(", t->num, ")") : join(t->num, "", "");
}

/* Numerator and denominator of a node's text as one expression; a division is counted by who creates the denominator.
 */
static char *whole_text(const struct text *t, enum precedence *level)
{
    *level = t->den ? PRODUCT : t->level;
    if (!t->den)
        return join(t->num ? t->num : "1.0", "", "");
    char *num = factor_text(t), *all = join(num, " / ", t->den);
    free(num);
    return all;
}

/* Numerator and denominator, and so their quotient, are far inside the range of double. */
static bool in_range(rational r)
{
    const fmpq *c = rational_value(r);
    return fmpz_bits(fmpq_numref(c)) < 1000 && fmpz_bits(fmpq_denref(c)) < 1000;
}

/* x + x, or that of a name for x + x: additions without rounding error. */
static char *doubled_text(struct emitter *e, const char *x, int times)
{
    char name[32];
    char *left = join("(", x, " + "), *twice = join(left, x, ")");
    free(left);
    e->out->ops.add++;
    if (times > 1) {
        name_value(e, 'u', ++e->helpers, twice, name);
        free(twice);
        twice = doubled_text(e, name, times - 1);
    }
    return twice;
}

/* coef * text for a coefficient > 0, as a factor or term; counts the operation. */
static char *scaled_text(struct emitter *e, rational coef, const struct text *t)
{
    enum precedence level;
    const int doublings = schedule_doublings(e->s, coef);
    if (doublings > 0 && t->num && !t->den && t->level == ATOM && !strchr(t->num, '('))
        return doubled_text(e, t->num, doublings);
    if (coef == ONE)
        return t->den ? whole_text(t, &level) : factor_text(t);
    char *c = emit_rational(rational_value(coef)), *all;
    e->out->out_of_range |= !in_range(coef);
    if (!t->num) {
        all = t->den ? join(c, " / ", t->den) : join(c, "", "");
    } else {
        char *num = factor_text(t), *product = join(c, " * ", num);
        e->out->ops.mul++;
        all = t->den ? join(product, " / ", t->den) : join(product, "", "");
        free(num);
        free(product);
    }
    free(c);
    return all;
}

/* size * node as a term of a sum; what several sums have is named once. */
static char *term_text(struct emitter *e, rational size, int node)
{
    if (size == ONE || node == 0 || !schedule_shares_term(e->s, size, node))
        return scaled_text(e, size, &e->text[node]);
    struct named_term *t = NULL;
    for (size_t i = 0; i < e->terms && !t; i++)
        if (e->term[i].size == size && e->term[i].node == node)
            t = &e->term[i];
    if (!t) {
        grow_array(&e->term, e->terms, &e->term_room, sizeof *e->term);
        t = &e->term[e->terms++];
        *t = (struct named_term){.size = size, .node = node};
        char *text = scaled_text(e, size, &e->text[node]);
        name_value(e, 'u', ++e->helpers, text, t->name);
        free(text);
    } else if (e->text[node].den)
        e->out->ops.div--; /* a user that does not divide by itself after all */
    return join(t->name, "", "");
}

/* A sum: terms of equal |coefficient| together, a positive one first. */
static void print_sum(struct emitter *e, int n, struct text *t)
{
    const struct node *node = &e->s->dag->node[n];
    rational *coef = new_array(node->edges, sizeof *coef);
    bool *done = new_array(node->edges, sizeof *done);
    size_t first = 0;
    for (size_t i = 0; i < node->edges; i++)
        coef[i] = schedule_coefficient(e->s, n, i);
    while (first + 1 < node->edges && (rational_sign(coef[first]) < 0 || node->edge[first].node == 0))
        first++;
    if (rational_sign(coef[first]) < 0 || node->edge[first].node == 0)
        for (first = 0; first + 1 < node->edges && rational_sign(coef[first]) < 0;)
            first++;
    for (size_t turn = 0; turn < node->edges; turn++) {
        const size_t i = turn == 0 ? first : turn <= first ? turn - 1 : turn;
        if (done[i])
            continue;
        const rational size = rational_abs(coef[i]);
        const bool negative = rational_sign(coef[i]) < 0, begins = t->num == NULL;
        const bool alone = size == ONE || node->edge[i].node == 0;
        char *group = NULL;
        size_t members = 0;
        for (size_t k = 0; k < node->edges; k++) { /* the terms +-size * node, starting with i itself */
            const size_t j = k == 0 ? i : k <= i ? k - 1 : k;
            if (done[j] || (j != i && (alone || node->edge[j].node == 0 || rational_abs(coef[j]) != size)))
                continue;
            char *term = scaled_text(e, ONE, &e->text[node->edge[j].node]);
            const bool minus = (rational_sign(coef[j]) < 0) != negative;
            if (members++) {
                append(&group, minus ? " - " : " + ");
                e->out->ops.add++;
            }
            append(&group, term);
            free(term);
            done[j] = true;
        }
        if (members == 1) {
            free(group);
            group = term_text(e, size, node->edge[i].node);
        } else if (size != ONE) {
            struct text inner = {group, NULL, SUM};
            if (schedule_doublings(e->s, size) > 0) { /* what is doubled is written twice: it needs a name */
                char name[32];
                name_value(e, 'u', ++e->helpers, group, name);
                inner = (struct text){join(name, "", ""), NULL, ATOM};
                free(group);
            }
            group = scaled_text(e, size, &inner);
            free(inner.num);
        }
        if (begins && negative)
            append(&t->num, "-");
        else if (!begins) {
            append(&t->num, negative ? " - " : " + ");
            e->out->ops.add++;
        }
        append(&t->num, group);
        free(group);
    }
    t->level = node->edges > 1 || rational_sign(coef[0]) < 0 ? SUM : PRODUCT;
    free(coef);
    free(done);
}

static void print_product(struct emitter *e, int n, struct text *t)
{
    const struct node *node = &e->s->dag->node[n];
    long factors = 0;
    for (size_t i = 0; i < node->edges; i++) {
        const struct text *part = &e->text[node->edge[i].node];
        for (int k = 0; k < node->edge[i].power; k++) {
            if (part->num || !part->den) {
                char *factor = factor_text(part);
                if (t->num)
                    append(&t->num, " * ");
                append(&t->num, factor);
                free(factor);
                factors++;
            }
            if (part->den && t->den) {
                char *both = join(t->den, " * ", part->den);
                free(t->den);
                t->den = join("(", both, ")");
                free(both);
                e->out->ops.mul++;
                e->out->ops.div--; /* two divisions become one */
            } else if (part->den)
                append(&t->den, part->den);
        }
    }
    e->out->ops.mul += factors > 1 ? factors - 1 : 0;
    t->level = factors > 1 ? PRODUCT : ATOM;
}

/* An operand that is written twice: its name, or that of a helper that holds coef * it. */
static char *operand_name(struct emitter *e, int n, size_t i)
{
    const struct edge *edge = &e->s->dag->node[n].edge[i];
    const struct text *t = &e->text[edge->node];
    rational coef = schedule_coefficient(e->s, n, i);
    char name[32];
    if (e->s->dag->node[n].kind == NODE_ABS)
        coef = rational_abs(coef);
    if (coef == ZERO)
        return join("0.0", "", "");
    if (edge->node == 0)
        return emit_rational(rational_value(coef));
    if (coef == ONE)
        return join(t->num, "", "");
    char *product = scaled_text(e, rational_abs(coef), t);
    char *value = join(rational_sign(coef) < 0 ? "-" : "", product, "");
    name_value(e, 'u', ++e->helpers, value, name);
    free(product);
    free(value);
    return join(name, "", "");
}

static void print_function(struct emitter *e, int n, struct text *t)
{
    const struct node *node = &e->s->dag->node[n];
    char *a = operand_name(e, n, 0), *b = node->edges > 1 ? operand_name(e, n, 1) : NULL, *parts[8];
    size_t k = 0;
    t->level = ATOM;
    if (node->kind == NODE_SQRT || node->kind == NODE_ABS) {
        t->num = join(node->kind == NODE_SQRT ? "sqrt(" : "fabs(", a, ")");
        e->out->ops.sqrt += node->kind == NODE_SQRT;
        e->out->ops.compare += node->kind == NODE_ABS;
    } else {
        if (node->kind == NODE_PDIV) {
            parts[k++] = join("(", b, " == 0.0 ? 1.0 : ");
            parts[k++] = join(a, " / ", b);
            e->out->ops.div++;
        } else {
            parts[k++] = join("(", a, node->kind == NODE_MIN ? " < " : " > ");
            parts[k++] = join(b, " ? ", a);
            parts[k++] = join(" : ", b, "");
        }
        parts[k++] = join(")", "", "");
        for (size_t i = 0; i < k; i++) {
            append(&t->num, parts[i]);
            free(parts[i]);
        }
        e->out->ops.compare++;
    }
    free(a);
    free(b);
}

/* Where divisions are cheap, each user of an inverse divides by itself instead of multiplying by the inverse. */
static bool divides_anew(const struct emitter *e, int n)
{
    const struct cost_model *m = e->s->model;
    const int uses = e->s->uses[n];
    return uses > 1 && !e->named[n] && (uses - 1) * m->div < uses * m->mul;
}

static void print_node(struct emitter *e, int n)
{
    const struct node *node = &e->s->dag->node[n];
    struct text *t = &e->text[n];
    char name[32];
    bool divided_anew = false;
    if (node->kind == NODE_ONE)
        return;
    if (node->kind == NODE_INPUT) {
        const char *input = e->file->input[node->input];
        if (e->file->segment) {
            snprintf(name, sizeof name, "x%c[%c]", input[1], (char)(input[0] - 'x' + '0'));
            t->num = join(name, "", "");
        } else
            t->num = join("in_", input, "");
        t->level = ATOM;
        return;
    }
    if (node->kind == NODE_SUM)
        print_sum(e, n, t);
    else if (node->kind == NODE_PRODUCT)
        print_product(e, n, t);
    else if (node->kind == NODE_INVERSE) {
        struct text *below = &e->text[node->edge[0].node];
        if (e->s->uses[n] == 1 && strlen(below->num) > INLINE_LENGTH - 8) { /* so that its user divides */
            name_value(e, 't', e->out->ops.temporaries + 1 - e->helpers, below->num, name);
            free(below->num);
            *below = (struct text){join(name, "", ""), NULL, ATOM};
        }
        t->den = below->level == ATOM ? join(below->num, "", "") : join("(", below->num, ")");
        divided_anew = divides_anew(e, n);
        e->out->ops.div += divided_anew ? e->s->uses[n] : 1;
    } else
        print_function(e, n, t);
    enum precedence level;
    char *all = whole_text(t, &level);
    const bool plain =
        strcspn(all, " (/*+-") == strlen(all); /* a name or an input: an alias needs no name of its own */
    if (!plain && !divided_anew && (e->s->uses[n] > 1 || e->named[n] || strlen(all) > INLINE_LENGTH)) {
        name_value(e, 't', e->out->ops.temporaries + 1 - e->helpers, all, name);
        free(t->num);
        free(t->den);
        *t = (struct text){join(name, "", ""), NULL, ATOM};
    }
    free(all);
}

/* Values that are written twice (a square, 2x as x + x) need names; so does a divisor of more than one factor or term,
 * and what is inverted by several users. */
static void mark_named(struct emitter *e)
{
    const struct dag *g = e->s->dag;
    for (size_t i = 0; i < e->s->n; i++) {
        const struct node *n = &g->node[e->s->order[i]];
        for (size_t k = 0; k < n->edges; k++) {
            bool twice = n->edge[k].power > 1 || n->kind >= NODE_PDIV;
            if (n->kind == NODE_SUM) {
                const rational coef = schedule_coefficient(e->s, e->s->order[i], k);
                twice = schedule_doublings(e->s, coef) > 0;
            }
            const bool divisor = n->kind == NODE_INVERSE && g->node[n->edge[k].node].kind != NODE_SUM;
            if (twice || divisor)
                e->named[n->edge[k].node] = true;
        }
    }
    for (size_t i = 0; i < e->s->n; i++) {
        const int n = e->s->order[i];
        if (g->node[n].kind == NODE_INVERSE && divides_anew(e, n))
            e->named[g->node[n].edge[0].node] = true;
    }
}

static void print_output(struct emitter *e, size_t o)
{
    const struct value *v = &e->s->dag->output[o];
    const rational coef = rational_mul(v->coef, rational_inv(e->s->scale[v->node])), size = rational_abs(coef);
    const bool negative = rational_sign(coef) < 0;
    enum precedence level;
    char head[100];
    char *text = coef == ONE ? whole_text(&e->text[v->node], &level) : scaled_text(e, size, &e->text[v->node]);
    char *value = join(negative ? "-" : "", text, "");
    snprintf(head, sizeof head, "*%s%s = ", e->file->segment ? "" : "out_", e->s->dag->output_name[o]);
    write_statement(e, head, value);
    free(text);
    free(value);
}

void emit_statements(const struct genome_file *f, const struct schedule *s, struct emission *out)
{
    struct emitter e = {.file = f, .s = s, .out = out};
    *out = (struct emission){0};
    e.text = new_array(s->dag->nodes, sizeof *e.text);
    e.named = new_array(s->dag->nodes, sizeof *e.named);
    mark_named(&e);
    for (size_t i = 0; i < s->n; i++)
        print_node(&e, s->order[i]);
    for (size_t o = 0; o < s->dag->outputs; o++)
        print_output(&e, o);
    for (size_t n = 0; n < s->dag->nodes; n++) {
        free(e.text[n].num);
        free(e.text[n].den);
    }
    free(e.text);
    free(e.named);
    free(e.term);
    out->text = e.body ? e.body : join("", "", "");
}
