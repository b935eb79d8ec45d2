/* Resolves names of sets to nodes and elements: sets within sets, numbers and ranges. An explicit stack visits each set
 * once, so that deep nesting and sets that contain themselves are harmless. */
#include "inp.h"

#include <stdlib.h>
#include <string.h>

static const char *const what_name[] = {"node", "element"};

/* A search for the members of sets: positions in a sorted table, made unique by `mark`. */
struct set_walk {
    struct inp_model *m;
    enum inp_what what;
    const struct inp_numbers *table; /* not owned */
    unsigned char *mark;             /* not owned; by position */
    struct inp_list *found;          /* not owned */
    struct inp_list pending, lent;   /* owned; sets to visit, and element sets that contribute their nodes */
    size_t visit, missing;           /* members of sets that are not defined */
    int64_t first_missing;
};

static void append(struct inp_list *list, size_t value)
{
    APPEND(list->index, list->n, list->room) = value;
}

struct inp_shown inp_name_shown(const struct inp_model *m, int name)
{
    const char *text = m->names.name[name].text;
    return inp_show((struct inp_text){text, strlen(text)});
}

static void add(struct set_walk *s, size_t at)
{
    if (!s->mark[at])
        append(s->found, at);
    s->mark[at] = 1;
}

/* Finds numbers. On a surface's own lines they must be defined; of a range, at least one must be. */
static bool find_numbers(struct set_walk *s, const struct inp_item *item, bool of_set)
{
    const struct inp_numbers *t = s->table;
    bool any = false;
    for (size_t i = inp_numbers_find(t, item->first); i < t->n && t->entry[i].key <= item->last; i++) {
        if ((t->entry[i].key - item->first) % item->step != 0)
            continue;
        any = true;
        add(s, i);
    }
    if (any)
        return true;
    if (!of_set)
        return inp_fail(&s->m->lines, item->at, "%s %d is not defined", what_name[s->what], inp_number_of(item->first));
    if (s->missing++ == 0)
        s->first_missing = item->first;
    return true;
}

static bool find_item(struct set_walk *s, const struct inp_item *item, bool of_set)
{
    struct inp_model *m = s->m;
    if (item->refused)
        return inp_fail(&m->lines, item->at, "%s", item->refused);
    if (item->lent) {
        append(&s->lent, (size_t)item->name);
        return true;
    }
    if (item->name < 0)
        return find_numbers(s, item, of_set);
    const int set = m->names.name[item->name].set[s->what];
    if (set < 0)
        return inp_fail(&m->lines, item->at, "%s set '%s' is not defined", what_name[s->what],
                        inp_name_shown(m, item->name).s);
    if (m->set[set].visit == s->visit)
        return true;
    m->set[set].visit = s->visit;
    append(&s->pending, (size_t)set);
    return true;
}

static bool walk(struct set_walk *s, const struct inp_item *line)
{
    if (!find_item(s, line, false))
        return false;
    while (s->pending.n > 0) {
        const struct inp_items *items = &s->m->set[s->pending.index[--s->pending.n]].items;
        for (size_t i = 0; i < items->n; i++)
            if (!find_item(s, &items->item[i], true))
                return false;
    }
    if (s->missing > 0)
        inp_note(&s->m->lines, line->at, "skipped %zu set entr%s without a defined %s; the first is %d", s->missing,
                 s->missing > 1 ? "ies" : "y", what_name[s->what], inp_number_of(s->first_missing));
    return true;
}

/* Adds the nodes of the elements of sets. */
static bool add_lent(struct set_walk *s, struct inp_place at)
{
    struct inp_model *m = s->m;
    struct inp_list elements = {0};
    unsigned char *mark = new_array(m->elements.n, 1);
    bool done = true;
    for (size_t i = 0; i < s->lent.n && done; i++) {
        const struct inp_item item = {.name = (int)s->lent.index[i], .at = at};
        done = inp_members(m, INP_ELEMENT, &item, &elements, mark);
    }
    for (size_t i = 0; i < elements.n && done; i++) {
        const struct inp_element *e = &m->element[m->elements.entry[elements.index[i]].order];
        for (int k = 0; k < e->nodes; k++)
            add(s, (size_t)m->connectivity[e->first + (size_t)k]);
    }
    free(mark);
    free(elements.index);
    return done;
}

bool inp_members(struct inp_model *m, enum inp_what what, const struct inp_item *line, struct inp_list *list,
                 unsigned char *mark)
{
    struct set_walk s = {.m = m, .what = what, .mark = mark, .found = list, .visit = ++m->visits};
    s.table = what == INP_NODE ? &m->nodes : &m->elements;
    const bool done = walk(&s, line) && (s.lent.n == 0 || add_lent(&s, line->at));
    free(s.pending.index);
    free(s.lent.index);
    return done;
}
