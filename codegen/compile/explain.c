/* Prints graphs as counts and in infix; see explain.h. */
#include "explain.h"

#include "../base/text.h"
#include "../graph/constant_text.h"
#include "../graph/cost.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static const char *const passes[] = {
    "simplified", "common denominators", "multiplying out", "one division for several", "early sharing", "Horner",
    "sharing"};

static bool is_named(const char *pass, const char *text)
{
    for (; *pass && *text; pass++, text++)
        if (*text != (*pass == ' ' ? '-' : (char)tolower((unsigned char)*pass)))
            return false;
    return *pass == *text;
}

bool explain_knows(const char *text)
{
    for (size_t i = 0; i < sizeof passes / sizeof *passes; i++)
        if (is_named(passes[i], text))
            return true;
    return false;
}

/* ---- infix ---- */

/* How tightly a text binds. */
enum hold { HOLD_SUM, HOLD_PRODUCT, HOLD_ATOM };

struct infix {
    const struct genome_file *file; /* not owned */
    const struct dag *dag;          /* not owned */
    char **text;                    /* owned: by node */
    enum hold *hold;                /* owned: by node */
};

static void add_operand(const struct infix *w, struct growing *to, int n, enum hold least)
{
    const bool bare = w->hold[n] >= least;
    growing_add(to, bare ? "" : "(");
    growing_add(to, w->text[n]);
    growing_add(to, bare ? "" : ")");
}

/* Writes |coef| node. */
static void add_multiple(const struct infix *w, struct growing *to, rational coef, int n)
{
    if (coef == ONE && n != 0) {
        add_operand(w, to, n, HOLD_PRODUCT);
        return;
    }
    char *c = constant_text(rational_value(coef));
    const bool quotient = strchr(c, '/') != NULL;
    growing_add(to, quotient ? "(" : "");
    growing_add(to, c);
    growing_add(to, quotient ? ")" : "");
    free(c);
    if (n == 0)
        return;
    growing_add(to, "*");
    add_operand(w, to, n, HOLD_PRODUCT);
}

static void add_value(const struct infix *w, struct growing *to, rational coef, int n, bool first)
{
    const bool negative = rational_sign(coef) < 0;
    if (first && coef == ONE && n != 0) {
        add_operand(w, to, n, HOLD_SUM);
        return;
    }
    growing_add(to, first ? (negative ? "-" : "") : negative ? " - " : " + ");
    add_multiple(w, to, rational_abs(coef), n);
}

static void add_call(const struct infix *w, struct growing *to, const struct node *node)
{
#define TEXT(gene, text, ...) [NODE_##gene - NODE_PDIV] = text,
    static const char *const choice[] = {CHOICES(TEXT)};
    const char *name =
        node->kind >= NODE_UNARY ? unary_of[node->kind - NODE_UNARY].text : choice[node->kind - NODE_PDIV];
    growing_add(to, node->kind == NODE_PDIV ? "pdiv" : name);
    for (size_t i = 0; i < node->edges; i++) {
        growing_add(to, i ? ", " : "(");
        add_value(w, to, node->edge[i].coef, node->edge[i].node, true);
    }
    growing_add(to, ")");
}

static void add_node(struct infix *w, struct growing *to, int n)
{
    const struct node *node = &w->dag->node[n];
    w->hold[n] = HOLD_ATOM;
    if (node->kind == NODE_ONE || node->kind == NODE_INPUT)
        growing_add(to, node->kind == NODE_ONE ? "1" : w->file->input[node->input]);
    else if (node->kind == NODE_SUM) {
        w->hold[n] = HOLD_SUM;
        for (size_t i = 0; i < node->edges; i++)
            add_value(w, to, node->edge[i].coef, node->edge[i].node, i == 0);
    } else if (node->kind == NODE_PRODUCT) {
        w->hold[n] = HOLD_PRODUCT;
        for (size_t i = 0; i < node->edges; i++)
            for (int power = 0; power < node->edge[i].power; power++) {
                growing_add(to, i + (size_t)power ? "*" : "");
                add_operand(w, to, node->edge[i].node, HOLD_PRODUCT);
            }
    } else if (node->kind == NODE_INVERSE) {
        w->hold[n] = HOLD_PRODUCT;
        growing_add(to, "1/");
        add_operand(w, to, node->edge[0].node, HOLD_ATOM);
    } else
        add_call(w, to, node);
}

static void print_infix(FILE *out, const struct genome_file *f, const struct dag *g)
{
    struct infix w = {f, g, new_array(g->nodes, sizeof *w.text), new_array(g->nodes, sizeof *w.hold)};
    int *uses = dag_uses(g);
    for (size_t n = 0; n < g->nodes; n++) {
        struct growing text = {0};
        if (n > 0 && !uses[n])
            continue;
        add_node(&w, &text, (int)n);
        w.text[n] = text.text;
        if (uses[n] < 2 || g->node[n].kind <= NODE_INPUT)
            continue;
        fprintf(out, "    v%zu = %s\n", n, text.text);
        free(w.text[n]);
        w.text[n] = new_format("v%zu", n);
        w.hold[n] = HOLD_ATOM;
    }
    for (size_t i = 0; i < g->outputs; i++) {
        struct growing text = {0};
        add_value(&w, &text, g->output[i].coef, g->output[i].node, true);
        fprintf(out, "    %s = %s\n", g->output_name[i], text.text);
        free(text.text);
    }
    for (size_t n = 0; n < g->nodes; n++)
        free(w.text[n]);
    free(w.text);
    free(w.hold);
    free(uses);
}

/* ---- counts ---- */

static void print_counts(FILE *out, const char *pass, const struct dag *g)
{
    struct operations ops = {0};
    int *uses = dag_uses(g);
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        if (!uses[n])
            continue;
        for (size_t i = 0; i < node->edges; i++) {
            ops.mul += node->kind == NODE_PRODUCT ? node->edge[i].power : 0;
            ops.mul += node->edge[i].node != 0 && node->edge[i].coef != ONE && node->edge[i].coef != MINUS_ONE;
        }
        ops.mul -= node->kind == NODE_PRODUCT;
        ops.add += node->kind == NODE_SUM ? (long)node->edges - 1 : 0;
        ops.div += node->kind == NODE_INVERSE || node->kind == NODE_PDIV;
        ops.compare += node_chooses(node);
        if (node->kind >= NODE_UNARY)
            unary_count(&ops, node->kind - NODE_UNARY, 1);
    }
    fprintf(out, "  %-26s %5ld mul %4ld div %5ld add %4ld sqrt %4ld compare\n", pass, ops.mul, ops.div, ops.add,
            ops.sqrt, ops.compare);
    free(uses);
}

void explain_graph(FILE *out, const struct genome_file *f, const char *pass, const char *asked, const struct dag *g)
{
    print_counts(out, pass, g);
    if (asked && is_named(pass, asked))
        print_infix(out, f, g);
}
