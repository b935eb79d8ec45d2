/* Tables of an input file's numbers and names.  Numbers: sorted once, then found by position where they run without
 * gaps, as most do, and by bisection elsewhere.  Names: open addressing over FNV-1a hashes. */
#include "inp.h"

#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

void inp_numbers_add(struct inp_numbers *t, int number, struct inp_place at)
{
    grow_array(&t->entry, t->n, &t->room, sizeof *t->entry);
    t->entry[t->n] = (struct inp_entry){number, at, t->n};
    t->n++;
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

/* Slot of a name without blanks: the one that holds it, or the free one where it belongs. */
static size_t slot_of(const struct inp_names *t, const char *text)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (const char *c = text; *c; c++)
        hash = (hash ^ (uint64_t)toupper((unsigned char)*c)) * 0x100000001b3u;
    size_t slot = (size_t)(hash % t->slots);
    while (t->slot[slot] >= 0 && strcasecmp(t->name[t->slot[slot]].text, text) != 0)
        slot = (slot + 1) % t->slots;
    return slot;
}

static void widen(struct inp_names *t)
{
    free(t->slot);
    t->slots = t->slots ? 2 * t->slots : 64;
    t->slot = new_array(t->slots, sizeof *t->slot);
    for (size_t i = 0; i < t->slots; i++)
        t->slot[i] = -1;
    for (size_t i = 0; i < t->n; i++)
        t->slot[slot_of(t, t->name[i].text)] = (int)i;
}

int inp_names_index(struct inp_names *t, struct inp_text name)
{
    char *text = new_array(name.n + 1, 1);
    size_t n = 0;
    for (size_t i = 0; i < name.n; i++)
        if (!isspace((unsigned char)name.s[i]))
            text[n++] = name.s[i];
    if (2 * t->n >= t->slots)
        widen(t);
    const size_t slot = slot_of(t, text);
    if (t->slot[slot] >= 0) {
        free(text);
        return t->slot[slot];
    }
    grow_array(&t->name, t->n, &t->room, sizeof *t->name);
    t->name[t->n] = (struct inp_name){text, {-1, -1}, {-1, -1}};
    t->slot[slot] = (int)t->n;
    return (int)t->n++;
}

void inp_names_clear(struct inp_names *t)
{
    for (size_t i = 0; i < t->n; i++)
        free(t->name[i].text);
    free(t->name);
    free(t->slot);
}
