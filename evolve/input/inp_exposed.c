/* Exposed faces of solids, which form a surface without face labels: faces whose corners no other face has. Sorting
 * faces by their corners brings equal faces together. */
#include "inp.h"

#include <stdlib.h>
#include <string.h>

struct corners {
    int node[4]; /* positions, ascending; for triangles, -1 first */
    int face;
    size_t element;
};

static int by_corners(const void *a, const void *b)
{
    const struct corners *p = a, *q = b;
    for (int i = 0; i < 4; i++)
        if (p->node[i] != q->node[i])
            return p->node[i] < q->node[i] ? -1 : 1;
    return 0;
}

static struct corners corners_of(const struct inp_model *m, size_t element, int face)
{
    const struct inp_element *e = &m->element[m->elements.entry[element].order];
    struct corners c = {{-1, -1, -1, -1}, face, element};
    for (int i = 0; i < e->type->shape->face[face].corners; i++) {
        const int node = m->connectivity[e->first + e->type->shape->face[face].node[i] - 1];
        int k = 3 - i;
        for (; k < 3 && c.node[k + 1] < node; k++)
            c.node[k] = c.node[k + 1];
        c.node[k] = node;
    }
    return c;
}

void inp_find_exposed(struct inp_model *m)
{
    struct corners *all = NULL;
    size_t n = 0, room = 0;
    for (size_t at = 0; at < m->elements.n; at++) {
        const struct inp_type *type = m->element[m->elements.entry[at].order].type;
        for (int face = 0; type->shape && !type->shell && face < type->shape->faces; face++)
            APPEND(all, n, room) = corners_of(m, at, face);
    }
    if (n > 0)
        qsort(all, n, sizeof *all, by_corners);
    m->exposed = new_array(m->elements.n, 1);
    for (size_t i = 0; i < n; i++)
        if ((i == 0 || by_corners(&all[i], &all[i - 1]) != 0) && (i + 1 == n || by_corners(&all[i], &all[i + 1]) != 0))
            m->exposed[all[i].element] = (unsigned char)(m->exposed[all[i].element] | (1 << all[i].face));
    free(all);
}
