/* runtime/replace/sfepy.c: two opposite faces, each with a Gauss point, apart and penetrating. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>

void evaluateContactConstraints(double *GPs, int32_t *ISN, int32_t *IEN, int32_t *N, double *AABBmin, double *AABBmax,
                                int32_t *head, int32_t *next, double *X, uint32_t *elementID, uint32_t *segmentID,
                                int n, int nsn, int nsd, int npd, int ngp, int nen, int nes, int neq,
                                double longestEdge);

static int failed;

static void near(const char *what, double is, double should_be)
{
    if (!(fabs(is - should_be) <= 1e-12)) {
        printf("%s: %a, not %a\n", what, is, should_be);
        failed = 1;
    }
}

/* Makes faces of 1 x 1 at heights 0 and `height`; the upper face's nodes run the other way. */
static void two_faces(double height)
{
    double X[3][8] = {{0, 1, 1, 0, 0, 0, 1, 1}, {0, 0, 1, 1, 0, 1, 1, 0}};
    double GPs[12][2] = {{0.75, 0.25}, {0.5, 0.375}, {height, 0}, {1, 0}};
    int32_t sides[4] = {0, 1, 2, 3}, nodes[8] = {0, 1, 2, 3, 4, 5, 6, 7}, cells[3] = {1, 1, 1}, head = 0,
            next[2] = {1, -1};
    double low[3] = {-1, -1, -1}, high[3] = {2, 2, 2};
    uint32_t elements[2] = {0, 1}, segments[2] = {0, 0};
    for (int i = 4; i < 8; i++)
        X[2][i] = height;
    evaluateContactConstraints(GPs[0], sides, nodes, cells, low, high, &head, next, X[0], elements, segments, 2, 4, 3,
                               2, 1, 4, 1, 24, 1.);
    for (int v = 0; v < 2; v++) {
        const int contact = height < 0;
        near("gap", GPs[5][v], height);
        near("whether it is in contact", GPs[9][v], contact);
        near("the element that it meets", GPs[10][v], contact ? 1 - GPs[3][v] : 0);
        near("r", GPs[6][v], contact ? (v ? -0.25 : 0.5) : 0);
        near("s", GPs[7][v], contact ? (v ? -0.5 : 0) : 0);
    }
}

int main(void)
{
    two_faces(0.125);
    two_faces(-0.125);
    return failed;
}
