/* Text of the search: nodes as a mesh has them to xi, eta and the gap.  For a genome NAME of a segment,
 *   NAME_at:  xi and eta by straight-line code, corners in the order that the scene assumes, nothing checked;
 *   NAME:     xi, eta and the signed gap (9), corners in any order, with a status;
 *   NAME_n:   NAME_at for many pairs, from columns of coordinates. */
#include "header_search.h"

#include "c_code.h"
#include "header_single.h"
#include "text.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char helpers[] =
    "\n#ifndef FOOTPOINT_QUAD4_SEARCH@G\n"
    "#define FOOTPOINT_QUAD4_SEARCH@G\n"
    "/* 1 if two corners coincide. */\n"
    "FOOTPOINT_FN int @Dcoincide(const @R a[3], const @R b[3])\n"
    "{\n"
    "    return (a[0] == b[0]) & (a[1] == b[1]) & (a[2] == b[2]);\n"
    "}\n\n"
    "/* Status of the nodes: all finite, no two corners the same. */\n"
    "FOOTPOINT_FN int @Dinspect(const @R xA[3], const @R xB[3], const @R xC[3],\n"
    "                                         const @R xD[3], const @R xS[3])\n"
    "{\n"
    "    const @R sum = (xA[0] + xA[1] + xA[2]) + (xB[0] + xB[1] + xB[2]) + (xC[0] + xC[1] + xC[2]) +\n"
    "                       (xD[0] + xD[1] + xD[2]) + (xS[0] + xS[1] + xS[2]);\n"
    "    const int coincide = @Dcoincide(xA, xB) | @Dcoincide(xB, xC) |\n"
    "                         @Dcoincide(xC, xD) | @Dcoincide(xD, xA) |\n"
    "                         @Dcoincide(xA, xC) | @Dcoincide(xB, xD);\n"
    "    return sum - sum == 0.0@F ? (coincide ? FOOTPOINT_ERR_DEGENERATE : FOOTPOINT_OK) : "
    "FOOTPOINT_ERR_NOT_FINITE;\n"
    "}\n\n"
    "/* Gap (9): (xS - r(xi,eta)) . n with the unit normal n = r_xi x r_eta / |...| there; mesh length, > 0 open.\n"
    " * 0, and *gap untouched, where r_xi and r_eta are parallel: there is no area and no normal. */\n"
    "FOOTPOINT_FN int @Dgap(const @R xA[3], const @R xB[3], const @R xC[3],\n"
    "                                      const @R xD[3], const @R xS[3], @R xi, @R eta, @R "
    "*gap)\n"
    "{\n"
    "    @R u[3], v[3], d[3], nx, ny, nz, nn, uu = 0.0@F, vv = 0.0@F;\n"
    "    int i, area;\n"
    "    for (i = 0; i < 3; i++) {\n"
    "        const @R ab = xB[i] - xA[i], dc = xC[i] - xD[i], ad = xD[i] - xA[i], bc = xC[i] - xB[i];\n"
    "        const @R s = 0.5@F * (1.0@F + xi), t = 0.5@F * (1.0@F + eta);\n"
    "        u[i] = ab + t * (dc - ab);\n"
    "        v[i] = ad + s * (bc - ad);\n"
    "        d[i] = (xS[i] - xA[i]) - s * ab - t * v[i];\n"
    "        uu += u[i] * u[i] + ab * ab + dc * dc;\n"
    "        vv += v[i] * v[i] + ad * ad + bc * bc;\n"
    "    }\n"
    "    nx = u[1] * v[2] - u[2] * v[1];\n"
    "    ny = u[2] * v[0] - u[0] * v[2];\n"
    "    nz = u[0] * v[1] - u[1] * v[0];\n"
    "    nn = nx * nx + ny * ny + nz * nz;\n"
    "    area = nn > @N * (uu * vv);\n"
    "    nn = (d[0] * nx + d[1] * ny + d[2] * nz) / sqrt@F(nn);\n"
    "    *gap = area ? nn : *gap;\n"
    "    return area;\n"
    "}\n\n";
static const char more_helpers[] = "FOOTPOINT_FN @R @Dsquare_distance(const @R a[3], const @R b[3])\n"
                                   "{\n"
                                   "    const @R x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];\n"
                                   "    return x * x + y * y + z * z;\n"
                                   "}\n\n"
                                   "/* Number of the corner nearest to s: 0..3, the first of equals. */\n"
                                   "FOOTPOINT_FN int @Dnearest_corner(const @R *const x[4], const @R s[3])\n"
                                   "{\n"
                                   "    @R least = @Dsquare_distance(x[0], s);\n"
                                   "    int nearest = 0, i;\n"
                                   "    for (i = 1; i < 4; i++) {\n"
                                   "        const @R d = @Dsquare_distance(x[i], s);\n"
                                   "        nearest = d < least ? i : nearest;\n"
                                   "        least = d < least ? d : least;\n"
                                   "    }\n"
                                   "    return nearest;\n"
                                   "}\n"
                                   "#endif\n";

/* The same of the kinds whose geometry is in a table: the slave node is the last of the vectors x. */
static const char kind_inspect[] =
    "/* Status of the vectors: all finite, no two corners the same. */\n"
    "FOOTPOINT_FN int @D@N_inspect(const @R *const x[%zu])\n"
    "{\n"
    "    @R sum = 0.0@F;\n"
    "    int coincide = 0, i, j;\n"
    "    for (i = 0; i < %zu; i++)\n"
    "        sum += x[i][0] + x[i][1] + x[i][2];\n"
    "    for (i = 1; i < %zu; i++)\n"
    "        for (j = 0; j < i; j++)\n"
    "            coincide |= (x[i][0] == x[j][0]) & (x[i][1] == x[j][1]) & (x[i][2] == x[j][2]);\n"
    "    return sum - sum == 0.0@F ? (coincide ? FOOTPOINT_ERR_DEGENERATE : FOOTPOINT_OK) : "
    "FOOTPOINT_ERR_NOT_FINITE;\n"
    "}\n\n";
static const char kind_surface[] = "/* u = r_xi, v = r_eta and d = S - r at (xi,eta). */\n"
                                   "FOOTPOINT_FN void @D@N_surface(const @R *const x[%zu], @R xi, @R eta,\n"
                                   "    @R u[3], @R v[3], @R d[3])\n"
                                   "{\n";
static const char kind_gap[] =
    "}\n\n"
    "/* Gap (9): (xS - r(xi,eta)) . n with the unit normal n = r_xi x r_eta / |...| there; mesh length, > 0 open.\n"
    " * 0, and *gap untouched, where r_xi and r_eta are parallel: there is no area and no normal. */\n"
    "FOOTPOINT_FN int @D@N_gap(const @R *const x[%zu], @R xi, @R eta, @R *gap)\n"
    "{\n"
    "    @R u[3], v[3], d[3], nx, ny, nz, nn, uu = 0.0@F, vv = 0.0@F;\n"
    "    int area, i, j;\n"
    "    @D@N_surface(x, xi, eta, u, v, d);\n"
    "    for (j = 0; j < 3; j++) {\n"
    "        @R size = 0.0@F;\n"
    "        for (i = 1; i < %zu; i++)\n"
    "            size += (x[i][j] - x[0][j]) * (x[i][j] - x[0][j]);\n"
    "        uu += u[j] * u[j] + size;\n"
    "        vv += v[j] * v[j] + size;\n"
    "    }\n"
    "    nx = u[1] * v[2] - u[2] * v[1];\n"
    "    ny = u[2] * v[0] - u[0] * v[2];\n"
    "    nz = u[0] * v[1] - u[1] * v[0];\n"
    "    nn = nx * nx + ny * ny + nz * nz;\n"
    "    area = nn > %s * (uu * vv);\n"
    "    nn = (d[0] * nx + d[1] * ny + d[2] * nz) / sqrt@F(nn);\n"
    "    *gap = area ? nn : *gap;\n"
    "    return area;\n"
    "}\n"
    "#endif\n";

static const char *least_area(enum precision precision)
{
    return precision == PRECISION_FLOAT ? "1e-30f + 1e-9f" : "1e-20";
}

static void print_kind_helpers(const struct segment_kind *k, enum precision precision, FILE *out)
{
    const size_t vectors = segment_vectors(k) + 1;
    char guard[32];
    snprintf(guard, sizeof guard, "%s", k->name);
    for (char *c = guard; *c; c++)
        *c = (char)toupper((unsigned char)*c);
    char *inspect = new_format(kind_inspect, vectors, vectors, k->corners);
    char *surface = new_format(kind_surface, vectors);
    char *gap = new_format(kind_gap, vectors, strlen(k->nodes), least_area(precision));
    c_print("\n#ifndef FOOTPOINT_@N_SEARCH@G\n#define FOOTPOINT_@N_SEARCH@G\n", precision, guard, out);
    c_print(inspect, precision, k->name, out);
    c_print(surface, precision, k->name, out);
    c_print(k->surface, precision, k->name, out);
    c_print(gap, precision, k->name, out);
    free(inspect);
    free(surface);
    free(gap);
}

void search_print_helpers(const struct segment_kind *k, enum precision precision, FILE *out)
{
    if (k->surface) {
        print_kind_helpers(k, precision, out);
        return;
    }
    c_print(helpers, precision, least_area(precision), out);
    c_print(more_helpers, precision, "", out);
}

/* Marks the operations whose NaN or infinity makes xi or eta so. */
static bool *mark_carriers(const struct program *p)
{
    bool *carries = new_array(p->ops, sizeof *carries);
    for (size_t i = 0; i < p->outputs; i++)
        carries[p->output[i]] = true;
    for (size_t i = p->ops; i-- > 0;) {
        const struct op *o = &p->op[i];
        if (!carries[i] || o->a < 0 || o->kind == OP_MIN || o->kind == OP_MAX || o->kind == OP_PDIV)
            continue;
        carries[o->a] = true;
        if (o->b >= 0 && o->kind != OP_DIV)
            carries[o->b] = true;
    }
    return carries;
}

bool search_hides_poles(const struct function *f)
{
    const struct program *p = f->program;
    bool *carries = mark_carriers(p), hides = false;
    for (size_t k = 0; k < f->evidence->denominators; k++) {
        const struct denominator *d = &f->evidence->denominator[k];
        bool seen = d->verdict == POLE_FREE;
        for (size_t i = 0; i < p->ops && !seen; i++)
            seen = carries[i] && p->op[i].kind == OP_DIV && p->op[i].b == d->op;
        hides = hides || !seen;
    }
    free(carries);
    return hides;
}

/* Vectors and what comes last, four parameters a line. */
static void print_arguments(const struct segment_kind *k, const char *function, const char *last,
                            enum precision precision, FILE *out)
{
    const int column = fprintf(out, "%s(", function);
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        c_print("const @R @N[3],", precision, name, out);
        if (i % 4 == 3)
            fprintf(out, "\n%*s", column, "");
        else
            fputc(' ', out);
    }
    c_print(last, precision, "", out);
    fputs(")\n", out);
}

/* "xA, xB, ..., xS" */
static void print_vectors(const struct segment_kind *k, FILE *out)
{
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(out, "%s%s", i ? ", " : "", name);
    }
}

/* "    FUNCTION(xA, ..., xS, LAST);" */
static void print_call(const struct unit *u, const char *before, const char *function, const char *last, FILE *out)
{
    fprintf(out, "    %s%s(", before, function);
    print_vectors(u->file->segment, out);
    fprintf(out, ", %s);\n", last);
}

static void print_statements(const struct unit *u, const struct function *f, FILE *out)
{
    single_print_inputs(u, f, out);
    c_print_statements(u, f, out);
    c_print_unused(u, f, out);
}

/* NAME_at.  If it hides poles, its statements are in a function that returns a status, which NAME asks. */
static void print_at(const struct unit *u, const struct function *f, bool hides, FILE *out)
{
    const enum precision precision = u->options.precision;
    const struct operations *ops = &f->code.emission.ops;
    char *head;
    if (hides) {
        c_print("\n/* xi and eta of @N_at, and whether its denominators are far enough from 0. */\n", precision,
                f->name, out);
        head = new_format("FOOTPOINT_FN int footpoint_detail_%s", f->name);
        print_arguments(u->file->segment, head, "@R *xi, @R *eta", precision, out);
        free(head);
        fputs("{\n", out);
        print_statements(u, f, out);
        c_print_status(u, f, out);
        fputs("}\n", out);
    }
    fprintf(out, "\n/* %ld mul, %ld div, %ld add, %ld sqrt.  xi, eta dimensionless; nothing checked. */\n", ops->mul,
            ops->div, ops->add, ops->sqrt);
    head = new_format("FOOTPOINT_FN void %s_at", f->name);
    print_arguments(u->file->segment, head, "@R *xi, @R *eta", precision, out);
    free(head);
    fputs("{\n", out);
    if (hides)
        print_call(u, "(void)footpoint_detail_", f->name, "xi, eta", out);
    else
        print_statements(u, f, out);
    fputs("}\n", out);
}

/* Corners into the assumed order, and (u,v) found there back to the caller's.  `call` begins the call. */
static void print_ordered_call(const struct unit *u, const char *call, FILE *out)
{
    static const char nearest[] = "    x[0] = xA;\n    x[1] = xB;\n    x[2] = xC;\n    x[3] = xD;\n"
                                  "    k = @Dnearest_corner(x, xS);\n";
    static const char shorter[] =
        "    mirror = @Dsquare_distance(x[k], x[(k + 3) & 3]) >\n"
        "             @Dsquare_distance(x[k], x[(k + 1) & 3]);\n"
        "    @N(x[k], x[(k + (mirror ? 3 : 1)) & 3], x[(k + 2) & 3], x[(k + (mirror ? 1 : 3)) & 3], xS, &u, &v);\n"
        "    w = mirror ? v : u;\n"
        "    v = mirror ? u : v;\n"
        "    u = w;\n";
    static const char back[] = "    xi = k == 0 ? u : k == 1 ? -v : k == 2 ? -u : v;\n"
                               "    eta = k == 0 ? v : k == 1 ? u : k == 2 ? -v : -u;\n";
    const enum corner_order order = u->file->order;
    const enum precision precision = u->options.precision;
    if (order == CORNERS_ANY) {
        print_call(u, "", call, "&xi, &eta", out);
        return;
    }
    c_print(nearest, precision, "", out);
    c_print(order == CORNERS_NEAREST ? "    @N(x[k], x[(k + 1) & 3], x[(k + 2) & 3], x[(k + 3) & 3], xS, &u, &v);\n"
                                     : shorter,
            precision, call, out);
    fputs(back, out);
}

/* Ends the line of declarations; kinds of the table take their vectors as an array. */
static void print_vector_array(const struct unit *u, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    fputs(";\n", out);
    if (!k->surface)
        return;
    char *head = new_format("    const @R *const x[%zu] = {", segment_vectors(k) + 1);
    c_print(head, u->options.precision, "", out);
    print_vectors(k, out);
    fputs("};\n", out);
    free(head);
}

static void print_checked(const struct unit *u, const struct function *f, bool hides, FILE *out)
{
    const enum precision precision = u->options.precision;
    const enum corner_order order = u->file->order;
    const bool of_kind = u->file->segment->surface != NULL;
    char *head = new_format("FOOTPOINT_FN int %s", f->name);
    char *call = new_format(hides ? "flaw = footpoint_detail_%s" : "%s_at", f->name);
    fputs("\n/* loc = {xi, eta}, gap along the unit normal at the foot point (mesh length, > 0 open); both untouched "
          "on error.\n * Returns FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE or FOOTPOINT_ERR_DEGENERATE. */\n",
          out);
    print_arguments(u->file->segment, head, "@R loc[2], @R *gap", precision, out);
    c_print("{\n    @R xi, eta, g = 0.0@F", precision, "", out);
    if (order != CORNERS_ANY) {
        c_print(order == CORNERS_NEAREST ? ", u, v;\n" : ", u, v, w;\n", precision, "", out);
        c_print("    const @R *x[4];\n    int k", precision, "", out);
        fputs(order == CORNERS_NEAREST ? "" : ", mirror", out);
    }
    print_vector_array(u, out);
    c_print(of_kind ? "    int area, status = @D@N_inspect(x);\n"
                    : "    int area, status = @Dinspect(xA, xB, xC, xD, xS);\n",
            precision, u->file->segment->name, out);
    if (hides)
        fputs("    int flaw;\n", out);
    print_ordered_call(u, call, out);
    c_print(of_kind ? "    area = @D@N_gap(x, xi, eta, &g);\n" : "    area = @Dgap(xA, xB, xC, xD, xS, xi, eta, &g);\n",
            precision, u->file->segment->name, out);
    c_print("    if (status == FOOTPOINT_OK && !(area @N&& (xi - xi) + (eta - eta) + (g - g) == 0.0@F))\n"
            "        status = FOOTPOINT_ERR_DEGENERATE;\n"
            "    if (status == FOOTPOINT_OK) {\n        loc[0] = xi;\n        loc[1] = eta;\n        *gap = g;\n    }\n"
            "    return status;\n}\n",
            precision, hides ? "&& flaw == FOOTPOINT_OK " : "", out);
    free(call);
    free(head);
}

/* NAME_sure: NAME, and whether its answer is as good as the banner says. */
static void print_sure(const struct unit *u, const struct function *f, FILE *out)
{
    struct memory *m = memory_open();
    print_vectors(u->file->segment, m->stream);
    char *vectors = memory_close(m), *head = new_format("FOOTPOINT_FN int %s_sure", f->name);
    char *worst = single_worst_name(f);
    fprintf(out,
            "\n/* Largest error of xi and eta on the samples held out. */\n#define %s %.3ef\n\n"
            "/* As %s, but FOOTPOINT_ERR_DOMAIN unless it is sure that a foot point is as near to the answer as\n"
            " * that, and that no point of the segment is nearer to S. */\n",
            worst, f->measured->worst, f->name);
    print_arguments(u->file->segment, head, "@R loc[2], @R *gap", u->options.precision, out);
    single_print_sure(f, vectors, out);
    free(worst);
    free(vectors);
    free(head);
}

/* One vector of pair i from its columns, two declarations a line: "xA[3] = {x[0][i], x[1][i], x[2][i]}". */
static void print_gathered(const struct unit *u, FILE *out)
{
    const size_t vectors = segment_vectors(u->file->segment) + 1;
    for (size_t k = 0; k < vectors; k++) {
        char name[4];
        segment_vector_name(u->file->segment, k, name);
        if (k % 2 == 0)
            c_print("        const @R ", u->options.precision, "", out);
        fprintf(out, "%s[3] = {x[%zu][i], x[%zu][i], x[%zu][i]}%s", name, 3 * k, 3 * k + 1, 3 * k + 2,
                k % 2 == 0 && k + 1 < vectors ? ", " : ";\n");
    }
}

/* The loop over columns.  FOOTPOINT_LOOP inlines what it calls, without which it would not vectorise. */
static void print_loop(const struct unit *u, const struct function *f, FILE *out)
{
    const struct segment_kind *kind = u->file->segment;
    const enum precision precision = u->options.precision;
    c_print("\n/* @N_at for n pairs.\n * x[3 k + i] is the column of coordinate i of ", precision, f->name, out);
    fputs(*kind->normals ? "vector k (" : "node k (", out);
    for (size_t k = 0; k <= segment_vectors(kind); k++) {
        char name[4];
        segment_vector_name(kind, k, name);
        fprintf(out, "%s%s", k ? ", " : "", *kind->normals ? name : name + 1);
    }
    fputs("); xi and eta overlap nothing else.\n *", out);
    c_print_loop_note(f, out);
    char *loop = new_format(" */\nFOOTPOINT_LOOP void @N_n(size_t n, const @R *const x[%zu],\n"
                            "    @R *FOOTPOINT_RESTRICT xi, @R *FOOTPOINT_RESTRICT eta)\n"
                            "{\n    size_t i;\n    for (i = 0; i < n; i++) {\n",
                            segment_inputs(kind));
    c_print(loop, precision, f->name, out);
    free(loop);
    print_gathered(u, out);
    fputs("    ", out);
    char *at = new_format("%s_at", f->name);
    print_call(u, "", at, "&xi[i], &eta[i]", out);
    free(at);
    fputs("    }\n}\n", out);
}

void search_print(const struct unit *u, const struct function *f, FILE *out)
{
    const bool hides = search_hides_poles(f);
    print_at(u, f, hides, out);
    print_checked(u, f, hides, out);
    if (single_checks(u) && isfinite(f->measured->worst))
        print_sure(u, f, out);
    print_loop(u, f, out);
}
