/* Slopes and changes of the squared distance over a part of a closed face. */

/* A matrix M(s,t) over a part of the face: the least determinant at its corners, minus rounding, and least and greatest
 * entries. */
typedef struct {
    REAL m11[CORNERS], m12[CORNERS], m22[CORNERS], det, low, wide, high;
} footpoint_detail_KIND_form;

/* Computes how fast half the squared distance grows from an edge into the face, `grows`, or may fall, `falls`; a slope
 * f is off by `off`. */
FOOTPOINT_PART void footpoint_detail_KIND_grows(REAL held, REAL f, REAL off, REAL *grows,
                                                REAL *falls)
{
    const REAL outward = fabs(held) > 0.0 ? held * f : -fabs(f);
    *grows = footpoint_detail_greater(outward - off, 0.0);
    *falls = footpoint_detail_greater(off - outward, 0.0);
}
