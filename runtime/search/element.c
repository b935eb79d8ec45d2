/* Computes forces and consistent tangents of a contact element of any face, for the normal law (10) with a multiplier and for
 * Coulomb's law by return mapping; see footpoint.h. */
#include "../footpoint.h"
#include "../geometry/vector.h"

enum { MOST_NODES = 9, MOST_COORDINATES = 3 * (MOST_NODES + 1) };

static int all_finite(const double *x, int n)
{
    int finite = 1;
    for (int i = 0; i < n; i++)
        finite = finite && number_finite(x[i]);
    return finite;
}

static double largest(const double *x, int n)
{
    double most = 0.0;
    for (int i = 0; i < n; i++)
        most = fabs(x[i]) > most ? fabs(x[i]) : most;
    return most;
}

int footpoint_element_normal(int nodes, double gap, const double *d_gap, const double *hessian, double stiffness,
                             double multiplier, double *pressure, double *force, double *tangent)
{
    if (nodes < 2 || nodes > MOST_NODES || !(stiffness >= 0.0))
        return FOOTPOINT_ERR_ARGUMENT;
    const int n = 3 * (nodes + 1);
    if (!number_finite(gap) || !number_finite(stiffness) || !number_finite(multiplier) || !all_finite(d_gap, n) ||
        !all_finite(hessian, n * (n + 1) / 2))
        return FOOTPOINT_ERR_NOT_FINITE;
    const double law = multiplier - stiffness * gap, p = law > 0.0 ? law : 0.0, k = law > 0.0 ? stiffness : 0.0;
    const double slope = largest(d_gap, n), bend = largest(hessian, n * (n + 1) / 2);
    if (!number_finite(p * slope) || !number_finite(k * slope * slope + p * bend))
        return FOOTPOINT_ERR_NOT_FINITE;
    for (int r = 0; r < n; r++) {
        force[r] = p * d_gap[r];
        for (int c = 0; c <= r; c++)
            tangent[r * (r + 1) / 2 + c] = k * d_gap[r] * d_gap[c] - p * hessian[r * (r + 1) / 2 + c];
    }
    *pressure = p;
    return FOOTPOINT_OK;
}

/* ---- friction ---- */

/* Returns the weight of node k, the slave node being the last, in the vector from the sticking point to the slave node. */
static double weight(const double *phi, int nodes, int k)
{
    return k < nodes ? -phi[k] : 1.0;
}

/* The force -factor s on the slave node, with s = `length` times `along`. */
struct traction {
    double s[3], along[3], length, factor;
    int slides;
};

/* Computes the change dt of the force for a change ds of s and d_limit of the friction limit. */
static void change_of(const struct traction *y, const double ds[3], double d_limit, double dt[3])
{
    const double longer = y->slides ? vector_dot(y->along, ds) : 0.0;
    for (int i = 0; i < 3; i++)
        dt[i] = -y->factor * (ds[i] - longer * y->along[i]) - (y->slides ? d_limit * y->along[i] : 0.0);
}

/* Limits the force to friction, by return mapping. */
static void cut_down(struct traction *y, double limit, double tangential)
{
    y->length = hypot(hypot(y->s[0], y->s[1]), y->s[2]);
    for (int i = 0; i < 3; i++)
        y->along[i] = y->length > 0.0 ? y->s[i] / y->length : 0.0;
    y->slides = limit > 0.0 && tangential * y->length > limit;
    y->factor = y->slides ? limit / y->length : limit > 0.0 ? tangential : 0.0;
}

/* Computes b = a / 2^exponent, of a length near 1. */
static void shorten(const double a[3], int *exponent, double b[3])
{
    *exponent = vector_exponent(a);
    for (int i = 0; i < 3; i++)
        b[i] = ldexp(a[i], -*exponent);
}

/* Computes the slip in xi and eta: the part of s that its spring does not hold, in any unit of length.  Returns 0 if the face
 * has no area. */
static int slip_of(const struct traction *y, double tangential, const double r_xi[3], const double r_eta[3],
                   double slip[2])
{
    double a[3], b[3], n[3], u[3], v[3];
    int per_xi, per_eta;
    shorten(r_xi, &per_xi, a);
    shorten(r_eta, &per_eta, b);
    vector_cross(a, b, n);
    vector_cross(y->along, b, u);
    vector_cross(a, y->along, v);
    const double square = vector_dot(n, n), rest = (1.0 - y->factor / tangential) * y->length;
    if (!(square > VECTOR_PARALLEL * (vector_dot(a, a) * vector_dot(b, b))))
        return 0;
    slip[0] = vector_dot(n, u) / square * ldexp(rest, -per_xi);
    slip[1] = vector_dot(n, v) / square * ldexp(rest, -per_eta);
    return 1;
}

int footpoint_element_friction(int nodes, const double *x, const double *phi, const double r_xi[3],
                               const double r_eta[3], const double normal[3], const double *d_gap,
                               const double *d_normal, double pressure, double stiffness, double friction,
                               double tangential, double slip[2], double *force, double *tangent)
{
    double way[3] = {0, 0, 0}, change[2], most = 0.0, f[MOST_COORDINATES], dt[MOST_COORDINATES][3];
    struct traction y;
    if (nodes < 2 || nodes > MOST_NODES || !(stiffness >= 0.0 && friction >= 0.0 && tangential > 0.0))
        return FOOTPOINT_ERR_ARGUMENT;
    const int n = 3 * (nodes + 1);
    for (int k = 1; k <= nodes; k++)
        for (int i = 0; i < 3; i++)
            way[i] += weight(phi, nodes, k) * (x[3 * k + i] - x[i]);
    if (!vector_finite(way) || !number_finite(phi[0]) || !number_finite(pressure) || !number_finite(stiffness) ||
        !number_finite(tangential) || !vector_finite(r_xi) || !vector_finite(r_eta) || !vector_finite(normal) ||
        !all_finite(d_normal, 3 * n) || !all_finite(d_gap, n))
        return FOOTPOINT_ERR_NOT_FINITE;
    const double height = vector_dot(way, normal);
    for (int i = 0; i < 3; i++)
        y.s[i] = way[i] - height * normal[i];
    cut_down(&y, friction * pressure, tangential);
    if (!number_finite(y.length))
        return FOOTPOINT_ERR_NOT_FINITE;
    if (!slip_of(&y, tangential, r_xi, r_eta, change))
        return FOOTPOINT_ERR_DEGENERATE;
    for (int c = 0; c < n; c++) {
        double ds[3], dm[3];
        for (int i = 0; i < 3; i++)
            dm[i] = d_normal[n * i + c];
        const double w = weight(phi, nodes, c / 3), turned = w * normal[c % 3] + vector_dot(way, dm);
        for (int i = 0; i < 3; i++)
            ds[i] = (i == c % 3 ? w : 0.0) - normal[i] * turned - height * dm[i];
        change_of(&y, ds, -friction * stiffness * d_gap[c], dt[c]);
        f[c] = -w * y.factor * y.s[c % 3];
        most = fabs(w) > most ? fabs(w) : most;
    }
    if (!all_finite(change, 2) || !all_finite(f, n) || !all_finite(dt[0], 3 * n) ||
        !number_finite(most * largest(dt[0], 3 * n)))
        return FOOTPOINT_ERR_NOT_FINITE;
    memcpy(slip, change, sizeof change);
    memcpy(force, f, (size_t)n * sizeof *f);
    for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++)
            tangent[n * r + c] = -weight(phi, nodes, r / 3) * dt[c][r % 3];
    return FOOTPOINT_OK;
}
