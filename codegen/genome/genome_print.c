/* Printer of genome text (grammar: genome.h). Statements are printed as written, or with other names, so that a program
 * can contain a frame more than once. The rest comes from the data structure. */
#include "../base/text.h"
#include "genome.h"
#include "names.h"
#include "words.h"

#include <stdlib.h>
#include <string.h>

enum { PRINT_WIDTH = 118 };

/* Prints words on a line up to the width, then on indented lines. */
static void print_line(const char *text, FILE *stream)
{
    print_broken(text, 0, PRINT_WIDTH, "\n    ", NULL, stream);
    fputc('\n', stream);
}

static void print_notes(const struct genome_note *note, size_t n, FILE *stream)
{
    for (size_t i = 0; i < n; i++)
        fprintf(stream, "note %s %s\n", note[i].key, note[i].text);
}

/* Finds the vector that begins with input i. */
static bool input_vector(const struct genome_file *f, size_t i, char name[NAME_ROOM])
{
    const char *input = f->input[i];
    if (f->segment)
        snprintf(name, NAME_ROOM, "%s", input + 1);
    else
        snprintf(name, NAME_ROOM, "%.*s", (int)strlen(input) - 1, input);
    const struct name *n = names_find(&f->names, name);
    return n && n->kind == NAME_VECTOR && n->gene == GENE_SYMBOL + (int)i;
}

static void print_inputs(const struct genome_file *f, FILE *stream)
{
    char name[NAME_ROOM];
    for (size_t i = 0, column = 0; i < f->inputs; i++) {
        const bool vector = input_vector(f, i, name);
        if (column == 0)
            fputs("input", stream);
        column += (size_t)fprintf(stream, " %s%s", vector ? "vector " : "", vector ? name : f->input[i]);
        i += vector ? 2 : 0;
        if (column + 20 > PRINT_WIDTH || i + 1 == f->inputs) {
            fputc('\n', stream);
            column = 0;
        }
    }
}

/* Prints a keyword and its items, separated by commas, on as many lines as needed. An item that fits shares its
 * predecessor's line. Names before "->" and "=" are never split, as the reader requires. */
static void print_items(const char *line, const char *indent, FILE *stream)
{
    const int keyword = (int)strcspn(line, " ");
    char *broken = new_joined("\n    ", indent, "");
    size_t used = 0;
    for (const char *item = line + keyword, *end; *item; item = end + (*end == ',')) {
        end = item + strcspn(item, ",");
        const size_t length = (size_t)(end - item);
        if (used > 0 && used + 1 + length > PRINT_WIDTH) {
            fputc('\n', stream);
            used = 0;
        }
        used += (size_t)(used > 0 ? fprintf(stream, ",") : fprintf(stream, "%s%.*s", indent, keyword, line));
        char *text = new_text(item, length);
        const char *equals = strstr(text, " = ");
        const size_t head = equals ? (size_t)(equals - text) + 2 : *line == 'f' ? length : 0;
        fprintf(stream, "%.*s", (int)head, text);
        print_broken(text + head, used + head, PRINT_WIDTH, broken, NULL, stream);
        used += length;
        free(text);
    }
    fprintf(stream, "%s\n", line[keyword] ? "" : line);
    free(broken);
}

/* Prints the lines of a text and empties it. The lets of a function's body are indented. */
static void print_lines(struct growing *text, FILE *stream)
{
    for (char *line = text->text, *next; line; line = next) {
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        print_items(line, line > text->text && next ? "    " : "", stream);
    }
    free(text->text);
    *text = (struct growing){NULL, 0, 0};
}

/* Prints statements, together if they share a line; `needed` selects statements, NULL selects all. */
static void print_statements(const struct genome_file *f, const bool *needed, FILE *stream)
{
    struct growing line = {NULL, 0, 0};
    for (size_t i = 0; i < f->statements; i++) {
        const char *text = f->statement[i].text;
        if (!f->statement[i].joined)
            print_lines(&line, stream);
        if (needed && !needed[i])
            continue;
        if (line.text)
            growing_add(&line, ",");
        growing_add(&line, line.text ? strchr(text, ' ') : text);
    }
    print_lines(&line, stream);
}

/* Prints an item per vector with three ranges; version 1 has an item per line. */
static void print_ranges(const struct genome_file *f, FILE *stream)
{
    const struct genome_range *r = f->range;
    struct growing line = {NULL, 0, 0};
    char name[NAME_ROOM];
    for (size_t i = 0, n; i < f->inputs; i += n) {
        const bool vector = input_vector(f, i, name) && r[i].given && r[i + 1].given && r[i + 2].given;
        n = vector ? 3 : 1;
        if (!r[i].given)
            continue;
        growing_add(&line, line.text ? ", " : "range ");
        growing_add(&line, vector ? name : f->input[i]);
        for (size_t c = i; c < i + n; c++) {
            char *limits = new_format(" %s %s", f->constant[r[c].lo].text, f->constant[r[c].hi].text);
            growing_add(&line, limits);
            free(limits);
        }
        if (f->format == 1)
            print_lines(&line, stream);
    }
    if (line.text)
        print_lines(&line, stream);
}

static void print_requires(const struct genome_file *f, FILE *stream)
{
    struct growing line = {NULL, 0, 0};
    for (size_t i = 0; i < f->requires; i++) {
        char *text = genome_expr_text(f, line.text ? "," : "require", &f->require[i]);
        growing_add(&line, text);
        free(text);
        if (f->format == 1 || i + 1 == f->requires)
            print_lines(&line, stream);
    }
}

/* Prints outputs from the k-th on that share a line; returns the next. */
static size_t print_outputs(const struct genome_file *f, const struct genome *g, size_t k, FILE *stream)
{
    struct growing line = {NULL, 0, 0};
    do {
        char *head = new_joined(line.text ? ", " : "", g->out[k].name, " =");
        char *text = genome_expr_text(f, head, &g->out[k]);
        free(head);
        if (line.text && (f->format == 1 || strlen(line.text) + strlen(text) > PRINT_WIDTH)) {
            free(text);
            break;
        }
        growing_add(&line, text);
        free(text);
    } while (++k < g->outs);
    print_line(line.text, stream);
    free(line.text);
    return k;
}

/* Prints outputs from the k-th on that are elements of the same row; returns the next. */
static size_t print_row(const struct genome_file *f, const struct genome *g, size_t k, FILE *stream)
{
    const char *name = g->out[k].name;
    const size_t n = strcspn(name, "[");
    struct memory *m = memory_open();
    fprintf(m->stream, "%.*s%s", (int)n, name, strncmp(name, "require[", n + 1) == 0 ? "" : " =");
    do {
        char *text = genome_expr_text(f, "", &g->out[k]);
        fputs(text, m->stream);
        free(text);
    } while (++k < g->outs && name[n] && strncmp(g->out[k].name, name, n + 1) == 0);
    char *line = memory_close(m);
    print_line(line, stream);
    free(line);
    return k;
}

static void print_genome(const struct genome_file *f, const struct genome *g, FILE *stream)
{
    fprintf(stream, "\ngenome %s\n", g->name);
    print_notes(g->note, g->notes, stream);
    for (size_t k = 0; k < g->outs;)
        k = f->face ? print_row(f, g, k, stream) : print_outputs(f, g, k, stream);
    fputs("end\n", stream);
}

/* ---- what is needed ---- */

static void need_symbols(const struct genome_file *f, const struct genome_expr *e, bool *needed)
{
    for (size_t i = 0; i < e->length; i++)
        if (e->gene[i] >= GENE_SYMBOL + (int)f->inputs && e->gene[i] < GENE_LOCAL)
            needed[genome_statement_of(f, (size_t)(e->gene[i] - GENE_SYMBOL))] = true;
}

/* Returns an array indexed by statement: genomes and requires depend on it. */
static bool *needed_statements(const struct genome_file *f)
{
    bool *needed = new_array(f->statements, sizeof *needed);
    for (size_t i = 0; i < f->requires; i++)
        need_symbols(f, &f->require[i], needed);
    for (size_t i = 0; i < f->genomes; i++)
        for (size_t k = 0; k < f->genome[i].outs; k++)
            need_symbols(f, &f->genome[i].out[k], needed);
    for (size_t i = f->statements; i-- > 0;)
        for (size_t k = 0; needed[i] && k < f->statement[i].needs; k++)
            needed[f->statement[i].need[k]] = true;
    return needed;
}

/* ---- files ---- */

/* Prints a file. needed: the statements to print; NULL: all statements and the exchanges. */
static void print_file(const struct genome_file *f, const bool *needed, FILE *stream)
{
    print_notes(f->note, f->notes, stream);
    if (!f->segment || f->format == 1)
        print_inputs(f, stream);
    if (f->face)
        fprintf(stream, "face %s\n", f->segment->name);
    else if (f->segment)
        fprintf(stream, "segment %s %s\n", f->segment->name, corner_order_name(f->order));
    print_ranges(f, stream);
    if (f->region) {
        fputs("region\n", stream);
        print_file(f->region, NULL, stream);
        fputs("end\n", stream);
    }
    print_statements(f, needed, stream);
    for (size_t i = 0; !needed && i < f->exchanges; i++)
        fprintf(stream, "exchange %s %s\n", genome_symbol_name(f, f->exchange[i][0]),
                genome_symbol_name(f, f->exchange[i][1]));
    print_requires(f, stream);
    for (size_t i = 0; i < f->genomes; i++)
        print_genome(f, &f->genome[i], stream);
}

void genome_print(const struct genome_file *f, FILE *stream)
{
    fprintf(stream, "footpoint-genome %d\n", f->format);
    print_file(f, NULL, stream);
}

void genome_print_needed(const struct genome_file *f, FILE *stream)
{
    bool *needed = needed_statements(f);
    fprintf(stream, "footpoint-genome %d\n", f->format);
    print_file(f, needed, stream);
    free(needed);
}

/* ---- statements with other names ---- */

/* Returns the name in the file that statement k, or a statement that it needs, defines. A function's own names do not
 * change. */
static const struct name *find_defined(const struct genome_file *f, size_t k, const char *text)
{
    const struct genome_statement *s = &f->statement[k];
    const struct name *n = names_find(&f->names, text);
    bool defined = n && n->statement == k;
    for (size_t i = 0; n && i < s->needs; i++)
        defined = defined || s->need[i] == n->statement;
    return defined ? n : NULL;
}

/* For a component, the vector's name changes. */
static bool is_component(const struct genome_file *f, size_t k, const struct name *n)
{
    char *vector = new_text(n->text, strlen(n->text) - 1);
    const struct name *v = n->kind == NAME_NUMBER ? find_defined(f, k, vector) : NULL;
    free(vector);
    return v && v->kind == NAME_VECTOR && v->statement == n->statement && n->gene >= v->gene && n->gene < v->gene + 3;
}

char *genome_statement_suffixed(const struct genome_file *f, size_t k, const char *suffix)
{
    const struct genome_statement *s = &f->statement[k];
    struct memory *m = memory_open();
    struct words w = words_of(s->text, strlen(s->text));
    for (const char *end = s->text; words_next(&w, false); end = w.at) {
        char text[NAME_ROOM];
        const struct name *n = word_copy(&w, text, sizeof text) ? find_defined(f, k, text) : NULL;
        const size_t stem = n && is_component(f, k, n) ? w.length - 1 : w.length;
        fwrite(end, 1, (size_t)(w.word - end), m->stream);
        fprintf(m->stream, "%.*s%s%.*s", (int)stem, w.word, n ? suffix : "", (int)(w.length - stem), w.word + stem);
    }
    return memory_close(m);
}
