/* Functions of patches of either kind; see footpoint_patch.h. */
#include "../footpoint_patch.h"
#include "patch_table.h"

enum { VECTORS = 8 };

/* Returns NULL if there is no such patch. */
static const struct patch *patch_of(enum footpoint_patch patch)
{
    switch (patch) {
    case FOOTPOINT_BEZIER:
        return &footpoint_patch_bezier;
    case FOOTPOINT_GREGORY:
        return &footpoint_patch_gregory;
    default:
        return NULL;
    }
}

/* Pointers to corners and normals. */
struct rows {
    const double *x[VECTORS];
};

static struct rows rows_of(const double *x)
{
    struct rows r;
    for (int k = 0; k < VECTORS; k++)
        r.x[k] = x + 3 * k;
    return r;
}

int footpoint_patch_locate(enum footpoint_patch patch, const double *x, double loc[2], double *gap)
{
    const struct patch *const p = patch_of(patch);
    const struct rows r = rows_of(x);
    return p ? p->pairs.locate(r.x, x + 3 * VECTORS, loc, gap) : FOOTPOINT_ERR_ARGUMENT;
}

size_t footpoint_patch_locate_pairs(enum footpoint_patch patch, size_t n, const double *xyz, const double *normals,
                                    size_t nodes, const int *seg, const int *slave, double *loc, double *gap,
                                    int *status)
{
    const struct patch *const p = patch_of(patch);
    const struct pairs pairs = {n, xyz, normals, nodes, seg, slave, NULL};
    return footpoint_pairs_locate(p ? &p->pairs : NULL, &pairs, loc, gap, status);
}

int footpoint_patch_place(enum footpoint_patch patch, const double *x, const double loc[2], double *r, double *r_xi,
                          double *r_eta, double *normal, double *gap)
{
    const struct patch *const p = patch_of(patch);
    const struct rows rows = rows_of(x);
    return p ? p->place(rows.x, x + 3 * VECTORS, loc, r, r_xi, r_eta, normal, gap) : FOOTPOINT_ERR_ARGUMENT;
}

int footpoint_patch_differentiate(enum footpoint_patch patch, const double *x, const double loc[2], double *r,
                                  double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                                  double *d_gap, double *d_xi_n, double *d_eta_n, double *d_gap_n)
{
    const struct patch *const p = patch_of(patch);
    const struct rows rows = rows_of(x);
    return p ? p->differentiate(rows.x, x + 3 * VECTORS, loc, r, r_xi, r_eta, normal, gap, d_xi, d_eta, d_gap, d_xi_n,
                                d_eta_n, d_gap_n)
             : FOOTPOINT_ERR_ARGUMENT;
}
