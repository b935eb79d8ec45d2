/* The search in float, by the search in double. */

FOOTPOINT_FN int ROUNDED(FLOAT_PARAMETERS, float loc[2], float *gap)
{
    const float *const from[VECTORS] = {NODE_NAMES};
    double x[VECTORS][3], answer[3];
    int status, i, k;
    for (k = 0; k < VECTORS; k++)
        for (i = 0; i < 3; i++)
            x[k][i] = (double)from[k][i];
    status = IN_DOUBLE(VECTOR_ROWS, answer, answer + 2);
    if (status < FOOTPOINT_OK)
        return status;
    for (i = 0; i < 3; i++)
        if (!(answer[i] >= -FLOAT_MAX && answer[i] <= FLOAT_MAX))
            return FOOTPOINT_ERR_DOMAIN;
    loc[0] = (float)answer[0];
    loc[1] = (float)answer[1];
    *gap = (float)answer[2];
    return status;
}
