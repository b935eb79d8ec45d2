/* From names to nodes and faces: sets within sets, numbers and ranges within sets, surfaces made of them.  Sets are
 * walked with a stack of their own and each once, so that deep nesting and sets that contain themselves are harmless.
 */
#include "inp.h"

#include <stdlib.h>
#include <string.h>

static const char *const what_name[] = {"node", "element"};

/* Search for the members of sets: positions in a sorted table, each once thanks to `mark`. */
struct set_walk {
    struct inp_model *m;
    enum inp_what what;
    const struct inp_numbers *table; /* not owned */
    unsigned char *mark;             /* owned; by position */
    struct inp_list found;           /* found.index owned */
    struct inp_list pending;         /* owned; sets to be walked */
};

static void append(struct inp_list *list, size_t value)
{
    APPEND(list->index, list->n, list->room) = value;
}

static struct set_walk walk_new(struct inp_model *m, enum inp_what what)
{
    struct set_walk s = {.m = m, .what = what, .table = what == INP_NODE ? &m->nodes : &m->elements};
    s.mark = new_array(s.table->n, 1);
    return s;
}

static void walk_clear(struct set_walk *s)
{
    free(s->mark);
    free(s->found.index);
    free(s->pending.index);
}

/* Numbers that are listed must be defined; of a range, at least one. */
static bool find_numbers(struct set_walk *s, const struct inp_item *item)
{
    const struct inp_numbers *t = s->table;
    bool any = false;
    for (size_t i = inp_numbers_find(t, item->first); i < t->n && t->entry[i].number <= item->last; i++) {
        if ((t->entry[i].number - item->first) % item->step != 0)
            continue;
        any = true;
        if (!s->mark[i])
            append(&s->found, i);
        s->mark[i] = 1;
    }
    if (any)
        return true;
    if (item->first == item->last)
        return inp_fail(&s->m->lines, item->at, "%s %d is not defined", what_name[s->what], item->first);
    return inp_fail(&s->m->lines, item->at, "no %s from %d to %d is defined", what_name[s->what], item->first,
                    item->last);
}

static bool find_item(struct set_walk *s, const struct inp_item *item)
{
    struct inp_model *m = s->m;
    if (item->refused)
        return inp_fail(&m->lines, item->at, "%s", item->refused);
    if (item->name < 0)
        return find_numbers(s, item);
    const struct inp_name *name = &m->names.name[item->name];
    const int set = name->set[s->what];
    if (set < 0)
        return inp_fail(&m->lines, item->at, "%s set '%s' is not defined", what_name[s->what],
                        inp_show((struct inp_text){name->text, strlen(name->text)}).s);
    if (m->set[set].visit == m->visits)
        return true;
    m->set[set].visit = m->visits;
    append(&s->pending, (size_t)set);
    return true;
}

/* Add what a line of a surface names. */
static bool find(struct set_walk *s, const struct inp_item *line)
{
    struct inp_model *m = s->m;
    m->visits++;
    if (!find_item(s, line))
        return false;
    while (s->pending.n > 0) {
        const struct inp_items *items = &m->set[s->pending.index[--s->pending.n]].items;
        for (size_t i = 0; i < items->n; i++)
            if (!find_item(s, &items->item[i]))
                return false;
    }
    return true;
}

static int ascending(const void *a, const void *b)
{
    const size_t p = *(const size_t *)a, q = *(const size_t *)b;
    return (p > q) - (p < q);
}

static struct inp_shown name_of(const struct inp_model *m, int name)
{
    const char *text = m->names.name[name].text;
    return inp_show((struct inp_text){text, strlen(text)});
}

/* The surface of this name, of what is preferred if there are both. */
static const struct inp_surface *surface_of(const struct inp_model *m, int name, enum inp_what preferred,
                                            struct inp_place at)
{
    const int *s = m->names.name[name].surface;
    if (s[preferred] >= 0)
        return &m->surface[s[preferred]];
    if (s[!preferred] >= 0)
        return &m->surface[s[!preferred]];
    inp_fail(&m->lines, at, "surface '%s' is not defined", name_of(m, name).s);
    return NULL;
}

/* Sort what was found; a surface without anything is an error. */
static bool finish(const struct inp_model *m, int name, const struct inp_surface *s, struct inp_list *list)
{
    if (list->n == 0)
        return inp_fail(&m->lines, s->at, "surface '%s' is empty", name_of(m, name).s);
    qsort(list->index, list->n, sizeof *list->index, ascending);
    return true;
}

static void add_node(struct set_walk *nodes, size_t at)
{
    if (!nodes->mark[at])
        append(&nodes->found, at);
    nodes->mark[at] = 1;
}

/* An element whose faces are not known: all its nodes, if nodes are asked for. */
static bool add_whole(const struct inp_model *m, const struct inp_entry *entry, const struct inp_item *line,
                      struct set_walk *nodes)
{
    const struct inp_element *e = &m->element[entry->order];
    for (int k = 0; nodes && k < e->nodes; k++)
        add_node(nodes, (size_t)m->connectivity[e->first + (size_t)k]);
    if (nodes)
        return true;
    char known[300];
    inp_type_list(known, sizeof known);
    return inp_fail(&m->lines, line->at,
                    "element %d of a master surface is of type %s; faces are known of %s, and their variants",
                    entry->number, e->type->name, known);
}

/* Faces with one line's label of the elements found; taken: one bit for each face of each element.  `nodes`, or NULL,
 * takes those of elements whose faces are not known. */
static bool add_faces(const struct set_walk *e, const struct inp_item *line, unsigned char *taken,
                      struct set_walk *nodes, struct inp_list *faces)
{
    for (size_t i = 0; i < e->found.n; i++) {
        const size_t at = e->found.index[i];
        const struct inp_entry *entry = &e->m->elements.entry[at];
        const struct inp_type *type = e->m->element[entry->order].type;
        if (!type->shape) {
            if (!add_whole(e->m, entry, line, nodes))
                return false;
            continue;
        }
        const int face = inp_face_index(type, line->face);
        if (face < 0 && line->face == INP_FACE_NONE)
            return inp_fail(&e->m->lines, line->at, "element %d of type %s is solid and needs a face label, S1 to S%d",
                            entry->number, type->name, type->shape->faces);
        if (face < 0)
            return inp_fail(&e->m->lines, line->at, "element %d of type %s has no face %s", entry->number, type->name,
                            inp_face_name(line->face));
        if (!(taken[at] & (1 << face)))
            append(faces, INP_MAX_FACES * at + (size_t)face);
        taken[at] = (unsigned char)(taken[at] | (1 << face));
    }
    return true;
}

static bool surface_faces(struct inp_model *m, const struct inp_surface *s, struct set_walk *nodes,
                          struct inp_list *faces)
{
    struct set_walk e = walk_new(m, INP_ELEMENT);
    unsigned char *taken = new_array(m->elements.n, 1);
    bool done = true;
    for (size_t i = 0; i < s->items.n && done; i++) {
        done = find(&e, &s->items.item[i]) && add_faces(&e, &s->items.item[i], taken, nodes, faces);
        while (e.found.n > 0)
            e.mark[e.found.index[--e.found.n]] = 0;
    }
    free(taken);
    walk_clear(&e);
    return done;
}

int inp_face_nodes(const struct inp_model *m, size_t face, int node[9])
{
    const struct inp_element *e = &m->element[m->elements.entry[face / INP_MAX_FACES].order];
    const struct inp_shape *shape = e->type->shape;
    const int corners = shape->face[face % INP_MAX_FACES].corners;
    const int n = e->type->order == INP_LINEAR ? corners : 2 * corners + (e->type->order == INP_BIQUADRATIC);
    for (int i = 0; i < n; i++)
        node[i] = m->connectivity[e->first + shape->face[face % INP_MAX_FACES].node[i] - 1];
    return n;
}

bool inp_master_faces(struct inp_model *m, const struct inp_pair *pair, struct inp_list *faces)
{
    const struct inp_surface *s = surface_of(m, pair->master, INP_ELEMENT, pair->at);
    if (s && s->what == INP_NODE)
        return inp_fail(&m->lines, pair->at, "master surface '%s' is made of nodes; it must be made of element faces",
                        name_of(m, pair->master).s);
    return s && surface_faces(m, s, NULL, faces) && finish(m, pair->master, s, faces);
}

/* Nodes of element faces, each once. */
static void add_nodes(struct set_walk *nodes, const struct inp_list *faces)
{
    for (size_t i = 0; i < faces->n; i++) {
        int node[9];
        for (int k = inp_face_nodes(nodes->m, faces->index[i], node); k-- > 0;)
            add_node(nodes, (size_t)node[k]);
    }
}

bool inp_slave_nodes(struct inp_model *m, const struct inp_pair *pair, struct inp_list *nodes, struct inp_list *faces)
{
    const struct inp_surface *s = surface_of(m, pair->slave, INP_NODE, pair->at);
    if (!s)
        return false;
    struct set_walk walk = walk_new(m, INP_NODE);
    bool done = true;
    if (s->what == INP_ELEMENT) {
        done = surface_faces(m, s, &walk, faces);
        add_nodes(&walk, faces);
    } else
        for (size_t i = 0; i < s->items.n && done; i++)
            done = find(&walk, &s->items.item[i]);
    *nodes = walk.found;
    walk.found = (struct inp_list){0};
    walk_clear(&walk);
    return done && finish(m, pair->slave, s, nodes);
}
