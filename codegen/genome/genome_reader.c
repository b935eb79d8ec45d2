/* Words, names and numbers of genome text; see genome_reader.h. */
#include "genome_reader.h"
#include "../base/text.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_NAME = NAME_ROOM - 2, MAX_NUMBER = 63, MAX_EXPONENT = 330 };

static const char *const keywords[] = {"note",     "input",    "segment",    "range",  "let",
                                       "exchange", "function", "require",    "genome", "end",
                                       "vector",   "face",     "derivative", "least",  "region"};
enum { NEW_KEYWORDS = 5 }; /* the last are new in version 2 */

static bool fail_at(const struct words *w, const char *format, const char *text, size_t length, const char *path,
                    struct diag *d)
{
    char shown[48];
    snprintf(shown, sizeof shown, "%.*s%s", length > 40 ? 40 : (int)length, text, length > 40 ? "..." : "");
    for (char *c = shown; *c; c++)
        if (!isprint((unsigned char)*c))
            *c = '?';
    return diag_at(d, path, w->word_line, w->word_column, format, shown);
}

bool word_fail(const struct words *w, const char *format, const char *path, struct diag *d)
{
    return fail_at(w, format, w->word, w->length, path, d);
}

bool reader_fail_text(struct genome_reader *r, const char *format, const char *text, size_t length)
{
    return fail_at(&r->w, format, text, length, r->file->path, r->d);
}

bool reader_fail(struct genome_reader *r, const char *format)
{
    return reader_fail_text(r, format, r->w.word, r->w.length);
}

void reader_free(struct genome_reader *r)
{
    free(r->gene);
    free(r->node);
    free(r->task);
    free(r->need);
}

bool next_word(struct genome_reader *r, bool same_line)
{
    return words_next(&r->w, same_line);
}

bool end_of_line(struct genome_reader *r)
{
    return !next_word(r, true) || reader_fail(r, "unexpected '%s'");
}

bool next_is_comma(struct genome_reader *r)
{
    const struct words before = r->w;
    if (r->file->format > 1 && next_word(r, true) && word_is(&r->w, ","))
        return true;
    r->w = before;
    return false;
}

bool end_of_item(struct genome_reader *r)
{
    const struct words before = r->w;
    const bool more = next_is_comma(r);
    r->w = before;
    return more || end_of_line(r);
}

bool read_list(struct genome_reader *r, bool (*read_item)(struct genome_reader *))
{
    bool good = read_item(r);
    while (good && next_is_comma(r)) {
        r->joined = true;
        good = read_item(r);
    }
    r->joined = false;
    return good;
}

bool word_is_keyword(const struct words *w, int format)
{
    const size_t n = sizeof keywords / sizeof *keywords - (format == 1 ? NEW_KEYWORDS : 0);
    for (size_t i = 0; i < n; i++)
        if (word_is(w, keywords[i]))
            return true;
    return false;
}

bool read_name(struct genome_reader *r, char name[NAME_ROOM])
{
    int gene;
    if (r->w.length > MAX_NAME)
        return reader_fail(r, "name '%s' is too long");
    for (size_t i = 0; i < r->w.length; i++) {
        const unsigned char c = (unsigned char)r->w.word[i];
        if (!(c < 128 && (isalpha(c) || c == '_' || (i > 0 && isdigit(c)))))
            return reader_fail(r, "'%s' must be a name");
    }
    if (word_is_keyword(&r->w, r->file->format))
        return reader_fail(r, "keyword '%s' must not be used as a name");
    if (word_is_operator(&r->w, r->file->format, &gene))
        return reader_fail(r, "gene '%s' must not be used as a name");
    return word_copy(&r->w, name, NAME_ROOM);
}

const struct name *find_name(struct genome_reader *r, const char *text)
{
    const struct name *n = r->function ? names_find(&r->function->names, text) : NULL;
    if (n)
        return n;
    n = names_find(&r->file->names, text);
    if (n && n->statement != NO_STATEMENT)
        APPEND(r->need, r->needs, r->need_room) = n->statement;
    return n;
}

bool read_new_name(struct genome_reader *r, char name[NAME_ROOM])
{
    if (!read_name(r, name))
        return false;
    return !names_find(r->function ? &r->function->names : &r->file->names, name) ||
           reader_fail(r, "name '%s' is defined already");
}

const char *operator_name(int gene)
{
    return gene == GENE_DOT ? "dot" : gene == GENE_CROSS ? "cross" : gene_name(gene);
}

int operator_arity(int gene)
{
    return gene == GENE_DOT || gene == GENE_CROSS ? 2 : gene_arity(gene);
}

bool word_is_operator(const struct words *w, int format, int *gene)
{
    const int operators = format == 1 ? GENE_OPERATORS : GENE_CROSS + 1;
    for (*gene = 0; *gene < operators; ++*gene)
        if (word_is(w, operator_name(*gene)))
            return true;
    return false;
}

bool looks_like_number(const struct genome_reader *r)
{
    size_t i = 0;
    if (r->w.length > 1 && (r->w.word[0] == '-' || r->w.word[0] == '+'))
        i = 1;
    return isdigit((unsigned char)r->w.word[i]) || (r->w.word[i] == '.' && r->w.length > i + 1);
}

/* Reads a plain decimal with an optional exponent, so that the text is an exact rational of bounded size. */
bool read_number(struct genome_reader *r, int *gene)
{
    char text[MAX_NUMBER + 1];
    char *rest;
    if (r->w.length > MAX_NUMBER)
        return reader_fail(r, "number '%s' is too long");
    memcpy(text, r->w.word, r->w.length);
    text[r->w.length] = '\0';
    const size_t plain = strspn(text, "+-.0123456789eE");
    errno = 0;
    const double value = strtod(text, &rest);
    if (plain != r->w.length || *rest)
        return reader_fail(r, "'%s' must be a decimal number");
    const char *exponent = strpbrk(text, "eE");
    const long power = exponent ? strtol(exponent + 1, NULL, 10) : 0;
    if (!isfinite(value) || power > MAX_EXPONENT || power < -MAX_EXPONENT)
        return reader_fail(r, "number '%s' is out of range");
    *gene = -1 - (int)genome_add_constant(r->file, text);
    return true;
}

/* Returns the text of a statement with a line for each "let" of a function. */
static char *plain_text(const struct genome_reader *r, const char *keyword, const char *start)
{
    struct memory *m = memory_open();
    struct words w = words_of(start, (size_t)(r->w.at - start));
    fputs(keyword, m->stream);
    while (words_next(&w, false)) {
        if (!word_is(&w, ","))
            fputc(word_is(&w, "let") || word_is(&w, "end") ? '\n' : ' ', m->stream);
        fwrite(w.word, 1, w.length, m->stream);
    }
    return memory_close(m);
}

void add_statement(struct genome_reader *r, const char *keyword, const char *name, const char *start, int line)
{
    char *text = plain_text(r, keyword, start);
    genome_add_statement(
        r->file, (struct genome_statement){new_text(name, strlen(name)), text, r->need, r->needs, line, r->joined});
    r->need = NULL;
    r->needs = r->need_room = 0;
}

bool add_number(struct genome_reader *r, const char *name, int line, int *gene)
{
    struct genome_function *x = r->function;
    struct genome_file *f = r->file;
    r->total += r->genes;
    if (f->format > 1 && r->total > GENOME_MOST)
        return diag_at(r->d, f->path, r->w.word_line, r->w.word_column, "expanded file must have at most %d genes",
                       GENOME_MOST);
    if (x)
        genome_add_expr(&x->let, &x->lets, &x->let_room, name, r->gene, r->genes);
    else
        genome_add_expr(&f->let, &f->lets, &f->let_room, name, r->gene, r->genes);
    struct genome_expr *let = x ? &x->let[x->lets - 1] : &f->let[f->lets - 1];
    let->line = line;
    *gene = x ? x->first_let + (int)x->lets - 1 : GENE_SYMBOL + (int)(f->inputs + f->lets - 1);
    return true;
}
