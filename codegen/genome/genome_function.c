/* Functions of genome text, stored as lets of numbers; see genome_reader.h. */
#include "genome_reader.h"

#include <stdlib.h>
#include <string.h>

static bool read_parameters(struct genome_reader *r, struct genome_function *x)
{
    while (next_word(r, true) && !word_is(&r->w, "->")) {
        struct target t = {.line = r->w.word_line, .column = r->w.word_column};
        const bool vector = word_is(&r->w, "vector");
        if (vector && !next_word(r, true))
            return reader_fail(r, "'vector' must be followed by a name");
        if (!read_name(r, t.name) || !add_name(r, &t, vector, x->first_let))
            return false;
        APPEND(x->parameter, x->parameters, x->parameter_room) = (struct genome_value){vector, x->first_let};
        x->first_let += vector ? 3 : 1;
    }
    if (!word_is(&r->w, "->"))
        return reader_fail_text(r, "expected '->' and the values of function '%s'", x->name, strlen(x->name));
    return x->parameters > 0 || reader_fail(r, "function needs parameters");
}

static bool read_body(struct genome_reader *r, const char *name)
{
    while (next_word(r, false)) {
        if (word_is(&r->w, "end"))
            return true;
        if (!word_is(&r->w, "let"))
            return reader_fail(r, "expected 'let' or 'end', not '%s'");
        if (!read_list(r, read_let))
            return false;
    }
    return reader_fail_text(r, "function '%s' has no 'end'", name, strlen(name));
}

/* Reads the names after "->", which the body has defined by then. */
static bool read_results(struct genome_reader *r, struct genome_function *x)
{
    char name[NAME_ROOM];
    while (next_word(r, true)) {
        const struct name *n = word_copy(&r->w, name, sizeof name) ? names_find(&r->function->names, name) : NULL;
        if (!n)
            return reader_fail(r, "'%s' is not a value of the function");
        APPEND(x->result, x->results, x->result_room) = (struct genome_value){n->kind == NAME_VECTOR, n->gene};
    }
    return x->results > 0 || reader_fail(r, "function needs values");
}

static bool read_definitions(struct genome_reader *r, struct genome_function *x)
{
    if (!read_parameters(r, x))
        return false;
    struct words results = r->w;
    while (next_word(r, true))
        continue;
    if (!read_body(r, x->name))
        return false;
    const struct words end = r->w;
    r->w = results;
    if (!read_results(r, x))
        return false;
    r->w = end;
    return end_of_line(r);
}

/* Version 1: copies the body, the lets of the file that depend on two symbols. */
static void take_lets(const struct genome_file *f, const int from[2], const int to[2], struct genome_function *x)
{
    int *local = new_array(f->inputs + f->lets, sizeof *local);
    for (int k = 0; k < 2; k++)
        local[from[k] - GENE_SYMBOL] = x->first_let + k;
    x->first_let += 2;
    for (size_t i = 0; i < f->lets; i++) {
        int *gene = new_array(f->let[i].length, sizeof *gene);
        bool follows = false;
        for (size_t k = 0; k < f->let[i].length; k++) {
            const int symbol = f->let[i].gene[k] - GENE_SYMBOL;
            gene[k] = symbol >= 0 && local[symbol] ? local[symbol] : f->let[i].gene[k];
            follows = follows || gene[k] >= GENE_LOCAL;
        }
        if (follows && !local[f->inputs + i]) {
            genome_add_expr(&x->let, &x->lets, &x->let_room, f->let[i].name, gene, f->let[i].length);
            local[f->inputs + i] = x->first_let + (int)x->lets - 1;
        }
        free(gene);
    }
    x->parameters = x->results = 2;
    x->parameter = new_array(2, sizeof *x->parameter);
    x->result = new_array(2, sizeof *x->result);
    for (int k = 0; k < 2; k++) {
        const int result = local[to[k] - GENE_SYMBOL];
        x->parameter[k].gene = GENE_LOCAL + k;
        x->result[k].gene = result ? result : to[k];
    }
    free(local);
}

static bool read_function_of_lets(struct genome_reader *r, struct genome_function *x)
{
    int symbol[4];
    for (int k = 0; k < 4; k++)
        if (!read_symbol(r, &symbol[k]))
            return false;
    take_lets(r->file, symbol, symbol + 2, x);
    return end_of_line(r);
}

static bool read_function_name(struct genome_reader *r, char name[NAME_ROOM])
{
    if (!next_word(r, true))
        return reader_fail(r, "function needs a name");
    if (!read_name(r, name))
        return false;
    const struct name *n = names_find(&r->file->names, name);
    if (strcmp(name, "exchange") == 0 || strcmp(name, "halves") == 0 || (n && n->kind == NAME_FUNCTION))
        return reader_fail(r, "function '%s' is defined already");
    if (n)
        return reader_fail(r, "name '%s' is defined already");
    return r->file->functions < GENOME_FUNCTIONS || reader_fail(r, "too many functions at '%s'");
}

bool read_function(struct genome_reader *r)
{
    struct genome_file *f = r->file;
    const char *start = r->w.at;
    const int line = r->w.word_line;
    char name[NAME_ROOM];
    if (f->genomes > 0 && f->format > 1 && !r->alone)
        return reader_fail(r, "'function' must precede the genomes");
    if (!read_function_name(r, name))
        return false;
    struct genome_function x = {.name = new_text(name, strlen(name)), .first_let = GENE_LOCAL};
    r->function = &x;
    const bool good = f->format == 1 ? read_function_of_lets(r, &x) : read_definitions(r, &x);
    r->function = NULL;
    if (!good) {
        genome_free_function(&x);
        return false;
    }
    names_add(&f->names, name, NAME_FUNCTION, (int)f->functions, f->statements);
    APPEND(f->function, f->functions, f->function_room) = x;
    add_statement(r, "function", name, start, line);
    return true;
}
