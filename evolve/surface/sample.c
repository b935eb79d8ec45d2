/* Growing sets of samples; see sample.h. */
#include "sample.h"

#include "../../codegen/genome/base.h"

#include <stdlib.h>

void sample_set_add(struct sample_set *set, const struct sample *s)
{
    grow_array(&set->s, set->n, &set->room, sizeof *set->s);
    set->s[set->n++] = *s;
}

void sample_set_free(struct sample_set *set)
{
    free(set->s);
    *set = (struct sample_set){0};
}
