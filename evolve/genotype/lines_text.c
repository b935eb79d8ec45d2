/* Programs and genome files; see lines_text.h. */
#include "lines_text.h"

#include "../common/decimal.h"

#include <stdlib.h>
#include <string.h>

enum { WORD = 80 };

/* ---- from a genome ---- */

struct reader {
    struct lines *to; /* not owned, as are these */
    const struct genome_file *file;
    const struct gene_set *genes;
    int *line; /* owned: by symbol of the file; -1: not read yet, -2: it is no value of the program */
};

static int read_symbol(struct reader *r, size_t symbol);

/* The expression that begins at *gene, which moves behind it; -2 where it needs an input that is none of the program's
 * values.  Operands come in their order, as programs have them. */
static int read_genes(struct reader *r, const int **gene)
{
    const int own = *(*gene)++, arity = gene_arity(own);
    if (arity == 0)
        return own < 0 ? lines_number(r->to, r->file->constant[-1 - own].value)
                       : read_symbol(r, (size_t)(own - GENE_SYMBOL));
    const int a = read_genes(r, gene);
    const int b = a >= 0 && arity == 2 ? read_genes(r, gene) : -1;
    return a < 0 || b < -1 ? -2 : lines_operation(r->to, own, a, b);
}

static int read_expression(struct reader *r, const struct genome_expr *e)
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

static int read_symbol(struct reader *r, size_t symbol)
{
    int *line = &r->line[symbol];
    if (*line != -1)
        return *line;
    const long own = genome_find_symbol(r->to->rules->program, genome_symbol_name(r->file, symbol));
    if (own >= 0 && is_terminal(r->genes, GENE_SYMBOL + (int)own))
        return *line = lines_symbol(r->to, GENE_SYMBOL + (int)own);
    return *line = symbol < r->file->inputs ? -2 : read_expression(r, &r->file->let[symbol - r->file->inputs]);
}

bool lines_read(struct lines *c, const struct genome_file *f, const struct genome_expr *const out[2],
                const struct gene_set *genes, int last, size_t max, struct tree *t)
{
    const size_t symbols = f->inputs + f->lets;
    struct reader r = {c, f, genes, new_array(symbols, sizeof *r.line)};
    for (size_t i = 0; i < symbols; i++)
        r.line[i] = -1;
    lines_begin(c);
    for (int k = 0; k < 2; k++)
        c->root[k] = read_expression(&r, out[k]);
    free(r.line);
    return c->root[0] >= 0 && c->root[1] >= 0 && (last < 0 || lines_strip(c, last)) && lines_store(c, max, t);
}

/* ---- to lets and outputs ---- */

struct writer {
    const struct lines *code; /* not owned */
    struct genome_file *file;
    int *symbol;     /* owned: by line; gene of its let, or 0 */
    unsigned *users; /* owned: by line */
    int *gene;       /* owned: the expression under construction */
    size_t genes, room;
};

static void put(struct writer *w, int gene)
{
    grow_array(&w->gene, w->genes, &w->room, sizeof *w->gene);
    w->gene[w->genes++] = gene;
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

static void count_users(struct writer *w)
{
    const struct lines *c = w->code;
    for (size_t i = 0; i < c->lines; i++) {
        const struct line *x = &c->line[i];
        if (!c->needed[i] || !line_is_operation(x))
            continue;
        w->users[x->a]++;
        if (x->b >= 0)
            w->users[x->b]++;
    }
    w->users[c->root[0]]++;
    w->users[c->root[1]]++;
}

/* Append what has been put as a let <name>_<number>, the next number that is free; its gene. */
static int add_let(struct writer *w, const char *name, size_t *number)
{
    char own[WORD];
    do
        snprintf(own, sizeof own, "%.50s_%zu", name, ++*number);
    while (genome_find_symbol(w->file, own) >= 0);
    genome_add_let(w->file, own, w->gene, w->genes);
    return GENE_SYMBOL + (int)genome_find_symbol(w->file, own);
}

/* Lets for what is used twice, and for divisors. */
static void write_lets(struct writer *w, const char *name)
{
    const struct lines *c = w->code;
    size_t number = 0;
    for (size_t i = 0; i < c->lines; i++) {
        if (!c->needed[i] || c->line[i].a < 0 || (w->users[i] < 2 && !c->divides[i]))
            continue;
        w->genes = 0;
        write_operation(w, &c->line[i]);
        w->symbol[i] = add_let(w, name, &number);
    }
}

/* What a scene measures (sampled_region.h), so that headers may rely on it: divisors. */
static void write_measured(struct writer *w, const char *name)
{
    char least[WORD];
    size_t number = 0;
    snprintf(least, sizeof least, "least_%.40s", name);
    for (size_t i = 0; i < w->code->lines; i++) {
        if (!w->code->divides[i] || !w->symbol[i])
            continue;
        w->genes = 0;
        put(w, w->symbol[i]);
        add_let(w, least, &number);
    }
}

void lines_expand(struct lines *c, const struct tree *t, int last, struct genome_file *f, const char *name,
                  struct tree out[2])
{
    lines_load(c, t, last, LINES_WHOLE);
    struct writer w = {.code = c, .file = f};
    w.symbol = new_array(c->lines, sizeof *w.symbol);
    w.users = new_array(c->lines, sizeof *w.users);
    count_users(&w);
    write_lets(&w, name);
    write_measured(&w, name);
    for (int k = 0; k < 2; k++) {
        w.genes = 0;
        write_line(&w, c->root[k]);
        out[k] = (struct tree){new_array(w.genes, sizeof *w.gene), w.genes};
        memcpy(out[k].gene, w.gene, w.genes * sizeof *w.gene);
    }
    free(w.symbol);
    free(w.users);
    free(w.gene);
}

char *lines_print(struct lines *c, const struct tree *t, int last)
{
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    if (!f)
        return NULL;
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
    fclose(f);
    return text;
}
