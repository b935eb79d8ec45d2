/* The emitted text is parsed again and evaluated beside its genome; see prove.h.  The two evaluations share nothing
 * with the passes in between but the arithmetic below. */
#include "prove.h"

#include <ctype.h>
#include <flint/fmpq.h>
#include <flint/ulong_extras.h>
#include <search.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 8, TRIES = 80, MOST_BITS = 1 << 16 };

static const mp_limb_t prime = 1152921504606846577UL; /* below 2^60; not one that the passes use */

/* A number twice: exact while it is small enough, and modulo the prime. */
struct number {
    fmpq_t q;
    bool exact;
    mp_limb_t m;
};

static mp_limb_t multiply_mod(mp_limb_t a, mp_limb_t b)
{
    return n_mulmod2(a, b, prime);
}

static mp_limb_t hash(mp_limb_t z)
{
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static void number_init(struct number *x)
{
    fmpq_init(x->q);
    x->exact = true;
    x->m = 0;
}

static void number_set(struct number *x, const struct number *y)
{
    fmpq_set(x->q, y->q);
    x->exact = y->exact;
    x->m = y->m;
}

static void set_rational(struct number *x, const fmpq *q)
{
    const mp_limb_t n = fmpz_fdiv_ui(fmpq_numref(q), prime), d = fmpz_fdiv_ui(fmpq_denref(q), prime);
    if (q != x->q)
        fmpq_set(x->q, q);
    x->exact = true;
    x->m = multiply_mod(n, n_invmod(d, prime));
}

static bool is_zero(const struct number *x)
{
    return x->exact ? fmpq_is_zero(x->q) : x->m == 0;
}

/* An arbitrary function with the squares' roots right. */
static void square_root(struct number *x)
{
    if (x->exact && fmpz_is_square(fmpq_numref(x->q)) && fmpz_is_square(fmpq_denref(x->q))) {
        fmpz_sqrt(fmpq_numref(x->q), fmpq_numref(x->q));
        fmpz_sqrt(fmpq_denref(x->q), fmpq_denref(x->q));
        set_rational(x, x->q);
        return;
    }
    fmpq_set_si(x->q, (slong)(hash(x->m) % 100003), 8);
    set_rational(x, x->q);
}

/* *x = *x op *y; false for a division by 0, and for a function that only exact numbers decide. */
static bool apply(int op, struct number *x, const struct number *y)
{
    const bool exact = x->exact && (gene_arity(op) == 1 || y->exact), protected_zero = op == GENE_PDIV && is_zero(y);
    mp_limb_t m = 0;
    if ((op == GENE_DIV || (op == GENE_PDIV && !protected_zero)) && (y->m == 0 || is_zero(y)))
        return false;
    if (!exact && (op == GENE_SQRT || op == GENE_MIN || op == GENE_MAX || op == GENE_ABS))
        return false;
    if (op == GENE_SQRT) {
        square_root(x);
        return true;
    }
    if (op == GENE_ADD)
        m = n_addmod(x->m, y->m, prime);
    else if (op == GENE_SUB)
        m = n_submod(x->m, y->m, prime);
    else if (op == GENE_MUL)
        m = multiply_mod(x->m, y->m);
    else if (op == GENE_DIV || op == GENE_PDIV)
        m = protected_zero ? 1 : multiply_mod(x->m, n_invmod(y->m, prime));
    else if (op == GENE_NEG)
        m = n_negmod(x->m, prime);
    if (!exact) {
        x->exact = false;
        x->m = m;
        return true;
    }
    if (op == GENE_ADD)
        fmpq_add(x->q, x->q, y->q);
    else if (op == GENE_SUB)
        fmpq_sub(x->q, x->q, y->q);
    else if (op == GENE_MUL)
        fmpq_mul(x->q, x->q, y->q);
    else if (protected_zero)
        fmpq_one(x->q);
    else if (op == GENE_DIV || op == GENE_PDIV)
        fmpq_div(x->q, x->q, y->q);
    else if (op == GENE_NEG)
        fmpq_neg(x->q, x->q);
    else if (op == GENE_ABS)
        fmpq_abs(x->q, x->q);
    else if ((fmpq_cmp(y->q, x->q) < 0) == (op == GENE_MIN))
        fmpq_set(x->q, y->q);
    if (op == GENE_MIN || op == GENE_MAX || op == GENE_ABS)
        set_rational(x, x->q);
    else
        x->m = m;
    x->exact = fmpq_height_bits(x->q) <= MOST_BITS;
    return true;
}

/* Decimal text, exactly. */
static const char *read_decimal(struct number *x, const char *text)
{
    fmpz_t ten;
    long exponent = 0;
    bool after = false;
    const bool negative = *text == '-';
    fmpq_t q;
    fmpq_init(q);
    fmpz_init_set_ui(ten, 10);
    text += *text == '-' || *text == '+';
    for (; isdigit((unsigned char)*text) || *text == '.'; text++) {
        if (*text == '.') {
            after = true;
            continue;
        }
        fmpz_mul_ui(fmpq_numref(q), fmpq_numref(q), 10);
        fmpz_add_ui(fmpq_numref(q), fmpq_numref(q), (unsigned long)(*text - '0'));
        exponent -= after;
    }
    if (*text == 'e' || *text == 'E') {
        char *end;
        exponent += strtol(text + 1, &end, 10);
        text = end;
    }
    fmpz_pow_ui(ten, ten, (unsigned long)labs(exponent));
    if (exponent < 0)
        fmpq_div_fmpz(q, q, ten);
    else
        fmpq_mul_fmpz(q, q, ten);
    if (negative)
        fmpq_neg(q, q);
    set_rational(x, q);
    fmpz_clear(ten);
    fmpq_clear(q);
    return text;
}

/* ---- the genome ---- */

struct values {
    struct number *v; /* owned */
    size_t n, room;
};

static struct number *push(struct values *s)
{
    grow_array(&s->v, s->n, &s->room, sizeof *s->v);
    number_init(&s->v[s->n]);
    return &s->v[s->n++];
}

static void pop(struct values *s)
{
    fmpq_clear(s->v[--s->n].q);
}

static void values_free(struct values *s)
{
    while (s->n)
        pop(s);
    free(s->v);
}

/* Value of an expression into *out; symbols by their index. */
static bool evaluate_expression(const struct genome_file *f, const struct genome_expr *e, const struct values *symbols,
                                struct number *out)
{
    struct values stack = {0};
    bool good = true;
    for (size_t i = e->length; good && i-- > 0;) {
        const int gene = e->gene[i];
        if (gene < 0)
            read_decimal(push(&stack), f->constant[-1 - gene].text);
        else if (gene >= GENE_SYMBOL)
            number_set(push(&stack), &symbols->v[gene - GENE_SYMBOL]);
        else if (gene_arity(gene) == 1)
            good = apply(gene, &stack.v[stack.n - 1], NULL);
        else {
            good = apply(gene, &stack.v[stack.n - 1], &stack.v[stack.n - 2]);
            const struct number swap = stack.v[stack.n - 1];
            stack.v[stack.n - 1] = stack.v[stack.n - 2];
            stack.v[stack.n - 2] = swap;
            pop(&stack);
        }
    }
    if (good)
        number_set(out, &stack.v[0]);
    values_free(&stack);
    return good;
}

/* ---- the emitted text ---- */

struct named_value {
    char *name; /* owned */
    size_t index;
};

struct reader {
    const struct genome_file *file;
    const char *at;
    const struct values *inputs;
    struct values locals;
    void *names;
    bool good, division; /* division: a divisor was 0 */
};

static void skip_blanks(struct reader *r)
{
    while (isspace((unsigned char)*r->at))
        r->at++;
}

static bool accept(struct reader *r, const char *word)
{
    skip_blanks(r);
    const size_t n = strlen(word);
    if (strncmp(r->at, word, n) != 0)
        return false;
    r->at += n;
    return true;
}

static void expect(struct reader *r, const char *word)
{
    r->good = accept(r, word) && r->good;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(((const struct named_value *)a)->name, ((const struct named_value *)b)->name);
}

static void free_name(void *p)
{
    free(((struct named_value *)p)->name);
    free(p);
}

static size_t read_word(struct reader *r, char word[80])
{
    size_t n = 0;
    skip_blanks(r);
    while ((isalnum((unsigned char)*r->at) || *r->at == '_' || *r->at == '[' || *r->at == ']') && n < 79)
        word[n++] = *r->at++;
    word[n] = '\0';
    return n;
}

static void read_variable(struct reader *r, struct number *x)
{
    char word[80], input[80];
    if (!read_word(r, word)) {
        r->good = false;
        return;
    }
    struct named_value key = {word, 0}, *const *found = tfind(&key, &r->names, compare_names);
    if (found) {
        number_set(x, &r->locals.v[(*found)->index]);
        return;
    }
    if (r->file->segment) /* xA[2] is input zA */
        snprintf(input, sizeof input, "%c%c", word[3] - '0' + 'x', word[1]);
    else
        snprintf(input, sizeof input, "%s", strlen(word) > 3 ? word + 3 : "");
    const long k = genome_find_symbol(r->file, input);
    if (k < 0 || (size_t)k >= r->file->inputs)
        r->good = false;
    else
        number_set(x, &r->inputs->v[k]);
}

static bool same_number(const struct number *a, const struct number *b)
{
    return a->exact && b->exact ? fmpq_equal(a->q, b->q) : a->m == b->m;
}

static void read_sum(struct reader *r, struct number *x);

/* After "(": a sum, or a choice `a < b ? a : b`, `a > b ? a : b`, `d == 0.0 ? 1.0 : n / d`. */
static void read_parenthesis(struct reader *r, struct number *x)
{
    struct number y, then, otherwise;
    read_sum(r, x);
    const char relation = accept(r, "<") ? '<' : accept(r, ">") ? '>' : accept(r, "==") ? '=' : 0;
    if (relation) {
        number_init(&y);
        number_init(&then);
        number_init(&otherwise);
        read_sum(r, &y);
        expect(r, "?");
        read_sum(r, &then);
        expect(r, ":");
        const bool division = r->division, zero = is_zero(x);
        read_sum(r, &otherwise);
        if (relation == '=') {
            if (zero)
                r->division = division; /* the branch not taken does not count */
            r->good = r->good && is_zero(&y);
            number_set(x, zero ? &then : &otherwise);
        } else {
            r->good = r->good && same_number(&then, x) && same_number(&otherwise, &y);
            r->division = !apply(relation == '<' ? GENE_MIN : GENE_MAX, x, &y) || r->division;
        }
        fmpq_clear(y.q);
        fmpq_clear(then.q);
        fmpq_clear(otherwise.q);
    }
    expect(r, ")");
}

static void read_factor(struct reader *r, struct number *x)
{
    if (accept(r, "-")) {
        read_factor(r, x);
        r->division = !apply(GENE_NEG, x, NULL) || r->division;
    } else if (accept(r, "sqrt(")) {
        read_sum(r, x);
        expect(r, ")");
        r->division = !apply(GENE_SQRT, x, NULL) || r->division;
    } else if (accept(r, "fabs(")) {
        read_sum(r, x);
        expect(r, ")");
        r->division = !apply(GENE_ABS, x, NULL) || r->division;
    } else if (accept(r, "("))
        read_parenthesis(r, x);
    else if (isdigit((unsigned char)*r->at))
        r->at = read_decimal(x, r->at);
    else
        read_variable(r, x);
}

static void read_chain(struct reader *r, struct number *x, bool product)
{
    struct number y;
    number_init(&y);
    if (product)
        read_factor(r, x);
    else
        read_chain(r, x, true);
    while (r->good && !r->division) {
        const bool first = accept(r, product ? "*" : "+");
        if (!first && !accept(r, product ? "/" : "-"))
            break;
        if (product)
            read_factor(r, &y);
        else
            read_chain(r, &y, true);
        const int op = product ? (first ? GENE_MUL : GENE_DIV) : first ? GENE_ADD : GENE_SUB;
        if (!apply(op, x, &y))
            r->division = true;
    }
    fmpq_clear(y.q);
}

static void read_sum(struct reader *r, struct number *x)
{
    read_chain(r, x, false);
}

/* All statements; values of the outputs, in order, to out. */
static void read_statements(struct reader *r, const struct genome *genome, struct number *out)
{
    char word[80];
    for (size_t outputs = 0; r->good && !r->division;) {
        skip_blanks(r);
        if (!*r->at)
            break;
        const bool output = accept(r, "*");
        if (!output)
            expect(r, "const double");
        read_word(r, word);
        expect(r, "=");
        if (output) { /* in the genome's order, each by its name */
            const char *name = outputs < genome->outs ? genome->out[outputs].name : "";
            const char *written = r->file->segment ? word : strncmp(word, "out_", 4) == 0 ? word + 4 : "";
            if (!*name || strcmp(written, name) != 0) {
                r->good = false;
                break;
            }
        }
        struct number *x = output ? &out[outputs++] : push(&r->locals);
        read_sum(r, x);
        expect(r, ";");
        if (!output) {
            struct named_value *n = new_array(1, sizeof *n);
            *n = (struct named_value){new_text(word, strlen(word)), r->locals.n - 1};
            tsearch(n, &r->names, compare_names);
        }
    }
}

static void free_names(void **root)
{
    while (*root) {
        struct named_value *n = **(struct named_value ***)root;
        tdelete(n, root, compare_names);
        free_name(n);
    }
}

/* The lets that the outputs need. */
static void mark_needed(const struct genome_file *f, const struct genome *genome, bool *needed)
{
    for (size_t k = f->lets + genome->outs; k-- > 0;) {
        const struct genome_expr *e = k < f->lets ? &f->let[k] : &genome->out[k - f->lets];
        for (size_t i = 0; (k >= f->lets || needed[f->inputs + k]) && i < e->length; i++)
            if (e->gene[i] >= GENE_SYMBOL)
                needed[e->gene[i] - GENE_SYMBOL] = true;
    }
}

/* Coordinate i of a point: rationals at first; later small ones, on which no number grows. */
static void set_coordinate(fmpq_t q, unsigned long attempt, size_t i)
{
    const mp_limb_t h = hash(attempt * 1000003 + i);
    if (attempt <= TRIES / 2)
        fmpq_set_si(q, (slong)(h % 509) - 254, 1UL << (h >> 60));
    else
        fmpq_set_si(q, (slong)(h % 5) - 2, 2);
}

/* One point: 1 equal, 0 different, -1 a divisor is 0 there. */
static int compare_at(const struct genome_file *f, const struct genome *genome, const char *statements,
                      unsigned long seed)
{
    struct values symbols = {0}, out = {0}, text = {0};
    int result = 1;
    bool *needed = new_array(f->inputs + f->lets, sizeof *needed);
    fmpq_t q;
    fmpq_init(q);
    mark_needed(f, genome, needed);
    for (size_t i = 0; i < f->inputs; i++) {
        set_coordinate(q, seed, i);
        set_rational(push(&symbols), q);
    }
    for (size_t i = 0; i < f->lets && result > 0; i++) {
        struct number *x = push(&symbols);
        if (needed[f->inputs + i] && !evaluate_expression(f, &f->let[i], &symbols, x))
            result = -1;
    }
    for (size_t i = 0; i < genome->outs && result > 0; i++) {
        push(&text);
        if (!evaluate_expression(f, &genome->out[i], &symbols, push(&out)))
            result = -1;
    }
    if (result > 0) {
        struct reader r = {.file = f, .at = statements, .inputs = &symbols, .good = true};
        read_statements(&r, genome, text.v);
        if (r.division)
            result = -1;
        for (size_t i = 0; i < genome->outs && result > 0; i++) {
            if (!r.good || !same_number(&out.v[i], &text.v[i]))
                result = 0;
        }
        free_names(&r.names);
        values_free(&r.locals);
    }
    values_free(&symbols);
    values_free(&out);
    values_free(&text);
    fmpq_clear(q);
    free(needed);
    return result;
}

bool prove_equal(const struct genome_file *f, const struct genome *genome, const char *statements, struct diag *d)
{
    int equal = 0;
    for (unsigned long attempt = 1; attempt <= TRIES && equal < POINTS; attempt++) {
        const int result = compare_at(f, genome, statements, attempt);
        if (result == 0)
            return diag_at(d, f->path, genome->line, 1,
                           "internal error: the code made for genome '%s' does not equal it", genome->name);
        equal += result > 0;
    }
    return equal == POINTS || diag_at(d, f->path, genome->line, 1,
                                      "genome '%s' divides by 0, or its numbers grow too large, at %d of %d points",
                                      genome->name, TRIES - equal, TRIES);
}
