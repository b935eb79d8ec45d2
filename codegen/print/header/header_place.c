/* Prints functions at a place of a face, which map nodes, slave node and (xi, eta) to rows of values. A genome NAME
 * becomes
 *   NAME: one pair, with a status; if the quick way fails, it is computed again in another unit of length;
 *   NAME_n: many pairs, from columns of coordinates;
 *   PREFIX_GENOME_OF(search), in capitals: a macro that defines search_GENOME and search_GENOME_n, the search followed
 *     by NAME.
 *
 * The row `require` is not written; its elements are > 0 if there is an answer. The quick way suits moderate numbers
 * and finite rows. Otherwise rows are computed in another unit of length and checked one by one, and so are tangents
 * that rounding may have made. */
#include "header_place.h"

#include "../../base/text.h"
#include "../../program/degree.h"
#include "../c_text.h"
#include "../templates.h"
#include "header_lines.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_ROWS = 16 };

struct row {
    const char *name;           /* not owned; `length` characters */
    size_t length, first, size; /* first, size: range of the genome's outputs */
    int degree;                 /* the row's power of the unit of length */
};

struct rows {
    struct row row[MOST_ROWS];
    size_t n, required; /* size of the row `require` */
};

static bool row_is(const struct row *r, const char *name)
{
    return r->length == strlen(name) && strncmp(r->name, name, r->length) == 0;
}

/* Returns true if the output is 0 in any unit of length. */
static bool is_zero(const struct program *p, size_t output)
{
    const struct op *op = &p->op[p->output[output]];
    return op->kind == OP_CONSTANT && fmpq_is_zero(&p->constant[op->input]);
}

/* Groups the outputs, which are elements of consecutive rows. */
static struct rows find_rows(const struct unit *u, const struct function *f)
{
    struct rows r = {.n = 0};
    for (size_t k = 0, n; k < f->genome->outs; k += n) {
        const char *name = f->genome->out[k].name;
        const size_t length = strcspn(name, "[");
        for (n = 1; k + n < f->genome->outs && strncmp(f->genome->out[k + n].name, name, length + 1) == 0; n++)
            continue;
        if (length == strlen("require") && strncmp(name, "require", length) == 0)
            r.required = n;
        else if (r.n < MOST_ROWS) {
            struct row *row = &r.row[r.n++];
            size_t first = 0;
            while (first + 1 < n && is_zero(f->program, k + first))
                first++;
            *row = (struct row){name, length, k, n, 0};
            homogeneous_degree(f->program, u->file->segment, f->program->output[k + first], &row->degree);
        }
    }
    return r;
}

static bool is_one_of(const char *const *list, const char *name, size_t length)
{
    while (*list && !(strncmp(*list, name, length) == 0 && (*list)[length] == '\0'))
        list++;
    return *list != NULL;
}

/* Returns true for variables of the emitted functions and for words of C and C++. */
static bool is_taken(const struct unit *u, const char *name, size_t length)
{
    static const char *const own[] = {"xi",    "eta",      "loc",    "n",       "i",     "p",     "x",    "y",
                                      "at",    "row",      "step",   "always",  "again", "flaw",  "zero", "status",
                                      "shape", "distance", "search", "require", "space", "value", NULL};
    static const char *const word[] = {
        "auto",    "bool",      "break",    "case",     "catch",   "char",      "class",    "const",    "continue",
        "default", "delete",    "do",       "double",   "else",    "enum",      "explicit", "export",   "extern",
        "false",   "float",     "for",      "friend",   "goto",    "if",        "inline",   "int",      "long",
        "mutable", "namespace", "new",      "operator", "private", "protected", "public",   "register", "restrict",
        "return",  "short",     "signed",   "sizeof",   "static",  "struct",    "switch",   "template", "this",
        "throw",   "true",      "try",      "typedef",  "typeid",  "typename",  "union",    "unsigned", "using",
        "virtual", "void",      "volatile", "while",    "and",     "or",        "not",      "xor",      "sqrt",
        "fabs",    NULL};
    const struct segment_kind *k = u->file->segment;
    for (size_t v = 0; v <= segment_vectors(k); v++) {
        char vector[4];
        segment_vector_name(k, v, vector);
        if (strncmp(vector, name, length) == 0 && vector[length] == '\0')
            return true;
    }
    return is_one_of(own, name, length) || is_one_of(word, name, length) ||
           (length > 1 && name[0] == 't' && strspn(name + 1, "0123456789") + 1 >= length);
}

bool place_check(const struct unit *u, struct diag *d)
{
    const struct genome_file *file = u->file;
    if (u->options.precision == PRECISION_FLOAT)
        return diag_at(d, file->path, 0, 0, "functions at places of faces are in double alone");
    for (size_t g = 0; g < file->genomes; g++) {
        const struct function *f = &u->function[g];
        const char *row = "";
        size_t rows = 0;
        int degree = 0, first = 0;
        bool known = false; /* whether `degree` is known */
        for (size_t k = 0; k < f->genome->outs; k++) {
            const struct genome_expr *e = &f->genome->out[k];
            const size_t length = strcspn(e->name, "[");
            const bool begins = strncmp(row, e->name, length) != 0 || row[length] != e->name[length];
            row = e->name;
            if (length == strlen("require") && strncmp(row, "require", length) == 0)
                continue;
            rows += begins;
            if (rows > MOST_ROWS)
                return diag_at(d, file->path, e->line, 1, "genome '%s' has more than %d rows", f->genome->name,
                               MOST_ROWS);
            if (begins && is_taken(u, row, length))
                return diag_at(d, file->path, e->line, 1, "row '%.*s' takes a name of the header's own or a word of C",
                               (int)length, row);
            known = known && !begins;
            if (is_zero(f->program, k))
                continue;
            if (!homogeneous_degree(f->program, file->segment, f->program->output[k], &degree) ||
                (known && degree != first))
                return diag_at(d, file->path, e->line, 1,
                               "row '%.*s' is not of one power of a length: faces have any size", (int)length, row);
            first = degree;
            known = true;
        }
    }
    return true;
}

enum { ROLE_REQUIRE = 1, ROLE_GAP = 2, ROLE_OTHER = 4, ROLE_ANY = 7 };

static int role_of(const char *name)
{
    const size_t length = strcspn(name, "[");
    if (length == strlen("require") && strncmp(name, "require", length) == 0)
        return ROLE_REQUIRE;
    return length == strlen("gap") && strncmp(name, "gap", length) == 0 ? ROLE_GAP : ROLE_OTHER;
}

/* Returns, indexed by vector, whether rows of these roles depend on it. Divisors are tested like ROLE_REQUIRE, which
 * shows their flaws. */
static bool *vectors_read(const struct unit *u, const struct function *f, int roles)
{
    const struct program *p = f->program;
    bool *read = new_array(p->ops, sizeof *read),
         *vector = new_array(segment_vectors(u->file->segment) + 1, sizeof *vector);
    for (size_t k = 0; k < p->outputs; k++)
        read[p->output[k]] = read[p->output[k]] || (roles & role_of(f->genome->out[k].name));
    for (size_t i = 0; (roles & ROLE_REQUIRE) && f->evidence && i < f->evidence->denominators; i++)
        read[f->evidence->denominator[i].op] = true;
    for (size_t i = p->ops; i-- > p->inputs;)
        for (int h = 0; read[i] && h < 2; h++)
            if ((h ? p->op[i].b : p->op[i].a) >= 0)
                read[h ? p->op[i].b : p->op[i].a] = true;
    for (size_t i = 0; i < 3 * (segment_vectors(u->file->segment) + 1); i++)
        vector[i / 3] = vector[i / 3] || read[i];
    free(read);
    return vector;
}

/* Returns true if rows of these roles depend on the slave node. */
static bool slave_read(const struct unit *u, const struct function *f, int roles)
{
    bool *read = vectors_read(u, f, roles);
    const bool slave = read[segment_vectors(u->file->segment)];
    free(read);
    return slave;
}

/* Returns true if only the row `gap` depends on the slave node. */
static bool gap_alone(const struct unit *u, const struct function *f)
{
    return slave_read(u, f, ROLE_GAP) && !slave_read(u, f, ROLE_REQUIRE | ROLE_OTHER);
}

/* Returns "    const double *const xA = x[0], *const xB = x[1];". */
static char *vectors_text(const struct unit *u)
{
    const struct segment_kind *k = u->file->segment;
    struct memory *m = memory_open();
    fprintf(m->stream, "    const %s ", lines_real(u));
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(m->stream, "%s*const %s = x[%zu]", i == 0 ? "" : i % 5 ? ", " : ",\n                 ", name, i);
    }
    fputs(";\n", m->stream);
    return memory_close(m);
}

static void print_unused(const struct unit *u, const struct function *f, FILE *out)
{
    bool *reads = vectors_read(u, f, ROLE_ANY);
    for (size_t i = 0; i < segment_vectors(u->file->segment); i++) {
        char name[4];
        segment_vector_name(u->file->segment, i, name);
        if (!reads[i])
            fprintf(out, "    (void)%s;\n", name);
    }
    free(reads);
}

static bool is_of_row(const struct row *r, const struct c_statement *s)
{
    return s->output >= (long)r->first && s->output < (long)(r->first + r->size);
}

/* Returns the statements of temporaries and of the row `require`. */
static char *statements_text(const struct unit *u, const struct function *f, const struct rows *r,
                             const struct c_code *c)
{
    struct memory *m = memory_open();
    bool *wanted = new_array(c->statements, sizeof *wanted);
    for (size_t i = 0; i < c->statements; i++) {
        wanted[i] = true;
        for (size_t k = 0; k < r->n; k++)
            wanted[i] = wanted[i] && !is_of_row(&r->row[k], &c->statement[i]);
    }
    print_unused(u, f, m->stream);
    c_print_packed(c, wanted, m->stream);
    free(wanted);
    return memory_close(m);
}

/* Returns the assignments to a row, with "[3 * step] = " for element 3. */
static char *elements_text(const struct row *r, const struct c_code *c)
{
    struct memory *m = memory_open();
    for (size_t i = 0; i < c->statements; i++)
        if (is_of_row(r, &c->statement[i]))
            fprintf(m->stream, "        %.*s[%zu * step] = %s;\n", (int)r->length, r->name,
                    (size_t)c->statement[i].output - r->first, c->statement[i].value);
    return memory_close(m);
}

/* Returns the value of the row `gap`, or NULL. */
static const char *gap_value(const struct rows *r, const struct c_code *c)
{
    for (size_t k = 0; k < r->n; k++)
        for (size_t i = 0; i < c->statements && row_is(&r->row[k], "gap"); i++)
            if (is_of_row(&r->row[k], &c->statement[i]))
                return c->statement[i].value;
    return NULL;
}

/* Prints tests of the nodes that no other test reads: " | footpoint_detail_infinite(xF[0] + xF[1] + xF[2])". */
static void add_hidden_nodes(const struct unit *u, const struct function *f, FILE *out)
{
    bool *reads = vectors_read(u, f, ROLE_ANY), *shown = vectors_read(u, f, ROLE_REQUIRE);
    for (size_t i = 0; i < segment_vectors(u->file->segment); i++) {
        char name[4];
        segment_vector_name(u->file->segment, i, name);
        if (reads[i] && !shown[i])
            fprintf(out, " | footpoint_detail_infinite(%s[0] + %s[1] + %s[2])", name, name, name);
    }
    free(reads);
    free(shown);
}

/* Returns the test that rejects the quick way: places far away, and slave nodes so distant that rows may overflow. On
 * faces whose only second derivative is the twist, only the gap can overflow. If only the gap depends on the slave
 * node, the gap is tested instead. */
static char *far_text(const struct unit *u, const struct function *f, const char *gap)
{
    const struct segment_kind *kind = u->file->segment;
    const bool by_gap = gap && strlen(kind->nodes) <= 4 && !*kind->normals;
    struct memory *m = memory_open();
    fputs("        flaw |= footpoint_detail_far(xi, eta)", m->stream);
    if (slave_read(u, f, ROLE_REQUIRE | ROLE_OTHER))
        fprintf(m->stream, " | footpoint_detail_above(%s, FOOTPOINT_DETAIL_MOST)",
                by_gap ? gap : "fabs(xS[0]) + fabs(xS[1]) + fabs(xS[2])");
    else if (!gap_alone(u, f))
        fputs(" | footpoint_detail_infinite(xS[0] + xS[1] + xS[2])", m->stream);
    fputs(";", m->stream);
    return memory_close(m);
}

static char *flaw_text(const struct unit *u, const struct function *f, const struct rows *r, const char *gap)
{
    char *flaw = c_flaw(u, f, false), *far = far_text(u, f, gap);
    struct memory *m = memory_open(), *broken = memory_open();
    fprintf(m->stream, "    flaw = %s", flaw);
    for (size_t i = 0; i < r->required; i++)
        fprintf(m->stream, " | footpoint_detail_not_above(require[%zu])", i);
    add_hidden_nodes(u, f, m->stream);
    fputs(";", m->stream);
    char *text = memory_close(m);
    c_print_broken(text, broken->stream);
    fputs("    if (!again)\n", broken->stream);
    c_print_broken(far, broken->stream);
    free(text);
    free(far);
    free(flaw);
    return memory_close(broken);
}

/* Returns the first function, at most f, with tangents (rows r_xi and r_eta), or NULL; *row is the index of r_xi. */
static const struct function *tangents_of(const struct unit *u, const struct function *f, size_t *row)
{
    for (const struct function *g = u->function; g <= f; g++) {
        const struct rows r = find_rows(u, g);
        for (*row = 0; *row + 1 < r.n; ++*row)
            if (row_is(&r.row[*row], "r_xi") && row_is(&r.row[*row + 1], "r_eta"))
                return g;
    }
    return NULL;
}

/* Returns the power of xi and eta with which tangents grow. */
static int tangent_degree(const struct segment_kind *kind)
{
    const size_t nodes = strlen(kind->nodes);
    return *kind->normals ? 5 : nodes == 9 ? 3 : nodes == 8 ? 2 : nodes == 3 ? 0 : 1;
}

/* Returns "BEFORE phi AFTER, BEFORE r_xi AFTER". */
static char *list_text(const struct rows *r, const char *before, const char *after)
{
    struct memory *m = memory_open();
    for (size_t i = 0; i < r->n; i++)
        fprintf(m->stream, "%s%s%.*s%s", i ? ", " : "", before, (int)r->row[i].length, r->row[i].name, after);
    return memory_close(m);
}

static char *row_parameters_text(const struct rows *r)
{
    struct memory *m = memory_open();
    for (size_t i = 0; i < r->n; i++)
        fprintf(m->stream, "%sdouble %.*s[%zu]", i ? ", " : "", (int)r->row[i].length, r->row[i].name, r->row[i].size);
    return memory_close(m);
}

/* Returns "size, degree" of each row. */
static char *shape_text(const struct rows *r)
{
    struct memory *m = memory_open();
    for (size_t i = 0; i < r->n; i++)
        fprintf(m->stream, "%s%zu, %d", i ? ", " : "", r->row[i].size, r->row[i].degree);
    return memory_close(m);
}

/* Returns the words of the templates in templates/place/. */
static struct words words_of(const struct unit *u, const struct function *f, const struct rows *r,
                             const struct c_code *c)
{
    struct words w = lines_words(u, f, f);
    size_t row = 0, space = 0;
    const struct function *tangents = tangents_of(u, f, &row);
    const char *gap = gap_value(r, c);
    for (size_t i = 0; i < r->n; i++)
        space += r->row[i].size;
    words_add(&w, "VECTOR_LIST", vectors_text(u));
    words_add(&w, "REQUIRED", new_format("%zu", r->required));
    words_add(&w, "STATEMENTS", statements_text(u, f, r, c));
    words_add(&w, "TESTS", flaw_text(u, f, r, gap));
    words_add(&w, "GAP", new_format("%s", gap ? gap : ""));
    words_add(&w, "FIRST", new_format("%zu", tangents ? row : 0));
    words_add(&w, "DEGREE", new_format("%d", tangents ? tangent_degree(u->file->segment) : 0));
    words_add(&w, "TANGENTS", tangents ? new_format("%s_detail", tangents->name) : new_format("0"));
    words_add(&w, "SIZES_AND_DEGREES", shape_text(r));
    words_add(&w, "SPACE", new_format("%zu", space));
    words_add(&w, "ROW_COUNT", new_format("%zu", r->n));
    words_add(&w, "ROW_NAMES", list_text(r, "", ""));
    words_add(&w, "ROW_PLACES", list_text(r, "", " + i"));
    words_add(&w, "ROW_COLUMNS", list_text(r, "double *FOOTPOINT_RESTRICT ", ""));
    words_add(&w, "ROW_PARAMETERS", row_parameters_text(r));
    words_add(&w, "JOINED", new_format("search##_%s", f->genome->name));
    words_add(&w, "SEARCHED", new_format("search##"));
    words_add(&w, "SEARCH", new_format("search"));
    return w;
}

static void print_detail(const struct unit *u, const struct function *f, const struct rows *r, const struct c_code *c,
                         const struct words *w, FILE *out)
{
    struct words row[MOST_ROWS] = {{NULL, 0, 0}};
    const struct placeholder *all[MOST_ROWS], *set[MOST_ROWS];
    const bool last = gap_alone(u, f);
    size_t sets = 0;
    for (size_t i = 0; i < r->n; i++) {
        words_add(&row[i], "ROW", new_text(r->row[i].name, r->row[i].length));
        words_add(&row[i], "ROW_NUMBER", new_format("%zu", i));
        words_add(&row[i], "ELEMENTS", elements_text(&r->row[i], c));
        all[i] = row[i].word;
        if (!last || !row_is(&r->row[i], "gap"))
            set[sets++] = row[i].word;
    }
    const struct block blocks[] = {
        {"ROW", r->n, all},       {"SET_ROW", sets, set},          {"REQUIRE", r->required > 0, NULL},
        {"GAP_LAST", last, NULL}, {"GAP_AMONG_ROWS", !last, NULL}, {NULL, 0, NULL}};
    templates_print_blocks("place_detail", PRECISION_DOUBLE, w->word, blocks, out);
    for (size_t i = 0; i < r->n; i++)
        words_clear(&row[i]);
}

/* Prints a template as the text of a macro PREFIX_NAME_OF(search), in capitals. */
static void print_macro(const struct unit *u, const char *name, const char *template, const struct words *w, FILE *out)
{
    char *prefix = unit_face_prefix(u->file, &u->options);
    char *upper = new_capitals(prefix), *genome = new_capitals(name);
    struct memory *m = memory_open();
    templates_print(NULL, (const char *const[]){template, NULL}, PRECISION_DOUBLE, w->word, m->stream);
    char *text = memory_close(m);
    fprintf(out, "\n#define %s_%s_OF(search)", upper, genome);
    for (const char *t = text, *end; *t; t = end + 1) {
        end = strchr(t, '\n');
        if (end > t)
            fprintf(out, " \\\n%.*s", (int)(end - t), t);
    }
    fputc('\n', out);
    free(text);
    free(genome);
    free(upper);
    free(prefix);
}

/* Returns true if the first rows of f are those of this list, which NULL ends. */
static bool begins_with(const struct unit *u, const struct function *f, const char *const *name)
{
    const struct rows r = find_rows(u, f);
    size_t k = 0;
    while (name[k] && k < r.n && row_is(&r.row[k], name[k]))
        k++;
    return !*u->file->segment->normals && !name[k];
}

/* Rows from which derivatives along a direction are computed. */
static const char *const slope_rows[] = {"phi",    "phi_xi",  "phi_eta",  "r_xi", "r_eta",
                                         "r_xixi", "r_xieta", "r_etaeta", NULL};

/* Returns the first function that gives these rows, or NULL. */
static const struct function *slopes_of(const struct unit *u)
{
    for (size_t k = 0; k < u->file->genomes; k++)
        if (begins_with(u, &u->function[k], slope_rows))
            return &u->function[k];
    return NULL;
}

/* Prints PREFIX_gradients_along and PREFIX_hessian_along, and the macros that join them with PREFIX_along. */
static void print_slopes(const struct unit *u, struct words *w, FILE *out)
{
    char *prefix = unit_face_prefix(u->file, &u->options);
    words_add(w, "UPPER", new_capitals(prefix));
    words_add(w, "SLOPES", new_format("%s_gradients_along", prefix));
    words_add(w, "SLOPES_detail", new_format("%s_gradients_along_detail", prefix));
    words_add(w, "SLOPES_detail_size", new_format("%s_gradients_along_detail_size", prefix));
    words_add(w, "SLOPES_detail_again", new_format("%s_gradients_along_detail_again", prefix));
    words_add(w, "SLOPE_COUNT", new_format("%zu", 3 * segment_vectors(u->file->segment) + 6));
    words_add(w, "JOINED_SLOPES", new_format("search##_gradients"));
    words_add(w, "BENDS", new_format("%s_hessian_along", prefix));
    words_add(w, "BENDS_detail_turns", new_format("%s_hessian_along_detail_turns", prefix));
    words_add(w, "JOINED_BENDS", new_format("search##_hessian"));
    words_add(w, "PROJECTION", new_format("search"));
    templates_print(NULL, (const char *const[]){"place_along", NULL}, PRECISION_DOUBLE, w->word, out);
    print_macro(u, "gradients_along", "place_along_joined", w, out);
    templates_print(NULL, (const char *const[]){"place_bends_calls", NULL}, PRECISION_DOUBLE, w->word, out);
    print_macro(u, "hessian_along", "place_bends_joined", w, out);
    free(prefix);
}

void place_print_helpers(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    const char *kind = u->file->segment->name;
    char *vectors = lines_vectors(u), *prefix = unit_face_prefix(u->file, &u->options), *upper = new_capitals(prefix);
    const struct placeholder own[] = {{"VECTORS", vectors}, {"UPPER", upper}, {"KIND", kind}, {NULL, NULL}};
    templates_print("FOOTPOINT_DETAIL_SCALE", (const char *const[]){"scale", NULL}, precision, NULL, out);
    templates_print("FOOTPOINT_DETAIL_PLACE", (const char *const[]){"place", NULL}, precision, NULL, out);
    if (slopes_of(u)) {
        templates_print("FOOTPOINT_DETAIL_PRODUCTS", (const char *const[]){"products", NULL}, precision, NULL, out);
        templates_print("FOOTPOINT_DETAIL_SLOPES", (const char *const[]){"place_slopes", NULL}, precision, NULL, out);
        templates_print("FOOTPOINT_DETAIL_BENDS", (const char *const[]){"place_bends", NULL}, precision, NULL, out);
    }
    templates_print(NULL, (const char *const[]){"contract_place", NULL}, precision, own, out);
    free(upper);
    free(prefix);
    free(vectors);
}

void place_print(const struct unit *u, const struct function *f, FILE *out)
{
    const struct rows r = find_rows(u, f);
    struct c_code c = c_code_of(u, f);
    struct words w = words_of(u, f, &r, &c);
    print_detail(u, f, &r, &c, &w, out);
    templates_print(NULL, (const char *const[]){"place_calls", NULL}, PRECISION_DOUBLE, w.word, out);
    print_macro(u, f->genome->name, "place_joined", &w, out);
    if (f == slopes_of(u))
        print_slopes(u, &w, out);
    words_clear(&w);
    printer_free(c_code_clear(&c));
}
