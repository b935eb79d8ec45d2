/* Reader of genome text (grammar: genome.h), line by line; see genome_reader.h. It makes a single pass over words;
 * every error gives file, line and column. */
#include "genome_infix.h"
#include "genome_reader.h"

#include "../base/text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static bool read_note(struct genome_reader *r, struct genome_note **note, size_t *n, size_t *room)
{
    if (!next_word(r, true))
        return reader_fail(r, "note needs a key");
    while (r->w.at < r->w.end && (*r->w.at == ' ' || *r->w.at == '\t'))
        r->w.at++;
    const char *text = r->w.at;
    while (r->w.at < r->w.end && *r->w.at != '\n')
        r->w.at++;
    if (memchr(r->w.word, '\0', (size_t)(r->w.at - r->w.word)))
        return reader_fail(r, "note '%s' must not contain a NUL byte");
    size_t length = (size_t)(r->w.at - text);
    while (length > 0 && isspace((unsigned char)text[length - 1]))
        length--;
    APPEND(*note, *n, *room) = (struct genome_note){new_text(r->w.word, r->w.length), new_text(text, length)};
    return true;
}

static bool read_order(struct genome_reader *r, const struct segment_kind *kind, enum corner_order *order)
{
    if (!next_word(r, true))
        return reader_fail(r, "segment needs an order of corners");
    for (*order = CORNERS_ANY; *order <= CORNERS_NEAREST_SHORTER; ++*order)
        if (word_is(&r->w, corner_order_name(*order)))
            return *order == CORNERS_ANY || kind->turns ||
                   reader_fail(r, "order of corners of this segment must be 'any', not '%s'");
    return reader_fail(r, "unknown order of corners '%s'");
}

static const struct segment_kind *read_kind(struct genome_reader *r)
{
    struct genome_file *f = r->file;
    if (f->segment)
        reader_fail(r, "a second 'segment' line");
    else if (f->format > 1 && f->inputs + f->statements + f->genomes > 0)
        reader_fail(r, "'%s' must precede the first 'input', 'let', 'function' or 'genome'");
    else if (!next_word(r, true))
        reader_fail(r, "segment needs a kind");
    else {
        char *name = new_text(r->w.word, r->w.length);
        const struct segment_kind *kind = segment_find(name);
        free(name);
        return kind || reader_fail(r, "unknown segment kind '%s'") ? kind : NULL;
    }
    return NULL;
}

/* Reads a segment and a place on it. */
static bool read_face(struct genome_reader *r)
{
    const struct segment_kind *kind = r->file->format == 1 ? NULL : read_kind(r);
    if (r->file->format == 1)
        return reader_fail(r, "unknown keyword '%s'");
    if (!kind || !end_of_line(r))
        return false;
    genome_add_segment(r->file, kind, CORNERS_ANY);
    genome_add_input(r->file, "xi");
    genome_add_input(r->file, "eta");
    r->file->face = true;
    return true;
}

/* In version 1, inputs have lines of their own. */
static bool read_segment(struct genome_reader *r)
{
    struct genome_file *f = r->file;
    enum corner_order order = CORNERS_ANY;
    const struct segment_kind *kind = read_kind(r);
    if (!kind || !read_order(r, kind, &order) || !end_of_line(r))
        return false;
    if (f->format > 1)
        genome_add_segment(f, kind, order);
    f->segment = kind;
    f->order = order;
    return true;
}

/* Returns true if `output` is an element of a row, "NAME[3]". */
static bool is_element(const char *output, const char *name)
{
    const size_t n = strlen(name);
    return strncmp(output, name, n) == 0 && output[n] == '[';
}

/* Returns true if another value follows, on any line: neither a keyword nor the name of another row. */
static bool row_goes_on(struct genome_reader *r)
{
    const struct words before = r->w;
    bool more = next_word(r, false) && !word_is_keyword(&r->w, r->file->format);
    more = more && !(next_word(r, true) && word_is(&r->w, "="));
    r->w = before;
    return more;
}

/* Reads the values of a row, vectors by their components. */
static bool read_row(struct genome_reader *r, struct genome *g, const char *name, int line)
{
    for (size_t n = 0; n == 0 || row_goes_on(r);) {
        if (!read_expression(r, name, true))
            return false;
        for (int c = 0; c < (r->node[0].vector ? 3 : 1); c++) {
            if (!expand(r, c))
                return false;
            char *element = new_format("%s[%zu]", name, n++);
            genome_add_expr(&g->out, &g->outs, &g->out_room, element, r->gene, r->genes);
            g->out[g->outs - 1].line = line;
            free(element);
        }
    }
    return true;
}

static bool read_output(struct genome_reader *r, struct genome *g)
{
    char name[NAME_ROOM];
    if (r->file->face && word_is(&r->w, "require") ? !word_copy(&r->w, name, sizeof name) : !read_name(r, name))
        return false;
    const int line = r->w.word_line;
    for (size_t i = 0; i < g->outs; i++)
        if (strcmp(g->out[i].name, name) == 0 || is_element(g->out[i].name, name))
            return reader_fail(r, "output '%s' is defined already");
    if (strcmp(name, "require") != 0 && (!next_word(r, true) || !word_is(&r->w, "=")))
        return reader_fail_text(r, "expected '=' after '%s'", name, strlen(name));
    if (r->file->face)
        return read_row(r, g, name, line);
    if (!read_expression(r, name, false) || !expand_number(r, name))
        return false;
    genome_add_expr(&g->out, &g->outs, &g->out_room, name, r->gene, r->genes);
    g->out[g->outs - 1].line = line;
    if (!next_is_comma(r))
        return true;
    return next_word(r, true) ? read_output(r, g) : reader_fail(r, "expected an output after the comma");
}

static bool read_genome(struct genome_reader *r)
{
    char name[NAME_ROOM];
    const int line = r->w.word_line;
    if (!next_word(r, true))
        return reader_fail(r, "genome needs a name");
    if (!read_name(r, name))
        return false;
    for (size_t i = 0; i < r->file->genomes; i++)
        if (strcmp(r->file->genome[i].name, name) == 0)
            return reader_fail(r, "genome '%s' is defined already");
    struct genome *g = genome_add(r->file, name);
    g->line = line;
    if (!end_of_line(r))
        return false;
    while (next_word(r, false)) {
        if (word_is(&r->w, "end")) {
            if (g->outs == 0)
                return reader_fail_text(r, "genome '%s' needs an output", name, strlen(name));
            return end_of_line(r);
        }
        if (word_is(&r->w, "note") ? !read_note(r, &g->note, &g->notes, &g->note_room) : !read_output(r, g))
            return false;
    }
    return reader_fail_text(r, "genome '%s' has no 'end'", name, strlen(name));
}

static bool read_exchange(struct genome_reader *r)
{
    int gene[2];
    if (!read_symbol(r, &gene[0]) || !read_symbol(r, &gene[1]))
        return false;
    const size_t a = (size_t)(gene[0] - GENE_SYMBOL), b = (size_t)(gene[1] - GENE_SYMBOL);
    for (size_t i = 0; i < r->file->exchanges; i++)
        for (int k = 0; k < 2; k++)
            if (r->file->exchange[i][k] == a || r->file->exchange[i][k] == b)
                return reader_fail(r, "'%s' or its partner is exchanged already");
    genome_add_exchange(r->file, a, b);
    return end_of_item(r);
}

/* Adds a number, or the components of a vector. */
static bool add_inputs(struct genome_reader *r, const char *name, bool vector)
{
    const int gene = GENE_SYMBOL + (int)r->file->inputs;
    for (int c = 0; c < (vector ? 3 : 1); c++) {
        char component[NAME_ROOM];
        snprintf(component, sizeof component, "%.63s%c", name, vector ? "xyz"[c] : '\0');
        if (names_find(&r->file->names, component))
            return reader_fail_text(r, "name '%s' is defined already", component, strlen(component));
        genome_add_input(r->file, component);
    }
    if (vector)
        names_add(&r->file->names, name, NAME_VECTOR, gene, NO_STATEMENT);
    return true;
}

static bool read_inputs(struct genome_reader *r)
{
    char name[NAME_ROOM];
    if (r->file->segment && r->file->format > 1)
        return reader_fail(r, "'input' must not be used with a segment, whose kind defines the inputs");
    if (r->file->lets + r->file->genomes > 0)
        return reader_fail(r, "'input' must precede the first 'let' or 'genome'");
    if (!next_word(r, true))
        return reader_fail(r, "input needs a name");
    do {
        const bool vector = r->file->format > 1 && word_is(&r->w, "vector");
        if (vector && !next_word(r, true))
            return reader_fail(r, "input needs a name");
        if (!read_new_name(r, name) || !add_inputs(r, name, vector))
            return false;
    } while (next_word(r, true));
    return true;
}

static bool read_limit(struct genome_reader *r, const char *input, int *gene)
{
    if (!next_word(r, true))
        return reader_fail_text(r, "the range of '%s' needs two numbers", input, strlen(input));
    if (!looks_like_number(r))
        return reader_fail(r, "'%s' must be a decimal number");
    return read_number(r, gene);
}

static bool read_interval(struct genome_reader *r, size_t input)
{
    struct genome_file *f = r->file;
    int lo, hi;
    if (f->range[input].given)
        return reader_fail_text(r, "the range of '%s' is given already", f->input[input], strlen(f->input[input]));
    if (!read_limit(r, f->input[input], &lo) || !read_limit(r, f->input[input], &hi))
        return false;
    if (!(f->constant[-1 - lo].value <= f->constant[-1 - hi].value))
        return reader_fail(r, "upper limit '%s' is below the lower limit");
    f->range[input] = (struct genome_range){true, (size_t)(-1 - lo), (size_t)(-1 - hi)};
    return true;
}

static bool read_range(struct genome_reader *r)
{
    char text[NAME_ROOM];
    if (!next_word(r, true))
        return reader_fail(r, "range needs an input");
    const struct name *n = word_copy(&r->w, text, sizeof text) ? names_find(&r->file->names, text) : NULL;
    if (!n || n->statement != NO_STATEMENT)
        return reader_fail(r, "'%s' is not an input");
    for (int c = 0; c < (n->kind == NAME_VECTOR ? 3 : 1); c++)
        if (!read_interval(r, (size_t)(n->gene - GENE_SYMBOL + c)))
            return false;
    return end_of_item(r);
}

static bool read_require(struct genome_reader *r)
{
    r->in_require = true;
    const bool good = read_expression(r, "require", false) && expand_number(r, "require");
    r->in_require = false;
    if (!good)
        return false;
    genome_add_require(r->file, r->gene, r->genes);
    r->file->require[r->file->requires - 1].line = r->node[0].line;
    return true;
}

/* Reads a `least` of a frame: a statement, so that it accompanies the lets. */
static bool read_least(struct genome_reader *r)
{
    struct genome_file *f = r->file;
    const char *start = r->w.at;
    if (f->format == 1)
        return reader_fail(r, "unknown keyword '%s'");
    if (!read_expression(r, "least", false) || !expand_number(r, "least"))
        return false;
    genome_add_expr(&f->least, &f->leasts, &f->least_room, "", r->gene, r->genes);
    add_statement(r, "least", "", start, r->node[0].line);
    return true;
}

/* Checks that every input is a value of the region. */
static bool check_region(struct genome_reader *r, int line)
{
    const struct genome_file *f = r->file;
    for (size_t i = 0; i < f->inputs; i++)
        if (genome_region_symbol(f, i) < 0)
            return diag_at(r->d, f->path, line, 1, "region must define '%s'", f->input[i]);
    return true;
}

static bool read_line(struct genome_reader *r);

/* Reads the region block as a file of its own. */
static bool read_region(struct genome_reader *r)
{
    const int line = r->w.word_line;
    struct genome_file *f = r->file;
    if (f->format == 1)
        return reader_fail(r, "unknown keyword '%s'");
    if (f->region || r->in_region)
        return reader_fail(r, "a second '%s'");
    if (!end_of_line(r))
        return false;
    struct genome_reader inner = {.file = genome_file_new(f->path), .d = r->d, .w = r->w, .in_region = true};
    f->region = inner.file;
    bool good = true, ended = false;
    while (good && !ended && next_word(&inner, false)) {
        ended = word_is(&inner.w, "end");
        inner.needs = 0;
        good = ended ? end_of_line(&inner) : read_line(&inner);
    }
    r->w = inner.w;
    reader_free(&inner);
    if (good && !ended)
        return diag_at(r->d, f->path, line, 1, "region has no 'end'");
    return good && check_region(r, line);
}

static bool read_version(struct genome_reader *r)
{
    if (!next_word(r, false) || !word_is(&r->w, "footpoint-genome"))
        return reader_fail(r, "not a genome file: the first word must be 'footpoint-genome'");
    if (!next_word(r, true) || !(r->w.length == 1 && *r->w.word >= '1' && *r->w.word <= '3'))
        return reader_fail(r, "format version '%s' is not supported; this program reads versions 1 to 3");
    r->file->format = *r->w.word - '0';
    return end_of_line(r);
}

/* Translates version 3 to the text of version 2. */
static bool translate(struct genome_reader *r, struct prefix_text *prefix)
{
    if (r->file->format <= GENOME_FORMAT)
        return true;
    r->file->format = GENOME_FORMAT;
    if (!infix_to_prefix(r->w, r->file->path, prefix, r->d))
        return false;
    r->w = words_placed(prefix->text, prefix->size, prefix->place);
    return true;
}

/* Reads the line that begins with the current word. */
static bool read_line(struct genome_reader *r)
{
    struct genome_file *f = r->file;
    if (r->in_region && !(word_is(&r->w, "input") || word_is(&r->w, "range") || word_is(&r->w, "let") ||
                          word_is(&r->w, "function") || word_is(&r->w, "require")))
        return reader_fail(r, "'%s' must not be inside the region");
    return word_is(&r->w, "note")       ? read_note(r, &f->note, &f->notes, &f->note_room)
           : word_is(&r->w, "input")    ? read_inputs(r)
           : word_is(&r->w, "segment")  ? read_segment(r)
           : word_is(&r->w, "face")     ? read_face(r)
           : word_is(&r->w, "range")    ? read_list(r, read_range)
           : word_is(&r->w, "region")   ? read_region(r)
           : word_is(&r->w, "let")      ? read_list(r, read_let)
           : word_is(&r->w, "exchange") ? read_list(r, read_exchange)
           : word_is(&r->w, "function") ? read_function(r)
           : word_is(&r->w, "require")  ? read_list(r, read_require)
           : word_is(&r->w, "least")    ? read_list(r, read_least)
           : word_is(&r->w, "genome")   ? read_genome(r)
                                        : reader_fail(r, "unknown keyword '%s'");
}

static bool read_lines(struct genome_reader *r)
{
    while (next_word(r, false)) {
        r->needs = 0;
        if (!read_line(r))
            return false;
    }
    return true;
}

/* Checks that a segment's inputs are the coordinates of its vectors in order, and that outputs are xi and eta. */
static bool check_segment(const struct genome_file *f, struct diag *d)
{
    if (!f->segment)
        return true;
    if (f->face)
        return true; /* the reader made them */
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
            return diag_at(d, f->path, g->line, 1,
                           "genome '%s' of a segment must have exactly the outputs xi and "
                           "eta",
                           g->name);
    }
    return true;
}

static struct genome_reader reader_of(struct genome_file *f, const char *text, size_t size, struct diag *d)
{
    return (struct genome_reader){.file = f, .d = d, .w = words_of(text, size)};
}

bool genome_read_statement(struct genome_file *f, const char *text, struct diag *d)
{
    struct genome_reader r = reader_of(f, text, strlen(text), d);
    r.alone = true;
    const bool good = read_lines(&r);
    reader_free(&r);
    return good;
}

struct genome_file *genome_parse(const char *path, const char *text, size_t size, struct diag *d)
{
    struct genome_reader r = reader_of(genome_file_new(path), text, size, d);
    struct prefix_text prefix = {0};
    const bool good = read_version(&r) && translate(&r, &prefix) && read_lines(&r) && check_segment(r.file, d);
    reader_free(&r);
    prefix_text_free(&prefix);
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
