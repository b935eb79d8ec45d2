/* Search trees of names; see names.h. */
#define _GNU_SOURCE /* tdestroy */
#include "names.h"

#include "../base/base.h"

#include <search.h>
#include <stdlib.h>
#include <string.h>

/* Compares texts, so that a search needs no copy. */
static int compare(const void *a, const void *b)
{
    return strcmp(a, b);
}

const struct name *names_find(void *const *tree, const char *text)
{
    const char *const *found = tfind(text, tree, compare);
    return found ? (const struct name *)(*found - offsetof(struct name, text)) : NULL;
}

void names_add(void **tree, const char *text, enum name_kind kind, int gene, size_t statement)
{
    const size_t length = strlen(text) + 1;
    struct name *n = new_array(sizeof *n + length, 1);
    *n = (struct name){.kind = kind, .gene = gene, .statement = statement};
    memcpy(n->text, text, length);
    if (!tsearch(n->text, tree, compare))
        abort();
}

static void free_name(void *text)
{
    free((char *)text - offsetof(struct name, text));
}

void names_free(void *tree)
{
    tdestroy(tree, free_name);
}
