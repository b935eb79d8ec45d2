/* Reader of genome text (grammar: genome.h).  One pass over words; every refusal says file, line and column. */
#include "genome.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_NAME = 63, MAX_NUMBER = 63, MAX_EXPONENT = 330 };

struct reader {
    struct genome_file *file;
    struct diag *d;
    const char *at, *end; /* unread text */
    const char *line_start;
    int line;
    const char *word; /* current word; length 0 at the end of the text */
    size_t length;
    int word_line, word_column;
    int *gene; /* owned: the expression being read */
    size_t genes, gene_room;
};

static const char *const keywords[] = {"note",     "input",    "segment", "range",  "let",
                                       "exchange", "function", "require", "genome", "end"};

static bool fail(struct reader *r, const char *format, const char *word, int length)
{
    char shown[48];
    snprintf(shown, sizeof shown, "%.*s%s", length > 40 ? 40 : length, word, length > 40 ? "..." : "");
    for (char *c = shown; *c; c++)
        if (!isprint((unsigned char)*c))
            *c = '?';
    return diag_at(r->d, r->file->path, r->word_line, r->word_column, format, shown);
}

#define FAIL(r, format) fail(r, format, (r)->word, (int)(r)->length)

/* Next word; with `same_line`, stops before a newline and returns false there. */
static bool next_word(struct reader *r, bool same_line)
{
    for (;; r->at++) {
        if (r->at < r->end && *r->at == '#')
            while (r->at < r->end && *r->at != '\n')
                r->at++;
        if (r->at == r->end)
            break;
        if (*r->at == '\n') {
            if (same_line)
                break;
            r->line++;
            r->line_start = r->at + 1;
        } else if (*r->at != ' ' && *r->at != '\t' && *r->at != '\r')
            break;
    }
    r->word = r->at;
    r->word_line = r->line;
    r->word_column = (int)(r->at - r->line_start) + 1;
    while (r->at < r->end && !strchr(" \t\r\n#", *r->at))
        r->at++;
    while (r->at < r->end && *r->at == '\0') /* strchr matches NUL: keep it inside the word, to be refused */
        r->at++;
    r->length = (size_t)(r->at - r->word);
    return r->length > 0;
}

static bool word_is(const struct reader *r, const char *text)
{
    return r->length == strlen(text) && memcmp(r->word, text, r->length) == 0;
}

static bool word_is_keyword(const struct reader *r)
{
    for (size_t i = 0; i < sizeof keywords / sizeof *keywords; i++)
        if (word_is(r, keywords[i]))
            return true;
    return false;
}

/* A new name: letters, digits, underscores; not an operator, a keyword, nor a C keyword's business (names are prefixed
 * when emitted). */
static bool read_name(struct reader *r, char name[MAX_NAME + 1])
{
    if (r->length > MAX_NAME)
        return FAIL(r, "name '%s' is too long");
    for (size_t i = 0; i < r->length; i++) {
        const unsigned char c = (unsigned char)r->word[i];
        if (!(c < 128 && (isalpha(c) || c == '_' || (i > 0 && isdigit(c)))))
            return FAIL(r, "'%s' is not a name");
    }
    if (word_is_keyword(r))
        return FAIL(r, "'%s' is a keyword, not a name");
    memcpy(name, r->word, r->length);
    name[r->length] = '\0';
    for (int op = 0; op < GENE_OPERATORS; op++)
        if (strcmp(name, gene_name(op)) == 0)
            return FAIL(r, "'%s' is a gene, not a name");
    return true;
}

static bool read_new_symbol(struct reader *r, char name[MAX_NAME + 1])
{
    if (!read_name(r, name))
        return false;
    return genome_find_symbol(r->file, name) < 0 || FAIL(r, "name '%s' is defined already");
}

static bool looks_like_number(const struct reader *r)
{
    size_t i = 0;
    if (r->length > 1 && (r->word[0] == '-' || r->word[0] == '+'))
        i = 1;
    return isdigit((unsigned char)r->word[i]) || (r->word[i] == '.' && r->length > i + 1);
}

/* Plain decimal with an optional exponent, so that text is an exact rational of bounded size. */
static bool read_number(struct reader *r, int *gene)
{
    char text[MAX_NUMBER + 1];
    char *rest;
    if (r->length > MAX_NUMBER)
        return FAIL(r, "number '%s' is too long");
    memcpy(text, r->word, r->length);
    text[r->length] = '\0';
    const size_t plain = strspn(text, "+-.0123456789eE");
    errno = 0;
    const double value = strtod(text, &rest);
    if (plain != r->length || *rest)
        return FAIL(r, "'%s' is not a decimal number");
    const char *exponent = strpbrk(text, "eE");
    const long power = exponent ? strtol(exponent + 1, NULL, 10) : 0;
    if (!isfinite(value) || power > MAX_EXPONENT || power < -MAX_EXPONENT)
        return FAIL(r, "number '%s' is out of range");
    *gene = -1 - (int)genome_add_constant(r->file, text);
    return true;
}

static bool read_gene(struct reader *r, int *gene)
{
    char name[MAX_NAME + 1];
    for (int op = 0; op < GENE_OPERATORS; op++)
        if (word_is(r, gene_name(op))) {
            *gene = op;
            return true;
        }
    if (looks_like_number(r))
        return read_number(r, gene);
    if (r->length <= MAX_NAME) {
        memcpy(name, r->word, r->length);
        name[r->length] = '\0';
        const long k = strlen(name) == r->length ? genome_find_symbol(r->file, name) : -1;
        if (k >= 0) {
            *gene = GENE_SYMBOL + (int)k;
            return true;
        }
    }
    return FAIL(r, "unknown gene '%s'");
}

/* Genes up to stack count 1. */
static bool read_genes(struct reader *r, const char *name)
{
    long missing = 1;
    r->genes = 0;
    while (missing > 0) {
        if (!next_word(r, false) || word_is_keyword(r) || word_is(r, "="))
            return diag_at(r->d, r->file->path, r->word_line, r->word_column,
                           "the expression of '%s' ends early: %ld operand%s missing", name, missing,
                           missing == 1 ? " is" : "s are");
        grow_array(&r->gene, r->genes, &r->gene_room, sizeof *r->gene);
        if (!read_gene(r, &r->gene[r->genes]))
            return false;
        missing += gene_arity(r->gene[r->genes++]) - 1;
    }
    if (next_word(r, true))
        return FAIL(r, "gene '%s' follows a complete expression");
    return true;
}

static bool read_expression(struct reader *r, const char *name)
{
    if (!next_word(r, true) || !word_is(r, "="))
        return fail(r, "expected '=' after '%s'", name, (int)strlen(name));
    return read_genes(r, name);
}

static bool read_note(struct reader *r, struct genome_note **note, size_t *n, size_t *room)
{
    if (!next_word(r, true))
        return FAIL(r, "note without a key");
    while (r->at < r->end && (*r->at == ' ' || *r->at == '\t'))
        r->at++;
    const char *text = r->at;
    while (r->at < r->end && *r->at != '\n')
        r->at++;
    if (memchr(r->word, '\0', (size_t)(r->at - r->word)))
        return FAIL(r, "note '%s' holds a NUL byte");
    size_t length = (size_t)(r->at - text);
    while (length > 0 && isspace((unsigned char)text[length - 1]))
        length--;
    grow_array(note, *n, room, sizeof **note);
    (*note)[(*n)++] = (struct genome_note){new_text(r->word, r->length), new_text(text, length)};
    return true;
}

static bool read_segment(struct reader *r)
{
    if (r->file->segment)
        return FAIL(r, "a second 'segment' line");
    if (!next_word(r, true))
        return FAIL(r, "segment without a kind");
    char *name = new_text(r->word, r->length);
    r->file->segment = segment_find(name);
    free(name);
    if (!r->file->segment)
        return FAIL(r, "unknown segment kind '%s'");
    if (!next_word(r, true))
        return FAIL(r, "segment without an order of corners");
    for (int order = CORNERS_ANY; order <= CORNERS_NEAREST_SHORTER; order++)
        if (word_is(r, corner_order_name((enum corner_order)order))) {
            r->file->order = (enum corner_order)order;
            return order == CORNERS_ANY || r->file->segment->turns ||
                   FAIL(r, "corners of this segment are in the order 'any', not '%s'");
        }
    return FAIL(r, "unknown order of corners '%s'");
}

static bool end_of_line(struct reader *r)
{
    return !next_word(r, true) || FAIL(r, "'%s' is too much here");
}

static bool read_output(struct reader *r, struct genome *g)
{
    char name[MAX_NAME + 1];
    if (!read_name(r, name))
        return false;
    const int line = r->word_line;
    for (size_t i = 0; i < g->outs; i++)
        if (strcmp(g->out[i].name, name) == 0)
            return FAIL(r, "output '%s' is defined already");
    if (!read_expression(r, name))
        return false;
    genome_add_expr(&g->out, &g->outs, &g->out_room, name, r->gene, r->genes);
    g->out[g->outs - 1].line = line;
    return true;
}

static bool read_genome(struct reader *r)
{
    char name[MAX_NAME + 1];
    const int line = r->word_line;
    if (!next_word(r, true))
        return FAIL(r, "genome without a name");
    if (!read_name(r, name))
        return false;
    for (size_t i = 0; i < r->file->genomes; i++)
        if (strcmp(r->file->genome[i].name, name) == 0)
            return FAIL(r, "genome '%s' is defined already");
    struct genome *g = genome_add(r->file, name);
    g->line = line;
    if (!end_of_line(r))
        return false;
    while (next_word(r, false)) {
        if (word_is(r, "end")) {
            if (g->outs == 0)
                return fail(r, "genome '%s' has no output", name, (int)strlen(name));
            return end_of_line(r);
        }
        if (word_is(r, "note") ? !read_note(r, &g->note, &g->notes, &g->note_room) : !read_output(r, g))
            return false;
    }
    return fail(r, "the file ends inside genome '%s'", name, (int)strlen(name));
}

static bool read_let(struct reader *r)
{
    char name[MAX_NAME + 1];
    if (r->file->genomes > 0)
        return FAIL(r, "'let' must stand before the genomes");
    if (!next_word(r, true))
        return FAIL(r, "let without a name");
    if (!read_new_symbol(r, name))
        return false;
    const int line = r->word_line;
    if (!read_expression(r, name))
        return false;
    genome_add_let(r->file, name, r->gene, r->genes);
    r->file->let[r->file->lets - 1].line = line;
    return true;
}

/* The next word, a symbol. */
static bool read_symbol(struct reader *r, size_t *symbol)
{
    int gene = 0;
    if (!next_word(r, true))
        return FAIL(r, "a value is missing here");
    if (!read_gene(r, &gene))
        return false;
    *symbol = (size_t)(gene - GENE_SYMBOL);
    return gene >= GENE_SYMBOL || FAIL(r, "'%s' is not a value");
}

static bool read_exchange(struct reader *r)
{
    size_t a = 0, b = 0;
    if (!read_symbol(r, &a) || !read_symbol(r, &b))
        return false;
    for (size_t i = 0; i < r->file->exchanges; i++)
        for (int k = 0; k < 2; k++)
            if (r->file->exchange[i][k] == a || r->file->exchange[i][k] == b)
                return FAIL(r, "'%s' or its partner is exchanged already");
    genome_add_exchange(r->file, a, b);
    return end_of_line(r);
}

static bool read_function(struct reader *r)
{
    char name[MAX_NAME + 1];
    size_t from[2], to[2];
    if (!next_word(r, true))
        return FAIL(r, "function without a name");
    if (!read_new_symbol(r, name))
        return false;
    if (strcmp(name, "exchange") == 0 || strcmp(name, "halves") == 0 || genome_find_function(r->file, name) >= 0)
        return FAIL(r, "function '%s' is defined already");
    if (r->file->functions == GENOME_FUNCTIONS)
        return FAIL(r, "function '%s' is one too many");
    if (!read_symbol(r, &from[0]) || !read_symbol(r, &from[1]) || !read_symbol(r, &to[0]) || !read_symbol(r, &to[1]))
        return false;
    genome_add_function(r->file, name, from, to);
    return end_of_line(r);
}

static bool read_inputs(struct reader *r)
{
    char name[MAX_NAME + 1];
    if (r->file->lets + r->file->genomes > 0)
        return FAIL(r, "'input' must stand before the first 'let' or 'genome'");
    if (!next_word(r, true))
        return FAIL(r, "input without a name");
    do {
        if (!read_new_symbol(r, name))
            return false;
        genome_add_input(r->file, name);
    } while (next_word(r, true));
    return true;
}

static bool read_limit(struct reader *r, const char *input, int *gene)
{
    if (!next_word(r, true))
        return fail(r, "the range of '%s' needs two numbers", input, (int)strlen(input));
    if (!looks_like_number(r))
        return FAIL(r, "'%s' is not a decimal number");
    return read_number(r, gene);
}

static bool read_range(struct reader *r)
{
    struct genome_file *f = r->file;
    int lo, hi;
    if (!next_word(r, true))
        return FAIL(r, "range without an input");
    char *name = new_text(r->word, r->length);
    const long input = strlen(name) == r->length ? genome_find_symbol(f, name) : -1;
    free(name);
    if (input < 0 || (size_t)input >= f->inputs)
        return FAIL(r, "'%s' is not an input");
    if (f->range[input].given)
        return FAIL(r, "the range of '%s' is given already");
    if (!read_limit(r, f->input[input], &lo) || !read_limit(r, f->input[input], &hi))
        return false;
    if (!(f->constant[-1 - lo].value <= f->constant[-1 - hi].value))
        return FAIL(r, "the upper limit '%s' is below the lower one");
    f->range[input] = (struct genome_range){true, (size_t)(-1 - lo), (size_t)(-1 - hi)};
    return end_of_line(r);
}

static bool read_require(struct reader *r)
{
    const int line = r->word_line;
    if (!read_genes(r, "require"))
        return false;
    genome_add_require(r->file, r->gene, r->genes);
    r->file->require[r->file->requires - 1].line = line;
    return true;
}

static bool read_version(struct reader *r)
{
    if (!next_word(r, false) || !word_is(r, "footpoint-genome"))
        return FAIL(r, "not a genome file: the first word must be 'footpoint-genome'");
    if (!next_word(r, true) || !word_is(r, "1"))
        return FAIL(r, "format version '%s' is not supported (this program reads version 1)");
    return end_of_line(r);
}

static bool read_file(struct reader *r)
{
    struct genome_file *f = r->file;
    if (!read_version(r))
        return false;
    while (next_word(r, false)) {
        const bool good = word_is(r, "note")       ? read_note(r, &f->note, &f->notes, &f->note_room)
                          : word_is(r, "input")    ? read_inputs(r)
                          : word_is(r, "segment")  ? read_segment(r) && end_of_line(r)
                          : word_is(r, "range")    ? read_range(r)
                          : word_is(r, "let")      ? read_let(r)
                          : word_is(r, "exchange") ? read_exchange(r)
                          : word_is(r, "function") ? read_function(r)
                          : word_is(r, "require")  ? read_require(r)
                          : word_is(r, "genome")   ? read_genome(r)
                                                   : FAIL(r, "unknown keyword '%s'");
        if (!good)
            return false;
    }
    return true;
}

/* A segment's inputs are the coordinates of its vectors in their order; outputs are xi and eta. */
static bool check_segment(const struct genome_file *f, struct diag *d)
{
    if (!f->segment)
        return true;
    const size_t inputs = segment_inputs(f->segment);
    for (size_t i = 0; i < inputs; i++) {
        char name[5];
        segment_input_name(f->segment, i, name);
        if (f->inputs != inputs || strcmp(f->input[i], name) != 0)
            return diag_at(d, f->path, 0, 0, "the inputs of segment %s must be xA yA zA xB ... zS", f->segment->name);
    }
    for (size_t i = 0; i < f->genomes; i++) {
        const struct genome *g = &f->genome[i];
        if (g->outs != 2 || strcmp(g->out[0].name, "xi") != 0 || strcmp(g->out[1].name, "eta") != 0)
            return diag_at(d, f->path, g->line, 1, "genome '%s' of a segment must have the outputs xi and eta",
                           g->name);
    }
    return true;
}

struct genome_file *genome_parse(const char *path, const char *text, size_t size, struct diag *d)
{
    struct reader r = {
        .file = genome_file_new(path), .d = d, .at = text, .end = text + size, .line_start = text, .line = 1};
    const bool good = read_file(&r) && check_segment(r.file, d);
    free(r.gene);
    if (good)
        return r.file;
    genome_file_free(r.file);
    return NULL;
}

struct genome_file *genome_read(const char *path, struct diag *d)
{
    size_t size;
    char *text = read_text(path, &size, d);
    struct genome_file *f = text ? genome_parse(path, text, size, d) : NULL;
    free(text);
    return f;
}
