/* Text of twin trees; see twin_text.h. */
#include "twin_text.h"

#include "../common/decimal.h"

#include <stdlib.h>
#include <string.h>

enum { WORD = 80 };

int twin_gene(const struct genome_file *f, const char *name)
{
    for (int gene = 0; gene < GENE_OPERATORS; gene++)
        if (strcmp(gene_name(gene), name) == 0)
            return gene;
    if (strcmp(name, "exchange") == 0)
        return GENE_EXCHANGE;
    if (strcmp(name, "halves") == 0)
        return GENE_HALVES;
    const long k = genome_find_function(f, name);
    return k < 0 || !genome_function_of_pair(&f->function[k]) ? -1 : GENE_FUNCTION + (int)k;
}

static const char *word_of(const struct genome_file *f, int gene, char number[DECIMAL_TEXT])
{
    if (gene < 0) {
        decimal_text(gene, number);
        return number;
    }
    if (gene >= GENE_SYMBOL)
        return genome_symbol_name(f, (size_t)(gene - GENE_SYMBOL));
    if (gene >= GENE_FUNCTION)
        return f->function[gene - GENE_FUNCTION].name;
    return gene == GENE_EXCHANGE ? "exchange" : gene == GENE_HALVES ? "halves" : gene_name(gene);
}

char *twin_print(const struct genome_file *f, const struct tree *t)
{
    char number[DECIMAL_TEXT], *text;
    size_t size = 1;
    for (size_t i = 0; i < t->length; i++)
        size += 1 + strlen(word_of(f, t->gene[i], number));
    text = new_array(size, 1);
    for (size_t i = 0, at = 0; i < t->length; i++)
        at += (size_t)snprintf(text + at, size - at, "%s%s", i ? " " : "", word_of(f, t->gene[i], number));
    return text;
}

static bool read_gene(const struct genome_file *f, const char *word, int *gene)
{
    char *rest;
    *gene = twin_gene(f, word);
    if (*gene >= 0)
        return true;
    const long symbol = genome_find_symbol(f, word);
    if (symbol >= 0) {
        *gene = GENE_SYMBOL + (int)symbol;
        return true;
    }
    *gene = decimal_gene(strtod(word, &rest));
    return rest != word && *rest == '\0';
}

bool twin_parse(const struct genome_file *f, const char *text, struct tree *t)
{
    size_t room = 0;
    *t = (struct tree){NULL, 0};
    bool good = true;
    for (const char *at = text + strspn(text, " "); good && *at; at += strspn(at, " ")) {
        char word[WORD];
        const size_t length = strcspn(at, " ");
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        grow_array(&t->gene, t->length, &room, sizeof *t->gene);
        good = length < WORD && read_gene(f, word, &t->gene[t->length++]);
        at += length;
    }
    if (good && t->length > 0 && gene_span(t->gene, t->length) == t->length)
        return true;
    free(t->gene);
    t->gene = NULL;
    return false;
}

/* ---- expressions ---- */

struct writer {
    const struct twin_code *code; /* not owned */
    struct genome_file *file;
    int *symbol;     /* owned: by line; gene of its let, or 0 */
    unsigned *users; /* owned: by line */
    bool *divides;   /* owned: by line; it is a divisor */
    int *gene;       /* owned: the expression under construction */
    size_t genes, room;
};

static void put(struct writer *w, int gene)
{
    grow_array(&w->gene, w->genes, &w->room, sizeof *w->gene);
    w->gene[w->genes++] = gene;
}

static void write_line(struct writer *w, int i);

static void write_operation(struct writer *w, const struct twin_line *x)
{
    put(w, x->gene);
    write_line(w, x->a);
    if (x->b >= 0)
        write_line(w, x->b);
}

static void write_line(struct writer *w, int i)
{
    const struct twin_line *x = &w->code->line[i];
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
    const struct twin_code *c = w->code;
    for (size_t i = 0; i < c->lines; i++) {
        const struct twin_line *x = &c->line[i];
        if (!c->needed[i] || x->a < 0)
            continue;
        w->users[x->a]++;
        if (x->b >= 0)
            w->users[x->b]++;
        if (x->gene == GENE_DIV || x->gene == GENE_PDIV)
            w->divides[x->b] = true;
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
    const struct twin_code *c = w->code;
    size_t number = 0;
    for (size_t i = 0; i < c->lines; i++) {
        if (!c->needed[i] || c->line[i].a < 0 || (w->users[i] < 2 && !w->divides[i]))
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
        if (!w->divides[i] || !w->symbol[i])
            continue;
        w->genes = 0;
        put(w, w->symbol[i]);
        add_let(w, least, &number);
    }
}

void twin_expand(const struct twins *twins, const struct tree *t, struct genome_file *f, const char *name,
                 struct tree out[2])
{
    struct twin_code *code = twin_code_new(twins);
    twin_translate(code, t, false);
    struct writer w = {.code = code, .file = f};
    w.symbol = new_array(code->lines, sizeof *w.symbol);
    w.users = new_array(code->lines, sizeof *w.users);
    w.divides = new_array(code->lines, sizeof *w.divides);
    count_users(&w);
    write_lets(&w, name);
    write_measured(&w, name);
    for (int k = 0; k < 2; k++) {
        w.genes = 0;
        write_line(&w, code->root[k]);
        out[k] = (struct tree){new_array(w.genes, sizeof *w.gene), w.genes};
        memcpy(out[k].gene, w.gene, w.genes * sizeof *w.gene);
    }
    free(w.symbol);
    free(w.users);
    free(w.divides);
    free(w.gene);
    twin_code_free(code);
}
