/* Reader of the emitted statements; see program.h. Operators wait on a stack (Dijkstra's shunting yard), not in
 * recursive calls, so that neither long chains nor deep parentheses have a limit. */
#include "program.h"

#include "../genome/names.h"
#include "../graph/constant_text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_WORD = 79 };

struct statement_reader {
    const struct genome_file *file;
    const struct genome *genome;
    struct program *program;
    const char *at;
    void *names;  /* owned: of operations */
    int *value;   /* owned: operations waiting for their operator */
    int *waiting; /* owned: operators waiting for their operands: an op_kind, or OPEN */
    size_t values, value_room, waits, wait_room;
};

enum { OPEN = -1 }; /* a parenthesis; a function's waits as its operation */

const struct unary *op_unary(enum op_kind kind)
{
    return &unary_of[kind - OP_UNARY];
}

int program_add(struct program *p, enum op_kind kind, int a, int b)
{
    APPEND(p->op, p->ops, p->op_room) =
        (struct op){.kind = kind, .a = a, .b = b, .input = -1, .squared = kind == OP_MUL && a == b};
    return (int)p->ops - 1;
}

int program_add_constant(struct program *p, const fmpq *q, bool quotient)
{
    grow_array(&p->constant, p->constants, &p->constant_room, sizeof *p->constant);
    fmpq_init(&p->constant[p->constants]);
    fmpq_set(&p->constant[p->constants], q);
    const int op = program_add(p, OP_CONSTANT, -1, -1);
    p->op[op].input = (int)p->constants++;
    p->op[op].quotient = quotient;
    return op;
}

/* Removes the operations added since there were `ops`. */
static void forget_ops(struct program *p, size_t ops)
{
    while (p->ops > ops)
        if (p->op[--p->ops].kind == OP_CONSTANT)
            fmpq_clear(&p->constant[--p->constants]);
}

/* ---- words ---- */

static void skip_blanks(struct statement_reader *r)
{
    while (isspace((unsigned char)*r->at))
        r->at++;
}

static bool accept(struct statement_reader *r, const char *text)
{
    skip_blanks(r);
    const size_t n = strlen(text);
    if (strncmp(r->at, text, n) != 0)
        return false;
    r->at += n;
    return true;
}

/* Reads the text from..to again, wherever its lines are broken. */
static bool accept_again(struct statement_reader *r, const char *from, const char *to)
{
    skip_blanks(r);
    while (from < to) {
        if (isspace((unsigned char)*from)) {
            if (!isspace((unsigned char)*r->at))
                return false;
            skip_blanks(r);
            while (from < to && isspace((unsigned char)*from))
                from++;
        } else if (*from++ != *r->at++)
            return false;
    }
    return true;
}

static bool read_word(struct statement_reader *r, char word[MOST_WORD + 1])
{
    size_t n = 0;
    skip_blanks(r);
    while (isalnum((unsigned char)r->at[n]) || (r->at[n] && strchr("_[]", r->at[n])))
        n++;
    if (n == 0 || n > MOST_WORD)
        return false;
    memcpy(word, r->at, n);
    word[n] = '\0';
    r->at += n;
    return true;
}

/* Reads a literal of type double: digits, point, digits. */
static bool read_literal(struct statement_reader *r, fmpq *q)
{
    skip_blanks(r);
    const size_t whole = strspn(r->at, "0123456789");
    if (whole == 0 || r->at[whole] != '.' || !isdigit((unsigned char)r->at[whole + 1]))
        return false;
    const char *end = decimal_read(q, r->at);
    if (!end || isalnum((unsigned char)*end) || *end == '.' || *end == '_')
        return false;
    r->at = end;
    return true;
}

/* ---- operands; each function returns an operation, or -1 if the text is something else ---- */

/* Reads "n.0 / d.0)" after its parenthesis. */
static int read_quotient(struct statement_reader *r)
{
    const char *start = r->at;
    fmpq_t n, d;
    int op = -1;
    fmpq_init(n);
    fmpq_init(d);
    const bool negative = accept(r, "-");
    if (read_literal(r, n) && accept(r, "/") && read_literal(r, d) && accept(r, ")") && !fmpq_is_zero(d)) {
        fmpq_div(n, n, d);
        if (negative)
            fmpq_neg(n, n);
        op = program_add_constant(r->program, n, true);
    } else
        r->at = start;
    fmpq_clear(n);
    fmpq_clear(d);
    return op;
}

/* Finds input zA of a segment, written xA[2]; "" for other words. */
static void read_coordinate(const char *word, char input[5])
{
    const size_t length = strlen(word);
    snprintf(input, 5, "%s", "");
    if (length == 5 && strchr("xn", word[0]) && word[2] == '[' && strchr("012", word[3]) && word[4] == ']')
        snprintf(input, 5, "%c%.*s", 'x' + word[3] - '0', word[0] == 'x' ? 1 : 2, word[0] == 'x' ? word + 1 : word);
}

/* Finds a named value or an input: in_NAME or, for a segment, xA[2], its input zA. */
static int find_name(const struct statement_reader *r, char *word)
{
    const struct name *found = names_find(&r->names, word);
    char coordinate[5];
    const char *input = coordinate;
    if (found)
        return found->gene;
    if (!r->file->segment)
        input = strncmp(word, "in_", 3) == 0 ? word + 3 : "";
    else if (r->file->face && (strcmp(word, "xi") == 0 || strcmp(word, "eta") == 0))
        input = word;
    else
        read_coordinate(word, coordinate);
    const long k = genome_find_symbol(r->file, input);
    return k >= 0 && (size_t)k < r->file->inputs ? (int)k : -1;
}

/* Reads a name or a literal. */
static int read_atom(struct statement_reader *r)
{
    char word[MOST_WORD + 1];
    fmpq_t q;
    skip_blanks(r);
    if (!isdigit((unsigned char)*r->at))
        return read_word(r, word) ? find_name(r, word) : -1;
    fmpq_init(q);
    const int op = read_literal(r, q) ? program_add_constant(r->program, q, false) : -1;
    fmpq_clear(q);
    return op;
}

/* Reads the operand that a choice repeats: a name or a constant. */
static int read_repeated(struct statement_reader *r)
{
    const bool negative = accept(r, "-");
    const int op = accept(r, "(") ? read_quotient(r) : read_atom(r);
    return negative && op >= 0 ? program_add(r->program, OP_NEG, op, -1) : op;
}

/* Returns the operator of a choice between the two sides of the comparison, or OP_INPUT. */
static enum op_kind read_comparison(struct statement_reader *r, bool inverted)
{
    if (inverted)
        return accept(r, ">=") ? OP_MIN : accept(r, "<=") ? OP_MAX : OP_INPUT;
    return accept(r, "==") ? OP_PDIV : accept(r, "<") ? OP_MIN : accept(r, ">") ? OP_MAX : OP_INPUT;
}

/* Reads "a < b ? a : b)", "!(a >= b) ? a : b)", the same with > and <=, or "d == 0.0 ? 1.0 : n / d)" after its
 * parenthesis. */
static int read_choice(struct statement_reader *r)
{
    const char *start = r->at;
    const bool inverted = accept(r, "!(");
    skip_blanks(r);
    const char *a_text = r->at;
    const size_t ops = r->program->ops;
    const int a = read_repeated(r);
    const char *a_end = r->at;
    const enum op_kind kind = a < 0 ? OP_INPUT : read_comparison(r, inverted);
    int b = -1;
    bool good = kind != OP_INPUT;
    if (kind == OP_PDIV) {
        good = accept(r, "0.0") && accept(r, "?") && accept(r, "1.0") && accept(r, ":");
        b = good ? read_repeated(r) : -1;
        good = b >= 0 && accept(r, "/") && accept_again(r, a_text, a_end) && accept(r, ")");
    } else if (good) {
        skip_blanks(r);
        const char *b_text = r->at;
        b = read_repeated(r);
        const char *b_end = r->at;
        good = b >= 0 && (!inverted || accept(r, ")")) && accept(r, "?") && accept_again(r, a_text, a_end) &&
               accept(r, ":") && accept_again(r, b_text, b_end) && accept(r, ")");
    }
    if (good)
        return kind == OP_PDIV ? program_add(r->program, kind, b, a) : program_add(r->program, kind, a, b);
    forget_ops(r->program, ops);
    r->at = start;
    return -1;
}

/* ---- expressions ---- */

static int precedence(int kind)
{
    return kind == OP_NEG ? 3 : kind == OP_MUL || kind == OP_DIV ? 2 : kind == OP_ADD || kind == OP_SUB ? 1 : 0;
}

static void push(int **stack, size_t *n, size_t *room, int what)
{
    APPEND(*stack, *n, *room) = what;
}

static void defer(struct statement_reader *r, int kind)
{
    push(&r->waiting, &r->waits, &r->wait_room, kind);
}

/* Applies the waiting operators with at least this precedence. */
static void apply(struct statement_reader *r, int least)
{
    while (r->waits && precedence(r->waiting[r->waits - 1]) >= least) {
        const int kind = r->waiting[--r->waits];
        const int b = kind == OP_NEG ? -1 : r->value[--r->values];
        int *a = &r->value[r->values - 1];
        *a = program_add(r->program, (enum op_kind)kind, *a, b);
    }
}

/* Reads a minus; two in a row are another operator of C. */
static bool accept_minus(struct statement_reader *r)
{
    skip_blanks(r);
    return r->at[0] == '-' && r->at[1] != '-' && accept(r, "-");
}

/* Reads the name of a unary function and its parenthesis. */
static bool accept_unary(struct statement_reader *r)
{
    const char *start = r->at;
    for (unsigned k = 0; k < UNARIES; k++) {
        if (accept(r, unary_of[k].c) && accept(r, "(")) {
            defer(r, OP_UNARY + (int)k);
            return true;
        }
        r->at = start;
    }
    return false;
}

/* Reads signs and opening parentheses, then an operand; returns -1 if it is missing. */
static int read_operand(struct statement_reader *r)
{
    for (;;) {
        if (accept_minus(r))
            defer(r, OP_NEG);
        else if (accept_unary(r))
            continue;
        else if (accept(r, "(")) {
            int op = read_quotient(r);
            if (op < 0)
                op = read_choice(r);
            if (op >= 0)
                return op;
            defer(r, OPEN);
        } else
            return read_atom(r);
    }
}

/* Closes the innermost parenthesis; returns false if no parenthesis is open. */
static bool close_parenthesis(struct statement_reader *r)
{
    apply(r, 1);
    if (!r->waits)
        return false;
    const int kind = r->waiting[--r->waits];
    if (kind != OPEN) {
        int *a = &r->value[r->values - 1];
        *a = program_add(r->program, (enum op_kind)kind, *a, -1);
    }
    return true;
}

/* Reads an expression up to the first word that cannot continue it; returns -1 if it is malformed. */
static int read_expression(struct statement_reader *r)
{
    r->values = r->waits = 0;
    for (;;) {
        const int operand = read_operand(r);
        if (operand < 0)
            return -1;
        push(&r->value, &r->values, &r->value_room, operand);
        while (accept(r, ")"))
            if (!close_parenthesis(r))
                return -1;
        const int kind = accept(r, "+")    ? OP_ADD
                         : accept_minus(r) ? OP_SUB
                         : accept(r, "*")  ? OP_MUL
                         : accept(r, "/")  ? OP_DIV
                                           : OPEN;
        apply(r, kind == OPEN ? 1 : precedence(kind));
        if (kind == OPEN)
            return r->waits ? -1 : r->value[0];
        defer(r, kind);
    }
}

/* ---- statements ---- */

void program_add_statement(struct program *p, const char *name, int op, size_t first, long output)
{
    APPEND(p->statement, p->statements, p->statement_room) =
        (struct statement){new_text(name, strlen(name)), op, (int)first, output};
}

/* Returns true for "*out_NAME" (of a segment "*NAME", of a face "NAME[0]") of the genome's next output. */
static bool is_next_output(const struct statement_reader *r, const char *word)
{
    const size_t k = r->program->outputs;
    const char *name = r->file->segment ? word : strncmp(word, "out_", 4) == 0 ? word + 4 : "";
    return k < r->genome->outs && strcmp(name, r->genome->out[k].name) == 0;
}

bool program_is_constant(const struct program *p, int op)
{
    return p->op[p->op[op].kind == OP_NEG ? p->op[op].a : op].kind == OP_CONSTANT;
}

bool program_hides_constants(const struct genome_file *f)
{
    return f->segment && !f->face;
}

static bool read_statement(struct statement_reader *r)
{
    struct program *p = r->program;
    char word[MOST_WORD + 1];
    const size_t first = p->ops;
    const size_t next = p->outputs;
    const char *name = r->file->face && next < r->genome->outs ? r->genome->out[next].name : "*";
    const bool output = strncmp(r->at, name, strlen(name)) == 0;
    if (output && !r->file->face)
        r->at++;
    const bool changes = !output && !accept(r, "const"); /* a variable, which only constants may be */
    if (!output && !accept(r, "double"))
        return false;
    if (!read_word(r, word) || (output && !is_next_output(r, word)) || !accept(r, "="))
        return false;
    const bool hidden = !output && program_hides_constants(r->file) && accept(r, "zero");
    if (hidden && !accept(r, "+") && *r->at != '-')
        return false;
    const int op = read_expression(r);
    if (op < 0 || !accept(r, ";") || ((hidden || changes) && !program_is_constant(p, op)))
        return false;
    if (!output) {
        program_add_statement(p, word, op, first, -1);
        const bool new = find_name(r, word) < 0;
        if (new)
            names_add(&r->names, word, NAME_NUMBER, op, NO_STATEMENT);
        return new;
    }
    program_add_statement(p, r->genome->out[p->outputs].name, op, first, (long)p->outputs);
    p->output[p->outputs++] = op;
    return true;
}

struct program *program_read(const struct genome_file *f, const struct genome *genome, const char *statements,
                             struct diag *d)
{
    struct program *p = program_new(f, genome->outs);
    struct statement_reader r = {.file = f, .genome = genome, .program = p, .at = statements};
    bool good = true;
    const char *start = statements;
    for (skip_blanks(&r); good && *r.at; skip_blanks(&r)) {
        start = r.at;
        good = read_statement(&r);
    }
    good = good && p->outputs == genome->outs;
    names_free(r.names);
    free(r.value);
    free(r.waiting);
    if (good)
        return p;
    diag_at(d, f->path, genome->line, 1, "internal error: cannot read the code made for genome '%s': '%.*s'",
            genome->name, (int)strcspn(start, "\n;") > 60 ? 60 : (int)strcspn(start, "\n;"), start);
    program_free(p);
    return NULL;
}

struct program *program_new(const struct genome_file *f, size_t outputs)
{
    struct program *p = new_array(1, sizeof *p);
    p->inputs = f->inputs;
    p->output = new_array(outputs, sizeof *p->output);
    for (size_t i = 0; i < f->inputs; i++) {
        const int op = program_add(p, OP_INPUT, -1, -1);
        p->op[op].input = op;
    }
    return p;
}

static bool op_equal(const struct program *p, const struct program *q, size_t i)
{
    const struct op *a = &p->op[i], *b = &q->op[i];
    return a->kind == b->kind && a->a == b->a && a->b == b->b && a->quotient == b->quotient && a->input == b->input &&
           (a->kind != OP_CONSTANT || fmpq_equal(&p->constant[a->input], &q->constant[b->input]));
}

static bool statement_equal(const struct statement *a, const struct statement *b)
{
    return strcmp(a->name, b->name) == 0 && a->op == b->op && a->first == b->first && a->output == b->output;
}

bool program_equal(const struct program *p, const struct program *q)
{
    bool equal =
        p->ops == q->ops && p->statements == q->statements && p->inputs == q->inputs && p->outputs == q->outputs;
    for (size_t i = 0; equal && i < p->ops; i++)
        equal = op_equal(p, q, i);
    for (size_t i = 0; equal && i < p->statements; i++)
        equal = statement_equal(&p->statement[i], &q->statement[i]);
    return equal;
}

bool *program_reads(const struct program *p)
{
    bool *reads = new_array(p->ops, sizeof *reads);
    for (size_t i = 0; i < p->ops; i++) {
        if (p->op[i].a >= 0)
            reads[p->op[i].a] = true;
        if (p->op[i].b >= 0)
            reads[p->op[i].b] = true;
    }
    for (size_t i = 0; i < p->outputs; i++)
        reads[p->output[i]] = true;
    return reads;
}

struct operations program_count(const struct program *p)
{
    long n[OP_KINDS] = {0};
    for (size_t i = 0; i < p->ops; i++)
        n[p->op[i].kind]++;
    struct operations ops = {.mul = n[OP_MUL],
                             .div = n[OP_DIV] + n[OP_PDIV],
                             .add = n[OP_ADD] + n[OP_SUB],
                             .compare = n[OP_MIN] + n[OP_MAX] + n[OP_PDIV],
                             .temporaries = (long)(p->statements - p->outputs)};
    for (unsigned k = 0; k < UNARIES; k++)
        unary_count(&ops, k, n[OP_UNARY + k]);
    return ops;
}

void program_free(struct program *p)
{
    if (!p)
        return;
    forget_ops(p, 0);
    for (size_t i = 0; i < p->statements; i++)
        free(p->statement[i].name);
    free(p->statement);
    free(p->constant);
    free(p->output);
    free(p->op);
    free(p);
}
