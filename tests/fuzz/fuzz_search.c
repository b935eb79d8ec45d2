/* Fuzzes the runtime library's searches on a small mesh of any numbers and indices.  Every function must return a status of its
 * contract, write nothing unless that permits it, and then finite numbers; a batch must have the bits of the
 * generated functions.  Built with clang -fsanitize=fuzzer, or with replay_main.c. */
#include "../../generated/footpoint_quad4.h"
#include "../../runtime/footpoint_batch.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 24, MOST_PAIRS = 100 };
#define UNTOUCHED 77.25

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

typedef int search(const double *, const double *, const double *, const double *, const double *, double *, double *);
static search *const single[FOOTPOINT_TIERS] = {
    footpoint_quad4_fast,    footpoint_quad4_coarse,   footpoint_quad4_gauss2,
    footpoint_quad4_medium,  footpoint_quad4_balanced, footpoint_quad4_fine,
    footpoint_quad4_precise, footpoint_quad4_accurate, footpoint_quad4_full};

struct input {
    const uint8_t *data;
    size_t size, at;
};

static void require(int good, const char *what)
{
    if (good)
        return;
    fprintf(stderr, "fuzz_search: %s\n", what);
    abort();
}

/* Takes the next bytes; zeros after the end. */
static void take(struct input *in, void *to, size_t size)
{
    memset(to, 0, size);
    for (size_t i = 0; i < size && in->at < in->size; i++)
        ((uint8_t *)to)[i] = in->data[in->at++];
}

static unsigned take_byte(struct input *in)
{
    uint8_t byte;
    take(in, &byte, 1);
    return byte;
}

/* Takes a coordinate: any bits of a double, or a small number of two bytes or one, so that some coincide. */
static double take_number(struct input *in, unsigned form, double scale)
{
    int64_t bits;
    double x;
    take(in, &bits, form == 0 ? 8 : form == 1 ? 2 : 1);
    if (form != 0)
        return scale * (form == 1 ? (double)(int16_t)bits / 256 : (double)(int8_t)bits);
    memcpy(&x, &bits, sizeof x);
    return x;
}

struct mesh {
    size_t nodes, pairs;
    double xyz[MOST_NODES][3];
    int32_t seg[MOST_PAIRS][4], slave[MOST_PAIRS];
    int64_t seg64[MOST_PAIRS][4], slave64[MOST_PAIRS];
};

static void take_mesh(struct input *in, struct mesh *m)
{
    const unsigned form = take_byte(in) % 3, exponent = take_byte(in);
    const double scale = exponent < 200 ? 1.0 : exponent < 228 ? 1e-20 : 1e25;
    m->nodes = 5 + take_byte(in) % (MOST_NODES - 4);
    m->pairs = take_byte(in) % (MOST_PAIRS + 1);
    const unsigned invalid = take_byte(in); /* from 128 on, some indices are out of range */
    for (size_t i = 0; i < 3 * m->nodes; i++)
        m->xyz[i / 3][i % 3] = take_number(in, form, scale);
    for (size_t i = 0; i < 5 * m->pairs; i++) {
        /* A multiplication replaces missing input. */
        const unsigned byte = in->at < in->size ? take_byte(in) : (unsigned)(i * 2654435761U >> 16 & 255);
        int32_t index = (int32_t)(byte % (unsigned)m->nodes);
        if (invalid >= 128 && byte == invalid)
            index = byte % 2 ? -index - 1 : INT32_MAX - index;
        *(i % 5 < 4 ? &m->seg[i / 5][i % 5] : &m->slave[i / 5]) = index;
        *(i % 5 < 4 ? &m->seg64[i / 5][i % 5] : &m->slave64[i / 5]) = index;
    }
}

static int is_finite(const double *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!(x[i] - x[i] == 0.0))
            return 0;
    return 1;
}

static int is_untouched(const double *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (x[i] != UNTOUCHED)
            return 0;
    return 1;
}

static int has_answer(int status)
{
    return status >= FOOTPOINT_OK;
}

static void check_answer(const char *what, int status, const double *x, size_t n)
{
    require(status >= FOOTPOINT_STATUS_LEAST && status <= FOOTPOINT_STATUS_MOST, what);
    require(has_answer(status) ? is_finite(x, n) : is_untouched(x, n), what);
}

/* ---- batches ---- */

static void check_batch(const struct mesh *m, enum footpoint_tier tier, int kind)
{
    static double loc[MOST_PAIRS][2], gap[MOST_PAIRS];
    static int status[MOST_PAIRS];
    struct footpoint_pairs p = {.n = m->pairs, .nodes = m->nodes, .stride = 3};
    size_t failed = 0;
    p.x = m->xyz[0], p.y = p.x + 1, p.z = p.x + 2;
    p.seg = kind & 1 ? NULL : m->seg[0], p.slave = kind & 1 ? NULL : m->slave;
    p.seg64 = kind & 1 ? m->seg64[0] : NULL, p.slave64 = kind & 1 ? m->slave64 : NULL;
    for (size_t i = 0; i < m->pairs; i++)
        loc[i][0] = loc[i][1] = gap[i] = UNTOUCHED;
    const size_t count = footpoint_locate_batch(&p, tier, loc[0], kind & 2 ? gap : NULL, kind & 4 ? status : NULL);
    for (size_t i = 0; i < m->pairs; i++) {
        double expected[3] = {UNTOUCHED, UNTOUCHED, UNTOUCHED};
        const double *x[5] = {0}, untouched = UNTOUCHED;
        int valid = 1, answer = FOOTPOINT_ERR_ARGUMENT;
        for (int k = 0; k < 5; k++) {
            const int32_t index = k < 4 ? m->seg[i][k] : m->slave[i];
            valid &= index >= 0 && (size_t)index < m->nodes;
            x[k] = m->xyz[valid ? index : 0];
        }
        if (valid)
            answer = single[tier](x[0], x[1], x[2], x[3], x[4], expected, expected + 2);
        check_answer("search of one pair", answer, expected, 3);
        failed += answer != FOOTPOINT_OK;
        require(memcmp(loc[i], expected, sizeof loc[i]) == 0, "xi, eta of a batch");
        require(memcmp(&gap[i], kind & 2 ? &expected[2] : &untouched, sizeof gap[i]) == 0, "gap of a batch");
        require(!(kind & 4) || status[i] == answer, "status of a batch");
    }
    require(count == failed, "count of a batch");
}

static void check_prepared(const struct mesh *m, enum footpoint_tier tier)
{
    static double loc[MOST_NODES][2], gap[MOST_NODES];
    const double(*const x)[3] = m->xyz;
    struct footpoint_segment s;
    int status[MOST_NODES];
    if (footpoint_prepare(x[0], x[1], x[2], x[3], &s) != FOOTPOINT_OK)
        return;
    for (size_t i = 0; i < m->nodes; i++)
        loc[i][0] = loc[i][1] = gap[i] = UNTOUCHED;
    footpoint_locate_prepared(&s, tier, m->nodes, x[0], loc[0], gap, status);
    for (size_t i = 0; i < m->nodes; i++) {
        double expected[3] = {UNTOUCHED, UNTOUCHED, UNTOUCHED};
        require(single[tier](x[0], x[1], x[2], x[3], x[i], expected, expected + 2) == status[i], "prepared: status");
        require(memcmp(loc[i], expected, sizeof loc[i]) == 0 && gap[i] == expected[2], "prepared: answer");
    }
}

/* ---- one pair ---- */

static void check_pair(const struct mesh *m)
{
    const double *const A = m->xyz[0], *const B = m->xyz[1], *const C = m->xyz[2], *const D = m->xyz[3];
    const double *const S = m->xyz[4];
    double x[3] = {UNTOUCHED, UNTOUCHED, UNTOUCHED}, f[15];
    int status = footpoint_newton(A, B, C, D, S, 20, 1e-12, x, x + 2, NULL);
    check_answer("footpoint_newton", status, x, 3);
    for (int i = 0; i < 15; i++)
        f[i] = UNTOUCHED;
    if (status == FOOTPOINT_OK) {
        status = footpoint_force_balanced(A, B, C, D, S, x, 0.5, f, (double(*)[3])(f + 3));
        require(status == FOOTPOINT_OK || is_untouched(f, 15), "footpoint_force_balanced");
    }
    x[0] = x[1] = x[2] = UNTOUCHED;
    check_answer("footpoint_normal", footpoint_normal(A, B, C, x), x, 3);
}

static void check_choice(const struct mesh *m)
{
    double distance = UNTOUCHED;
    int chosen = -7, status;
    for (size_t i = 0; i < m->pairs; i++)
        for (int k = 0; k < 4; k++)
            if (m->seg[i][k] >= (int32_t)m->nodes)
                return; /* the caller must prevent this */
    const int candidates = (int)(m->pairs < 9 ? m->pairs : 9), master = candidates ? m->seg[0][0] : 0;
    status = footpoint_select_segment(m->xyz[0], master, candidates, m->seg[0], m->xyz[4], &chosen);
    require(status == FOOTPOINT_OK ? chosen >= 0 && chosen < candidates : chosen == -7, "footpoint_select_segment");
    chosen = -7;
    status = footpoint_select_closest(m->xyz[0], master, candidates, m->seg[0], m->xyz[4], &chosen, &distance);
    check_answer("footpoint_select_closest: distance", status, &distance, 1);
    require(has_answer(status) ? chosen >= 0 && chosen < candidates : chosen == -7, "footpoint_select_closest");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct mesh m;
    struct input in = {data, size, 0};
    const unsigned tier = take_byte(&in) % FOOTPOINT_TIERS, kind = take_byte(&in);
    take_mesh(&in, &m);
    check_batch(&m, (enum footpoint_tier)tier, (int)(kind % 8));
    check_prepared(&m, (enum footpoint_tier)tier);
    check_pair(&m);
    check_choice(&m);
    return 0;
}
