/* Graphs as text, and their values; see graph_text.h. */
#include "graph_text.h"

#include "../../codegen/base/text.h"
#include "../../codegen/graph/constant_text.h"
#include "../../codegen/graph/from_genome.h"
#include "../../codegen/program/dialects.h"

enum { POINTS = 3 };

struct genome_file *row_file(const char *genome)
{
    const char *start = strstr(genome, "genome ") ? "" : "genome g\n", *out = strchr(genome, '=') ? "" : "r = ";
    char *text = new_format("footpoint-genome 1\ninput a b c d x y z\n%s%s%s\nend\n", start, out, genome);
    struct genome_file *f = parse(text);
    free(text);
    return f;
}

char *row_code(const struct genome_file *f, const struct program *p)
{
    struct memory *m = memory_open();
    printer_free(c_statements(f, &f->genome[0], p, &c_double, m->stream));
    return memory_close(m);
}

struct dag *row_graph(const struct genome_file *f)
{
    struct diag d = {0};
    struct dag *g = simplify_genome(f, &f->genome[0], KEEP_ALL, &d);
    if (!g)
        fail_msg("%s", d.text);
    return g;
}

/* ---- text ---- */

struct writer {
    const struct genome_file *file;
    const struct dag *dag;
    char **full;             /* owned: by node, written out to the inputs; also what operands are sorted by */
    char **name;             /* owned: by node, once its statement is written */
    int *uses;               /* owned: by node */
    bool factors;            /* a product is sorted: its sums come last */
    bool naming;             /* values used more than once get statements */
    struct growing *program; /* the statements so far */
    long names, mul, add, div;
};

static char *node_text(struct writer *w, int n);

static bool is_inverse(const struct writer *w, int n)
{
    return w->dag->node[n].kind == NODE_INVERSE && !(w->naming && w->uses[n] > 1);
}

static bool is_sum(const struct writer *w, int n)
{
    return w->dag->node[n].kind == NODE_SUM && w->dag->node[n].edges > 1;
}

/* As an operand of a product, or what is divided by. */
static char *factor_text(struct writer *w, int n, bool below)
{
    char *text = node_text(w, n);
    const bool multiple = w->dag->node[n].kind == NODE_SUM && !is_sum(w, n) && *text != '-' && !below;
    if (multiple || !strpbrk(text, " -*/^") || w->dag->node[n].kind >= NODE_PDIV)
        return text;
    char *all = new_joined("(", text, ")");
    free(text);
    return all;
}

/* coef * node: alone, or as a term behind its sign, but for a first one that is positive. */
static void add_value(struct writer *w, struct growing *to, rational coef, int n, bool first, bool alone)
{
    const bool negative = rational_sign(coef) < 0;
    growing_add(to, first ? (negative ? "-" : "") : negative ? " - " : " + ");
    const rational size = rational_abs(coef);
    char *c = constant_text(rational_value(size)), *point = strstr(c, ".0");
    if (point && !point[2])
        *point = '\0';
    if (n == 0)
        growing_add(to, c);
    else {
        if (size != ONE) {
            w->mul++;
            growing_add(to, c);
            growing_add(to, "*");
        }
        const bool whole = !is_sum(w, n) || (alone && coef == ONE);
        char *text = whole ? node_text(w, n) : factor_text(w, n, false);
        growing_add(to, text);
        free(text);
    }
    free(c);
}

static const struct writer *sorter;

static int by_text(const void *a, const void *b)
{
    const struct edge *x = a, *y = b;
    const bool later = sorter->factors && is_sum(sorter, x->node);
    if (sorter->factors && later != is_sum(sorter, y->node))
        return later ? 1 : -1;
    return x->node == 0 ? -1 : y->node == 0 ? 1 : strcmp(sorter->full[x->node], sorter->full[y->node]);
}

static struct edge *sorted_edges(struct writer *w, const struct node *node)
{
    struct edge *edge = new_array(node->edges, sizeof *edge);
    for (size_t i = 0; i < node->edges; i++)
        edge[i] = node->edge[i];
    for (size_t i = 0; i < node->edges; i++)
        if (!w->full[edge[i].node])
            free(node_text(w, edge[i].node));
    w->factors = node->kind == NODE_PRODUCT;
    sorter = w;
    if (node->kind == NODE_SUM || node->kind == NODE_PRODUCT)
        qsort(edge, node->edges, sizeof *edge, by_text);
    return edge;
}

static void write_product(struct writer *w, struct growing *to, const struct edge *edge, size_t n)
{
    size_t written = 0;
    for (size_t i = 0; i < n; i++) {
        if (is_inverse(w, edge[i].node))
            continue;
        char *text = factor_text(w, edge[i].node, false), *power = new_format("^%d", edge[i].power);
        growing_add(to, written > 0 ? "*" : "");
        growing_add(to, text);
        growing_add(to, edge[i].power > 1 ? power : "");
        w->mul += edge[i].power - (written == 0);
        written++;
        free(text);
        free(power);
    }
    for (size_t i = 0; i < n; i++)
        for (int k = 0; is_inverse(w, edge[i].node) && k < edge[i].power; k++) {
            char *text = factor_text(w, w->dag->node[edge[i].node].edge[0].node, true);
            growing_add(to, written > 0 ? "/" : "1/");
            growing_add(to, text);
            w->div++;
            written++;
            free(text);
        }
}

static void write_function(struct writer *w, struct growing *to, const struct node *node)
{
    static const char *const name[] = {
        [NODE_PDIV] = "pdiv", [NODE_MIN] = "min", [NODE_MAX] = "max", [NODE_SQRT] = "sqrt", [NODE_ABS] = "abs"};
    growing_add(to, name[node->kind]);
    growing_add(to, "(");
    for (size_t i = 0; i < node->edges; i++) {
        growing_add(to, i > 0 ? "," : "");
        add_value(w, to, node->edge[i].coef, node->edge[i].node, true, true);
    }
    growing_add(to, ")");
}

/* The text of a node's operation. */
static char *operation_text(struct writer *w, int n)
{
    const struct node *node = &w->dag->node[n];
    struct growing text = {0};
    struct edge *edge = sorted_edges(w, node);
    if (node->kind == NODE_ONE)
        growing_add(&text, "1");
    else if (node->kind == NODE_INPUT)
        growing_add(&text, w->file->input[node->input]);
    else if (node->kind == NODE_SUM)
        for (size_t i = 0; i < node->edges; i++) {
            add_value(w, &text, edge[i].coef, edge[i].node, i == 0, node->edges == 1);
            w->add += i > 0;
        }
    else if (node->kind == NODE_PRODUCT)
        write_product(w, &text, edge, node->edges);
    else if (node->kind == NODE_INVERSE) {
        char *below = factor_text(w, edge[0].node, true);
        growing_add(&text, "1/");
        growing_add(&text, below);
        w->div++;
        free(below);
    } else
        write_function(w, &text, node);
    free(edge);
    return text.text;
}

static char *node_text(struct writer *w, int n)
{
    if (w->naming && w->name[n])
        return new_format("%s", w->name[n]);
    if (!w->naming && w->full[n])
        return new_format("%s", w->full[n]);
    char *text = operation_text(w, n);
    if (!w->naming)
        w->full[n] = new_format("%s", text);
    else if (w->uses[n] > 1 && w->dag->node[n].edges > 0) {
        w->name[n] = new_format("t%ld", ++w->names);
        growing_add(w->program, w->name[n]);
        growing_add(w->program, " = ");
        growing_add(w->program, text);
        growing_add(w->program, "; ");
        free(text);
        text = new_format("%s", w->name[n]);
    }
    return text;
}

static char *write_graph(struct writer *w, const struct genome_file *f, const struct dag *g)
{
    struct growing program = {0};
    *w = (struct writer){.file = f, .dag = g, .uses = dag_uses(g), .program = &program};
    w->full = new_array(g->nodes, sizeof *w->full);
    w->name = new_array(g->nodes, sizeof *w->name);
    for (size_t o = 0; o < g->outputs; o++)
        free(node_text(w, g->output[o].node));
    w->naming = true;
    w->mul = w->add = w->div = 0;
    for (size_t o = 0; o < g->outputs; o++) {
        struct growing value = {0};
        add_value(w, &value, g->output[o].coef, g->output[o].node, true, true);
        if (g->outputs > 1 || program.text) { /* a lone output of one statement needs no name */
            growing_add(&program, o > 0 ? "; " : "");
            growing_add(&program, g->output_name[o]);
            growing_add(&program, " = ");
        }
        growing_add(&program, value.text);
        free(value.text);
    }
    for (size_t n = 0; n < g->nodes; n++) {
        free(w->full[n]);
        free(w->name[n]);
    }
    free(w->full);
    free(w->name);
    free(w->uses);
    return program.text;
}

char *graph_text(const struct genome_file *f, const struct dag *g)
{
    struct writer w;
    return write_graph(&w, f, g);
}

/* ---- values ---- */

/* One operation on x and y, into x. */
static void apply(fmpq_t x, const fmpq_t y, enum node_kind kind)
{
    const bool square = fmpq_sgn(x) >= 0 && fmpz_is_square(fmpq_numref(x)) && fmpz_is_square(fmpq_denref(x));
    if (kind == NODE_ABS)
        fmpq_abs(x, x);
    else if (kind == NODE_SQRT && square) {
        fmpz_sqrt(fmpq_numref(x), fmpq_numref(x));
        fmpz_sqrt(fmpq_denref(x), fmpq_denref(x));
    } else if (kind == NODE_SQRT) {
        fmpq_mul(x, x, x);
        fmpq_add_si(x, x, 5);
    } else if (kind == NODE_PDIV && fmpq_is_zero(y))
        fmpq_one(x);
    else if (kind == NODE_PDIV)
        fmpq_div(x, x, y);
    else if ((fmpq_cmp(y, x) < 0) == (kind == NODE_MIN))
        fmpq_set(x, y);
}

static void graph_value(const struct dag *g, int n, const fmpq *input, fmpq_t x)
{
    const struct node *node = &g->node[n];
    fmpq_t y, power;
    fmpq_init(y);
    fmpq_init(power);
    fmpq_set_si(x, node->kind != NODE_SUM, 1);
    if (node->kind == NODE_INPUT)
        fmpq_set(x, &input[node->input]);
    for (size_t i = 0; i < node->edges; i++) {
        graph_value(g, node->edge[i].node, input, y);
        fmpq_pow_si(power, y, node->edge[i].power);
        if (node->kind == NODE_PRODUCT)
            fmpq_mul(x, x, power);
        else if (node->kind == NODE_INVERSE)
            fmpq_inv(x, y);
        else {
            fmpq_mul(y, y, rational_value(node->edge[i].coef));
            if (node->kind == NODE_SUM)
                fmpq_add(x, x, y);
            else if (i == 0)
                fmpq_set(x, y);
        }
    }
    if (node->kind >= NODE_PDIV)
        apply(x, y, node->kind);
    fmpq_clear(y);
    fmpq_clear(power);
}

static void read_constant(fmpq_t q, const char *text)
{
    const char *point = strchr(text, '.');
    char digits[40] = "";
    for (const char *c = text; *c; c++)
        if (*c != '.')
            strncat(digits, c, 1);
    fmpz_set_str(fmpq_numref(q), digits, 10);
    fmpz_set_ui(fmpq_denref(q), 10);
    fmpz_pow_ui(fmpq_denref(q), fmpq_denref(q), point ? strlen(point + 1) : 0);
    fmpq_canonicalise(q);
}

/* Value of an expression, read from its end with a stack. */
static void genome_value(const struct genome_file *f, const struct genome_expr *e, const fmpq *symbol, fmpq_t value)
{
    fmpq *stack = new_array(e->length + 1, sizeof *stack);
    size_t depth = 0;
    for (size_t i = 0; i <= e->length; i++)
        fmpq_init(&stack[i]);
    for (size_t i = e->length; i-- > 0;) {
        const int gene = e->gene[i];
        if (gene < 0)
            read_constant(&stack[depth++], f->constant[-1 - gene].text);
        else if (gene >= GENE_SYMBOL)
            fmpq_set(&stack[depth++], &symbol[gene - GENE_SYMBOL]);
        else {
            const bool two = gene_arity(gene) == 2;
            fmpq *x = &stack[depth - 1], *y = two ? &stack[depth - 2] : x;
            if (gene == GENE_ADD)
                fmpq_add(x, x, y);
            else if (gene == GENE_SUB)
                fmpq_sub(x, x, y);
            else if (gene == GENE_MUL)
                fmpq_mul(x, x, y);
            else if (gene == GENE_DIV)
                fmpq_div(x, x, y);
            else if (gene == GENE_NEG)
                fmpq_neg(x, x);
            else
                apply(x, y,
                      gene == GENE_PDIV   ? NODE_PDIV
                      : gene == GENE_MIN  ? NODE_MIN
                      : gene == GENE_MAX  ? NODE_MAX
                      : gene == GENE_SQRT ? NODE_SQRT
                                          : NODE_ABS);
            fmpq_swap(x, y);
            depth -= two;
        }
    }
    fmpq_set(value, &stack[0]);
    for (size_t i = 0; i <= e->length; i++)
        fmpq_clear(&stack[i]);
    free(stack);
}

void check_values(const struct genome_file *f, const struct dag *g)
{
    static const slong numerator[7] = {-17, 23, 5, -29, 31, -11, 13}; /* primes: sums of few of them are not 0 */
    const size_t symbols = f->inputs + f->lets;
    fmpq *symbol = new_array(symbols, sizeof *symbol);
    fmpq_t wanted, found;
    fmpq_init(wanted);
    fmpq_init(found);
    for (size_t i = 0; i < symbols; i++)
        fmpq_init(&symbol[i]);
    for (int point = 0; point < POINTS; point++) {
        for (size_t i = 0; i < f->inputs; i++)
            fmpq_set_si(&symbol[i], numerator[(i + (size_t)point) % 7], 6 + (ulong)point);
        for (size_t i = 0; i < f->lets; i++)
            genome_value(f, &f->let[i], symbol, &symbol[f->inputs + i]);
        assert_int_equal(g->outputs, f->genome[0].outs);
        for (size_t o = 0; o < g->outputs; o++) {
            genome_value(f, &f->genome[0].out[o], symbol, wanted);
            graph_value(g, g->output[o].node, symbol, found);
            fmpq_mul(found, found, rational_value(g->output[o].coef));
            if (!fmpq_equal(wanted, found))
                fail_msg("output %s differs at point %d", g->output_name[o], point);
        }
    }
    for (size_t i = 0; i < symbols; i++)
        fmpq_clear(&symbol[i]);
    free(symbol);
    fmpq_clear(wanted);
    fmpq_clear(found);
}

/* ---- tables ---- */

void check_graphs(graph_pass *pass, const struct graph_row *row, size_t rows)
{
    size_t wrong = 0;
    for (size_t i = 0; i < rows; i++) {
        struct genome_file *f = row_file(row[i].genome);
        struct dag *g = row_graph(f), *made = pass ? pass(g) : NULL;
        const struct dag *result = made ? made : g;
        struct writer w;
        char *before = graph_text(f, g), *text = write_graph(&w, f, result);
        const char *expected = row[i].expected ? row[i].expected : before;
        const bool counts = w.mul == row[i].mul && w.add == row[i].add && w.div == row[i].div;
        if (strcmp(text, expected) != 0 || (row[i].expected && !counts)) {
            print_message("%s\n  read     %s\n  expected %s\n  made     %s (%ld mul, %ld add, %ld div)\n",
                          row[i].genome, before, expected, text, w.mul, w.add, w.div);
            wrong++;
        }
        check_values(f, result);
        free(before);
        free(text);
        dag_free(made);
        dag_free(g);
        genome_file_free(f);
    }
    assert_int_equal(wrong, 0);
}
