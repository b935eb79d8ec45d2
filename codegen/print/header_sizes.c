/* Determines the sizes of segments that functions accept; see header_sizes.h.
 *
 * Statuses rest on bits, because -ffast-math removes comparisons with NaN and infinity, and on four numbers that must be
 * within a range: the size of the segment, the denominators, the square of the normal, and the result.  A value
 * of degree n in lengths grows as size^n.  The range of sizes is chosen so that the steepest value takes half of the exponents
 * of the type, and the range of the others so that their products stay within it.  Overflow makes infinity or NaN,
 * which shows in the result, unless it is a divisor; underflow matters only in divisors.  If a number is
 * out of range, the search is repeated in a unit of length in which the segment is about 1 long: a
 * power of 2, so that nothing is rounded.  Numbers that are out of range then are so at any size. */
#include "header_sizes.h"

#include "../base/text.h"
#include "../program/degree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Exponents of 2 that the size may take, half of all; degree of the gap's own products, in double
 * twice as high, because compilers under -ffast-math divide by products of two denominators. */
enum { EXPONENTS = 512, EXPONENTS_FLOAT = 64, LEAST_DEGREE = 8, LEAST_DEGREE_FLOAT = 4, LEAST_REACH = 3 };

/* Finds the degree of a function's steepest value; coordinates relative to the segment have degree 0. */
static bool steepest(const struct function *f, const struct segment_kind *k, int *degree)
{
    *degree = 0;
    return f->scaled || homogeneous_steepest(f->program, k, degree);
}

bool sizes_scalable(const struct function *f, const struct segment_kind *k)
{
    int degree;
    return steepest(f, k, &degree);
}

char *sizes_least_name(const struct unit *u)
{
    char *prefix = new_capitals(u->options.prefix), *name = new_format("%s_LEAST", prefix);
    free(prefix);
    return name;
}

/* Prints the square of 2^-reach. */
void sizes_print_least(const struct unit *u, FILE *out)
{
    const bool single = u->options.precision == PRECISION_FLOAT;
    int most = single ? LEAST_DEGREE_FLOAT : LEAST_DEGREE;
    for (size_t i = 0; i < u->file->genomes; i++) {
        int degree;
        if (steepest(&u->function[i], u->file->segment, &degree) && degree > most)
            most = degree;
    }
    const int reach = (single ? EXPONENTS_FLOAT : EXPONENTS) / most;
    char *name = sizes_least_name(u);
    fprintf(
        out,
        "\n/* Where the squares of a segment's edges add up to less than this, or to more than 1 over it, nodes are "
        "first\n * scaled by a power of 2. */\n#define %s %.16e%s\n",
        name, ldexp(1.0, -2 * (reach > LEAST_REACH ? reach : LEAST_REACH)), single ? "f" : "");
    free(name);
}
