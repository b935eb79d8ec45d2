/* Reads and writes programs as genome text; see lines_text.h. */
#include "lines_text.h"

#include "../../codegen/base/text.h"
#include "../common/decimal.h"

#include <stdlib.h>
#include <string.h>

enum { WORD = 80 };

/* ---- from a genome ---- */

struct symbol_reader {
    struct lines *to; /* not owned */
    const struct genome_file *file;
    const struct gene_set *genes;
    int *line; /* owned: line of each symbol of the file; -1: not read yet, -2: not available to the program */
};

static int read_symbol(struct symbol_reader *r, size_t symbol);

/* Reads the expression at *gene and advances *gene past it. Returns -2 if it needs an input that the program lacks.
 * Reads operands in order, as programs store them. */
static int read_genes(struct symbol_reader *r, const int **gene)
{
    const int own = *(*gene)++, arity = gene_arity(own);
    if (arity == 0)
        return own < 0 ? lines_number(r->to, r->file->constant[-1 - own].value)
                       : read_symbol(r, (size_t)(own - GENE_SYMBOL));
    const int a = read_genes(r, gene);
    const int b = a >= 0 && arity == 2 ? read_genes(r, gene) : -1;
    return a < 0 || b < -1 ? -2 : lines_operation(r->to, own, a, b);
}

static int read_expression(struct symbol_reader *r, const struct genome_expr *e)
{
    const int *gene = e->gene;
    return read_genes(r, &gene);
}

static bool is_terminal(const struct gene_set *s, int gene)
{
    for (size_t i = 0; i < s->symbols; i++)
        if (s->symbol[i] == gene)
            return true;
    return false;
}

static int read_symbol(struct symbol_reader *r, size_t symbol)
{
    int *line = &r->line[symbol];
    if (*line != -1)
        return *line;
    const long own = genome_find_symbol(r->to->rules->program, genome_symbol_name(r->file, symbol));
    if (own >= 0 && is_terminal(r->genes, GENE_SYMBOL + (int)own))
        return *line = lines_symbol(r->to, GENE_SYMBOL + (int)own);
    return *line = symbol < r->file->inputs ? -2 : read_expression(r, &r->file->let[symbol - r->file->inputs]);
}

/* Finds the arguments, as symbols, if both expressions are results of the same function call. Otherwise returns
 * false. */
static bool find_arguments(const struct genome_file *f, const struct genome_expr *const out[2], size_t symbol[2])
{
    char argument[2][WORD];
    size_t statement[2];
    int end = 0;
    for (int k = 0; k < 2; k++) {
        if (out[k]->length != 1 || out[k]->gene[0] < GENE_SYMBOL + (int)f->inputs)
            return false;
        statement[k] = genome_statement_of(f, (size_t)(out[k]->gene[0] - GENE_SYMBOL));
    }
    const char *is = strchr(f->statement[statement[0]].text, '=');
    if (statement[0] != statement[1] || out[0]->gene[0] == out[1]->gene[0] || !is ||
        sscanf(is, "= %*s %79s %79s%n", argument[0], argument[1], &end) != 2 || is[end] != '\0')
        return false;
    for (int k = 0; k < 2; k++) {
        const long own = genome_find_symbol(f, argument[k]);
        if (own < 0)
            return false;
        symbol[k] = (size_t)own;
    }
    return true;
}

bool lines_read(struct lines *c, const struct genome_file *f, const struct genome_expr *const out[2],
                const struct gene_set *genes, bool called, size_t max, struct genes *t)
{
    const size_t symbols = f->inputs + f->lets;
    struct symbol_reader r = {c, f, genes, no_lines(symbols)};
    lines_begin(c);
    size_t argument[2];
    bool good = !called || find_arguments(f, out, argument);
    for (int k = 0; good && k < 2; k++) {
        c->root[k] = called ? read_symbol(&r, argument[k]) : read_expression(&r, out[k]);
        good = c->root[k] >= 0;
    }
    free(r.line);
    return good && lines_store(c, max, t);
}

bool lines_read_values(struct lines *c, char *const name[2], const struct gene_set *genes, size_t max, struct genes *t)
{
    const struct genome_file *f = c->rules->program;
    int gene[2];
    struct genome_expr value[2] = {{.length = 1, .gene = &gene[0]}, {.length = 1, .gene = &gene[1]}};
    for (int k = 0; k < 2; k++)
        gene[k] = GENE_SYMBOL + (int)genome_find_symbol(f, name[k]);
    return lines_read(c, f, (const struct genome_expr *const[]){&value[0], &value[1]}, genes, false, max, t);
}

bool lines_respell(struct lines *c, const struct genes *t, const struct gene_set *genes, size_t max, struct genes *to)
{
    const struct genome_file *f = c->rules->program;
    struct lines *from = lines_new(c->rules);
    lines_load(from, t, -1, LINES_INNER);
    int *map = no_lines(from->lines);
    struct symbol_reader r = {c, f, genes, no_lines(f->inputs + f->lets)};
    lines_begin(c);
    bool good = true;
    for (size_t i = 0; i < from->lines && good; i++) {
        const struct line *x = &from->line[i];
        map[i] = x->gene >= GENE_SYMBOL ? read_symbol(&r, (size_t)(x->gene - GENE_SYMBOL))
                 : x->gene < 0          ? lines_number(c, x->number)
                                        : lines_operation(c, x->gene, map[x->a], x->b >= 0 ? map[x->b] : -1);
        good = map[i] >= 0;
    }
    for (int k = 0; k < 2 && good; k++)
        c->root[k] = map[from->root[k]];
    free(r.line);
    free(map);
    lines_free(from);
    return good && lines_store(c, max, to);
}

/* ---- to lets and outputs ---- */

struct writer {
    const struct lines *code; /* not owned */
    struct genome_file *file;
    int *symbol; /* owned: by line; gene of its let, or 0 */
    int *users;  /* owned: by line; number of uses */
    int *gene;   /* owned: the expression under construction */
    size_t genes, room;
};

static void put(struct writer *w, int gene)
{
    APPEND(w->gene, w->genes, w->room) = gene;
}

static void write_line(struct writer *w, int i);

static void write_operation(struct writer *w, const struct line *x)
{
    put(w, x->gene);
    write_line(w, x->a);
    if (x->b >= 0)
        write_line(w, x->b);
}

static void write_line(struct writer *w, int i)
{
    const struct line *x = &w->code->line[i];
    char text[32];
    if (w->symbol[i]) {
        put(w, w->symbol[i]);
    } else if (x->gene >= GENE_SYMBOL) {
        put(w, x->gene);
    } else if (x->gene < 0) {
        number_shortest(x->number, text);
        put(w, -1 - (int)genome_add_constant(w->file, text));
    } else {
        write_operation(w, x);
    }
}

/* Returns true if no value and no function of the file has this name. */
static bool is_free(const struct genome_file *f, const char *name)
{
    return genome_find_symbol(f, name) < 0 && genome_find_function(f, name) < 0;
}

/* Appends the current expression as let <name>_<number>, with the next free number. Returns its gene. */
static int add_let(struct writer *w, const char *name, size_t *number)
{
    char own[WORD];
    do
        snprintf(own, sizeof own, "%.50s_%zu", name, ++*number);
    while (!is_free(w->file, own));
    genome_add_let(w->file, own, w->gene, w->genes);
    return GENE_SYMBOL + (int)genome_find_symbol(w->file, own);
}

/* Returns the first let, starting at `from`, that was written for another program and equals the current expression.
 * Returns the number of lets if there is no such let. */
static size_t find_let(const struct writer *w, size_t from)
{
    const struct genome_file *f = w->file;
    while (from < f->lets && (f->let[from].line > 0 || f->let[from].length != w->genes ||
                              memcmp(f->let[from].gene, w->gene, w->genes * sizeof *w->gene) != 0))
        from++;
    return from;
}

/* Writes lets for values used twice and for divisors. The first lets of a program may be shared with another program.
 * Lets keep their order, because codegen's choices depend on it. */
static void write_lets(struct writer *w, const char *name)
{
    const struct lines *c = w->code;
    size_t number = 0, known = 0;
    for (size_t i = 0; i < c->lines; i++) {
        if (!c->needed[i] || c->line[i].a < 0 || (w->users[i] < 2 && !c->divides[i]))
            continue;
        w->genes = 0;
        write_operation(w, &c->line[i]);
        known = number == 0 ? find_let(w, known) : w->file->lets;
        if (known < w->file->lets) {
            w->symbol[i] = GENE_SYMBOL + (int)(w->file->inputs + known);
            continue;
        }
        const bool joined = number > 0;
        w->symbol[i] = add_let(w, name, &number);
        w->file->statement[w->file->statements - 1].joined = joined;
    }
}

/* Marks the gene to be measured over the scene (sampled_region.h), so that headers may rely on its range. */
static void write_measured(struct writer *w, int gene)
{
    struct diag d;
    const struct genome_file *f = w->file;
    for (size_t i = 0; i < f->leasts; i++)
        if (f->least[i].length == 1 && f->least[i].gene[0] == gene)
            return;
    char *text = new_joined("least ", genome_symbol_name(f, (size_t)(gene - GENE_SYMBOL)), "");
    genome_read_statement(w->file, text, &d); /* cannot fail: the name exists */
    free(text);
}

/* Returns <name>_u and <name>_v for the arguments, then <name>_xi, <name>_eta, <name>_r1, ... for the results. */
static const char *part_name(const char *name, size_t k, char word[WORD])
{
    static const char *const part[] = {"u", "v", "xi", "eta"};
    if (k < 4)
        snprintf(word, WORD, "%.50s_%s", name, part[k]);
    else
        snprintf(word, WORD, "%.50s_r%zu", name, k - 3);
    return word;
}

/* Returns `name`, with a number appended if one of the call's names is taken. */
static const char *call_name(const struct writer *w, const struct genome_function *function, const char *name,
                             char own[WORD])
{
    bool good = false;
    for (int number = 1; !good; number++) {
        char word[WORD];
        snprintf(own, WORD, number > 1 ? "%.40s_%d" : "%.40s", name, number);
        good = true;
        for (size_t k = 0; k < 2 + function->results; k++)
            good = good && is_free(w->file, part_name(own, k, word));
    }
    return own;
}

/* Writes the roots as lets <name>_u and <name>_v and calls `function` on them. out: its first two results; the others
 * are marked to be measured. */
static void write_call(struct writer *w, const struct genome_function *function, const char *tier, int out[2])
{
    char word[WORD], own[WORD];
    const char *name = call_name(w, function, tier, own);
    struct diag d;
    struct memory *m = memory_open();
    for (size_t k = 0; k < 2; k++) {
        w->genes = 0;
        write_line(w, w->code->root[k]);
        genome_add_let(w->file, part_name(name, k, word), w->gene, w->genes);
    }
    fprintf(m->stream, "let");
    for (size_t k = 0; k < function->results; k++)
        fprintf(m->stream, " %s", part_name(name, 2 + k, word));
    fprintf(m->stream, " = %s %.50s_u %.50s_v", function->name, name, name);
    char *text = memory_close(m);
    genome_read_statement(w->file, text, &d); /* cannot fail: the names are new and the function exists */
    free(text);
    for (size_t k = 0; k < function->results; k++) {
        const int gene = GENE_SYMBOL + (int)genome_find_symbol(w->file, part_name(name, 2 + k, word));
        if (k < 2)
            out[k] = gene;
        else
            write_measured(w, gene);
    }
}

/* Counts the uses of each line as operand and as root. */
static void count_uses(const struct lines *c, int *uses)
{
    for (size_t i = 0; i < c->lines; i++) {
        const struct line *x = &c->line[i];
        if (!c->needed[i] || !line_is_operation(x))
            continue;
        uses[x->a]++;
        if (x->b >= 0)
            uses[x->b]++;
    }
    for (int k = 0; k < 2; k++)
        uses[c->root[k]]++;
}

void lines_expand(struct lines *c, const struct genes *t, int last, struct genome_file *f, const char *name,
                  struct genes out[2])
{
    lines_load(c, t, -1, LINES_INNER);
    struct writer w = {.code = c, .file = f};
    w.symbol = new_array(c->lines, sizeof *w.symbol);
    w.users = new_array(c->lines, sizeof *w.users);
    count_uses(c, w.users);
    write_lets(&w, name);
    for (size_t i = 0; i < c->lines; i++)
        if (c->divides[i] && w.symbol[i])
            write_measured(&w, w.symbol[i]);
    int gene[2];
    if (last >= 0)
        write_call(&w, &c->rules->program->function[last], name, gene);
    for (int k = 0; k < 2; k++) {
        w.genes = 0;
        if (last >= 0)
            put(&w, gene[k]);
        else
            write_line(&w, c->root[k]);
        out[k] = (struct genes){new_array(w.genes, sizeof *w.gene), w.genes};
        memcpy(out[k].gene, w.gene, w.genes * sizeof *w.gene);
    }
    free(w.symbol);
    free(w.users);
    free(w.gene);
}

char *lines_print(struct lines *c, const struct genes *t, int last)
{
    struct memory *m = memory_open();
    FILE *f = m->stream;
    lines_load(c, t, last, LINES_WHOLE);
    for (size_t i = 0; i < c->lines; i++) {
        const struct line *x = &c->line[i];
        if (!c->needed[i] || !line_is_operation(x))
            continue;
        fprintf(f, "%%%zu = %s", i, gene_name(x->gene));
        for (int k = 0; k < 2; k++) {
            const int from = k ? x->b : x->a;
            if (from < 0)
                continue;
            const struct line *y = &c->line[from];
            if (line_is_operation(y))
                fprintf(f, " %%%d", from);
            else if (y->gene < 0)
                fprintf(f, " %.7g", y->number);
            else
                fprintf(f, " %s", genome_symbol_name(c->rules->program, (size_t)(y->gene - GENE_SYMBOL)));
        }
        fputs("; ", f);
    }
    fprintf(f, "%%%d %%%d", c->root[0], c->root[1]);
    return memory_close(m);
}
