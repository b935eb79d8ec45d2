/* Counts how often each node of a graph is used; see dag.h. */
#include "dag.h"

int *dag_uses(const struct dag *g)
{
    int *uses = new_array(g->nodes, sizeof *uses);
    for (size_t i = 0; i < g->outputs; i++)
        uses[g->output[i].node]++;
    for (size_t n = g->nodes; n-- > 0;)
        if (uses[n])
            for (size_t i = 0; i < g->node[n].edges; i++)
                uses[g->node[n].edge[i].node]++;
    return uses;
}
