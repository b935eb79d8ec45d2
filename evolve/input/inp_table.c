/* Tables of an input file's numbers and names.  Numbers: sorted once, then found by position where they run without
 * gaps, as most do, and by bisection elsewhere.  Names: in capitals, in a search tree. */
#include "inp.h"

#include "../../codegen/genome/names.h"

#include <ctype.h>
#include <stdlib.h>

void inp_numbers_add(struct inp_numbers *t, int number, struct inp_place at)
{
    const size_t order = t->n;
    APPEND(t->entry, t->n, t->room) = (struct inp_entry){number, at, order};
}

static int by_number(const void *a, const void *b)
{
    const struct inp_entry *p = a, *q = b;
    if (p->number != q->number)
        return p->number < q->number ? -1 : 1;
    return (p->order > q->order) - (p->order < q->order);
}

const struct inp_entry *inp_numbers_sort(struct inp_numbers *t)
{
    const struct inp_entry *repeated = NULL;
    if (t->n > 0)
        qsort(t->entry, t->n, sizeof *t->entry, by_number);
    for (size_t i = 1; i < t->n; i++)
        if (t->entry[i].number == t->entry[i - 1].number && (!repeated || t->entry[i].order < repeated->order))
            repeated = &t->entry[i];
    return repeated;
}

size_t inp_numbers_find(const struct inp_numbers *t, int number)
{
    size_t first = 0, last = t->n;
    if (t->n == 0 || number <= t->entry[0].number)
        return 0;
    const size_t guess = (size_t)number - (size_t)t->entry[0].number;
    if (guess < t->n && t->entry[guess].number == number)
        return guess;
    while (first < last) {
        const size_t middle = first + (last - first) / 2;
        if (t->entry[middle].number < number)
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

int inp_names_index(struct inp_names *t, struct inp_text name)
{
    char *text = new_array(name.n + 1, 2), *key = text + name.n + 1;
    size_t n = 0;
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
