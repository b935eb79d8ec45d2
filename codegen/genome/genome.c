/* The genome text's data structure and printer; the grammar is in genome.h, the reader in genome_read.c. */
#define _GNU_SOURCE /* tdestroy */
#include "genome.h"

#include <search.h>
#include <stdlib.h>
#include <string.h>

enum { PRINT_WIDTH = 118 };

static const struct {
    const char *name;
    int arity;
} operators[GENE_OPERATORS] = {
#define OF_TWO(gene, text, ...) {text, 2},
#define OF_ONE(gene, text, ...) {text, 1},
    GENES_OF_TWO(OF_TWO) GENES_OF_ONE(OF_ONE)};

int gene_arity(int gene)
{
    if (gene < 0 || gene >= GENE_SYMBOL)
        return 0;
    return gene < GENE_OPERATORS ? operators[gene].arity : gene == GENE_HALVES ? 2 : 1;
}

const char *gene_name(int gene)
{
    return operators[gene].name;
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

/* Names and constants are found through search trees of (text, index), so that files of any size read in bounded time.
 */
struct named {
    const char *text; /* not owned */
    size_t index;
};

static int compare_entries(const void *a, const void *b)
{
    return strcmp(((const struct named *)a)->text, ((const struct named *)b)->text);
}

static struct named *find_entry(void *const *tree, const char *text)
{
    const struct named key = {text, 0};
    struct named *const *found = tfind(&key, tree, compare_entries);
    return found ? *found : NULL;
}

static void add_entry(void **tree, const char *text, size_t index)
{
    struct named *e = new_array(1, sizeof *e);
    *e = (struct named){text, index};
    struct named *const *slot = tsearch(e, tree, compare_entries);
    if (!slot || *slot != e)
        free(e);
}

struct genome_file *genome_file_new(const char *path)
{
    struct genome_file *f = new_array(1, sizeof *f);
    f->path = new_text(path, strlen(path));
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

void genome_file_free(struct genome_file *f)
{
    if (!f)
        return;
    tdestroy(f->symbol_tree, free);
    tdestroy(f->constant_tree, free);
    free_notes(f->note, f->notes);
    free_exprs(f->let, f->lets);
    free_exprs(f->require, f->requires);
    for (size_t i = 0; i < f->functions; i++)
        free(f->function[i].name);
    free(f->function);
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
    const struct named *e = find_entry(&f->symbol_tree, name);
    return e ? (long)e->index : -1;
}

const char *genome_symbol_name(const struct genome_file *f, size_t k)
{
    return k < f->inputs ? f->input[k] : f->let[k - f->inputs].name;
}

void genome_add_exchange(struct genome_file *f, size_t a, size_t b)
{
    grow_array(&f->exchange, f->exchanges, &f->exchange_room, sizeof *f->exchange);
    f->exchange[f->exchanges][0] = a;
    f->exchange[f->exchanges++][1] = b;
}

void genome_add_function(struct genome_file *f, const char *name, const size_t from[2], const size_t to[2])
{
    grow_array(&f->function, f->functions, &f->function_room, sizeof *f->function);
    f->function[f->functions++] =
        (struct genome_function){new_text(name, strlen(name)), {from[0], from[1]}, {to[0], to[1]}};
}

long genome_find_function(const struct genome_file *f, const char *name)
{
    for (size_t i = 0; i < f->functions; i++)
        if (strcmp(f->function[i].name, name) == 0)
            return (long)i;
    return -1;
}

size_t genome_add_constant(struct genome_file *f, const char *text)
{
    const struct named *e = find_entry(&f->constant_tree, text);
    if (e)
        return e->index;
    grow_array(&f->constant, f->constants, &f->constant_room, sizeof *f->constant);
    f->constant[f->constants] = (struct genome_constant){new_text(text, strlen(text)), strtod(text, NULL)};
    add_entry(&f->constant_tree, f->constant[f->constants].text, f->constants);
    return f->constants++;
}

void genome_add_note(struct genome_note **note, size_t *n, size_t *room, const char *key, const char *format, ...)
{
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    grow_array(note, *n, room, sizeof **note);
    (*note)[*n] = (struct genome_note){new_text(key, strlen(key)), new_text(text, strlen(text))};
    ++*n;
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
    add_entry(&f->symbol_tree, f->input[f->inputs], f->inputs);
    f->inputs++;
}

void genome_add_expr(struct genome_expr **e, size_t *n, size_t *room, const char *name, const int *gene, size_t length)
{
    grow_array(e, *n, room, sizeof **e);
    struct genome_expr *x = &(*e)[(*n)++];
    x->name = new_text(name, strlen(name));
    x->gene = new_array(length, sizeof *x->gene);
    memcpy(x->gene, gene, length * sizeof *gene);
    x->length = length;
}

void genome_add_let(struct genome_file *f, const char *name, const int *gene, size_t length)
{
    genome_add_expr(&f->let, &f->lets, &f->let_room, name, gene, length);
    add_entry(&f->symbol_tree, f->let[f->lets - 1].name, f->inputs + f->lets - 1);
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

static const char *gene_text(const struct genome_file *f, int gene)
{
    if (gene < 0)
        return f->constant[-1 - gene].text;
    return gene < GENE_OPERATORS ? gene_name(gene) : genome_symbol_name(f, (size_t)(gene - GENE_SYMBOL));
}

/* Words go on one line up to the width, then on indented ones. */
static void print_words(const struct genome_file *f, const struct genome_expr *e, size_t column, FILE *stream)
{
    for (size_t i = 0; i < e->length; i++) {
        const char *word = gene_text(f, e->gene[i]);
        const size_t width = strlen(word) + 1;
        if (column + width > PRINT_WIDTH && i > 0) {
            fputs("\n   ", stream);
            column = 3;
        }
        fprintf(stream, "%s%s", column ? " " : "", word);
        column += width;
    }
}

static void print_notes(const struct genome_note *note, size_t n, FILE *stream)
{
    for (size_t i = 0; i < n; i++)
        fprintf(stream, "note %s %s\n", note[i].key, note[i].text);
}

const char *corner_order_name(enum corner_order order)
{
    static const char *const name[] = {"any", "nearest", "nearest-shorter"};
    return name[order];
}

void genome_print(const struct genome_file *f, FILE *stream)
{
    fprintf(stream, "footpoint-genome %d\n", GENOME_FORMAT);
    print_notes(f->note, f->notes, stream);
    for (size_t i = 0, column = 0; i < f->inputs; i++) {
        if (column == 0)
            fputs("input", stream);
        column += (size_t)fprintf(stream, " %s", f->input[i]);
        if (column + 20 > PRINT_WIDTH || i + 1 == f->inputs) {
            fputc('\n', stream);
            column = 0;
        }
    }
    if (f->segment)
        fprintf(stream, "segment %s %s\n", f->segment->name, corner_order_name(f->order));
    for (size_t i = 0; i < f->inputs; i++)
        if (f->range[i].given)
            fprintf(stream, "range %s %s %s\n", f->input[i], f->constant[f->range[i].lo].text,
                    f->constant[f->range[i].hi].text);
    for (size_t i = 0; i < f->lets; i++) {
        const int column = fprintf(stream, "let %s =", f->let[i].name);
        print_words(f, &f->let[i], (size_t)column, stream);
        fputc('\n', stream);
    }
    for (size_t i = 0; i < f->exchanges; i++)
        fprintf(stream, "exchange %s %s\n", genome_symbol_name(f, f->exchange[i][0]),
                genome_symbol_name(f, f->exchange[i][1]));
    for (size_t i = 0; i < f->functions; i++) {
        const struct genome_function *x = &f->function[i];
        fprintf(stream, "function %s %s %s %s %s\n", x->name, genome_symbol_name(f, x->from[0]),
                genome_symbol_name(f, x->from[1]), genome_symbol_name(f, x->to[0]), genome_symbol_name(f, x->to[1]));
    }
    for (size_t i = 0; i < f->requires; i++) {
        const int column = fprintf(stream, "require");
        print_words(f, &f->require[i], (size_t)column, stream);
        fputc('\n', stream);
    }
    for (size_t i = 0; i < f->genomes; i++) {
        const struct genome *g = &f->genome[i];
        fprintf(stream, "\ngenome %s\n", g->name);
        print_notes(g->note, g->notes, stream);
        for (size_t k = 0; k < g->outs; k++) {
            const int column = fprintf(stream, "%s =", g->out[k].name);
            print_words(f, &g->out[k], (size_t)column, stream);
            fputc('\n', stream);
        }
        fputs("end\n", stream);
    }
}
