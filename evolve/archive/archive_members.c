/* Selects the members of a front that may become tiers; see archive.h. */
#include "archive.h"

#include <math.h>
#include <string.h>

static const double spare = 1.06; /* factor on the budget: costs are estimates, times decide */

size_t archive_members(const struct archive *a, struct objective *judge, const struct quest *q, size_t most,
                       const struct member **found)
{
    const double budget = q->own->budget;
    double least = INFINITY;
    size_t n = 0;
    for (const struct member *m = q->front->member; m <= q->front->member + q->front->limit; m++) {
        if (m->genes.length == 0 || (budget > 0 && m->cost > spare * budget))
            continue;
        const double error = archive_error(a, judge, q, &m->genes);
        if (error < least) {
            least = error;
            found[n++] = m;
        }
    }
    const size_t first = n > most ? n - most : 0;
    memmove(found, found + first, (n - first) * sizeof(*found));
    return n - first;
}
