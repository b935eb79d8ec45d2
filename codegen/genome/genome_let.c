/* Lets of genome text; see genome_reader.h. A let that calls a function gets a copy of the function's lets, with
 * arguments substituted for parameters. */
#include "../base/text.h"
#include "genome_reader.h"

#include <stdlib.h>
#include <string.h>

/* The names before the "=" of a let. */
struct targets {
    struct target *item; /* owned */
    size_t n, room;
};

/* ---- values ---- */

static void component_name(const char *vector, int component, char name[NAME_ROOM])
{
    snprintf(name, NAME_ROOM, "%.63s%c", vector, "xyz"[component]);
}

bool add_name(struct genome_reader *r, const struct target *t, bool vector, int gene)
{
    void **names = r->function ? &r->function->names : &r->file->names;
    for (int c = vector ? -1 : 0; c < (vector ? 3 : 1); c++) {
        char name[NAME_ROOM];
        snprintf(name, sizeof name, "%s", t->name);
        if (vector && c >= 0)
            component_name(t->name, c, name);
        if (names_find(names, name))
            return diag_at(r->d, r->file->path, t->line, t->column, "name '%s' is defined already", name);
        names_add(names, name, c < 0 ? NAME_VECTOR : NAME_NUMBER, gene + (c > 0 ? c : 0), r->file->statements);
    }
    return true;
}

/* Defines a name by an expression. */
static bool read_value(struct genome_reader *r, const struct target *t)
{
    int gene = 0, first = 0;
    const bool vector = r->node[0].vector;
    for (int c = 0; c < (vector ? 3 : 1); c++) {
        char name[NAME_ROOM];
        component_name(t->name, c, name);
        if (!expand(r, c) || !add_number(r, vector ? name : t->name, t->line, &gene))
            return false;
        first = c == 0 ? gene : first;
    }
    return add_name(r, t, vector, first);
}

/* ---- derivatives ---- */

/* Reads a symbol: the gene of a number or of a vector's first component. */
static bool read_variable(struct genome_reader *r, int *gene, bool *vector)
{
    if (!next_word(r, true))
        return reader_fail(r, "expected a value");
    if (!read_gene(r, gene))
        return false;
    *vector = *gene >= GENE_VECTOR;
    *gene -= *vector ? GENE_VECTOR - GENE_SYMBOL : 0;
    return *gene >= GENE_SYMBOL || reader_fail(r, "'%s' is not a value");
}

/* Reads derivative y x: of a vector by a number, or of a number by a vector, which is the vector of three
 * derivatives. */
static bool read_derivative(struct genome_reader *r, const struct target *t)
{
    int of, by, slope[3], gene = 0, first = 0;
    bool of_vector = false, by_vector = false, good = true;
    if (r->function)
        return reader_fail(r, "'%s' must not be inside a function");
    if (!read_variable(r, &of, &of_vector) || !read_variable(r, &by, &by_vector))
        return false;
    if (of_vector && by_vector)
        return reader_fail(r, "a vector has no derivative by the vector '%s'");
    if (!end_of_item(r))
        return false;
    const int components = of_vector || by_vector ? 3 : 1;
    for (int c = 0; good && c < components; c++)
        good = derive(r, of_vector ? of + c : of, by_vector ? by + c : by, t->name, t->line, &slope[c]);
    for (int c = 0; good && c < components; c++) {
        char name[NAME_ROOM];
        component_name(t->name, c, name);
        r->genes = 0;
        put_gene(r, slope[c]);
        good = add_number(r, components == 3 ? name : t->name, t->line, &gene);
        first = c == 0 ? gene : first;
    }
    return good && add_name(r, t, components == 3, first);
}

/* ---- calls ---- */

/* A call under construction. Arrays are indexed by the function's parameters and lets, component by component: */
struct call {
    const struct genome_function *function; /* not owned */
    const struct targets *target;           /* not owned */
    int *gene;                              /* owned: the gene that replaces it */
    size_t *owner;                          /* owned: 1 + the result that it is, or 0 */
    size_t genes;
};

static size_t components(const struct genome_value *v)
{
    return v->vector ? 3 : 1;
}

/* Finds the results that are lets of the body; the first of equal results owns the let. */
static void find_owners(struct call *call)
{
    const struct genome_function *x = call->function;
    for (size_t k = 0; k < x->results; k++) {
        size_t *owner = call->owner + (x->result[k].gene - GENE_LOCAL);
        bool taken = x->result[k].gene < x->first_let;
        for (size_t c = 0; c < components(&x->result[k]); c++)
            taken = taken || owner[c];
        for (size_t c = 0; !taken && c < components(&x->result[k]); c++)
            owner[c] = 1 + k;
    }
}

/* Returns the name of let i here: its result's, or "first-result.let". */
static char *name_of_let(const struct call *call, size_t i)
{
    const struct genome_function *x = call->function;
    const int gene = x->first_let + (int)i;
    const size_t owner = call->owner[gene - GENE_LOCAL];
    if (owner) {
        const struct genome_value *v = &x->result[owner - 1];
        const char letter[] = {"xyz"[gene - v->gene], '\0'};
        return new_joined(call->target->item[owner - 1].name, v->vector ? letter : "", "");
    }
    const char *inner = strrchr(x->let[i].name, '.');
    return new_joined(call->target->item[0].name, ".", inner ? inner + 1 : x->let[i].name);
}

static bool read_argument(struct genome_reader *r, struct call *call, size_t k)
{
    const bool vector = call->function->parameter[k].vector;
    if (!read_expression(r, call->function->name, true))
        return false;
    if (r->node[0].vector != vector)
        return diag_at(r->d, r->file->path, r->node[0].line, r->node[0].column, "'%s' takes a %s here",
                       call->function->name, vector ? "vector" : "number");
    const int line = r->node[0].line;
    for (int c = 0; c < (vector ? 3 : 1); c++) {
        int gene;
        if (!expand(r, c))
            return false;
        if (r->genes == 1)
            gene = r->gene[0];
        else if (!add_number(r, "argument", line, &gene))
            return false;
        call->gene[call->genes++] = gene;
    }
    return true;
}

static int gene_here(const struct call *call, int gene)
{
    return gene >= GENE_LOCAL ? call->gene[gene - GENE_LOCAL] : gene;
}

static bool copy_body(struct genome_reader *r, struct call *call)
{
    for (size_t i = 0; i < call->function->lets; i++) {
        const struct genome_expr *let = &call->function->let[i];
        r->genes = 0;
        for (size_t k = 0; k < let->length; k++)
            put_gene(r, gene_here(call, let->gene[k]));
        char *name = name_of_let(call, i);
        const bool good = add_number(r, name, let->line, &call->gene[call->genes++]);
        free(name);
        if (!good)
            return false;
    }
    return true;
}

/* Names a result by a separate let if it is not a let of the body or repeats an earlier result. */
static bool name_result(struct genome_reader *r, const struct call *call, size_t k)
{
    const struct genome_value *result = &call->function->result[k];
    const struct target *t = &call->target->item[k];
    const bool own = call->owner[result->gene - GENE_LOCAL] != 1 + k;
    int first = gene_here(call, result->gene);
    for (int c = 0; own && c < (int)components(result); c++) {
        int gene = 0;
        char name[NAME_ROOM];
        component_name(t->name, c, name);
        r->genes = 0;
        put_gene(r, gene_here(call, result->gene + c));
        if (!add_number(r, result->vector ? name : t->name, t->line, &gene))
            return false;
        first = c == 0 ? gene : first;
    }
    return add_name(r, t, result->vector, first);
}

static bool read_call(struct genome_reader *r, const struct genome_function *x, const struct targets *target)
{
    const size_t locals = (size_t)(x->first_let - GENE_LOCAL) + x->lets;
    struct call call = {x, target, new_array(locals, sizeof *call.gene), new_array(locals, sizeof *call.owner), 0};
    find_owners(&call);
    bool good = target->n == x->results || reader_fail(r, "'%s' has another number of values");
    for (size_t k = 0; good && k < x->parameters; k++)
        good = read_argument(r, &call, k);
    good = good && end_of_item(r) && copy_body(r, &call);
    for (size_t k = 0; good && k < x->results; k++)
        good = name_result(r, &call, k);
    free(call.gene);
    free(call.owner);
    return good;
}

/* ---- lets ---- */

/* Reads names up to "=". */
static bool read_targets(struct genome_reader *r, struct targets *t)
{
    while (next_word(r, true) && !(t->n > 0 && word_is(&r->w, "="))) {
        if (t->n > 0 && r->file->format == 1)
            break;
        grow_array(&t->item, t->n, &t->room, sizeof *t->item);
        struct target *x = &t->item[t->n];
        *x = (struct target){.line = r->w.word_line, .column = r->w.word_column};
        if (!read_new_name(r, x->name))
            return false;
        t->n++;
    }
    if (t->n == 0)
        return reader_fail(r, "let needs a name");
    const char *last = t->item[t->n - 1].name;
    return word_is(&r->w, "=") || reader_fail_text(r, "expected '=' after '%s'", last, strlen(last));
}

/* Returns the function that the next word names and reads the word, or returns NULL. */
static const struct genome_function *next_function(struct genome_reader *r)
{
    char text[NAME_ROOM];
    const struct words before = r->w;
    if (next_word(r, false) && word_copy(&r->w, text, sizeof text)) {
        const struct name *n = find_name(r, text);
        if (n && n->kind == NAME_FUNCTION)
            return &r->file->function[n->gene];
    }
    r->w = before;
    return NULL;
}

/* Reads the keyword if it comes next, and returns whether it did. */
static bool next_is_derivative(struct genome_reader *r)
{
    const struct words before = r->w;
    if (r->file->format > 1 && next_word(r, false) && word_is(&r->w, "derivative"))
        return true;
    r->w = before;
    return false;
}

static bool read_definition(struct genome_reader *r, struct targets *t)
{
    if (!read_targets(r, t))
        return false;
    const struct genome_function *x = r->file->format == 1 ? NULL : next_function(r);
    if (x)
        return read_call(r, x, t);
    if (t->n > 1)
        return reader_fail_text(r, "unexpected value '%s'", t->item[1].name, strlen(t->item[1].name));
    if (next_is_derivative(r))
        return read_derivative(r, &t->item[0]);
    return read_expression(r, t->item[0].name, false) && read_value(r, &t->item[0]);
}

bool read_let(struct genome_reader *r)
{
    const char *start = r->w.at;
    const int line = r->w.word_line;
    struct targets t = {0};
    if (r->file->genomes > 0 && !r->alone)
        return reader_fail(r, "'let' must precede the genomes");
    const bool good = read_definition(r, &t);
    if (good && !r->function)
        add_statement(r, "let", t.item[0].name, start, line);
    free(t.item);
    return good;
}
