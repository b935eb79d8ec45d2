/* The data structure of genome text. genome.h defines the grammar, genome_read.c the reader, genome_print.c the
 * printer. */
#include "genome.h"

#include "../base/text.h"
#include "names.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    int arity;
} operators[GENE_OPERATORS] = {
#define OF_TWO(gene, text, ...) {text, 2},
#define OF_ONE(gene, text, ...) {text, 1},
    GENES_OF_TWO(OF_TWO) GENES_OF_ONE(OF_ONE)};

const struct unary unary_of[UNARIES] = {
#define LINE(gene, text, value, slope, derivative, c, fortran, latex, root) {text, c, root ? 2 : 1, root, root, !root},
    UNARY(LINE)};

int gene_arity(int gene)
{
    if (gene < 0 || gene >= GENE_SYMBOL)
        return 0;
    return gene < GENE_OPERATORS ? operators[gene].arity : 1;
}

const char *gene_name(int gene)
{
    return operators[gene].name;
}

int gene_of_name(const char *name)
{
    for (int gene = 0; gene < GENE_OPERATORS; gene++)
        if (strcmp(operators[gene].name, name) == 0)
            return gene;
    return -1;
}

size_t gene_span(const int *gene, size_t n)
{
    long missing = 1;
    for (size_t i = 0; i < n; i++) {
        missing += gene_arity(gene[i]) - 1;
        if (missing == 0)
            return i + 1;
    }
    return 0;
}

int gene_fold(const int *gene, size_t length, int (*value)(void *context, int gene, int a, int b), void *context)
{
    enum { SHORT = 64 };
    int few[SHORT], *stack = length > SHORT ? new_array(length, sizeof *stack) : few, *top = stack;
    for (size_t i = length; i-- > 0;) {
        const int operands = gene_arity(gene[i]);
        const int a = operands > 0 ? *--top : -1, b = operands > 1 ? *--top : -1;
        *top++ = value(context, gene[i], a, b);
    }
    const int root = *--top;
    if (stack != few)
        free(stack);
    return root;
}

struct genome_file *genome_file_new(const char *path)
{
    struct genome_file *f = new_array(1, sizeof *f);
    f->path = new_text(path, strlen(path));
    f->format = GENOME_FORMAT;
    return f;
}

static void free_notes(struct genome_note *note, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        free(note[i].key);
        free(note[i].text);
    }
    free(note);
}

static void free_exprs(struct genome_expr *e, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        free(e[i].name);
        free(e[i].gene);
    }
    free(e);
}

void genome_free_function(struct genome_function *x)
{
    free(x->name);
    free(x->parameter);
    free(x->result);
    names_free(x->names);
    free_exprs(x->let, x->lets);
}

void genome_file_free(struct genome_file *f)
{
    if (!f)
        return;
    names_free(f->names);
    names_free(f->constant_names);
    free_notes(f->note, f->notes);
    free_exprs(f->let, f->lets);
    free_exprs(f->require, f->requires);
    free_exprs(f->least, f->leasts);
    genome_file_free(f->region);
    for (size_t i = 0; i < f->functions; i++)
        genome_free_function(&f->function[i]);
    free(f->function);
    for (size_t i = 0; i < f->statements; i++) {
        free(f->statement[i].name);
        free(f->statement[i].text);
        free(f->statement[i].need);
    }
    free(f->statement);
    free(f->exchange);
    for (size_t i = 0; i < f->inputs; i++)
        free(f->input[i]);
    for (size_t i = 0; i < f->constants; i++)
        free(f->constant[i].text);
    for (size_t i = 0; i < f->genomes; i++) {
        free(f->genome[i].name);
        free_notes(f->genome[i].note, f->genome[i].notes);
        free_exprs(f->genome[i].out, f->genome[i].outs);
    }
    free(f->input);
    free(f->range);
    free(f->constant);
    free(f->genome);
    free(f->path);
    free(f);
}

long genome_find_symbol(const struct genome_file *f, const char *name)
{
    const struct name *n = names_find(&f->names, name);
    return n && n->kind == NAME_NUMBER ? n->gene - GENE_SYMBOL : -1;
}

const struct genome_statement *genome_find_statement(const struct genome_file *f, const char *name)
{
    const struct name *n = names_find(&f->names, name);
    return n && n->statement != NO_STATEMENT ? &f->statement[n->statement] : NULL;
}

const char *genome_symbol_name(const struct genome_file *f, size_t k)
{
    return k < f->inputs ? f->input[k] : f->let[k - f->inputs].name;
}

long genome_region_symbol(const struct genome_file *f, size_t input)
{
    char vector[4], name[NAME_ROOM];
    if (!f->segment || input >= segment_inputs(f->segment))
        return genome_find_symbol(f->region, f->input[input]);
    segment_vector_name(f->segment, input / 3, vector);
    snprintf(name, sizeof name, "%s%c", vector + (*vector == 'x'), "xyz"[input % 3]);
    return genome_find_symbol(f->region, name);
}

void genome_add_exchange(struct genome_file *f, size_t a, size_t b)
{
    grow_array(&f->exchange, f->exchanges, &f->exchange_room, sizeof *f->exchange);
    f->exchange[f->exchanges][0] = a;
    f->exchange[f->exchanges++][1] = b;
}

long genome_find_function(const struct genome_file *f, const char *name)
{
    const struct name *n = names_find(&f->names, name);
    return n && n->kind == NAME_FUNCTION ? n->gene : -1;
}

bool genome_function_of_pair(const struct genome_function *x)
{
    return x->parameters == 2 && !x->parameter[0].vector && !x->parameter[1].vector && x->results >= 2 &&
           !x->result[0].vector && !x->result[1].vector;
}

size_t genome_add_constant(struct genome_file *f, const char *text)
{
    const struct name *n = names_find(&f->constant_names, text);
    if (n)
        return (size_t)n->gene;
    grow_array(&f->constant, f->constants, &f->constant_room, sizeof *f->constant);
    f->constant[f->constants] = (struct genome_constant){new_text(text, strlen(text)), strtod(text, NULL)};
    names_add(&f->constant_names, text, NAME_CONSTANT, (int)f->constants, NO_STATEMENT);
    return f->constants++;
}

void genome_add_note(struct genome_note **note, size_t *n, size_t *room, const char *key, const char *format, ...)
{
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    APPEND(*note, *n, *room) = (struct genome_note){new_text(key, strlen(key)), new_text(text, strlen(text))};
}

const char *genome_find_note(const struct genome_note *note, size_t n, const char *key)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(note[i].key, key) == 0)
            return note[i].text;
    return NULL;
}

struct genome *genome_add(struct genome_file *f, const char *name)
{
    grow_array(&f->genome, f->genomes, &f->genome_room, sizeof *f->genome);
    f->genome[f->genomes].name = new_text(name, strlen(name));
    return &f->genome[f->genomes++];
}

void genome_add_input(struct genome_file *f, const char *name)
{
    grow_array(&f->input, f->inputs, &f->input_room, sizeof *f->input);
    grow_array(&f->range, f->inputs, &f->range_room, sizeof *f->range);
    f->input[f->inputs] = new_text(name, strlen(name));
    names_add(&f->names, name, NAME_NUMBER, GENE_SYMBOL + (int)f->inputs, NO_STATEMENT);
    f->inputs++;
}

void genome_add_segment(struct genome_file *f, const struct segment_kind *kind, enum corner_order order)
{
    f->segment = kind;
    f->order = order;
    for (size_t i = 0; i < segment_inputs(kind); i++) {
        char name[5], vector[4];
        segment_input_name(kind, i, name);
        genome_add_input(f, name);
        segment_vector_name(kind, i / 3, vector);
        if (i % 3 == 0 && f->format > 1)
            names_add(&f->names, vector + (*vector == 'x'), NAME_VECTOR, GENE_SYMBOL + (int)i, NO_STATEMENT);
    }
}

void genome_add_expr(struct genome_expr **e, size_t *n, size_t *room, const char *name, const int *gene, size_t length)
{
    struct genome_expr *x = &APPEND(*e, *n, *room);
    x->name = new_text(name, strlen(name));
    x->gene = new_array(length, sizeof *x->gene);
    memcpy(x->gene, gene, length * sizeof *gene);
    x->length = length;
}

static const char *gene_text(const struct genome_file *f, int gene)
{
    if (gene < 0)
        return f->constant[-1 - gene].text;
    if (gene >= GENE_LOCAL)
        return genome_symbol_name(f->region, (size_t)(gene - GENE_LOCAL));
    return gene < GENE_OPERATORS ? gene_name(gene) : genome_symbol_name(f, (size_t)(gene - GENE_SYMBOL));
}

char *genome_expr_text(const struct genome_file *f, const char *head, const struct genome_expr *e)
{
    struct memory *m = memory_open();
    fputs(head, m->stream);
    for (size_t i = 0; i < e->length; i++)
        fprintf(m->stream, " %s", gene_text(f, e->gene[i]));
    return memory_close(m);
}

size_t genome_statement_of(const struct genome_file *f, size_t symbol)
{
    return names_find(&f->names, genome_symbol_name(f, symbol))->statement;
}

void genome_add_let(struct genome_file *f, const char *name, const int *gene, size_t length)
{
    char *head = new_joined("let ", name, " =");
    struct genome_statement s = {.name = new_text(name, strlen(name)), .need = new_array(length, sizeof *s.need)};
    for (size_t i = 0; i < length; i++)
        if (gene[i] >= GENE_SYMBOL + (int)f->inputs)
            s.need[s.needs++] = genome_statement_of(f, (size_t)(gene[i] - GENE_SYMBOL));
    genome_add_expr(&f->let, &f->lets, &f->let_room, name, gene, length);
    names_add(&f->names, name, NAME_NUMBER, GENE_SYMBOL + (int)(f->inputs + f->lets - 1), f->statements);
    s.text = genome_expr_text(f, head, &f->let[f->lets - 1]);
    genome_add_statement(f, s);
    free(head);
}

void genome_add_statement(struct genome_file *f, struct genome_statement s)
{
    APPEND(f->statement, f->statements, f->statement_room) = s;
}

void genome_add_range(struct genome_file *f, size_t input, const char *lo, const char *hi)
{
    const size_t first = genome_add_constant(f, lo);
    f->range[input] = (struct genome_range){true, first, genome_add_constant(f, hi)};
}

void genome_add_require(struct genome_file *f, const int *gene, size_t length)
{
    genome_add_expr(&f->require, &f->requires, &f->require_room, "", gene, length);
}

const char *corner_order_name(enum corner_order order)
{
    static const char *const name[] = {"any", "nearest", "nearest-shorter"};
    return name[order];
}
