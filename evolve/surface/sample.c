/* Growing sets of samples; see sample.h. */
#include "sample.h"

#include "../../codegen/base/base.h"

#include <stdlib.h>

void sample_set_add(struct sample_set *set, const struct sample *s)
{
    APPEND(set->s, set->n, set->room) = *s;
}

void sample_set_free(struct sample_set *set)
{
    free(set->s);
    *set = (struct sample_set){0};
}

const struct heldout_part heldout_part[HELDOUT_PARTS] = {
    {PART_HELDOUT, "heldout"}, {PART_HELDOUT_RANDOM, "heldout_random"}, {PART_HELDOUT_EVEN, "heldout_even"}};

void heldout_free(struct heldout *h)
{
    for (int part = 0; part < HELDOUT_PARTS; part++)
        sample_set_free(&h->part[part]);
    h->lines = 0;
}
