/* Helpers of checked searches; see header_helpers.h.
 *
 * Statuses rest on bits, as -ffast-math takes comparisons with NaN and infinity away, and on four things that must be
 * within a range: the size of the segment, the denominators, the square of the normal, and what is returned.  A value
 * of degree n in lengths goes as size^n: the range of sizes is such that the steepest one takes half of the exponents
 * of the type, the range of the others such that products of them stay within it.  Overflow makes infinity or NaN,
 * which shows in what is returned, unless it is divided by; underflow matters only in what is divided by.  Where
 * something is out of range, the search is done once more in a unit of length in which the segment is about 1 long: a
 * power of 2, so that nothing is rounded.  What is out of range then is so at any size. */
#include "header_helpers.h"

#include "../genome/text.h"
#include "../program/degree.h"
#include "c_text.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Exponents of 2 that the size may take, half of those that there are; degree of the gap's own products, in double
 * twice as high, as compilers under -ffast-math divide by products of two denominators. */
enum { EXPONENTS = 512, EXPONENTS_FLOAT = 64, LEAST_DEGREE = 8, LEAST_DEGREE_FLOAT = 4, LEAST_REACH = 3 };

static const char scale[] =
    "\n#ifndef FOOTPOINT_DETAIL_SCALE@G\n"
    "#define FOOTPOINT_DETAIL_SCALE@G\n"
    "/* 1 if all coordinates of n vectors are finite. */\n"
    "FOOTPOINT_FN int @Dfinite(const @R *const *x, int n)\n"
    "{\n"
    "    @I infinite = 0;\n"
    "    int i, j;\n"
    "    for (i = 0; i < n; i++)\n"
    "        for (j = 0; j < 3; j++)\n"
    "            infinite |= @Dinfinite(x[i][j]);\n"
    "    return !(infinite >> @B);\n"
    "}\n\n"
    "/* Nodes and slave node, the last of the vectors, in a unit of length, 2^exponent, in which the segment is about "
    "1\n"
    " * long; normals, which stand between them, as they are.  Not FOOTPOINT_OK: they are not finite, or of no length. "
    "*/\n"
    "FOOTPOINT_FN int @Dscale(const @R *const *x, int nodes, int vectors, @R (*y)[3], int *exponent)\n"
    "{\n"
    "    @R most = 0.0@F;\n"
    "    int i, j;\n"
    "    if (!@Dfinite(x, vectors))\n"
    "        return FOOTPOINT_ERR_NOT_FINITE;\n"
    "    for (i = 1; i < nodes; i++)\n"
    "        for (j = 0; j < 3; j++) {\n"
    "            const @R half = fabs@F(0.5@F * x[i][j] - 0.5@F * x[0][j]);\n"
    "            most = half > most ? half : most;\n"
    "        }\n"
    "    if ((@Dbelow(most, @Z) | @Dinfinite(most)) >> @B)\n"
    "        return FOOTPOINT_ERR_DEGENERATE;\n"
    "    (void)frexp@F(most, exponent);\n"
    "    for (i = 0; i < vectors; i++)\n"
    "        for (j = 0; j < 3; j++)\n"
    "            y[i][j] = i < nodes || i == vectors - 1 ? ldexp@F(x[i][j], -*exponent) : x[i][j];\n"
    "    return FOOTPOINT_OK;\n"
    "}\n"
    "#endif\n";

/* Ends both functions of the gap: uu, vv and size are sums of squares. */
#define END_OF_GAP                                                                                                     \
    "    nx = u[1] * v[2] - u[2] * v[1];\n"                                                                            \
    "    ny = u[2] * v[0] - u[0] * v[2];\n"                                                                            \
    "    nz = u[0] * v[1] - u[1] * v[0];\n"                                                                            \
    "    nn = nx * nx + ny * ny + nz * nz;\n"                                                                          \
    "    *gap = (d[0] * nx + d[1] * ny + d[2] * nz) / sqrt@F(nn);\n"                                                   \
    "    return @Dbelow(size, least) | @Dbelow(1.0@F / least, size) | @Doutside(nn) |\n"                               \
    "           @Dbits(nn - @N * (uu * vv)) | @Dinfinite(xi + eta + *gap);\n"                                          \
    "}\n"
#define ABOUT_GAP                                                                                                      \
    "/* Gap (9): (xS - r(xi,eta)) . n with the unit normal n = r_xi x r_eta / |...| there; mesh length, > 0 open.  "   \
    "The\n"                                                                                                            \
    " * highest bit of what it returns is set where r_xi and r_eta are parallel, so that there is no area and no "     \
    "normal,\n"                                                                                                        \
    " * where the sum of the squares of the edges is not between 1 / range and range, and where something is not "     \
    "finite. "                                                                                                         \
    "*/\n"

static const char quad4[] =
    "\n#ifndef FOOTPOINT_QUAD4_SEARCH@G\n"
    "#define FOOTPOINT_QUAD4_SEARCH@G\n" ABOUT_GAP
    "FOOTPOINT_PART @I @Dgap(const @R xA[3], const @R xB[3], const @R xC[3],\n"
    "    const @R xD[3], const @R xS[3], @R xi, @R eta, @R least, @R *gap)\n"
    "{\n"
    "    @R u[3], v[3], d[3], nx, ny, nz, nn, size, uu = 0.0@F, vv = 0.0@F, along = 0.0@F, across = 0.0@F;\n"
    "    int i;\n"
    "    for (i = 0; i < 3; i++) {\n"
    "        const @R ab = xB[i] - xA[i], dc = xC[i] - xD[i], ad = xD[i] - xA[i], bc = xC[i] - xB[i];\n"
    "        const @R s = 0.5@F * (1.0@F + xi), t = 0.5@F * (1.0@F + eta);\n"
    "        u[i] = ab + t * (dc - ab);\n"
    "        v[i] = ad + s * (bc - ad);\n"
    "        d[i] = (xS[i] - xA[i]) - s * ab - t * v[i];\n"
    "        uu += u[i] * u[i];\n"
    "        vv += v[i] * v[i];\n"
    "        along += ab * ab + dc * dc;\n"
    "        across += ad * ad + bc * bc;\n"
    "    }\n"
    "    size = along + across;\n"
    "    uu += along;\n"
    "    vv += across;\n" END_OF_GAP "\n";
static const char corners[] = "FOOTPOINT_FN @R @Dsquare_distance(const @R a[3], const @R b[3])\n"
                              "{\n"
                              "    const @R x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];\n"
                              "    return x * x + y * y + z * z;\n"
                              "}\n\n"
                              "/* Number of the corner nearest to s: 0..3, the first of equals. */\n"
                              "FOOTPOINT_FN int @Dnearest_corner(const @R *const *x, const @R s[3])\n"
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
static const char kind_surface[] = "/* u = r_xi, v = r_eta and d = S - r at (xi,eta). */\n"
                                   "FOOTPOINT_FN void @D@N_surface(const @R *const x[%zu], @R xi, @R eta,\n"
                                   "    @R u[3], @R v[3], @R d[3])\n"
                                   "{\n";
static const char kind_gap[] =
    "}\n\n" ABOUT_GAP "FOOTPOINT_PART @I @D%s_gap(const @R *const x[%zu], @R xi, @R eta, @R least, @R *gap)\n"
    "{\n"
    "    @R u[3], v[3], d[3], nx, ny, nz, nn, size = 0.0@F, uu, vv;\n"
    "    int i, j;\n"
    "    @D%s_surface(x, xi, eta, u, v, d);\n"
    "    for (j = 0; j < 3; j++)\n"
    "        for (i = 1; i < %zu; i++)\n"
    "            size += (x[i][j] - x[0][j]) * (x[i][j] - x[0][j]);\n"
    "    uu = u[0] * u[0] + u[1] * u[1] + u[2] * u[2] + size;\n"
    "    vv = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + size;\n" END_OF_GAP "#endif\n";

static char *capitals(const char *text)
{
    char *copy = new_text(text, strlen(text));
    for (char *c = copy; *c; c++)
        *c = (char)toupper((unsigned char)*c);
    return copy;
}

static void print_kind(const struct segment_kind *k, enum precision precision, const char *area, FILE *out)
{
    const size_t vectors = segment_vectors(k) + 1;
    char *guard = capitals(k->name), *surface = new_format(kind_surface, vectors);
    char *gap = new_format(kind_gap, k->name, vectors, k->name, strlen(k->nodes));
    c_print("\n#ifndef FOOTPOINT_@N_SEARCH@G\n#define FOOTPOINT_@N_SEARCH@G\n", precision, guard, out);
    c_print(surface, precision, k->name, out);
    c_print(k->surface, precision, k->name, out);
    c_print(gap, precision, area, out);
    free(guard);
    free(surface);
    free(gap);
}

/* Degree of a function's steepest value; coordinates that are relative to the segment have none. */
static bool steepest(const struct function *f, const struct segment_kind *k, int *degree)
{
    *degree = 0;
    return f->scaled || homogeneous_steepest(f->program, k, degree);
}

bool helpers_scalable(const struct function *f, const struct segment_kind *k)
{
    int degree;
    return steepest(f, k, &degree);
}

char *helpers_least_name(const struct unit *u)
{
    char *prefix = capitals(u->options.prefix), *name = new_format("%s_LEAST", prefix);
    free(prefix);
    return name;
}

/* The square of 2^-reach. */
static void print_least(const struct unit *u, FILE *out)
{
    const bool single = u->options.precision == PRECISION_FLOAT;
    int most = single ? LEAST_DEGREE_FLOAT : LEAST_DEGREE;
    for (size_t i = 0; i < u->file->genomes; i++) {
        int degree;
        if (steepest(&u->function[i], u->file->segment, &degree) && degree > most)
            most = degree;
    }
    const int reach = (single ? EXPONENTS_FLOAT : EXPONENTS) / most;
    char *name = helpers_least_name(u);
    fprintf(
        out,
        "\n/* Where the squares of a segment's edges add up to less than this, or to more than 1 over it, nodes are "
        "first\n * scaled by a power of 2. */\n#define %s %.16e%s\n",
        name, ldexp(1.0, -2 * (reach > LEAST_REACH ? reach : LEAST_REACH)), single ? "f" : "");
    free(name);
}

void helpers_print(const struct unit *u, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    const enum precision precision = u->options.precision;
    const char *area = precision == PRECISION_FLOAT ? "1e-9f" : "1e-20";
    c_print(scale, precision, "", out);
    if (k->surface)
        print_kind(k, precision, area, out);
    else {
        c_print(quad4, precision, area, out);
        c_print(corners, precision, "", out);
    }
    print_least(u, out);
}
