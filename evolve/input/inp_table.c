/* Tables of an input file's numbers and names. Numbers are sorted once. They are found by position where they run
 * without gaps, as most do, otherwise by bisection. Names are stored in capitals in a search tree. */
#include "inp.h"

#include "../../codegen/genome/names.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

void inp_numbers_add(struct inp_numbers *t, int64_t key, struct inp_place at)
{
    const size_t order = t->n;
    APPEND(t->entry, t->n, t->room) = (struct inp_entry){key, at, order};
}

static int by_key(const void *a, const void *b)
{
    const struct inp_entry *p = a, *q = b;
    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    return (p->order > q->order) - (p->order < q->order);
}

const struct inp_entry *inp_numbers_sort(struct inp_numbers *t)
{
    const struct inp_entry *repeated = NULL;
    if (t->n > 0)
        qsort(t->entry, t->n, sizeof *t->entry, by_key);
    for (size_t i = 1; i < t->n; i++)
        if (t->entry[i].key == t->entry[i - 1].key && (!repeated || t->entry[i].order < repeated->order))
            repeated = &t->entry[i];
    return repeated;
}

size_t inp_numbers_find(const struct inp_numbers *t, int64_t key)
{
    size_t first = 0, last = t->n;
    if (t->n == 0 || key <= t->entry[0].key)
        return 0;
    const size_t guess = (size_t)(key - t->entry[0].key);
    if (guess < t->n && t->entry[guess].key == key)
        return guess;
    while (first < last) {
        const size_t middle = first + (last - first) / 2;
        if (t->entry[middle].key < key)
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

int inp_names_index(struct inp_names *t, const char *instance, struct inp_text name)
{
    const size_t before = instance ? strlen(instance) + 1 : 0, room = before + name.n + 1;
    char *text = new_array(room, 2), *key = text + room;
    size_t n = 0;
    if (instance)
        snprintf(text, room, "%s.", instance);
    for (; n < before; n++)
        key[n] = (char)toupper((unsigned char)text[n]);
    for (size_t i = 0; i < name.n; i++)
        if (!isspace((unsigned char)name.s[i])) {
            text[n] = name.s[i];
            key[n++] = (char)toupper((unsigned char)name.s[i]);
        }
    const struct name *known = names_find(&t->tree, key);
    if (known) {
        free(text);
        return known->gene;
    }
    names_add(&t->tree, key, NAME_NUMBER, (int)t->n, NO_STATEMENT);
    APPEND(t->name, t->n, t->room) = (struct inp_name){text, {-1, -1}, {-1, -1}};
    return (int)t->n - 1;
}

void inp_names_clear(struct inp_names *t)
{
    for (size_t i = 0; i < t->n; i++)
        free(t->name[i].text);
    free(t->name);
    names_free(t->tree);
}
