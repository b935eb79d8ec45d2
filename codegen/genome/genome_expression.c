/* Expressions of genome text: finds their types and expands vectors to expressions of numbers; see genome_reader.h. It
 * uses no recursion, because expressions may be a million operators deep. */
#include "genome_reader.h"

#include <stdlib.h>
#include <string.h>

/* Vector operators as operations on numbers: a digit means component (c + digit) % 3 of operand a or b. */
static const char dot[] = "++*a0b0*a1b1*a2b2", cross[] = "-*a1b2*a2b1";

bool read_gene(struct genome_reader *r, int *gene)
{
    char name[NAME_ROOM];
    if (word_is_operator(&r->w, r->file->format, gene))
        return true;
    if (looks_like_number(r))
        return read_number(r, gene);
    const bool fits = word_copy(&r->w, name, sizeof name);
    const struct name *n = fits ? find_name(r, name) : NULL;
    if (fits && !n && r->in_require && r->file->region) {
        const long shape = genome_find_symbol(r->file->region, name);
        if (shape >= 0) {
            *gene = GENE_LOCAL + (int)shape;
            return true;
        }
    }
    if (!n || n->kind == NAME_FUNCTION)
        return reader_fail(r, n ? "function '%s' must not be inside an expression" : "unknown gene '%s'");
    *gene = n->kind == NAME_VECTOR ? n->gene - GENE_SYMBOL + GENE_VECTOR : n->gene;
    return true;
}

bool read_symbol(struct genome_reader *r, int *gene)
{
    if (!next_word(r, true))
        return reader_fail(r, "expected a value");
    if (!read_gene(r, gene))
        return false;
    return (*gene >= GENE_SYMBOL && *gene < GENE_VECTOR) || reader_fail(r, "'%s' is not a value");
}

/* ---- types ---- */

/* Returns whether the value is a vector, or -1 if there is no such operation. */
static int is_vector(int gene, bool a, bool b)
{
    switch (gene) {
    case GENE_ADD:
    case GENE_SUB:
        return a == b ? a : -1;
    case GENE_MUL:
        return a && b ? -1 : a || b;
    case GENE_NEG:
        return a;
    case GENE_DOT:
        return a && b ? 0 : -1;
    case GENE_CROSS:
        return a && b ? 1 : -1;
    default:
        return a || b ? -1 : 0;
    }
}

static bool fail_type(struct genome_reader *r, const struct node *n, bool a, bool b)
{
    static const char *const type[] = {"a number", "a vector"};
    const char *gene = operator_name(n->gene);
    if (operator_arity(n->gene) == 1)
        return diag_at(r->d, r->file->path, n->line, n->column, "'%s' of %s", gene, type[a]);
    return diag_at(r->d, r->file->path, n->line, n->column, "'%s' of %s and %s", gene, type[a], type[b]);
}

/* Finds type and second operand of each node, from the last to the first. */
static bool find_types(struct genome_reader *r)
{
    size_t *stack = new_array(r->nodes, sizeof *stack), depth = 0;
    bool good = true;
    for (size_t i = r->nodes; good && i-- > 0;) {
        struct node *n = &r->node[i];
        const int operands = operator_arity(n->gene);
        if (operands > 0) {
            n->second = operands == 2 ? stack[depth - 2] : 0;
            const bool a = r->node[i + 1].vector, b = operands == 2 && r->node[n->second].vector;
            const int vector = is_vector(n->gene, a, b);
            good = vector >= 0 || fail_type(r, n, a, b);
            n->vector = vector > 0;
            depth -= (size_t)operands;
        }
        stack[depth++] = i;
    }
    free(stack);
    return good;
}

bool end_of_expression(struct genome_reader *r)
{
    const struct words end = r->w;
    if (!next_is_comma(r) && next_word(r, true))
        return reader_fail(r, "unexpected gene '%s' after a complete expression");
    r->w = end;
    return true;
}

bool read_expression(struct genome_reader *r, const char *name, bool more)
{
    long missing = 1;
    r->nodes = 0;
    while (missing > 0) {
        if (!next_word(r, false) || word_is_keyword(&r->w, r->file->format) || word_is(&r->w, "=") ||
            word_is(&r->w, ","))
            return diag_at(r->d, r->file->path, r->w.word_line, r->w.word_column,
                           "expression of '%s' is incomplete: %ld operand%s missing", name, missing,
                           missing == 1 ? " is" : "s are");
        struct node *n = &APPEND(r->node, r->nodes, r->node_room);
        *n = (struct node){.line = r->w.word_line, .column = r->w.word_column};
        if (!read_gene(r, &n->gene))
            return false;
        n->vector = n->gene >= GENE_VECTOR;
        missing += operator_arity(n->gene) - 1;
    }
    return (more || end_of_expression(r)) && find_types(r);
}

/* ---- expansion ---- */

static void push(struct genome_reader *r, size_t at, int component)
{
    APPEND(r->task, r->tasks, r->task_room) = (struct task){at, component};
}

static void push_products(struct genome_reader *r, size_t at, int component)
{
    const struct node *n = &r->node[at];
    const char *form = n->gene == GENE_DOT ? dot : cross;
    const int first = n->gene == GENE_DOT ? 0 : component;
    for (size_t i = strlen(form); i-- > 0;)
        switch (form[i]) {
        case 'a':
        case 'b':
            push(r, form[i] == 'a' ? at + 1 : n->second, (first + form[i + 1] - '0') % 3);
            break;
        case '+':
        case '-':
        case '*':
            push(r, form[i] == '+' ? GENE_ADD : form[i] == '-' ? GENE_SUB : GENE_MUL, -1);
            break;
        }
}

void put_gene(struct genome_reader *r, int gene)
{
    APPEND(r->gene, r->genes, r->gene_room) = gene;
}

bool expand(struct genome_reader *r, int component)
{
    r->genes = r->tasks = 0;
    push(r, 0, component);
    while (r->tasks > 0) {
        const struct task t = r->task[--r->tasks];
        if (t.component < 0) {
            put_gene(r, (int)t.at);
            continue;
        }
        const struct node *n = &r->node[t.at];
        if (n->gene == GENE_DOT || n->gene == GENE_CROSS) {
            push_products(r, t.at, t.component);
        } else if (n->gene >= GENE_VECTOR) {
            put_gene(r, n->gene - GENE_VECTOR + GENE_SYMBOL + t.component);
        } else {
            put_gene(r, n->gene);
            if (operator_arity(n->gene) == 2)
                push(r, n->second, t.component);
            if (operator_arity(n->gene) > 0)
                push(r, t.at + 1, t.component);
        }
        if (r->genes > r->nodes && r->genes + r->total > GENOME_MOST)
            return diag_at(r->d, r->file->path, r->node[0].line, r->node[0].column,
                           "expanded file must have at most %d genes", GENOME_MOST);
    }
    return true;
}

bool expand_number(struct genome_reader *r, const char *name)
{
    if (r->node[0].vector)
        return diag_at(r->d, r->file->path, r->node[0].line, r->node[0].column, "'%s' is a vector; it must be a number",
                       name);
    return expand(r, 0);
}
