/* Text of functions at a place of a face: nodes, slave node and (xi, eta) to rows of values.  For a genome NAME
 *   NAME:    one pair, with a status; where the quick way does not tell, once more in another unit of length;
 *   NAME_n:  many pairs, from columns of coordinates;
 *   PREFIX_GENOME_OF(search), in capitals: a macro that defines the two joined with a search, search_GENOME and search_GENOME_n.
 * The row `require` is not written: its elements are > 0 where there is an answer.
 * The quick way is for moderate numbers, of which all rows are finite; of others they are computed in the other unit of
 * length and checked one by one, and so are tangents that might be rounding. */
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
    const char *name; /* not owned: of so many characters */
    size_t length, size;
    int degree; /* of lengths */
};

struct rows {
    struct row row[MOST_ROWS];
    size_t n, required; /* of the row `require` */
};

static bool row_is(const struct row *r, const char *name)
{
    return r->length == strlen(name) && strncmp(r->name, name, r->length) == 0;
}

/* An output that is 0 in any unit of length. */
static bool is_zero(const struct program *p, size_t output)
{
    const struct op *op = &p->op[p->output[output]];
    return op->kind == OP_CONSTANT && fmpq_is_zero(&p->constant[op->input]);
}

/* Outputs are elements of rows, one row after the other. */
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
            *row = (struct row){name, length, n, 0};
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

/* Names of the emitted functions' variables, and words of C and C++. */
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
        bool known = false; /* the row's degree */
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

/* By vector: rows of these roles depend on it.  Divisors are tested as ROLE_REQUIRE is, so that its flaws show there. */
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

/* The slave node is read by rows of these roles. */
static bool slave_read(const struct unit *u, const struct function *f, int roles)
{
    bool *read = vectors_read(u, f, roles);
    const bool slave = read[segment_vectors(u->file->segment)];
    free(read);
    return slave;
}

/* Only the row `gap` depends on the slave node. */
static bool gap_alone(const struct unit *u, const struct function *f)
{
    return slave_read(u, f, ROLE_GAP) && !slave_read(u, f, ROLE_REQUIRE | ROLE_OTHER);
}

/* The vectors and rows by the names that statements have for them. */
static void print_names(const struct unit *u, const struct rows *r, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(out, "%s*const %s = x[%zu]%s", i ? i % 5 ? ", " : ",\n                 " : "    const REAL ", name, i,
                i == segment_vectors(k) ? ";\n" : "");
    }
    for (size_t i = 0; i < r->n; i++)
        fprintf(out, "    REAL *const %.*s = row[%zu];\n", (int)r->row[i].length, r->row[i].name, i);
    if (r->required)
        fprintf(out, "    REAL require[%zu];\n", r->required);
    fputs("    REAL_BITS flaw;\n", out);
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

/* The row that a statement sets an element of; r->n if it is none. */
static size_t row_of(const struct rows *r, const char *text)
{
    size_t i = 0;
    while (i < r->n && !(strncmp(text, r->row[i].name, r->row[i].length) == 0 && text[r->row[i].length] == '['))
        i++;
    return i;
}

/* What is wanted of a row, with "[3 * step] = " for its element 3. */
static void print_row(const struct rows *r, size_t row, const char *statements, FILE *out)
{
    fprintf(out, "    if (always || %.*s) {\n", (int)r->row[row].length, r->row[row].name);
    for (const char *t = statements, *end; *t; t = end + 2) {
        end = strstr(t, ";\n");
        const char *text = t + strspn(t, " "), *bracket = strchr(text, ']');
        if (row_of(r, text) == row)
            fprintf(out, "        %.*s * step%.*s;\n", (int)(bracket - text), text, (int)(end - bracket), bracket);
    }
    fputs("    }\n", out);
}

/* The value that statements give the row `gap`; NULL if there is none. */
static char *gap_value(const struct rows *r, const char *statements)
{
    for (const char *t = statements, *end; *t; t = end + 2) {
        end = strstr(t, ";\n");
        const char *text = t + strspn(t, " "), *value = strstr(text, "= ") + 2;
        const size_t row = row_of(r, text);
        if (row < r->n && row_is(&r->row[row], "gap"))
            return new_text(value, (size_t)(end - value));
    }
    return NULL;
}

/* The row `gap` if only it depends on the slave node: its value is tested in place of the slave node. */
static void print_gap(const struct unit *u, const struct rows *r, const char *statements, FILE *out)
{
    char *value = gap_value(r, statements);
    char *text = new_format("    if (always || gap) {\n        const REAL value = %s;\n"
                            "        flaw |= again ? 0 : footpoint_detail_infinite(value);\n"
                            "        if (!always && flaw >> REAL_TOP)\n            return flaw;\n"
                            "        gap[0 * step] = value;\n    } else {\n"
                            "        flaw |= footpoint_detail_infinite(xS[0] + xS[1] + xS[2]);\n"
                            "        if (flaw >> REAL_TOP)\n            return flaw;\n    }\n",
                            value);
    c_print(text, u->options.precision, out);
    free(text);
    free(value);
}

static void print_others(const struct rows *r, const char *statements, FILE *out)
{
    for (const char *t = statements, *end; *t; t = end + 2) {
        end = strstr(t, ";\n");
        if (row_of(r, t + strspn(t, " ")) == r->n)
            fprintf(out, "%.*s;\n", (int)(end - t), t);
    }
}

/* The nodes that no test depends on, " | footpoint_detail_infinite(xF[0] + xF[1] + xF[2])". */
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

/* What the quick way is not for: places far away, and slave nodes whose distance might take rows beyond all numbers.  On
 * faces whose tangents have no slopes but a twist, only the gap does. */
static char *far_text(const struct unit *u, const struct function *f, const struct rows *r, const char *statements)
{
    const struct segment_kind *kind = u->file->segment;
    char *gap = strlen(kind->nodes) > 4 || *kind->normals ? NULL : gap_value(r, statements);
    struct memory *m = memory_open();
    fputs("        flaw |= footpoint_detail_far(xi, eta)", m->stream);
    if (slave_read(u, f, ROLE_REQUIRE | ROLE_OTHER))
        fprintf(m->stream, " | footpoint_detail_above(%s, FOOTPOINT_DETAIL_MOST)",
                gap ? gap : "fabs(xS[0]) + fabs(xS[1]) + fabs(xS[2])");
    else if (!gap_alone(u, f))
        fputs(" | footpoint_detail_infinite(xS[0] + xS[1] + xS[2])", m->stream);
    fputs(";", m->stream);
    free(gap);
    return memory_close(m);
}

static void print_flaw(const struct unit *u, const struct function *f, const struct rows *r, const char *statements,
                       FILE *out)
{
    char *flaw = c_flaw(u, f, false), *far = far_text(u, f, r, statements);
    struct memory *m = memory_open();
    fprintf(m->stream, "    flaw = %s", flaw);
    for (size_t i = 0; i < r->required; i++)
        fprintf(m->stream, " | footpoint_detail_not_above(require[%zu])", i);
    add_hidden_nodes(u, f, m->stream);
    fputs(";", m->stream);
    char *text = memory_close(m);
    c_print_broken(text, out);
    fputs("    if (!again)\n", out);
    c_print_broken(far, out);
    if (!gap_alone(u, f))
        c_print("    if (!always && flaw >> REAL_TOP)\n        return flaw;\n", u->options.precision, out);
    free(text);
    free(far);
    free(flaw);
}

static void print_place(const struct unit *u, const struct function *f, const struct rows *r, FILE *out)
{
    struct memory *m = memory_open(), *names = memory_open();
    c_print_statements(u, f, m->stream);
    print_names(u, r, names->stream);
    char *statements = memory_close(m), *head = memory_close(names);
    c_print("FOOTPOINT_PART REAL_BITS\n", u->options.precision, out);
    const int column = fprintf(out, "%s_detail(", f->name);
    c_print("const REAL *const *x, REAL xi, REAL eta,\n", u->options.precision, out);
    fprintf(out, "%*s", column, "");
    c_print("REAL *const *row, size_t step, int always, int again)\n{\n", u->options.precision, out);
    c_print(head, u->options.precision, out);
    print_unused(u, f, out);
    print_others(r, statements, out);
    print_flaw(u, f, r, statements, out);
    const bool gap = gap_alone(u, f);
    if (gap)
        print_gap(u, r, statements, out);
    for (size_t i = 0; i < r->n; i++)
        if (!gap || !row_is(&r->row[i], "gap"))
            print_row(r, i, statements, out);
    fputs("    return flaw;\n}\n", out);
    free(head);
    free(statements);
}

/* "double *const row[3] = {d_xi, d_eta, d_gap};", the elements of pair i. */
static void print_rows(const struct unit *u, const struct rows *r, const char *indent, const char *element, FILE *out)
{
    fprintf(out, "%s%s *const row[%zu] = {", indent, lines_real(u), r->n);
    for (size_t i = 0; i < r->n; i++)
        fprintf(out, "%s%.*s%s", i ? ", " : "", (int)r->row[i].length, r->row[i].name, element);
    fputs("};\n", out);
}

/* The first function, no later than f, that gives tangents, rows r_xi and r_eta; *row: the number of r_xi.  NULL: none. */
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

/* The power of xi and eta that tangents grow with. */
static int tangent_degree(const struct segment_kind *kind)
{
    const size_t nodes = strlen(kind->nodes);
    return *kind->normals ? 5 : nodes == 9 ? 3 : nodes == 8 ? 2 : nodes == 3 ? 0 : 1;
}

/* A function of its own, so that callers stay small: of each row "size, degree", and room for all of them. */
static void print_again(const struct unit *u, const struct function *f, const struct rows *r, FILE *out)
{
    const char *real = lines_real(u);
    size_t row = 0, size = 0;
    const struct function *g = tangents_of(u, f, &row);
    const int column = fprintf(out, "\nFOOTPOINT_COLD int %s_detail_again(", f->name) - 1;
    fprintf(out, "const %s *const *x, %s xi, %s eta,\n%*s%s *const *row, size_t step)\n{\n", real, real, real, column,
            "", real);
    fprintf(out, "    const int nodes = %zu, vectors = %zu, rows = %zu, first = %zu, degree = %d;\n",
            strlen(u->file->segment->nodes), segment_vectors(u->file->segment) + 1, r->n, g ? row : 0,
            g ? tangent_degree(u->file->segment) : 0);
    fprintf(out, "    const int shape[%zu] = {", 2 * r->n);
    for (size_t i = 0; i < r->n; size += r->row[i++].size)
        fprintf(out, "%s%zu, %d", i ? ", " : "", r->row[i].size, r->row[i].degree);
    fprintf(out, "};\n    %s space[%zu];\n    return footpoint_detail_place_again(%s_detail, ", real, size, f->name);
    fprintf(out, g ? "%s_detail" : "0", g ? g->name : "");
    fputs(", first, degree,\n        x, nodes, vectors, xi, eta, row, step, rows, shape, space);\n}\n\n", out);
}

/* Joined with a search: what goes before the same of NAME alone. */
static void print_one(const struct unit *u, const struct function *f, const struct rows *r, bool joined, FILE *out)
{
    const size_t vectors = segment_vectors(u->file->segment) + 1;
    const enum precision precision = u->options.precision;
    char *name = joined ? new_format("search##_%s", f->genome->name) : new_text(f->name, strlen(f->name));
    char *head = new_format("FOOTPOINT_FN int %s", name), *names = lines_vectors(u);
    struct memory *m = memory_open();
    fputs(joined ? "REAL loc[2]" : "const REAL loc[2]", m->stream);
    for (size_t i = 0; i < r->n; i++)
        fprintf(m->stream, ",REAL %.*s[%zu]", (int)r->row[i].length, r->row[i].name, r->row[i].size);
    char *last = memory_close(m);
    lines_print_head(u, head, last, out);
    fprintf(out, "{\n    const %s *const x[%zu] = {%s};\n", lines_real(u), vectors, names);
    print_rows(u, r, "    ", "", out);
    if (joined) {
        c_print("    REAL xi, eta;\n    REAL_BITS flaw = ", precision, out);
        fprintf(out, "search##_detail(%s, ", names);
        c_print("0.0, &xi, &eta);\n", precision, out);
        fprintf(out, "    flaw |= %s_detail(x, xi, eta, row, 1, 0, 0);\n", f->name);
        c_print("    if (flaw >> REAL_TOP) {\n        REAL distance;\n", precision, out);
        fprintf(out, "        const int status = search(%s, loc, &distance);\n", names);
        fprintf(out, "        if (status != FOOTPOINT_OK)\n            return status;\n");
    } else {
        fprintf(out, "    if (%s_detail(x, loc[0], loc[1], row, 1, 0, 0) >> ", f->name);
        c_print("REAL_TOP) {\n", precision, out);
    }
    fprintf(out, "        return %s_detail_again(x, loc[0], loc[1], row, 1);\n", f->name);
    fputs(joined ? "    }\n    loc[0] = xi;\n    loc[1] = eta;\n" : "    }\n", out);
    fputs("    return FOOTPOINT_OK;\n}\n", out);
    free(last);
    free(names);
    free(head);
    free(name);
}

/* The vectors of pair i. */
static void print_pair(const struct unit *u, const char *indent, FILE *out)
{
    const size_t vectors = segment_vectors(u->file->segment) + 1;
    char *columns = lines_columns(vectors), *places = lines_rows(u, "p");
    fprintf(out, "%sconst %s p[%zu][3] = {%s};\n%sconst %s *const y[%zu] = {%s};\n", indent, lines_real(u), vectors,
            columns, indent, lines_real(u), vectors, places);
    free(places);
    free(columns);
}

/* What is not good beyond doubt is done once more behind the loop. */
static void print_loop(const struct unit *u, const struct function *f, const struct rows *r, bool joined, FILE *out)
{
    const char *real = lines_real(u), *before = joined ? "" : "const ", *star = joined ? "*FOOTPOINT_RESTRICT " : "*";
    char *name = joined ? new_format("search##_%s", f->genome->name) : new_text(f->name, strlen(f->name));
    char *vectors = lines_rows(u, "p");
    fputs(joined ? "\nFOOTPOINT_UNUSED\n" : "\n", out);
    const int column = fprintf(out, "FOOTPOINT_LOOP void %s_n(", name);
    fprintf(out, "size_t n, const %s *const x[%zu],\n%*s", real, 3 * segment_vectors(u->file->segment) + 3, column, "");
    fprintf(out, "%s%s %sxi, %s%s %seta,\n", before, real, star, before, real, star);
    for (size_t i = 0; i < r->n; i++)
        fprintf(out, "%*s%s *FOOTPOINT_RESTRICT %.*s,\n", column, "", real, (int)r->row[i].length, r->row[i].name);
    fprintf(out, "%*sint *FOOTPOINT_RESTRICT status)\n{\n", column, "");
    if (joined)
        c_print("    const REAL zero = footpoint_detail_zero();\n", u->options.precision, out);
    fputs("    size_t i;\n    FOOTPOINT_EACH\n    for (i = 0; i < n; i++) {\n", out);
    print_pair(u, "        ", out);
    print_rows(u, r, "        ", " + i", out);
    if (joined) {
        c_print("        REAL at[2];\n        REAL_BITS flaw = ", u->options.precision, out);
        fprintf(out, "search##_detail(%s, zero, &at[0], &at[1]);\n", vectors);
        fprintf(out, "        flaw |= %s_detail(y, at[0], at[1], row, n, 1, 0);\n", f->name);
        fputs("        xi[i] = at[0];\n        eta[i] = at[1];\n        status[i] = FOOTPOINT_ERR_DEGENERATE * "
              "(int)(flaw >> ",
              out);
    } else
        fprintf(out,
                "        status[i] = FOOTPOINT_ERR_DEGENERATE *\n            (int)(%s_detail(y, xi[i], eta[i], "
                "row, n, 1, 0) >> ",
                f->name);
    c_print("REAL_TOP);\n    }\n    for (i = 0; i < n; i++)\n        if (status[i] != FOOTPOINT_OK) {\n",
            u->options.precision, out);
    print_pair(u, "            ", out);
    print_rows(u, r, "            ", " + i", out);
    if (joined) {
        c_print("            REAL at[2] = {xi[i], eta[i]}, distance;\n", u->options.precision, out);
        fprintf(out, "            status[i] = search(%s, at, &distance);\n", vectors);
        fputs(
            "            xi[i] = at[0];\n            eta[i] = at[1];\n            if (status[i] == FOOTPOINT_OK)\n    ",
            out);
    }
    fprintf(out, "            status[i] = %s_detail_again(y, xi[i], eta[i], row, n);\n", f->name);
    fputs("        }\n}\n", out);
    free(vectors);
    free(name);
}

/* The same with the search before it, as the text of a macro. */
static void print_joined(const struct unit *u, const struct function *f, const struct rows *r, FILE *out)
{
    char *prefix = unit_face_prefix(u->file, &u->options);
    char *upper = new_capitals(prefix), *genome = new_capitals(f->genome->name);
    struct memory *m = memory_open();
    fputs("FOOTPOINT_UNUSED\n", m->stream);
    print_one(u, f, r, true, m->stream);
    print_loop(u, f, r, true, m->stream);
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

void place_print_helpers(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    const char *kind = u->file->segment->name;
    char *vectors = lines_vectors(u), *prefix = unit_face_prefix(u->file, &u->options), *upper = new_capitals(prefix);
    const struct placeholder own[] = {{"VECTORS", vectors}, {"UPPER", upper}, {"KIND", kind}, {NULL, NULL}};
    templates_print("FOOTPOINT_DETAIL_SCALE", (const char *const[]){"scale", NULL}, precision, NULL, out);
    templates_print("FOOTPOINT_DETAIL_PLACE", (const char *const[]){"place", NULL}, precision, NULL, out);
    templates_print(NULL, (const char *const[]){"contract_place", NULL}, precision, own, out);
    free(upper);
    free(prefix);
    free(vectors);
}

void place_print(const struct unit *u, const struct function *f, FILE *out)
{
    const struct rows r = find_rows(u, f);
    print_place(u, f, &r, out);
    print_again(u, f, &r, out);
    print_one(u, f, &r, false, out);
    print_loop(u, f, &r, false, out);
    print_joined(u, f, &r, out);
}
