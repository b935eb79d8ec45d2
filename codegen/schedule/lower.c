/* Converts a schedule to statements. A short value with a single use is written at its use; any other value gets a
 * name. Until then it is a tree of operations (operation_tree.h), numerator and denominator separate, so that its user
 * divides once. */
#include "lower.h"

#include "operation_tree.h"

#include <stdlib.h>

enum { INLINE_WIDTH = 56, MOST_SEARCHED = 64 /* constants; older constants are named again */ };

/* A node's trees. */
struct form {
    int num, den; /* NO_TREE: 1 */
    bool product; /* num's factors may be separate factors of another product */
};

struct named_constant {
    rational value;
    int tree;
};

/* A function under construction. */
struct lowering {
    struct arena arena; /* of the arrays by node and by place */
    const struct genome_file *file;
    const struct schedule *s;
    struct forest forest;
    struct form *form;               /* owned; by node */
    bool *named;                     /* owned: must have a name, because it is written twice */
    bool *early;                     /* owned: a sum used in a later stage than its own */
    bool *last;                      /* owned: reaches an output without passing a choice (min, max, protected
                                      * quotient) */
    int *shared;                     /* owned: by place in the schedule's table; the name of this term, or 0 */
    long values, parts;              /* names so far: t1, t2, ... of nodes, and u1, u2, ... of other values */
    struct named_constant *constant; /* owned */
    size_t constants, constant_room;
    long negations;
    bool out_of_range;
};

static int name_value(struct lowering *l, int tree)
{
    return forest_name(&l->forest, 't', ++l->values, tree);
}

static int name_part(struct lowering *l, int tree)
{
    return forest_name(&l->forest, 'u', ++l->parts, tree);
}

/* ---- factors ---- */

static int numerator(struct lowering *l, const struct form *x)
{
    return x->num == NO_TREE ? forest_constant(&l->forest, ONE) : x->num;
}

static int whole(struct lowering *l, const struct form *x)
{
    const int num = numerator(l, x);
    return x->den == NO_TREE ? num : forest_binary(&l->forest, OP_DIV, num, x->den);
}

/* Returns true if numerator and denominator, and so their quotient, are far inside the range of double. */
static bool in_range(rational r)
{
    const fmpq *c = rational_value(r);
    return fmpz_bits(fmpq_numref(c)) < 1000 && fmpz_bits(fmpq_denref(c)) < 1000;
}

static int factor(struct lowering *l, rational c)
{
    l->out_of_range |= !in_range(c);
    return forest_constant(&l->forest, c);
}

static int negated(struct lowering *l, int tree)
{
    l->negations++;
    return forest_negate(&l->forest, tree);
}

/* Returns x + x, or the sum of a name for x + x with itself: additions without rounding error. */
static int doubled(struct lowering *l, int x, int times)
{
    const int twice = forest_binary(&l->forest, OP_ADD, x, x);
    return times > 1 ? doubled(l, name_part(l, twice), times - 1) : twice;
}

/* Returns coef * x; coef must be > 0. */
static int scaled(struct lowering *l, rational coef, const struct form *x)
{
    const int doublings = schedule_doublings(l->s, coef);
    if (doublings > 0 && x->num != NO_TREE && x->den == NO_TREE && forest_is_name(&l->forest, x->num))
        return doubled(l, x->num, doublings);
    if (coef == ONE)
        return whole(l, x);
    struct form all = {factor(l, coef), x->den, true};
    if (x->num != NO_TREE)
        all.num = forest_multiply(&l->forest, all.num, x->num, x->product);
    return whole(l, &all);
}

/* ---- sums ---- */

static bool is_negative(const struct addend *t)
{
    return rational_sign(t->coef) < 0;
}

/* Returns size * node as a term of a sum; a term of several sums is named once. */
static int term(struct lowering *l, rational size, int node)
{
    if (size == ONE || node == 0 || !schedule_shares_term(l->s, size, node))
        return scaled(l, size, &l->form[node]);
    int *name = &l->shared[schedule_term(l->s->term, l->s->terms, size, node) - l->s->term];
    if (!*name)
        *name = name_part(l, scaled(l, size, &l->form[node]));
    return *name;
}

/* Returns terms with the same coefficient up to sign as size * (node +- node ...), with the sign of `first`, which
 * comes first. */
static int group(struct lowering *l, const struct node *sum, const struct addend *terms, size_t n,
                 const struct addend *first)
{
    struct form inside = {NO_TREE, NO_TREE, false};
    if (n == 1)
        return term(l, first->size, sum->edge[first->edge].node);
    for (size_t k = 0; k < n; k++) {
        const struct addend *t = k == 0 ? first : &terms[k - 1] < first ? &terms[k - 1] : &terms[k];
        const int tree = whole(l, &l->form[sum->edge[t->edge].node]);
        const enum op_kind kind = is_negative(t) == is_negative(first) ? OP_ADD : OP_SUB;
        inside.num = k == 0 ? tree : forest_binary(&l->forest, kind, inside.num, tree);
    }
    if (schedule_doublings(l->s, first->size) > 0) /* a doubled value is written twice and needs a name */
        inside.num = name_part(l, inside.num);
    return scaled(l, first->size, &inside);
}

/* Returns the first edge of the sum: a positive term, and a constant only if no other term is positive. */
static size_t first_edge(const struct node *sum, const struct addend *const *term_of)
{
    size_t first = 0;
    while (first < sum->edges && (is_negative(term_of[first]) || sum->edge[first].node == 0))
        first++;
    if (first == sum->edges)
        for (first = 0; first + 1 < sum->edges && is_negative(term_of[first]);)
            first++;
    return first;
}

static struct form sum_form(struct lowering *l, int n)
{
    const struct node *node = &l->s->dag->node[n];
    struct addend *sorted = new_array(node->edges, sizeof *sorted);
    const struct addend **term_of = new_array(node->edges, sizeof *term_of); /* by edge */
    bool *done = new_array(node->edges, sizeof *done);                       /* by edge */
    int all = NO_TREE;
    schedule_sort_addends(l->s, n, sorted);
    for (size_t i = 0; i < node->edges; i++)
        term_of[sorted[i].edge] = &sorted[i];
    const size_t first = first_edge(node, term_of);
    for (size_t turn = 0; turn < node->edges; turn++) {
        const size_t i = turn == 0 ? first : turn <= first ? turn - 1 : turn;
        const struct addend *from = term_of[i], *to = term_of[i] + 1;
        if (done[i])
            continue;
        while (from > sorted && from[-1].like == from->like && from->like)
            from--;
        while (to < sorted + node->edges && to->like == from->like && from->like)
            to++;
        for (const struct addend *like = from; like < to; like++)
            done[like->edge] = true;
        const int part = group(l, node, from, (size_t)(to - from), term_of[i]);
        if (all == NO_TREE)
            all = is_negative(term_of[i]) ? negated(l, part) : part;
        else
            all = forest_binary(&l->forest, is_negative(term_of[i]) ? OP_SUB : OP_ADD, all, part);
    }
    const bool product = node->edges == 1 && !is_negative(term_of[0]);
    free(sorted);
    free(term_of);
    free(done);
    return (struct form){all, NO_TREE, product};
}

/* ---- products and quotients ---- */

static struct form product_form(struct lowering *l, int n)
{
    const struct node *node = &l->s->dag->node[n];
    struct form all = {NO_TREE, NO_TREE, false};
    for (size_t i = 0; i < node->edges; i++) {
        const struct form *x = &l->form[node->edge[i].node];
        for (int k = 0; k < node->edge[i].power; k++) {
            if (all.num == NO_TREE && (x->num != NO_TREE || x->den == NO_TREE)) {
                all.num = numerator(l, x);
                all.product = x->product;
            } else if (x->num != NO_TREE || x->den == NO_TREE) {
                all.num = forest_multiply(&l->forest, all.num, numerator(l, x), x->product);
                all.product = true;
            }
            if (x->den != NO_TREE)
                all.den = all.den == NO_TREE ? x->den : forest_binary(&l->forest, OP_MUL, all.den, x->den);
        }
    }
    return all;
}

/* Returns true if each user of an inverse divides instead of multiplying by the inverse, since divisions are cheap. */
static bool divides_anew(const struct lowering *l, int n)
{
    return l->s->uses[n] > 1 && !l->named[n] && !schedule_has_numerator(l->s, n);
}

static struct form inverse_form(struct lowering *l, int n)
{
    const int below = l->s->dag->node[n].edge[0].node;
    const rational c = rational_mul(l->s->scale[n], l->s->scale[below]);
    struct form *x = &l->form[below];
    if (l->s->uses[n] == 1 && forest_width(&l->forest, x->num) > INLINE_WIDTH - 8) /* so that its user divides */
        *x = (struct form){name_value(l, x->num), NO_TREE, false};
    return (struct form){c == ONE ? NO_TREE : factor(l, c), x->num, false};
}

/* ---- functions ---- */

/* Returns an operand that is written twice: its name, or the name of coef times it. */
static int operand(struct lowering *l, int n, size_t i)
{
    const struct edge *edge = &l->s->dag->node[n].edge[i];
    const struct form *x = &l->form[edge->node];
    rational coef = schedule_coefficient(l->s, n, i);
    if (l->s->dag->node[n].kind == NODE_ABS)
        coef = rational_abs(coef);
    if (coef == ZERO || edge->node == 0)
        return forest_constant(&l->forest, coef);
    if (coef == ONE)
        return x->num;
    const int product = scaled(l, rational_abs(coef), x);
    return name_part(l, rational_sign(coef) < 0 ? negated(l, product) : product);
}

/* Names a constant that is compared. */
static int compared_constant(struct lowering *l, rational c)
{
    size_t i = l->constants > MOST_SEARCHED ? l->constants - MOST_SEARCHED : 0;
    while (i < l->constants && l->constant[i].value != c)
        i++;
    if (i == l->constants)
        APPEND(l->constant, l->constants, l->constant_room) =
            (struct named_constant){c, name_part(l, forest_constant(&l->forest, c))};
    return l->constant[i].tree;
}

/* Writes a choice. A constant comes first, as c < x ? c : x passes on NaN. !(x >= c) ? x : c also does, for a constant
 * that comes second. It is better for the second choice of a clamp near an output: in a loop it needs fewer masks if
 * compilers know the constant. */
static int choice(struct lowering *l, int n)
{
    const struct node *node = &l->s->dag->node[n];
    const enum op_kind kind = node->kind == NODE_MIN ? OP_MIN : OP_MAX;
    const bool swap = node->edge[1].node == 0, constant = swap || node->edge[0].node == 0;
    const int b = operand(l, n, !swap);
    const int a = constant ? compared_constant(l, schedule_coefficient(l->s, n, swap)) : operand(l, n, swap);
    const bool second = constant && !program_hides_constants(l->file) && l->last[n] &&
                        node_chooses(&l->s->dag->node[node->edge[!swap].node]);
    return forest_binary(&l->forest, kind, second ? b : a, second ? a : b);
}

static int function_tree(struct lowering *l, int n)
{
    const enum node_kind kind = l->s->dag->node[n].kind;
    if (kind == NODE_MIN || kind == NODE_MAX)
        return choice(l, n);
    const int a = operand(l, n, 0);
    if (kind == NODE_PDIV)
        return forest_binary(&l->forest, OP_PDIV, a, operand(l, n, 1));
    return forest_unary(&l->forest, OP_UNARY + (kind - NODE_UNARY), a);
}

/* ---- statements ---- */

static void lower_node(struct lowering *l, int n)
{
    const struct node *node = &l->s->dag->node[n];
    struct form *x = &l->form[n];
    bool divided_anew = false;
    *x = (struct form){NO_TREE, NO_TREE, false};
    if (node->kind == NODE_ONE)
        return;
    if (node->kind == NODE_INPUT) {
        x->num = forest_input(&l->forest, node->input);
        return;
    }
    if (node->kind == NODE_SUM)
        *x = sum_form(l, n);
    else if (node->kind == NODE_PRODUCT)
        *x = product_form(l, n);
    else if (node->kind == NODE_INVERSE) {
        *x = inverse_form(l, n);
        divided_anew = divides_anew(l, n);
    } else
        x->num = function_tree(l, n);
    if (divided_anew || (x->den == NO_TREE && forest_is_plain(&l->forest, numerator(l, x))))
        return; /* an alias needs no name */
    const bool clamps = node->kind == NODE_MIN || node->kind == NODE_MAX, early = l->early[n] && x->den == NO_TREE;
    const int all = whole(l, x);
    if (clamps || early || l->s->uses[n] > 1 || l->named[n] || forest_width(&l->forest, all) > INLINE_WIDTH)
        *x = (struct form){name_value(l, all), NO_TREE, false};
}

static rational output_coefficient(const struct schedule *s, size_t o)
{
    const struct value *v = &s->dag->output[o];
    return rational_mul(v->coef, rational_inv(s->scale[v->node]));
}

/* Marks values that need names: values written twice (a square, 2x as x + x), divisors of more than one factor or term,
 * and arguments of inverses with several users. A sum that is known before a choice is computed before it, not at a
 * later use; otherwise its operands would occupy registers. */
static void mark_named(struct lowering *l)
{
    const struct dag *g = l->s->dag;
    for (size_t i = 0; i < l->s->n; i++) {
        const struct node *n = &g->node[l->s->order[i]];
        for (size_t k = 0; k < n->edges; k++) {
            bool twice = n->edge[k].power > 1 || n->kind >= NODE_PDIV;
            if (n->kind == NODE_SUM) {
                const rational coef = schedule_coefficient(l->s, l->s->order[i], k);
                twice = schedule_doublings(l->s, coef) > 0;
            }
            const bool divisor = n->kind == NODE_INVERSE && g->node[n->edge[k].node].kind != NODE_SUM;
            if (twice || divisor)
                l->named[n->edge[k].node] = true;
            l->early[n->edge[k].node] |=
                g->node[n->edge[k].node].kind == NODE_SUM && l->s->stage[n->edge[k].node] < l->s->stage[l->s->order[i]];
        }
    }
    for (size_t o = 0; o < g->outputs; o++)
        l->named[g->output[o].node] |= schedule_doublings(l->s, output_coefficient(l->s, o)) > 0;
    for (size_t i = 0; i < l->s->n; i++) {
        const int n = l->s->order[i];
        if (g->node[n].kind == NODE_INVERSE && divides_anew(l, n))
            l->named[g->node[n].edge[0].node] = true;
    }
}

/* Marks values that reach an output without passing a choice. */
static void mark_last(struct lowering *l)
{
    const struct dag *g = l->s->dag;
    for (size_t o = 0; o < g->outputs; o++)
        l->last[g->output[o].node] = true;
    for (size_t i = l->s->n; i-- > 0;) {
        const struct node *n = &g->node[l->s->order[i]];
        for (size_t k = 0; k < n->edges && l->last[l->s->order[i]] && !node_chooses(n); k++)
            l->last[n->edge[k].node] = true;
    }
}

static void lower_output(struct lowering *l, size_t o)
{
    const struct value *v = &l->s->dag->output[o];
    const rational coef = output_coefficient(l->s, o);
    const int size = scaled(l, rational_abs(coef), &l->form[v->node]);
    forest_output(&l->forest, l->s->dag->output_name[o], rational_sign(coef) < 0 ? negated(l, size) : size);
}

void lower(const struct genome_file *f, const struct schedule *s, struct lowered *to)
{
    struct lowering l = {.file = f, .s = s, .forest = forest_new(f, s->dag->outputs)};
    l.form = arena_array(&l.arena, s->dag->nodes, sizeof *l.form);
    l.named = arena_array(&l.arena, s->dag->nodes, sizeof *l.named);
    l.shared = arena_array(&l.arena, s->terms, sizeof *l.shared);
    l.early = arena_array(&l.arena, s->dag->nodes, sizeof *l.early);
    l.last = arena_array(&l.arena, s->dag->nodes, sizeof *l.last);
    mark_named(&l);
    mark_last(&l);
    for (size_t i = 0; i < s->n; i++)
        lower_node(&l, s->order[i]);
    for (size_t o = 0; o < s->dag->outputs; o++)
        lower_output(&l, o);
    *to = (struct lowered){forest_take(&l.forest), {0}, l.negations, l.out_of_range};
    to->ops = program_count(to->program);
    arena_free(&l.arena);
    free(l.constant);
}
