// ArborX: a callback for BVH queries of slave nodes among boxes of four-node faces. It keeps the nearest face of each
// slave node, also on a device: one thread has all candidates of a query. The number of a slave node is attached to its
// predicate, the number of a face is its place in the tree. A face has an answer for slave nodes no farther away than
// its longest edge; other faces are skipped. Unproved answers count, too, with the nearest point found: see `unproved`.
#ifndef FOOTPOINT_REPLACE_ARBORX
#define FOOTPOINT_REPLACE_ARBORX

#include "footpoint_quad4.h"

#ifndef KOKKOS_FUNCTION
#define KOKKOS_FUNCTION
#endif

struct footpoint_nearest_face {
    const double (*nodes)[3]; // coordinates; mesh length
    const int (*faces)[4];    // corners A, B, C, D
    const int *slaves;        // nodes
    // Indexed by slave node; distance must be set to a search radius before.
    double *distance; // to the nearest face so far; mesh length, >= 0
    int *face;        // its number; untouched if no face with an answer is that near
    double (*loc)[2]; // xi, eta, in [-1,1]
    int *unproved;    // set to 1 if a face without proof may be the nearest; otherwise untouched; or null

    template <class Query> KOKKOS_FUNCTION void operator()(const Query &query, int j) const
    {
        const int i = getData(query);
        const int *const f = faces[j];
        double at[2], away = 0.;
        int region = 0;
        const int status = footpoint_quad4_accurate_closest(nodes[f[0]], nodes[f[1]], nodes[f[2]], nodes[f[3]],
                                                            nodes[slaves[i]], at, &away, &region);
        if (status < FOOTPOINT_OK)
            return;
        if (status == FOOTPOINT_UNPROVED && unproved)
            unproved[i] = 1;
        if (!(fabs(away) < distance[i]))
            return;
        distance[i] = fabs(away);
        face[i] = j;
        loc[i][0] = at[0];
        loc[i][1] = at[1];
    }
};

#endif
