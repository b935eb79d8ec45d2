/* Selects the members of a front that may become tiers; see archive.h. */
#include "archive.h"

#include <math.h>

static const double spare = 1.06; /* factor on the budget: costs are estimates, times decide */

/* Keeps, from the cheapest on, members that are better on the judge's samples than all cheaper members. */
static size_t judged_front(const struct archive *a, struct objective *judge, const struct quest *q,
                           const struct member **found)
{
    const struct front *f = q->front;
    const double budget = q->own->budget;
    double least = INFINITY;
    size_t n = 0;
    for (size_t c = 0; c <= f->limit; c++) {
        const struct member *m = &f->member[c];
        if (m->genes.length == 0 || (budget > 0 && m->cost > spare * budget))
            continue;
        const double error = archive_error(a, judge, q, &m->genes);
        if (error < least) {
            least = error;
            found[n++] = m;
        }
    }
    return n;
}

size_t archive_members(const struct archive *a, struct objective *judge, const struct quest *q, size_t most,
                       const struct member **found)
{
    const size_t n = judged_front(a, judge, q, found), first = n > most ? n - most : 0;
    for (size_t i = first; i < n; i++)
        found[i - first] = found[i];
    return n - first;
}
