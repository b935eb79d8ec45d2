/* Corrections of answers side by side, in single precision, with the proof. */

/* Returns the greater of two numbers >= 0, or NaN. It compares bits, because vector instructions for maxima raise
 * exceptions of NaN. */
FOOTPOINT_PART REAL footpoint_detail_KIND_side_greater(REAL a, REAL b)
{
    union {
        REAL_BITS bits;
        REAL number;
    } most;
    const REAL_BITS x = footpoint_detail_bits(a), y = footpoint_detail_bits(b);
    most.bits = x > y ? x : y;
    return most.number;
}

/* Returns a coordinate, or 31 with its sign, too far for a proof, if it is larger: steps that run away do not overflow.
 * Compares bits, so that NaN raises nothing. */
FOOTPOINT_PART REAL footpoint_detail_KIND_side_kept(REAL p)
{
    union {
        REAL_BITS bits;
        REAL number;
    } at;
    REAL_BITS size;
    at.number = p;
    size = at.bits & 0x7fffffffu;
    at.bits ^= size;
    at.bits |= size < 0x41f80000u ? size : 0x41f80000u;
    return at.number;
}

/* Moves the answer by A (f,g).  See footpoint_detail_KIND_side_bound. */
FOOTPOINT_PART void footpoint_detail_KIND_side_correct(BLOCK *FOOTPOINT_RESTRICT t, int l, REAL f,
                                                       REAL g, REAL promise)
{
    const REAL s1 = t->a11[l] * f, s2 = t->a12[l] * g, t1 = t->a12[l] * f, t2 = t->a22[l] * g;
    const REAL sum = footpoint_detail_KIND_side_greater(fabs(s1) + fabs(s2), fabs(t1) + fabs(t2));
    const REAL off = 5.0 * REAL_UNIT * sum + t->off[l];
    const REAL step = footpoint_detail_KIND_side_greater(fabs(s1 + s2), fabs(t1 + t2)) + off;
    const REAL h = t->most[l] + t->turn[l] * step;
    const REAL room = 0.999 * promise - 4e-15 - (1.3 * h * step + 1.01 * off);
    t->xi[l] += (double)(s1 + s2);
    t->eta[l] += (double)(t1 + t2);
    t->most[l] = h;
    t->doubt[l] |= footpoint_detail_bits(0.08 - step) | footpoint_detail_bits(0.199 - h) |
                   footpoint_detail_bits(t->flat[l] - t->bend[l] * step);
    t->wide[l] = footpoint_detail_bits(room) | footpoint_detail_infinite(room);
}

FOOTPOINT_PART void footpoint_detail_KIND_side_corrections_of(BLOCK *FOOTPOINT_RESTRICT t,
                                                              REAL promise, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++)
        footpoint_detail_KIND_side_correct(t, l, (REAL)t->f[l], (REAL)t->g[l], promise);
}

FOOTPOINT_APART void footpoint_detail_KIND_side_corrections(BLOCK *FOOTPOINT_RESTRICT t,
                                                            REAL promise)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_corrections_of(t, promise, 8);
    else
        footpoint_detail_KIND_side_corrections_of(t, promise, SIDE);
}
