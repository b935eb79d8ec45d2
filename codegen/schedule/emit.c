/* Prints a schedule as straight-line C.  A value that is used once and short is written where it is used; any other
 * gets a name. */
#include "emit.h"

#include "expression_text.h"

#include <stdlib.h>
#include <string.h>

enum { INLINE_LENGTH = 56 };

/* Where divisions are cheap, each user of an inverse divides by itself instead of multiplying by the inverse. */
static bool divides_anew(const struct emitter *e, int n)
{
    return e->s->uses[n] > 1 && !e->named[n] && !schedule_has_numerator(e->s, n);
}

static void print_node(struct emitter *e, int n)
{
    const struct node *node = &e->s->dag->node[n];
    struct expression *t = &e->text[n];
    char name[32];
    bool divided_anew = false;
    if (node->kind == NODE_ONE)
        return;
    if (node->kind == NODE_INPUT) {
        const size_t input = (size_t)node->input;
        if (e->file->segment) {
            char vector[4];
            segment_vector_name(e->file->segment, input / 3, vector);
            t->num = new_format("%s[%zu]", vector, input % 3);
        } else
            t->num = new_joined("in_", e->file->input[input], "");
        t->level = ATOM;
        return;
    }
    if (node->kind == NODE_SUM)
        expression_sum(e, n, t);
    else if (node->kind == NODE_PRODUCT)
        expression_product(e, n, t);
    else if (node->kind == NODE_INVERSE) {
        struct expression *below = &e->text[node->edge[0].node];
        if (e->s->uses[n] == 1 && strlen(below->num) > INLINE_LENGTH - 8) { /* so that its user divides */
            emitter_name(e, 't', e->ops.temporaries + 1 - e->helpers, below->num, name);
            free(below->num);
            *below = (struct expression){new_joined(name, "", ""), NULL, ATOM};
        }
        t->num = expression_numerator(e, n);
        t->den = below->level == ATOM ? new_joined(below->num, "", "") : new_joined("(", below->num, ")");
        divided_anew = divides_anew(e, n);
        e->ops.div += divided_anew ? e->s->uses[n] : 1;
    } else
        expression_function(e, n, t);
    enum precedence level;
    char *all = expression_whole(t, &level);
    const bool plain =
        strcspn(all, " (/*+-") == strlen(all); /* a name or an input: an alias needs no name of its own */
    const bool clamps = node->kind == NODE_MIN || node->kind == NODE_MAX;
    if (!plain && !divided_anew &&
        (clamps || (e->early[n] && !t->den) || e->s->uses[n] > 1 || e->named[n] || strlen(all) > INLINE_LENGTH)) {
        emitter_name(e, 't', e->ops.temporaries + 1 - e->helpers, all, name);
        free(t->num);
        free(t->den);
        *t = (struct expression){new_joined(name, "", ""), NULL, ATOM};
    }
    free(all);
}

static rational output_coefficient(const struct schedule *s, size_t o)
{
    const struct value *v = &s->dag->output[o];
    return rational_mul(v->coef, rational_inv(s->scale[v->node]));
}

/* Values that are written twice (a square, 2x as x + x) need names; so does a divisor of more than one factor or term,
 * and what is inverted by several users.  A sum that is known before a choice is computed before it, not where it is
 * used after: else its operands would have to wait in registers. */
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
            e->early[n->edge[k].node] |=
                g->node[n->edge[k].node].kind == NODE_SUM && e->s->stage[n->edge[k].node] < e->s->stage[e->s->order[i]];
        }
    }
    for (size_t o = 0; o < g->outputs; o++)
        e->named[g->output[o].node] |= schedule_doublings(e->s, output_coefficient(e->s, o)) > 0;
    for (size_t i = 0; i < e->s->n; i++) {
        const int n = e->s->order[i];
        if (g->node[n].kind == NODE_INVERSE && divides_anew(e, n))
            e->named[g->node[n].edge[0].node] = true;
    }
}

/* What reaches an output past no choice. */
static void mark_last(struct emitter *e)
{
    const struct dag *g = e->s->dag;
    for (size_t o = 0; o < g->outputs; o++)
        e->last[g->output[o].node] = true;
    for (size_t i = e->s->n; i-- > 0;) {
        const struct node *n = &g->node[e->s->order[i]];
        for (size_t k = 0; k < n->edges && e->last[e->s->order[i]] && !node_chooses(n); k++)
            e->last[n->edge[k].node] = true;
    }
}

static void print_output(struct emitter *e, size_t o)
{
    const struct value *v = &e->s->dag->output[o];
    const rational coef = output_coefficient(e->s, o), size = rational_abs(coef);
    const bool negative = rational_sign(coef) < 0;
    enum precedence level;
    char head[100];
    char *text =
        coef == ONE ? expression_whole(&e->text[v->node], &level) : expression_scaled(e, size, &e->text[v->node]);
    char *value = new_joined(negative ? "-" : "", text, "");
    e->negations += negative;
    snprintf(head, sizeof head, "*%s%s = ", e->file->segment ? "" : "out_", e->s->dag->output_name[o]);
    emitter_write(e, head, value);
    free(text);
    free(value);
}

void emit_statements(const struct genome_file *f, const struct schedule *s, struct emission *out)
{
    struct emitter e = {.file = f, .s = s};
    e.text = new_array(s->dag->nodes, sizeof *e.text);
    e.named = new_array(s->dag->nodes, sizeof *e.named);
    e.term_named = new_array(s->terms, sizeof *e.term_named);
    e.early = new_array(s->dag->nodes, sizeof *e.early);
    e.last = new_array(s->dag->nodes, sizeof *e.last);
    mark_named(&e);
    mark_last(&e);
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
    free(e.early);
    free(e.last);
    free(e.constant);
    free(e.term_named);
    *out = (struct emission){.text = e.body.text ? e.body.text : new_joined("", "", ""),
                             .ops = e.ops,
                             .negations = e.negations,
                             .out_of_range = e.out_of_range};
}
