/* Translates infix expressions to prefix words (grammar: genome.h), so that all later steps, including statements
 * stored as text, handle only version 2; see genome_infix.h. Operator precedence parsing (Dijkstra's shunting yard)
 * makes a tree of each expression. It uses no recursion, because expressions may be a million operators deep. */
#include "genome_infix.h"

#include "../base/text.h"
#include "genome_reader.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* An operand, or an operator with its operands, which are other terms. */
struct term {
    const char *word; /* not owned */
    size_t length;
    int line, column, operands;
    size_t operand[2];
};

/* Precedence of operators. */
enum binding { PARENTHESIS, SUM, PRODUCT, SIGN };

/* An operator whose last operand is not complete, or an open parenthesis. */
struct pending {
    enum binding binding;
    size_t term;     /* of the operator, or of the function before the parenthesis */
    size_t operands; /* of that function; 0: the parenthesis groups */
    size_t before;   /* operands on the stack when the parenthesis was opened */
};

struct infix {
    struct words w;
    const char *path;
    struct diag *d;
    struct prefix_text *to;
    struct memory *out;
    struct term *term; /* owned, like all arrays below: the expression */
    size_t terms, term_room;
    size_t *operand; /* a stack of terms without an operator */
    size_t operands, operand_room;
    struct pending *pending;
    size_t pendings, pending_room;
    size_t parentheses; /* number of open parentheses */
    bool in_genome;
};

static const char missing_parenthesis[] = "expected ')' at the end of the file";

static bool fail(struct infix *x, const char *format)
{
    return word_fail(&x->w, format, x->path, x->d);
}

/* ---- words ---- */

static bool is_mark(char c)
{
    return c != '\0' && strchr("+-*/%()=,", c) != NULL;
}

static bool begins_number(const char *word, size_t length)
{
    const size_t point = length > 1 && *word == '.';
    return length > point && isdigit((unsigned char)word[point]);
}

/* Returns the length of a part. A word ends before a blank, a comment or a mark, unless the mark is the sign of an
 * exponent. */
static size_t part_length(const char *word, size_t most)
{
    const bool number = begins_number(word, most);
    size_t n = 1;
    while (n < most && !is_mark(*word) && !is_mark(word[n]) && (word[n] == '\0' || !strchr(" \t\r\n#", word[n]))) {
        const bool exponent = number && (word[n] == 'e' || word[n] == 'E') && n + 2 < most &&
                              (word[n + 1] == '-' || word[n + 1] == '+') && isdigit((unsigned char)word[n + 2]);
        n += exponent ? 3 : 1;
    }
    return n;
}

/* Reads the next name, number or mark. */
static bool next_part(struct infix *x, bool same_line)
{
    if (!words_find(&x->w, same_line))
        return false;
    x->w.length = part_length(x->w.word, (size_t)(x->w.end - x->w.word));
    x->w.at = x->w.word + x->w.length;
    return true;
}

/* Reads a mark if it comes next, and returns whether it did. */
static bool next_is(struct infix *x, const char *mark)
{
    const struct words before = x->w;
    if (next_part(x, true) && word_is(&x->w, mark))
        return true;
    x->w = before;
    return false;
}

/* Skips newlines after a comma, where a list may continue. */
static void skip_newlines(struct infix *x)
{
    words_find(&x->w, false);
}

static void add_place(struct prefix_text *t, int line, int column)
{
    APPEND(t->place, t->places, t->place_room) = (struct word_place){t->size, line, column};
}

static void put(struct infix *x, const char *text, size_t length, int line, int column)
{
    add_place(x->to, line, column);
    fwrite(text, 1, length, x->out->stream);
    fputc(' ', x->out->stream);
    x->to->size += length + 1;
}

static void put_word(struct infix *x)
{
    put(x, x->w.word, x->w.length, x->w.word_line, x->w.word_column);
}

static void put_newline(struct infix *x)
{
    put(x, "\n", 1, x->w.word_line, x->w.word_column);
}

/* ---- expressions ---- */

static size_t new_term(struct infix *x)
{
    APPEND(x->term, x->terms, x->term_room) =
        (struct term){.word = x->w.word, .length = x->w.length, .line = x->w.word_line, .column = x->w.word_column};
    return x->terms - 1;
}

static void push_operand(struct infix *x, size_t term)
{
    APPEND(x->operand, x->operands, x->operand_room) = term;
}

static void push_operator(struct infix *x, enum binding binding)
{
    APPEND(x->pending, x->pendings, x->pending_room) = (struct pending){.binding = binding, .term = new_term(x)};
}

/* Turns the last operands into those of a term, which becomes an operand itself. */
static void complete_term(struct infix *x, size_t term, size_t operands)
{
    x->operands -= operands;
    x->term[term].operands = (int)operands;
    for (size_t k = 0; k < operands; k++)
        x->term[term].operand[k] = x->operand[x->operands + k];
    push_operand(x, term);
}

/* Completes the operators since the last open parenthesis that have at least this precedence. */
static void complete_operators(struct infix *x, enum binding binding)
{
    while (x->pendings > 0 && x->pending[x->pendings - 1].binding >= binding) {
        const struct pending *p = &x->pending[--x->pendings];
        complete_term(x, p->term, p->binding == SIGN ? 1 : 2);
    }
}

static bool open_parenthesis(struct infix *x, size_t term, size_t operands)
{
    APPEND(x->pending, x->pendings, x->pending_room) = (struct pending){PARENTHESIS, term, operands, x->operands};
    x->parentheses++;
    return true;
}

static bool close_parenthesis(struct infix *x)
{
    if (x->parentheses == 0)
        return fail(x, "'%s' needs '('");
    complete_operators(x, SUM);
    const struct pending p = x->pending[--x->pendings];
    x->parentheses--;
    if (p.operands > 0 && p.operands != x->operands - p.before)
        return fail(x, p.operands == 1 ? "expected one operand before '%s'" : "expected two operands before '%s'");
    if (p.operands > 0)
        complete_term(x, p.term, p.operands);
    return true;
}

static bool part_operands(struct infix *x)
{
    complete_operators(x, SUM);
    return x->pending[x->pendings - 1].operands > 0 || fail(x, "'%s' must not be inside grouping parentheses");
}

/* Begins with a name: a value, or a function and its parenthesis. */
static bool begin_name(struct infix *x, bool *complete)
{
    int gene;
    const bool function = word_is_operator(&x->w, GENOME_FORMAT, &gene);
    const struct words name = x->w;
    const size_t term = new_term(x);
    const bool call = next_is(x, "(");
    if (function && call)
        return open_parenthesis(x, term, (size_t)operator_arity(gene));
    x->w = name;
    if (call)
        return fail(x, "'%s' must not be called inside an expression");
    if (function)
        return fail(x, "'%s' needs '(' and its operands");
    if (word_is_keyword(&x->w, GENOME_FORMAT))
        return fail(x, "expected an operand before '%s'");
    push_operand(x, term);
    *complete = true;
    return true;
}

/* Begins with a sign, which belongs to a number that follows directly. */
static void begin_sign(struct infix *x, bool *complete)
{
    const struct words sign = x->w;
    *complete = next_part(x, true) && x->w.word == sign.at && begins_number(x->w.word, x->w.length);
    if (*complete) {
        x->w.word--;
        x->w.word_column--;
        x->w.length++;
        push_operand(x, new_term(x));
    } else {
        x->w = sign;
        push_operator(x, SIGN);
    }
}

static bool begin_operand(struct infix *x, bool *complete)
{
    if (!next_part(x, false))
        return fail(x, "expected an operand at the end of the file");
    if (word_is(&x->w, "("))
        return open_parenthesis(x, 0, 0);
    if (word_is(&x->w, "-")) {
        begin_sign(x, complete);
        return true;
    }
    if (is_mark(*x->w.word))
        return fail(x, "expected an operand before '%s'");
    if (!begins_number(x->w.word, x->w.length))
        return begin_name(x, complete);
    push_operand(x, new_term(x));
    *complete = true;
    return true;
}

/* Returns true if the expression ends after this operand: before the end of its line or a comma outside parentheses;
 * for an argument, before a comma or the function's closing parenthesis. */
static bool expression_ends(struct infix *x, bool argument)
{
    const struct words before = x->w;
    const bool more = next_part(x, !argument && x->parentheses == 0);
    const bool ends = !more || word_is(&x->w, ",") || (argument && word_is(&x->w, ")"));
    x->w = before;
    return ends && x->parentheses == 0;
}

static bool continue_expression(struct infix *x, bool *complete)
{
    if (!next_part(x, false))
        return fail(x, missing_parenthesis);
    if (word_is(&x->w, ")"))
        return close_parenthesis(x);
    *complete = false;
    if (word_is(&x->w, ","))
        return part_operands(x);
    const bool sum = word_is(&x->w, "+") || word_is(&x->w, "-");
    if (!sum && !word_is(&x->w, "*") && !word_is(&x->w, "/") && !word_is(&x->w, "%"))
        return fail(x, "expected an operator before '%s'");
    complete_operators(x, sum ? SUM : PRODUCT);
    push_operator(x, sum ? SUM : PRODUCT);
    return true;
}

static void put_expression(struct infix *x)
{
    complete_operators(x, SUM);
    while (x->operands > 0) {
        const struct term t = x->term[x->operand[--x->operands]];
        if (*t.word == '-' && t.operands == 1)
            put(x, "neg", 3, t.line, t.column);
        else
            put(x, t.word, t.length, t.line, t.column);
        for (int k = t.operands; k-- > 0;)
            push_operand(x, t.operand[k]);
    }
}

static bool read_infix(struct infix *x, bool argument)
{
    bool complete = false;
    x->terms = x->operands = x->pendings = x->parentheses = 0;
    while (!complete || !expression_ends(x, argument))
        if (!(complete ? continue_expression(x, &complete) : begin_operand(x, &complete)))
            return false;
    put_expression(x);
    return true;
}

static bool read_value(struct infix *x)
{
    return read_infix(x, false);
}

/* ---- lines ---- */

static bool put_arguments(struct infix *x)
{
    if (next_is(x, ")"))
        return true;
    do {
        if (!read_infix(x, true))
            return false;
        next_part(x, false);
    } while (word_is(&x->w, ","));
    return word_is(&x->w, ")") || fail(x, missing_parenthesis);
}

/* Reads a right side, which may be a call of a function of the file or a derivative. */
static bool read_right_side(struct infix *x)
{
    int gene;
    const struct words before = x->w;
    if (next_part(x, false) && !is_mark(*x->w.word) && !word_is_operator(&x->w, GENOME_FORMAT, &gene)) {
        const struct words name = x->w;
        if (next_is(x, "(")) {
            put(x, name.word, name.length, name.word_line, name.word_column);
            return put_arguments(x);
        }
    }
    x->w = before;
    return read_infix(x, false);
}

/* Reads names, "=" and the right side. The reader reports missing parts. */
static bool read_definition(struct infix *x)
{
    while (next_part(x, true)) {
        put_word(x);
        if (word_is(&x->w, "="))
            return read_right_side(x);
    }
    return true;
}

static bool put_list(struct infix *x, bool (*put_item)(struct infix *))
{
    put_word(x);
    while (put_item(x)) {
        if (!next_is(x, ","))
            return true;
        put_word(x);
        skip_newlines(x);
    }
    return false;
}

static bool begins_output(struct infix *x)
{
    const struct words before = x->w;
    const bool begins = next_part(x, true) && next_is(x, "=");
    x->w = before;
    return begins;
}

/* Copies the values of an output, or of the requires of a genome, up to the next output, whose name stays unread. */
static bool put_row(struct infix *x, bool *more)
{
    do {
        if (!read_infix(x, false))
            return false;
        *more = next_is(x, ",");
        if (*more)
            skip_newlines(x);
    } while (*more && !begins_output(x));
    return true;
}

static bool put_outputs(struct infix *x)
{
    for (bool more = true; more;) {
        put_word(x);
        if (!word_is(&x->w, "require") && !next_is(x, "="))
            return fail(x, "expected '=' after '%s'");
        if (!word_is(&x->w, "require"))
            put_word(x);
        if (!put_row(x, &more))
            return false;
        if (more) {
            put_newline(x);
            next_part(x, true);
        }
    }
    return true;
}

static bool put_note(struct infix *x)
{
    const char *end = memchr(x->w.at, '\n', (size_t)(x->w.end - x->w.at));
    x->w.at = end ? end : x->w.end;
    x->w.length = (size_t)(x->w.at - x->w.word);
    put_word(x);
    return true;
}

/* Copies a line without expressions. */
static bool put_line(struct infix *x)
{
    do {
        put_word(x);
        if (word_is(&x->w, ","))
            skip_newlines(x);
    } while (words_next(&x->w, true));
    return true;
}

static bool read_line(struct infix *x)
{
    const bool was_in_genome = x->in_genome;
    if (word_is(&x->w, "note"))
        return put_note(x);
    x->in_genome = was_in_genome ? !word_is(&x->w, "end") : word_is(&x->w, "genome");
    if (was_in_genome && x->in_genome)
        return put_outputs(x);
    if (word_is(&x->w, "let"))
        return put_list(x, read_definition);
    if (word_is(&x->w, "require") || word_is(&x->w, "least"))
        return put_list(x, read_value);
    return put_line(x);
}

static bool read_lines(struct infix *x)
{
    while (next_part(x, false)) {
        if (!read_line(x))
            return false;
        if (next_part(x, true))
            return fail(x, "unexpected '%s'");
        put_newline(x);
    }
    add_place(x->to, x->w.word_line, x->w.word_column);
    return true;
}

bool infix_to_prefix(struct words w, const char *path, struct prefix_text *to, struct diag *d)
{
    struct infix x = {.w = w, .path = path, .d = d, .to = to, .out = memory_open()};
    const bool good = read_lines(&x);
    to->text = memory_close(x.out);
    free(x.term);
    free(x.operand);
    free(x.pending);
    return good;
}

void prefix_text_free(struct prefix_text *t)
{
    free(t->text);
    free(t->place);
}
