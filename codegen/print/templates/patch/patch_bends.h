/* Second derivatives of patches over their parts, as nets of Bernstein coefficients. */

/* First coefficients of r_pp, 2 along p by 4 along q, of r_pq, 3 by 3, and of r_qq, 4 by 2. */
enum {
    FOOTPOINT_DETAIL_PP = 0,
    FOOTPOINT_DETAIL_PQ = 8,
    FOOTPOINT_DETAIL_QQ = 17,
    FOOTPOINT_DETAIL_QQ_END = 25
};
typedef REAL footpoint_detail_bends[FOOTPOINT_DETAIL_QQ_END][3];

/* Middles and halves of the ranges of e . r_pp, e . r_pq and e . r_qq for a vector e. */
typedef struct {
    REAL middle[3], half[3];
} footpoint_detail_range;

/* Computes the whole net's. `line`, b, a and w: coefficients of p, b(p), a(p) and w(p) of footpoint_detail_net; slope
 * and twice, in the second degree, of the derivatives of a and -w. */
FOOTPOINT_PART void footpoint_detail_net_bends(const footpoint_detail_net *t,
                                               footpoint_detail_bends c)
{
    const REAL third = 1.0 / 3.0;
    const REAL line[4] = {-1.0, -third, third, 1.0}, b[4] = {-0.5, -0.5, 0.5, 0.5};
    const REAL a[4] = {0.0, -4.0 * third, 4.0 * third, 0.0};
    const REAL w[4] = {0.0, 4.0 * third, 4.0 * third, 0.0};
    const REAL slope[3] = {-2.0, 4.0, -2.0}, twice[3] = {-2.0, 0.0, 2.0};
    int i, j, k;
    for (k = 0; k < 3; k++) {
        for (i = 0; i < 2; i++) {
            const REAL end = i ? 1.0 : -1.0;
            const REAL x = 2.0 * t->x0[k] - 6.0 * end * t->x1[k];
            const REAL y = 2.0 * t->y0[k] - 6.0 * end * t->y1[k];
            const REAL X = 2.0 * t->X0[k] - 6.0 * end * t->X1[k];
            const REAL Y = 2.0 * t->Y0[k] - 6.0 * end * t->Y1[k];
            for (j = 0; j < 4; j++) {
                c[FOOTPOINT_DETAIL_PP + 4 * i + j][k] =
                    x + b[j] * X - 1.5 * end * (a[j] * t->Y1[k] - w[j] * t->Y0[k]);
                c[FOOTPOINT_DETAIL_QQ + 2 * j + i][k] =
                    y + b[j] * Y -
                    1.5 * end * (line[j] * t->m[k] + a[j] * t->X1[k] - w[j] * t->X0[k]);
            }
        }
        for (i = 0; i < 3; i++)
            for (j = 0; j < 3; j++)
                c[FOOTPOINT_DETAIL_PQ + 3 * i + j][k] =
                    (j == 1 ? 1.5 * (t->m[k] + slope[i] * t->X1[k] + twice[i] * t->X0[k]) : 0.0) +
                    (i == 1 ? 1.5 * (slope[j] * t->Y1[k] + twice[j] * t->Y0[k]) : 0.0);
    }
}

/* Converts coefficients c[0], c[step], ... of degree n over [0,1] to those over [from,to], by de Casteljau. */
FOOTPOINT_FN void footpoint_detail_cut(REAL (*c)[3], int n, int step, REAL from, REAL to)
{
    const REAL less = 1.0 - to, more = to > 0.0 ? from / to : 0.0;
    int r, k, i;
    for (r = 1; r <= n; r++)
        for (k = n; k >= r; k--)
            for (i = 0; i < 3; i++)
                c[k * step][i] += less * (c[(k - 1) * step][i] - c[k * step][i]);
    for (r = 1; r <= n; r++)
        for (k = 0; k <= n - r; k++)
            for (i = 0; i < 3; i++)
                c[k * step][i] += more * (c[(k + 1) * step][i] - c[k * step][i]);
}

/* Converts coefficients to those over the part from low to high, both from 0 to 1. */
FOOTPOINT_APART void footpoint_detail_bends_part(footpoint_detail_bends c, const REAL low[2],
                                                 const REAL high[2])
{
    const int begin[3] = {FOOTPOINT_DETAIL_PP, FOOTPOINT_DETAIL_PQ, FOOTPOINT_DETAIL_QQ};
    int g, k;
    for (g = 0; g < 3; g++) {
        const int along = 1 + g, across = 3 - g; /* degrees in p and q */
        for (k = 0; k <= across && (low[0] > 0.0 || high[0] < 1.0); k++)
            footpoint_detail_cut(c + begin[g] + k, along, across + 1, low[0], high[0]);
        for (k = 0; k <= along && (low[1] > 0.0 || high[1] < 1.0); k++)
            footpoint_detail_cut(c + begin[g] + k * (across + 1), across, 1, low[1], high[1]);
    }
}

/* Computes the means of the coefficients of r_pp, r_pq and r_qq. */
FOOTPOINT_PART void footpoint_detail_bends_mean(footpoint_detail_bends c, REAL mean[3][3])
{
    int k, i;
    for (i = 0; i < 3; i++) {
        REAL sum[3] = {0.0, 0.0, 0.0};
        for (k = 0; k < FOOTPOINT_DETAIL_PQ; k++)
            sum[0] += c[k][i];
        for (k = FOOTPOINT_DETAIL_PQ; k < FOOTPOINT_DETAIL_QQ; k++)
            sum[1] += c[k][i];
        for (k = FOOTPOINT_DETAIL_QQ; k < FOOTPOINT_DETAIL_QQ_END; k++)
            sum[2] += c[k][i];
        mean[0][i] = 0.125 * sum[0];
        mean[1][i] = sum[1] / 9.0;
        mean[2][i] = 0.125 * sum[2];
    }
}

FOOTPOINT_PART void footpoint_detail_bends_range(footpoint_detail_bends c, const REAL e[3],
                                                 footpoint_detail_range *r)
{
    const int begin[4] = {FOOTPOINT_DETAIL_PP, FOOTPOINT_DETAIL_PQ, FOOTPOINT_DETAIL_QQ,
                          FOOTPOINT_DETAIL_QQ_END};
    int g, k;
    for (g = 0; g < 3; g++) {
        REAL low = footpoint_detail_dot(e, c[begin[g]]), high = low;
        for (k = begin[g] + 1; k < begin[g + 1]; k++) {
            const REAL value = footpoint_detail_dot(e, c[k]);
            low = footpoint_detail_least(low, value);
            high = footpoint_detail_greater(high, value);
        }
        r->middle[g] = 0.5 * (low + high);
        r->half[g] = 0.5 * (high - low);
    }
}
