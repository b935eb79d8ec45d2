/* Register programs; see line_program.h. A hash table of lines finds equal values. */
#include "line_program.h"

#include "../../codegen/base/random.h"
#include "../../codegen/genome/gene_value.h"
#include "../common/decimal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int *no_lines(size_t n)
{
    int *line = new_array(n, sizeof *line);
    for (size_t i = 0; i < n; i++)
        line[i] = -1;
    return line;
}

int line_function(const struct genome_file *program, const char *name)
{
    const long k = genome_find_function(program, name);
    return k < 0 || !genome_function_of_pair(&program->function[k]) ? -1 : (int)k;
}

/* ---- lengths ---- */

static int power_of(int gene, int a, int b)
{
    if (a == NO_POWER || b == NO_POWER)
        return NO_POWER;
    if (gene == GENE_NEG)
        return a;
    if (gene >= GENE_UNARY(0)) {
        const int root = unary_of[gene - GENE_UNARY(0)].root;
        return root == 0 || a == ANY_POWER || a % root != 0 ? ANY_POWER : a / root;
    }
    if (gene == GENE_MUL || gene == GENE_DIV || gene == GENE_PDIV) {
        const int sum = gene == GENE_MUL ? a + b : a - b;
        return a == ANY_POWER || b == ANY_POWER || sum < -100 || sum > 100 ? ANY_POWER : sum;
    }
    return a == b || b == ANY_POWER ? a : a == ANY_POWER ? b : NO_POWER;
}

static int power_of_gene(void *rules, int gene, int a, int b)
{
    const struct line_rules *r = rules;
    if (!gene_is_leaf(gene))
        return power_of(gene, a, b);
    return gene < 0 ? 0 : r->power[gene - GENE_SYMBOL];
}

/* Finds the power of length of each let of a frame. A let that adds unlike powers counts as ANY_POWER. */
static void find_powers(struct line_rules *r)
{
    const struct genome_file *f = r->program;
    const size_t nodes = f->segment ? 3 * strlen(f->segment->nodes) : f->inputs;
    for (size_t i = 0; i < f->inputs; i++)
        r->power[i] = i < nodes || i + 3 >= f->inputs; /* normals are dimensionless */
    for (size_t k = 0; k < f->lets; k++) {
        const struct genome_expr *let = &f->let[k];
        const int power = gene_fold(let->gene, let->length, power_of_gene, r);
        r->power[f->inputs + k] = (signed char)(power == NO_POWER ? ANY_POWER : power);
    }
}

void lines_powers(const struct lines *c, signed char *power)
{
    for (size_t i = 0; i < c->lines; i++) {
        const struct line *x = &c->line[i];
        if (line_is_operation(x))
            power[i] = (signed char)power_of(x->gene, power[x->a], power[x->b >= 0 ? x->b : x->a]);
        else
            power[i] = x->gene < 0 ? (x->number == 0 ? ANY_POWER : 0) : c->rules->power[x->gene - GENE_SYMBOL];
    }
}

bool lines_keep_powers(const struct lines *c)
{
    signed char *power = new_array(c->lines, sizeof *power);
    lines_powers(c, power);
    bool good = true;
    for (size_t i = 0; i < c->lines; i++)
        good = good && !(c->needed[i] && power[i] == NO_POWER);
    free(power);
    return good;
}

/* ---- rules ---- */

struct line_rules *line_rules_new(const struct genome_file *program)
{
    struct line_rules *r = new_array(1, sizeof *r);
    *r = (struct line_rules){.program = program, .symbols = program->inputs + program->lets};
    r->partner = new_array(r->symbols, sizeof *r->partner);
    r->power = new_array(r->symbols, sizeof *r->power);
    for (size_t i = 0; i < r->symbols; i++)
        r->partner[i] = i;
    for (size_t i = 0; i < program->exchanges; i++)
        for (int k = 0; k < 2; k++)
            r->partner[program->exchange[i][k]] = program->exchange[i][1 - k];
    find_powers(r);
    return r;
}

void line_rules_free(struct line_rules *r)
{
    if (!r)
        return;
    free(r->partner);
    free(r->power);
    free(r);
}

/* ---- lines ---- */

struct lines *lines_new(const struct line_rules *r)
{
    struct lines *c = new_array(1, sizeof *c);
    c->rules = r;
    return c;
}

void lines_free(struct lines *c)
{
    if (!c)
        return;
    free(c->line);
    free(c->needed);
    free(c->divides);
    free(c->number);
    free(c->place);
    index_free(&c->known);
    free(c->map);
    free(c);
}

static uint64_t hash_of(const struct line *x)
{
    uint64_t bits, h;
    memcpy(&bits, &x->number, sizeof bits);
    h = ((uint64_t)(unsigned)x->gene * 0x9e3779b97f4a7c15u) ^ ((uint64_t)(unsigned)x->a * 0xbf58476d1ce4e5b9u) ^
        ((uint64_t)(unsigned)x->b * 0x94d049bb133111ebu) ^ bits;
    return random_mix(h);
}

static bool same(const struct line *x, const struct line *y)
{
    return x->gene == y->gene && x->a == y->a && x->b == y->b && memcmp(&x->number, &y->number, sizeof x->number) == 0;
}

/* Returns the equal line that exists already, or -1. */
static int known_line(const struct lines *c, const struct line *x)
{
    const uint64_t hash = hash_of(x);
    size_t probe = 0;
    for (int i; (i = index_next(&c->known, hash, &probe)) >= 0;)
        if (same(&c->line[i], x))
            return i;
    return -1;
}

/* Orders operations as they were built, then leaves by gene, whatever the order in which leaves were read. */
static bool stands_before(const struct lines *c, int i, int j)
{
    const struct line *x = &c->line[i], *y = &c->line[j];
    if (line_is_operation(x) || line_is_operation(y))
        return line_is_operation(x) && (!line_is_operation(y) || i < j);
    if (x->gene != y->gene)
        return x->gene < y->gene;
    return x->number != y->number ? x->number < y->number : i < j;
}

static struct line ordered(const struct lines *c, struct line x)
{
    if ((x.gene == GENE_ADD || x.gene == GENE_MUL) && stands_before(c, x.b, x.a)) {
        const int a = x.a;
        x.a = x.b;
        x.b = a;
    }
    return x;
}

/* Returns the equal line, or adds a new line. */
static int line_of(struct lines *c, struct line x)
{
    x = ordered(c, x);
    const int known = known_line(c, &x);
    if (known >= 0)
        return known;
    index_add(&c->known, hash_of(&x), (int)c->lines);
    grow_array(&c->line, c->lines, &c->room, sizeof *c->line);
    c->line[c->lines] = x;
    return (int)c->lines++;
}

void lines_begin(struct lines *c)
{
    c->lines = c->numbers = 0;
    index_clear(&c->known);
}

int lines_symbol(struct lines *c, int gene)
{
    return line_of(c, (struct line){gene, -1, -1, 0});
}

int lines_number(struct lines *c, double value)
{
    return line_of(c, (struct line){LINE_NUMBER, -1, -1, value == 0 ? 0 : value});
}

/* Returns true if line i is this number. A number that is to be fitted has no fixed value yet, so it never matches. */
static bool is_number(const struct lines *c, int i, double value)
{
    return i >= 0 && c->line[i].gene == LINE_NUMBER && c->line[i].a == -1 && c->line[i].number == value;
}

static bool is_known(const struct lines *c, int i)
{
    return c->line[i].gene == LINE_NUMBER && c->line[i].a == -1;
}

/* Returns the existing line to which an operation simplifies, or -1 if it does not simplify. */
static int simplified(struct lines *c, int gene, int a, int b)
{
    const bool product = gene == GENE_MUL, quotient = gene == GENE_DIV || gene == GENE_PDIV;
    if (gene == GENE_NEG && c->line[a].gene == GENE_NEG)
        return c->line[a].a;
    if ((gene == GENE_ADD || product) && b >= 0 && is_known(c, a)) {
        const int first = a;
        a = b;
        b = first;
    }
    if (((gene == GENE_ADD || gene == GENE_SUB) && is_number(c, b, 0)) || ((product || quotient) && is_number(c, b, 1)))
        return a;
    if ((product && is_number(c, b, 0)) || (quotient && is_number(c, a, 0)) || (gene == GENE_SUB && a == b))
        return lines_number(c, 0);
    if ((gene == GENE_MIN || gene == GENE_MAX) && a == b)
        return a;
    if (quotient && a == b)
        return lines_number(c, 1);
    return -1;
}

int lines_operation(struct lines *c, int gene, int a, int b)
{
    const int simple = simplified(c, gene, a, b);
    if (simple >= 0)
        return simple;
    if (is_known(c, a) && (b < 0 || is_known(c, b))) {
        const double v = gene_value(gene, c->line[a].number, b < 0 ? 0 : c->line[b].number);
        if (isfinite(v) && decimal_value(decimal_gene(v)) == v)
            return lines_number(c, v);
    }
    return line_of(c, (struct line){gene, a, b, 0});
}

static void reserve_map(struct lines *c, size_t n)
{
    if (c->map_room >= n)
        return;
    free(c->map);
    c->map_room = 2 * n;
    c->map = new_array(c->map_room, sizeof *c->map);
}

/* A call of a function. */
struct call {
    struct lines *lines;
    const struct genome_function *function;
    int *local; /* line of each parameter and let of the function; -1: not computed yet */
};

static int line_of_gene(void *call, int gene, int a, int b)
{
    struct call *c = call;
    if (!gene_is_leaf(gene))
        return lines_operation(c->lines, gene, a, b);
    if (gene < 0)
        return lines_number(c->lines, c->lines->rules->program->constant[-1 - gene].value);
    if (gene < GENE_LOCAL)
        return lines_symbol(c->lines, gene);
    int *line = &c->local[gene - GENE_LOCAL];
    if (*line < 0) {
        const struct genome_expr *let = &c->function->let[gene - c->function->first_let];
        *line = gene_fold(let->gene, let->length, line_of_gene, c);
    }
    return *line;
}

void lines_call(struct lines *c, int function, int x[2])
{
    const struct genome_function *f = &c->rules->program->function[function];
    const size_t locals = (size_t)(f->first_let - GENE_LOCAL) + f->lets;
    reserve_map(c, locals);
    for (size_t i = 0; i < locals; i++)
        c->map[i] = i < 2 ? x[i] : -1;
    struct call call = {c, f, c->map};
    for (int k = 0; k < 2; k++)
        x[k] = line_of_gene(&call, f->result[k].gene, -1, -1);
}

int lines_take(struct lines *to, const struct lines *from, int i, int *map)
{
    if (map[i] >= 0)
        return map[i];
    const struct line *x = &from->line[i];
    if (line_is_operation(x)) {
        const int a = lines_take(to, from, x->a, map), b = x->b >= 0 ? lines_take(to, from, x->b, map) : -1;
        return map[i] = lines_operation(to, x->gene, a, b);
    }
    return map[i] = x->gene == LINE_NUMBER ? lines_number(to, x->number) : lines_symbol(to, x->gene);
}

/* Sets needed[] and divides[]. */
static void mark(struct lines *c)
{
    if (c->needed_room < c->lines) {
        free(c->needed);
        free(c->divides);
        c->needed_room = 2 * c->lines;
        c->needed = new_array(c->needed_room, sizeof *c->needed);
        c->divides = new_array(c->needed_room, sizeof *c->divides);
    }
    memset(c->needed, 0, c->lines * sizeof *c->needed);
    memset(c->divides, 0, c->lines * sizeof *c->divides);
    c->needed[c->root[0]] = c->needed[c->root[1]] = true;
    for (size_t i = c->lines; i-- > 0;)
        if (c->needed[i]) {
            const struct line *x = &c->line[i];
            if (x->a >= 0)
                c->needed[x->a] = true;
            if (x->b >= 0)
                c->needed[x->b] = true;
            if (x->gene == GENE_DIV || x->gene == GENE_PDIV)
                c->divides[x->b] = true;
        }
}

void lines_images(struct lines *c, int *image)
{
    for (size_t i = 0; i < c->lines; i++) {
        struct line x = c->line[i];
        if (x.gene >= GENE_SYMBOL)
            x.gene = GENE_SYMBOL + (int)c->rules->partner[x.gene - GENE_SYMBOL];
        x.a = x.a >= 0 ? image[x.a] : x.a;
        x.b = x.b >= 0 ? image[x.b] : x.b;
        image[i] = -1;
        if (line_is_operation(&c->line[i]) && (x.a < 0 || (c->line[i].b >= 0 && x.b < 0)))
            continue;
        x = ordered(c, x);
        image[i] = known_line(c, &x);
    }
}

/* ---- genes ---- */

/* Returns true if a number is part of the structure, such as 1, 2 or 0.5, and must not be fitted. */
static bool is_kept(double value)
{
    const double twelve = 12 * value;
    return fabs(value) <= 64 && twelve == rint(twelve);
}

static bool valid_operand(const struct line_rules *r, int gene, size_t line)
{
    if (gene >= LINE_GENE)
        return (size_t)(gene - LINE_GENE) < line;
    return gene < 0 ? decimal_valid(gene) : gene >= GENE_SYMBOL && (size_t)(gene - GENE_SYMBOL) < r->symbols;
}

bool lines_valid(const struct line_rules *r, const int *gene, size_t length)
{
    if (length < 2 || (length - 2) % LINE_GENES != 0)
        return false;
    const size_t lines = (length - 2) / LINE_GENES;
    bool good = valid_operand(r, gene[0], lines) && valid_operand(r, gene[1], lines);
    for (size_t i = 0; good && i < lines; i++) {
        const int *g = gene + 2 + LINE_GENES * i;
        good = g[0] >= 0 && g[0] < GENE_OPERATORS && valid_operand(r, g[1], i) &&
               (gene_arity(g[0]) == 1 ? g[2] == -1 : valid_operand(r, g[2], i));
    }
    return good;
}

/* Loads an operand. A number with a line of its own is marked with the index of its gene. */
static int load_operand(struct lines *c, const struct genes *t, size_t at, const int *line, bool apart)
{
    const int gene = t->gene[at];
    if (gene >= LINE_GENE)
        return line[gene - LINE_GENE];
    if (gene >= 0)
        return lines_symbol(c, gene);
    const double value = decimal_value(gene);
    if (!apart || is_kept(value))
        return lines_number(c, value);
    const int own = line_of(c, (struct line){LINE_NUMBER, -2 - (int)at, -1, value});
    for (size_t i = 0; i < c->numbers; i++)
        if (c->number[i] == (size_t)own)
            return own;
    size_t room = c->number_room;
    grow_array(&c->number, c->numbers, &c->number_room, sizeof *c->number);
    grow_array(&c->place, c->numbers, &room, sizeof *c->place);
    c->number[c->numbers] = (size_t)own;
    c->place[c->numbers++] = at;
    return own;
}

void lines_load(struct lines *c, const struct genes *t, int last, enum lines_use use)
{
    const size_t n = (t->length - 2) / LINE_GENES;
    int *line = new_array(n, sizeof *line);
    const bool apart = use == LINES_APART;
    lines_begin(c);
    for (size_t i = 0; i < n; i++) {
        const size_t at = 2 + LINE_GENES * i;
        const int a = load_operand(c, t, at + 1, line, apart);
        const int b = gene_arity(t->gene[at]) == 2 ? load_operand(c, t, at + 2, line, apart) : -1;
        line[i] = lines_operation(c, t->gene[at], a, b);
    }
    for (size_t k = 0; k < 2; k++)
        c->root[k] = load_operand(c, t, k, line, apart);
    if (last >= 0 && use != LINES_INNER)
        lines_call(c, last, c->root);
    mark(c);
    free(line);
}

struct expression {
    struct lines *lines;
    const struct genome_constant *constant;
};

static int line_as_it_is(void *expression, int gene, int a, int b)
{
    const struct expression *e = expression;
    if (gene >= 0)
        return line_of(e->lines, (struct line){gene, a, b, 0});
    const double value = e->constant ? e->constant[-1 - gene].value : decimal_value(gene);
    return line_of(e->lines, (struct line){LINE_NUMBER, -1, -1, value});
}

void lines_expression(struct lines *c, const int *gene, size_t length, const struct genome_constant *constant)
{
    lines_begin(c);
    c->root[0] = c->root[1] = gene_fold(gene, length, line_as_it_is, &(struct expression){c, constant});
    mark(c);
}

static int operand_gene(const struct lines *c, int i, const int *number)
{
    const struct line *x = &c->line[i];
    return line_is_operation(x) ? LINE_GENE + number[i] : x->gene == LINE_NUMBER ? decimal_gene(x->number) : x->gene;
}

/* Numbers operations in the order in which the answers reach them, so that equal programs get equal genes. */
static void number_operation(struct lines *c, int i, int *order, int *n)
{
    const struct line *x = &c->line[i];
    if (c->map[i] >= 0 || !line_is_operation(x))
        return;
    number_operation(c, x->a, order, n);
    if (x->b >= 0)
        number_operation(c, x->b, order, n);
    c->map[i] = *n;
    order[(*n)++] = i;
}

bool lines_store(struct lines *c, size_t max, struct genes *t)
{
    int *order = new_array(c->lines, sizeof *order), n = 0;
    reserve_map(c, c->lines);
    for (size_t i = 0; i < c->lines; i++)
        c->map[i] = -1;
    for (int k = 0; k < 2; k++)
        number_operation(c, c->root[k], order, &n);
    const bool good = 2 + LINE_GENES * (size_t)n <= max;
    for (int i = 0; good && i < n; i++) {
        const struct line *x = &c->line[order[i]];
        int *gene = t->gene + 2 + LINE_GENES * i;
        gene[0] = x->gene;
        gene[1] = operand_gene(c, x->a, c->map);
        gene[2] = x->b >= 0 ? operand_gene(c, x->b, c->map) : -1;
        if ((x->gene == GENE_ADD || x->gene == GENE_MUL) && gene[2] >= LINE_GENE && gene[1] > gene[2]) {
            const int first = gene[1];
            gene[1] = gene[2];
            gene[2] = first;
        }
    }
    for (int k = 0; good && k < 2; k++)
        t->gene[k] = operand_gene(c, c->root[k], c->map);
    t->length = 2 + LINE_GENES * (size_t)n;
    free(order);
    return good;
}
