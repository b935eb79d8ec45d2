/* Tables of samples; see columns.h. Each column is 17 lines longer than whole blocks require. If columns were a power
 * of two apart, their blocks would share a few sets of the first-level cache and evict each other. */
#include "columns.h"

#include <stdint.h>
#include <stdlib.h>

enum { LINE = 64, STAGGER = 17 * LINE };

struct columns columns_new(size_t n, size_t count)
{
    const size_t blocks = (n + SUM_BLOCK - 1) / SUM_BLOCK;
    struct columns c = {.n = n, .count = count, .room = blocks * SUM_BLOCK + STAGGER / sizeof *c.data};
    c.memory = new_array(c.room * count + LINE / sizeof *c.data, sizeof *c.data);
    c.data = c.memory + (LINE - (uintptr_t)c.memory % LINE) % LINE / sizeof *c.data;
    return c;
}

void columns_free(struct columns *c)
{
    free(c->memory);
    free(c->band);
    *c = (struct columns){0};
}

double *columns_at(const struct columns *c, size_t column)
{
    return c->data + column * c->room;
}

struct columns columns_thin(const struct columns *all, size_t stride)
{
    struct columns c = columns_new((all->n + stride - 1) / stride, all->count);
    for (size_t j = 0; j < c.count; j++)
        for (size_t i = 0; i < c.n; i++)
            columns_at(&c, j)[i] = columns_at(all, j)[i * stride];
    return c;
}
