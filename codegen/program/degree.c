/* Degrees in lengths, computed from operands to results; see degree.h. Square roots halve them. */
#include "degree.h"

#include "../base/base.h"

#include <stdlib.h>
#include <string.h>

/* Twice a degree, or one of these. */
enum { ANY = 1 << 20, NONE, MOST = 1 << 16 }; /* degree of 0; of a value that is not homogeneous */

static int known(long twice)
{
    return labs(twice) < MOST ? (int)twice : NONE;
}

static int equal(int a, int b)
{
    return a == ANY ? b : b == ANY || a == b ? a : NONE;
}

static int of_input(const struct segment_kind *k, int input)
{
    const size_t vector = (size_t)input / 3, nodes = strlen(k->nodes);
    return vector < nodes || vector == segment_vectors(k) ? 2 : 0;
}

static int result(const struct program *p, const struct segment_kind *k, const struct op *o, const int *twice)
{
    const int a = o->a < 0 ? ANY : twice[o->a], b = o->b < 0 ? ANY : twice[o->b];
    if (a == NONE || b == NONE)
        return NONE;
    switch (o->kind) {
    case OP_CONSTANT:
        return fmpq_is_zero(p->constant + o->input) ? ANY : 0;
    case OP_INPUT:
        return of_input(k, o->input);
    case OP_NEG:
        return a;
    case OP_ADD:
    case OP_SUB:
    case OP_MIN:
    case OP_MAX:
        return equal(a, b);
    case OP_MUL:
        return a == ANY || b == ANY ? ANY : known((long)a + b);
    case OP_DIV:
        return a == ANY || b == ANY ? a : known((long)a - b);
    case OP_PDIV:
        return a == b && a != ANY ? 0 : NONE; /* if b is 0 the result is the number 1 */
    default: {
        const int root = op_unary(o->kind)->root;
        return root == 0 ? (a == 0 ? 0 : NONE) : a == ANY ? ANY : a % root ? NONE : a / root;
    }
    }
}

/* Returns twice the degree of each operation up to number `last`. The caller frees it. */
static int *twice_degrees(const struct program *p, const struct segment_kind *k, size_t last)
{
    int *twice = new_array(last + 1, sizeof *twice);
    for (size_t i = 0; i <= last; i++)
        twice[i] = result(p, k, &p->op[i], twice);
    return twice;
}

bool homogeneous_degree(const struct program *p, const struct segment_kind *k, int op, int *degree)
{
    int *twice = twice_degrees(p, k, (size_t)op);
    const int found = twice[op];
    free(twice);
    *degree = found == ANY ? 0 : found / 2;
    return found != NONE && (found == ANY || found % 2 == 0);
}

bool homogeneous_steepest(const struct program *p, const struct segment_kind *k, int *steepest)
{
    int *twice = twice_degrees(p, k, p->ops - 1), most = 0;
    bool same = true;
    for (size_t i = 0; i < p->ops && same; i++) {
        same = twice[i] != NONE;
        most = twice[i] != ANY && abs(twice[i]) > most ? abs(twice[i]) : most;
    }
    for (size_t i = 0; i < p->outputs && same; i++)
        same = twice[p->output[i]] == ANY || twice[p->output[i]] == 0;
    free(twice);
    *steepest = (most + 1) / 2;
    return same;
}
