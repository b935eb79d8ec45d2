/* The printer of programs; see dialect.h. It writes text from left to right with a stack of patterns, so that chains of
 * any length need neither recursion nor copies. */
#include "dialect.h"

#include "../base/text.h"
#include "../graph/constant_text.h"

#include <stdlib.h>
#include <string.h>

void split_constant(const fmpq *value, bool *negative, char **num, char **den)
{
    char *text = constant_text(value), *digits = text + strspn(text, "(-"), *over = strstr(text, ".0 / ");
    *negative = strchr(text, '-') != NULL;
    *den = NULL;
    if (over) {
        char *below = over + strlen(".0 / ");
        *over = '\0';
        *den = new_text(below, strlen(below) - strlen(".0)"));
    }
    *num = new_text(digits, strlen(digits));
    free(text);
}

/* Returns the number of underscores that distinguish temporaries (t1, u2, c3) from all inputs and outputs. */
static size_t tail_length(const struct genome_file *f, const struct genome *g)
{
    size_t tail = 0;
    for (size_t i = 0; i < f->inputs + g->outs; i++) {
        const char *name = i < f->inputs ? f->input[i] : g->out[i - f->inputs].name;
        const size_t digits = strspn(name + 1, "0123456789"), under = strspn(name + 1 + digits, "_");
        if (strchr("tuc", name[0]) && digits && !name[1 + digits + under] && under >= tail)
            tail = under + 1;
    }
    return tail;
}

struct printer *printer_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                            const struct dialect *d)
{
    struct printer *r = new_array(1, sizeof *r);
    *r = (struct printer){.file = f, .genome = genome, .program = p, .dialect = d};
    r->name = new_array(p->ops, sizeof *r->name);
    r->level = new_array(p->ops, sizeof *r->level);
    r->width = new_array(p->ops, sizeof *r->width);
    r->tail = d->bare ? tail_length(f, genome) : 0;
    return r;
}

void printer_free(struct printer *r)
{
    for (size_t i = 0; i < r->program->ops; i++)
        free(r->name[i]);
    free(r->name);
    free(r->level);
    free(r->width);
    free(r);
}

static const struct pattern *pattern_of(const struct printer *r, int op)
{
    const struct op *o = &r->program->op[op];
    const struct dialect *d = r->dialect;
    const bool chooses = o->kind == OP_MIN || o->kind == OP_MAX;
    if (o->squared && d->square.text)
        return &d->square;
    if (chooses && program_is_constant(r->program, o->b) && d->second[o->kind - OP_MIN].text)
        return &d->second[o->kind - OP_MIN];
    return &d->op[o->kind];
}

static char *constant(const struct dialect *d, const fmpq *value, enum level *level)
{
    if (d->constant)
        return d->constant(value, level);
    bool negative;
    char *num, *den;
    split_constant(value, &negative, &num, &den);
    const char *sign = negative ? "-" : "";
    char *text = den ? new_format(d->quotient, sign, num, den) : new_format(d->decimal, sign, num);
    *level = negative ? LEVEL_MINUS : LEVEL_NAME;
    free(num);
    free(den);
    return text;
}

/* Returns the text of a name, an input or a constant, and its level; NULL for an operation with operands. */
static char *leaf_text(const struct printer *r, int op, enum level *level)
{
    const struct op *o = &r->program->op[op];
    *level = LEVEL_NAME;
    if (r->name[op])
        return new_text(r->name[op], strlen(r->name[op]));
    if (o->kind == OP_CONSTANT)
        return constant(r->dialect, &r->program->constant[o->input], level);
    return o->kind == OP_INPUT ? r->dialect->input(r->file, (size_t)o->input) : NULL;
}

/* Computes level and width of an operation from its operands'. A product that begins with a sign counts as signed. */
static void measure(struct printer *r, int op)
{
    const struct op *o = &r->program->op[op];
    char *leaf = leaf_text(r, op, &r->level[op]);
    if (leaf) {
        r->width[op] = strlen(leaf);
        free(leaf);
        return;
    }
    const struct pattern *p = pattern_of(r, op);
    const bool signed_product = p->level == LEVEL_PRODUCT && p->text[0] == '$' && r->level[o->a] == LEVEL_MINUS;
    r->level[op] = signed_product ? LEVEL_MINUS : p->level;
    r->width[op] = strlen(p->text) + r->width[o->a] + (o->b >= 0 ? r->width[o->b] : 0);
}

/* ---- text ---- */

struct step {
    const char *at; /* rest of a pattern */
    int op;         /* operation whose operands the pattern names */
};

struct writer {
    struct printer *r;
    char *text; /* owned */
    size_t n, room;
    struct step *step; /* owned: a stack */
    size_t steps, step_room;
};

static void write_char(struct writer *w, char c)
{
    APPEND(w->text, w->n, w->room) = c;
}

static void write_text(struct writer *w, const char *s)
{
    for (; *s; s++)
        write_char(w, *s);
}

static void push(struct writer *w, const char *at, int op)
{
    APPEND(w->step, w->steps, w->step_room) = (struct step){at, op};
}

static void begin(struct writer *w, int op, enum level least)
{
    enum level level;
    char *leaf = leaf_text(w->r, op, &level);
    if (w->r->level[op] < least) {
        write_text(w, w->r->dialect->open);
        push(w, w->r->dialect->close, op);
    }
    push(w, leaf ? "" : pattern_of(w->r, op)->text, op);
    if (leaf)
        write_text(w, leaf);
    free(leaf);
}

char *printer_text(struct printer *r, int op, enum level least)
{
    struct writer w = {.r = r};
    begin(&w, op, least);
    while (w.steps) {
        struct step *s = &w.step[w.steps - 1];
        const char c = *s->at;
        if (c == '\0')
            w.steps--;
        else if (c == '$') {
            const struct op *o = &r->program->op[s->op];
            const int operand = s->at[1] == 'a' ? o->a : o->b, level = s->at[2] - '0';
            s->at += 3;
            begin(&w, operand, (enum level)level);
        } else {
            s->at++;
            write_char(&w, c);
        }
    }
    write_char(&w, '\0');
    free(w.step);
    return w.text;
}

static char *temporary_name(const struct printer *r, const char *plain)
{
    char *with_tail = new_format("%s%.*s", plain, (int)r->tail,
                                 "________________________________________________"
                                 "________________");
    if (!r->dialect->name)
        return with_tail;
    char *name = r->dialect->name(with_tail);
    free(with_tail);
    return name;
}

static void name_part(struct printer *r, int op, const char *plain, write_statement *write, void *to)
{
    char *text = printer_text(r, op, LEVEL_SUM);
    r->name[op] = temporary_name(r, plain);
    write(to, r->name[op], -1, text);
    free(text);
    measure(r, op);
}

void printer_run(struct printer *r, write_statement *write, void *to)
{
    const struct program *p = r->program;
    int next = 0; /* operations below it are measured */
    for (size_t i = 0; i < p->statements; i++) {
        const struct statement *s = &p->statement[i];
        for (; next <= s->op; next++) {
            measure(r, next);
            if (r->dialect->longest && next < s->op && r->width[next] > r->dialect->longest) {
                char *plain = new_format("c%ld", ++r->cuts);
                name_part(r, next, plain, write, to);
                free(plain);
            }
        }
        if (s->output < 0 && !r->name[s->op])
            name_part(r, s->op, s->name, write, to);
        else {
            char *text = printer_text(r, s->op, LEVEL_SUM);
            char *name = s->output < 0      ? temporary_name(r, s->name)
                         : r->dialect->name ? r->dialect->name(s->name)
                                            : new_text(s->name, strlen(s->name));
            write(to, name, s->output, text);
            free(name);
            free(text);
        }
    }
}
