/* A front with a bounded number of members, each for a cost rounded to an integer; see front.h. */
#include "front.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct front *front_new(size_t limit, size_t max_length)
{
    struct front *f = new_array(1, sizeof *f);
    *f = (struct front){.limit = limit, .max_length = max_length};
    f->member = new_array(limit + 1, sizeof *f->member);
    f->lowest = new_array(limit + 1, sizeof *f->lowest);
    f->pool = new_array((limit + 1) * max_length, sizeof *f->pool);
    for (size_t c = 0; c <= limit; c++)
        f->member[c].genes.gene = f->pool + c * max_length;
    front_clear(f);
    return f;
}

void front_free(struct front *f)
{
    if (!f)
        return;
    free(f->member);
    free(f->lowest);
    free(f->pool);
    free(f);
}

void front_clear(struct front *f)
{
    for (size_t c = 0; c <= f->limit; c++) {
        f->member[c].genes.length = 0;
        f->lowest[c] = INFINITY;
    }
}

void front_copy(const struct front *from, struct front *to)
{
    for (size_t c = 0; c <= to->limit; c++) {
        int *gene = to->member[c].genes.gene;
        to->member[c] = from->member[c];
        to->member[c].genes.gene = gene;
        genes_copy(&from->member[c].genes, &to->member[c].genes);
        to->lowest[c] = from->lowest[c];
    }
}

size_t front_place(const struct front *f, double cost)
{
    return cost < (double)f->limit + 0.5 ? (size_t)(cost + 0.5) : f->limit + 1;
}

double front_error(const struct front *f, double cost)
{
    const size_t place = front_place(f, cost);
    return f->lowest[place <= f->limit ? place : f->limit];
}

struct member *front_offer(struct front *f, const struct genes *t, double error, double cost)
{
    const size_t place = front_place(f, cost);
    if (place > f->limit || !(error < f->lowest[place]))
        return NULL;
    struct member *m = &f->member[place];
    *m = (struct member){.genes = m->genes, .error = error, .cost = cost};
    genes_copy(t, &m->genes);
    for (size_t c = place; c <= f->limit && f->lowest[c] >= error; c++) {
        f->lowest[c] = error;
        if (c > place)
            f->member[c].genes.length = 0;
    }
    return m;
}

size_t front_count(const struct front *f)
{
    size_t n = 0;
    for (size_t c = 0; c <= f->limit; c++)
        n += f->member[c].genes.length > 0;
    return n;
}

struct member *front_member(const struct front *f, size_t k)
{
    for (size_t c = 0; c <= f->limit; c++)
        if (f->member[c].genes.length > 0 && k-- == 0)
            return &f->member[c];
    return NULL;
}
