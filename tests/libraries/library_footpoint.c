/* footpoint: functions of generated/ and of the library, used as their READMEs describe. */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri6.h"
#include "../../runtime/footpoint.h"
#include "library.h"

#include <stdlib.h>
#include <string.h>

void attach_2d_(double *pneigh, double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                double *etl);

struct work {
    int kind, nodes;
    double x[LIBRARY_NODES][3];
};

static void *open_work(int kind)
{
    static const int nodes[LIBRARY_KINDS] = {4, 6, 8, 9};
    struct work *const w = calloc(1, sizeof *w);
    if (w) {
        w->kind = kind;
        w->nodes = nodes[kind];
    }
    return w;
}

static void set(void *work, const double *x)
{
    struct work *const w = work;
    memcpy(w->x, x, (size_t)w->nodes * sizeof *w->x);
}

#define FOUR w->x[0], w->x[1], w->x[2], w->x[3], xs
#define SIX w->x[0], w->x[1], w->x[2], w->x[3], w->x[4], w->x[5], xs
#define EIGHT w->x[0], w->x[1], w->x[2], w->x[3], w->x[4], w->x[5], w->x[6], w->x[7], xs
#define NINE w->x[0], w->x[1], w->x[2], w->x[3], w->x[4], w->x[5], w->x[6], w->x[7], w->x[8], xs

#define SEARCH(name, call)                                                                                             \
    static int name(void *work, const double xs[3], struct library_answer *a)                                          \
    {                                                                                                                  \
        const struct work *const w = work;                                                                             \
        double gap = 0;                                                                                                \
        int region = 0;                                                                                                \
        (void)gap;                                                                                                     \
        (void)region;                                                                                                  \
        return call;                                                                                                   \
    }

static int told(int status)
{
    return status == FOOTPOINT_OK ? LIBRARY_ANSWER : LIBRARY_NONE;
}

/* Returns true for statuses of footpoint_robust with outputs, except the status for an answer that may be wrong. */
static int told_robust(int status)
{
    return status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE || status == FOOTPOINT_NOT_UNIQUE ||
                   status == FOOTPOINT_ERR_DEGENERATE
               ? LIBRARY_ANSWER
               : LIBRARY_NONE;
}

SEARCH(balanced_at, (footpoint_quad4_balanced_at(FOUR, &a->loc[0], &a->loc[1]), LIBRARY_ANSWER))
SEARCH(accurate_at, (footpoint_quad4_accurate_at(FOUR, &a->loc[0], &a->loc[1]), LIBRARY_ANSWER))
SEARCH(accurate, told(footpoint_quad4_accurate(FOUR, a->loc, &gap)))
SEARCH(accurate_closest, told(footpoint_quad4_accurate_closest(FOUR, a->loc, &gap, &region)))
SEARCH(locate, told(footpoint_locate(FOUR, a->loc, &gap)))
SEARCH(robust, told_robust(footpoint_robust(FOUR, a->loc, &gap)))
SEARCH(tri6_accurate, told(footpoint_tri6_accurate(SIX, a->loc, &gap)))
SEARCH(quad8_accurate, told(footpoint_quad8_accurate(EIGHT, a->loc, &gap)))
SEARCH(quad8_full, told(footpoint_quad8_full(EIGHT, a->loc, &gap)))
SEARCH(quad9_accurate, told(footpoint_quad9_accurate(NINE, a->loc, &gap)))
SEARCH(quad9_full, told(footpoint_quad9_full(NINE, a->loc, &gap)))

/* Calls CalculiX's interface, which overwrites the slave node by the answer. */
static int attach(void *work, const double xs[3], struct library_answer *a)
{
    struct work *const w = work;
    double node[3] = {xs[0], xs[1], xs[2]}, ratio[LIBRARY_NODES], dist;
    attach_2d_(w->x[0], node, &w->nodes, ratio, &dist, &a->loc[0], &a->loc[1]);
    return LIBRARY_ANSWER;
}

enum { QUAD4 = 1 << LIBRARY_QUAD4, TRI6 = 1 << LIBRARY_TRI6, QUAD8 = 1 << LIBRARY_QUAD8, QUAD9 = 1 << LIBRARY_QUAD9 };

#define ROW(name, kinds, question, find, note)                                                                         \
    {                                                                                                                  \
        name, kinds, question, note, open_work, set, find, free                                                        \
    }
static const struct library_search searches[] = {
    ROW("balanced_at", QUAD4, LIBRARY_FOOT, balanced_at, "no status"),
    ROW("accurate_at", QUAD4, LIBRARY_FOOT, accurate_at, "no status"),
    ROW("accurate", QUAD4, LIBRARY_FOOT, accurate, "status and gap"),
    ROW("locate", QUAD4, LIBRARY_FOOT, locate, "footpoint_locate: checked by proof"),
    ROW("accurate_closest", QUAD4, LIBRARY_CLOSEST, accurate_closest, "closed face"),
    ROW("robust", QUAD4, LIBRARY_CLOSEST, robust, "footpoint_robust: any four corners"),
    ROW("accurate", TRI6, LIBRARY_FOOT, tri6_accurate, "status and gap"),
    ROW("accurate", QUAD8, LIBRARY_FOOT, quad8_accurate, "status and gap"),
    ROW("full", QUAD8, LIBRARY_FOOT, quad8_full, "status and gap"),
    ROW("accurate", QUAD9, LIBRARY_FOOT, quad9_accurate, "status and gap"),
    ROW("full", QUAD9, LIBRARY_FOOT, quad9_full, "status and gap"),
    ROW("attach_2d", QUAD4 | TRI6 | QUAD8, LIBRARY_CLOSEST, attach, "CalculiX's interface; no status"),
};

static int differentiate(const double *x, const double loc[2], double d[3][15])
{
    struct footpoint_derivatives out;
    if (footpoint_differentiate(x, x + 3, x + 6, x + 9, x + 12, loc, &out) != FOOTPOINT_OK)
        return 0;
    memcpy(d[0], out.d_xi, sizeof d[0]);
    memcpy(d[1], out.d_eta, sizeof d[1]);
    memcpy(d[2], out.d_gap, sizeof d[2]);
    return 1;
}

static const struct library_derivative derivatives[] = {
    {"differentiate", "footpoint_differentiate: tangents and normal, too", differentiate}};

const struct library *library_open(void)
{
    static const struct library footpoint = {"footpoint", LIBRARY_VERSION, sizeof searches / sizeof *searches, searches,
                                             1,           derivatives};
    return &footpoint;
}
