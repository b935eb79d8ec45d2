/* Text of the search: five nodes as a mesh has them to xi, eta and the gap.  For a genome NAME of a segment,
 *   NAME_at:  xi and eta by straight-line code, corners in the order that the scene assumes, nothing checked;
 *   NAME:     xi, eta and the signed gap (9), corners in any order, with a status;
 *   NAME_n:   NAME_at for many pairs, from columns of coordinates. */
#include "header_search.h"

#include "c_code.h"
#include "text.h"

#include <stdlib.h>

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

void search_print_helpers(enum precision precision, FILE *out)
{
    c_print(helpers, precision, precision == PRECISION_FLOAT ? "1e-12f" : "1e-20", out);
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

static void print_arguments(const char *function, const char *last, enum precision precision, FILE *out)
{
    const int column = fprintf(out, "%s(", function);
    c_print("const @R xA[3], const @R xB[3], const @R xC[3], const @R xD[3],\n", precision, "", out);
    fprintf(out, "%*s", column, "");
    c_print("const @R xS[3], ", precision, "", out);
    c_print(last, precision, "", out);
    fputs(")\n", out);
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
        print_arguments(head, "@R *xi, @R *eta", precision, out);
        free(head);
        fputs("{\n", out);
        c_print_statements(u, f, out);
        c_print_unused(u, f, out);
        c_print_status(u, f, out);
        fputs("}\n", out);
    }
    fprintf(out, "\n/* %ld mul, %ld div, %ld add, %ld sqrt.  xi, eta dimensionless; nothing checked. */\n", ops->mul,
            ops->div, ops->add, ops->sqrt);
    head = new_format("FOOTPOINT_FN void %s_at", f->name);
    print_arguments(head, "@R *xi, @R *eta", precision, out);
    free(head);
    fputs("{\n", out);
    if (hides)
        fprintf(out, "    (void)footpoint_detail_%s(xA, xB, xC, xD, xS, xi, eta);\n", f->name);
    else {
        c_print_statements(u, f, out);
        c_print_unused(u, f, out);
    }
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
        fprintf(out, "    %s(xA, xB, xC, xD, xS, &xi, &eta);\n", call);
        return;
    }
    c_print(nearest, precision, "", out);
    c_print(order == CORNERS_NEAREST ? "    @N(x[k], x[(k + 1) & 3], x[(k + 2) & 3], x[(k + 3) & 3], xS, &u, &v);\n"
                                     : shorter,
            precision, call, out);
    fputs(back, out);
}

static void print_checked(const struct unit *u, const struct function *f, bool hides, FILE *out)
{
    const enum precision precision = u->options.precision;
    const enum corner_order order = u->file->order;
    char *head = new_format("FOOTPOINT_FN int %s", f->name);
    char *call = new_format(hides ? "flaw = footpoint_detail_%s" : "%s_at", f->name);
    fputs("\n/* loc = {xi, eta}, gap along the unit normal at the foot point (mesh length, > 0 open); both untouched "
          "on error.\n * Returns FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE or FOOTPOINT_ERR_DEGENERATE. */\n",
          out);
    print_arguments(head, "@R loc[2], @R *gap", precision, out);
    c_print("{\n    @R xi, eta, g = 0.0@F", precision, "", out);
    if (order != CORNERS_ANY) {
        c_print(order == CORNERS_NEAREST ? ", u, v;\n" : ", u, v, w;\n", precision, "", out);
        c_print("    const @R *x[4];\n    int k", precision, "", out);
        fputs(order == CORNERS_NEAREST ? "" : ", mirror", out);
    }
    c_print(";\n    int area, status = @Dinspect(xA, xB, xC, xD, xS);\n", precision, "", out);
    if (hides)
        fputs("    int flaw;\n", out);
    print_ordered_call(u, call, out);
    c_print("    area = @Dgap(xA, xB, xC, xD, xS, xi, eta, &g);\n"
            "    if (status == FOOTPOINT_OK && !(area @N&& (xi - xi) + (eta - eta) + (g - g) == 0.0@F))\n"
            "        status = FOOTPOINT_ERR_DEGENERATE;\n"
            "    if (status == FOOTPOINT_OK) {\n        loc[0] = xi;\n        loc[1] = eta;\n        *gap = g;\n    }\n"
            "    return status;\n}\n",
            precision, hides ? "&& flaw == FOOTPOINT_OK " : "", out);
    free(call);
    free(head);
}

/* The loop over columns.  FOOTPOINT_LOOP inlines what it calls, without which it would not vectorise. */
static void print_loop(const struct unit *u, const struct function *f, FILE *out)
{
    static const char head[] =
        "\n/* @N_at for n pairs.\n"
        " * x[3 k + i] is the column of coordinate i of node k (A, B, C, D, S); xi and eta overlap nothing else.\n *";
    static const char loop[] =
        " */\nFOOTPOINT_LOOP void @N_n(size_t n, const @R *const x[15],\n"
        "    @R *FOOTPOINT_RESTRICT xi, @R *FOOTPOINT_RESTRICT eta)\n"
        "{\n"
        "    size_t i;\n"
        "    for (i = 0; i < n; i++) {\n"
        "        const @R xA[3] = {x[0][i], x[1][i], x[2][i]}, xB[3] = {x[3][i], x[4][i], x[5][i]};\n"
        "        const @R xC[3] = {x[6][i], x[7][i], x[8][i]}, xD[3] = {x[9][i], x[10][i], x[11][i]};\n"
        "        const @R xS[3] = {x[12][i], x[13][i], x[14][i]};\n"
        "        @N_at(xA, xB, xC, xD, xS, &xi[i], &eta[i]);\n"
        "    }\n"
        "}\n";
    c_print(head, u->options.precision, f->name, out);
    c_print_loop_note(f, out);
    c_print(loop, u->options.precision, f->name, out);
}

void search_print(const struct unit *u, const struct function *f, FILE *out)
{
    const bool hides = search_hides_poles(f);
    print_at(u, f, hides, out);
    print_checked(u, f, hides, out);
    print_loop(u, f, out);
}
