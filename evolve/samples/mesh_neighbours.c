/* Neighbours of a face; see mesh_neighbours.h. Elements are listed by node. Each node stores the last face whose
 * neighbour it was. */
#include "mesh_neighbours.h"

#include <stdlib.h>

struct neighbours {
    const struct mesh *mesh; /* not owned */
    size_t *first;           /* owned; nodes + 1: index in `element` of the node's first element */
    size_t *element;         /* owned; indices into mesh->element */
    size_t *last;            /* owned, indexed by node: number of the last face whose neighbour it was, from 1, or 0 */
    size_t face;             /* number of the current face */
};

struct neighbours *neighbours_new(const struct mesh *mesh)
{
    struct neighbours *n = new_array(1, sizeof *n);
    *n = (struct neighbours){.mesh = mesh,
                             .first = new_array(mesh->nodes + 1, sizeof *n->first),
                             .last = new_array(mesh->nodes, sizeof *n->last)};
    for (size_t e = 0; e < mesh->elements; e++)
        for (int i = 0; i < mesh->element[e].nodes; i++)
            n->first[mesh->element[e].node[i]]++;
    for (size_t node = 0; node < mesh->nodes; node++)
        n->first[node + 1] += n->first[node];
    n->element = new_array(n->first[mesh->nodes], sizeof *n->element);
    for (size_t e = mesh->elements; e-- > 0;) /* turns ends into beginnings */
        for (int i = 0; i < mesh->element[e].nodes; i++)
            n->element[--n->first[mesh->element[e].node[i]]] = e;
    return n;
}

void neighbours_free(struct neighbours *n)
{
    if (!n)
        return;
    free(n->first);
    free(n->element);
    free(n->last);
    free(n);
}

void neighbours_of(struct neighbours *n, const struct mesh_face *face)
{
    n->face++;
    for (int i = 0; i < face->nodes; i++)
        for (size_t k = n->first[face->node[i]]; k < n->first[face->node[i] + 1]; k++) {
            const struct mesh_element *e = &n->mesh->element[n->element[k]];
            for (int j = 0; j < e->nodes; j++)
                n->last[e->node[j]] = n->face;
        }
}

bool neighbours_has(const struct neighbours *n, int node)
{
    return n->last[node] == n->face;
}
