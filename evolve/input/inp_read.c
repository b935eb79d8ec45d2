/* Reader of Abaqus and CalculiX input files: nodes, elements, sets, surfaces and contact pairs, in a flat model or in
 * parts with instances. Other keywords (materials, steps, output) are skipped with their data. Keywords that would move
 * or make nodes or elements are errors, because skipping them would change the mesh. Sets and surfaces are stored as
 * written and resolved when a contact pair needs them, so definitions may come in any order. Unsupported features
 * (faces of beams and of plane elements, analytical surfaces) are errors only if contact needs them. */
#include "inp_reader.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const what_name[] = {"node", "element"};

/* Opens the set with this name; `r` then collects nodes or elements in it. */
static bool open_set(struct inp_reader *r, enum inp_what what, struct inp_text t)
{
    struct inp_model *m = r->m;
    int name;
    if (!inp_read_name(r, r->instance, t, &name))
        return false;
    int *set = &m->names.name[name].set[what];
    if (*set < 0) {
        grow_array(&m->set, m->sets, &m->set_room, sizeof *m->set);
        *set = (int)m->sets;
        m->set[m->sets++] = (struct inp_set){.visit = 0};
    }
    r->set = (size_t)*set;
    r->in_set = true;
    return true;
}

/* Adds a node or element just defined to the open set; consecutive numbers share an item. */
static void join_set(struct inp_reader *r, int number)
{
    if (!r->in_set)
        return;
    struct inp_items *items = &r->m->set[r->set].items;
    struct inp_item *last = r->run ? &items->item[items->n - 1] : NULL;
    const int64_t key = inp_key(r->instance, number);
    if (last && last->last == key - 1)
        last->last = key;
    else
        inp_add_item(items,
                     (struct inp_item){.name = -1, .first = key, .last = key, .step = 1, .at = r->m->lines.place});
    r->run = true;
}

static bool begin_node(struct inp_reader *r)
{
    struct inp_text t;
    if (inp_parameter(&r->m->lines, "SYSTEM", &t) && !inp_equals(t, "R"))
        return FAIL(r, "*NODE, SYSTEM=%s is not supported; coordinates must be rectangular", inp_show(t).s);
    if (inp_parameter(&r->m->lines, "NSET", &t) && !open_set(r, INP_NODE, t))
        return false;
    return inp_follow_input(r);
}

static bool read_node(struct inp_reader *r)
{
    struct inp_model *m = r->m;
    struct inp_text t;
    int number;
    double x[3] = {0};
    if (!inp_field(&m->lines, &t) || !inp_read_number(r, t, &number))
        return false;
    for (int i = 0; i < 3 && inp_field(&m->lines, &t); i++) {
        if (t.n > 0 && !inp_real(t, &x[i]))
            return FAIL(r, "'%s' must be a number", inp_show(t).s);
        if (!isfinite(x[i]))
            return FAIL(r, "coordinate '%s' of node %d must be finite", inp_show(t).s, number);
    }
    grow_array(&m->xyz, m->nodes.n, &m->xyz_room, sizeof *m->xyz);
    for (int i = 0; i < 3; i++)
        m->xyz[m->nodes.n][i] = x[i];
    inp_numbers_add(&m->nodes, inp_key(r->instance, number), m->lines.place);
    join_set(r, number);
    return true;
}

/* Returns a type without known faces, kept by its name. */
static const struct inp_type *other_type(struct inp_model *m, struct inp_text name)
{
    for (size_t i = 0; i < m->others; i++)
        if (inp_equals(name, m->other[i]->name))
            return m->other[i];
    struct inp_type *type = new_array(1, sizeof *type);
    const struct inp_shown shown = inp_show(name);
    type->name = new_text(shown.s, strlen(shown.s));
    return APPEND(m->other, m->others, m->other_room) = type;
}

static bool begin_element(struct inp_reader *r)
{
    struct inp_text t;
    if (!inp_parameter(&r->m->lines, "TYPE", &t) || t.n == 0)
        return FAIL(r, "*ELEMENT needs TYPE=");
    r->type = inp_type_find(t);
    if (!r->type)
        r->type = other_type(r->m, t);
    if (inp_parameter(&r->m->lines, "ELSET", &t) && !open_set(r, INP_ELEMENT, t))
        return false;
    return inp_follow_input(r);
}

static void add_connection(struct inp_model *m, struct inp_element *e, int node)
{
    APPEND(m->connectivity, m->connections, m->connection_room) = node;
    e->nodes++;
}

/* Reads the node numbers on a line of an element of unknown type, which may have any number of nodes. A comma at the
 * end continues the element on the next line. */
static void read_some_nodes(struct inp_reader *r, struct inp_element *e)
{
    struct inp_text t;
    int node;
    r->open = r->m->lines.continues;
    while (inp_field(&r->m->lines, &t))
        if (inp_number(t, &node))
            add_connection(r->m, e, node);
}

/* Reads the nodes of an element; a comma at the end of a line continues it until all nodes are read. */
static bool read_all_nodes(struct inp_reader *r, struct inp_element *e, struct inp_place at, int number)
{
    struct inp_model *m = r->m;
    struct inp_text t;
    for (;;) {
        while (inp_field(&m->lines, &t)) {
            int node;
            if (e->nodes == r->type->nodes)
                return inp_fail(&m->lines, at, "element %d has more than the %d nodes of type %s", number, e->nodes,
                                r->type->name);
            if (!inp_read_number(r, t, &node))
                return false;
            add_connection(m, e, node);
        }
        if (e->nodes == r->type->nodes)
            break;
        const bool continues = m->lines.continues;
        if (continues && !inp_next(&m->lines))
            return false;
        if (!continues || m->lines.kind != INP_DATA)
            return inp_fail(&m->lines, at, "element %d has %d nodes, but type %s has %d", number, e->nodes,
                            r->type->name, r->type->nodes);
    }
    return true;
}

static bool read_element(struct inp_reader *r)
{
    struct inp_model *m = r->m;
    const struct inp_place at = m->lines.place;
    struct inp_text t;
    int number;
    if (r->open) {
        read_some_nodes(r, &m->element[m->elements.n - 1]);
        return true;
    }
    if (!inp_field(&m->lines, &t) || !inp_read_number(r, t, &number))
        return false;
    grow_array(&m->element, m->elements.n, &m->element_room, sizeof *m->element);
    struct inp_element *e = &m->element[m->elements.n];
    *e = (struct inp_element){r->type, m->connections, 0};
    if (!r->type->shape)
        read_some_nodes(r, e);
    else if (!read_all_nodes(r, e, at, number))
        return false;
    inp_numbers_add(&m->elements, inp_key(r->instance, number), at);
    join_set(r, number);
    return true;
}

/* Adds the nodes of a set's elements. */
static bool lend_nodes(struct inp_reader *r, struct inp_text elements)
{
    struct inp_item item = {.name = -1, .lent = true, .face = INP_FACE_NONE, .at = r->m->lines.place};
    const int instance = inp_read_instance(r, &elements);
    if (!inp_read_name(r, instance, elements, &item.name))
        return false;
    inp_add_item(&r->m->set[r->set].items, item);
    return true;
}

static bool begin_set(struct inp_reader *r, enum inp_what what)
{
    struct inp_text t;
    const bool nodes = what == INP_NODE;
    if (!inp_parameter(&r->m->lines, nodes ? "NSET" : "ELSET", &t))
        return FAIL(r, nodes ? "*NSET needs NSET=" : "*ELSET needs ELSET=");
    r->what = what;
    r->generate = inp_parameter(&r->m->lines, "GENERATE", &(struct inp_text){0});
    if (!open_set(r, what, t) || !inp_choose_instance(r))
        return false;
    if (nodes && inp_parameter(&r->m->lines, "ELSET", &t) && !lend_nodes(r, t))
        return false;
    return inp_follow_input(r);
}

static bool begin_nset(struct inp_reader *r)
{
    return begin_set(r, INP_NODE);
}

static bool begin_elset(struct inp_reader *r)
{
    return begin_set(r, INP_ELEMENT);
}

static bool read_range(struct inp_reader *r)
{
    struct inp_text t;
    int value[3] = {0, 0, 1}, n = 0;
    while (inp_field(&r->m->lines, &t)) {
        if (n == 3)
            return FAIL(r, "GENERATE takes first, last and step; '%s' is extra", inp_show(t).s);
        if (!inp_read_number(r, t, &value[n++]))
            return false;
    }
    if (n < 2)
        return FAIL(r, "GENERATE needs a first and a last number");
    if (value[1] < value[0])
        return FAIL(r, "GENERATE runs from %d down to %d; the first number must not exceed the last", value[0],
                    value[1]);
    inp_add_item(&r->m->set[r->set].items, (struct inp_item){.name = -1,
                                                             .first = inp_key(r->members, value[0]),
                                                             .last = inp_key(r->members, value[1]),
                                                             .step = value[2],
                                                             .face = INP_FACE_NONE,
                                                             .at = r->m->lines.place});
    return true;
}

static bool read_set(struct inp_reader *r)
{
    struct inp_text t;
    struct inp_item item;
    if (r->generate)
        return read_range(r);
    while (inp_field(&r->m->lines, &t)) {
        if (t.n == 0)
            continue;
        if (!inp_read_member(r, t, &item))
            return false;
        inp_add_item(&r->m->set[r->set].items, item);
    }
    return true;
}

static const struct handler {
    const char *keyword;
    bool (*begin)(struct inp_reader *r);
    bool (*data)(struct inp_reader *r); /* NULL: data are skipped */
} handlers[] = {
    {"NODE", begin_node, read_node},
    {"ELEMENT", begin_element, read_element},
    {"NSET", begin_nset, read_set},
    {"ELSET", begin_elset, read_set},
    {"SURFACE", inp_begin_surface, inp_read_surface},
    {"CONTACTPAIR", inp_begin_pair, inp_read_pair},
    {"CONTACTINCLUSIONS", inp_begin_inclusions, inp_read_inclusion},
    {"TIE", inp_begin_tie, inp_read_tie},
    {"PART", inp_begin_part, NULL},
    {"ENDPART", inp_end_part, inp_read_place},
    {"ASSEMBLY", inp_begin_assembly, NULL},
    {"INSTANCE", inp_begin_instance, NULL},
    {"ENDINSTANCE", inp_end_instance, NULL},
};

#define NODES "it makes or moves nodes; list them in global coordinates"
#define ELEMENTS "it makes elements; list them"

static const char *const refused[][2] = {
    {"NGEN", NODES},   {"NFILL", NODES},    {"NCOPY", NODES},     {"NMAP", NODES},
    {"SYSTEM", NODES}, {"ELGEN", ELEMENTS}, {"ELCOPY", ELEMENTS},
};

static bool is_end(const struct inp_reader *r)
{
    const struct inp_lines *l = &r->m->lines;
    if (r->depth)
        return inp_fail(l, r->m->part[r->m->parts - 1].text.place, "*PART needs *END PART");
    return !r->instance || inp_fail(l, r->begun, "*INSTANCE needs *END INSTANCE");
}

/* Begins a keyword; *handler becomes NULL if its data are to be skipped. */
static bool begin_keyword(struct inp_reader *r, const struct handler **handler)
{
    const struct inp_text keyword = {r->m->lines.keyword, strlen(r->m->lines.keyword)};
    if (r->needs_pair)
        return inp_fail(&r->m->lines, r->keyword, "*CONTACT PAIR names no surfaces");
    r->keyword = r->m->lines.place;
    r->in_set = r->run = r->open = false;
    r->members = r->instance;
    *handler = NULL;
    if (r->m->lines.kind == INP_END)
        return is_end(r);
    if (r->over && !inp_equals(keyword, "ENDPART"))
        return true;
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        if (inp_equals(keyword, refused[i][0]))
            return FAIL(r, "*%s is not supported: %s", refused[i][0], refused[i][1]);
    for (size_t i = 0; i < sizeof handlers / sizeof *handlers; i++)
        if (inp_equals(keyword, handlers[i].keyword)) {
            *handler = &handlers[i];
            return handlers[i].begin(r);
        }
    return true;
}

/* Reads all lines; text before the first keyword is skipped. */
static bool read_lines(struct inp_reader *r)
{
    struct inp_lines *l = &r->m->lines;
    const struct handler *handler = NULL;
    for (;;) {
        if (!inp_next(l))
            return false;
        if (l->kind == INP_DATA) {
            if (handler && handler->data && !handler->data(r))
                return false;
        } else if (!begin_keyword(r, &handler))
            return false;
        if (l->kind == INP_END)
            return true;
    }
}

/* Replaces an element's node numbers by positions. For unknown types, numbers that are not nodes are dropped. */
static bool link_nodes(struct inp_model *m, const struct inp_entry *entry)
{
    struct inp_element *e = &m->element[entry->order];
    int *node = m->connections > 0 ? &m->connectivity[e->first] : NULL, found = 0;
    for (int k = 0; k < e->nodes; k++) {
        const int64_t key = inp_key(inp_instance_of(entry->key), node[k]);
        const size_t at = inp_numbers_find(&m->nodes, key);
        if (at < m->nodes.n && m->nodes.entry[at].key == key)
            node[found++] = (int)at;
        else if (e->type->shape)
            return inp_fail(&m->lines, entry->at, "node %d of element %d is not defined", node[k],
                            inp_number_of(entry->key));
    }
    e->nodes = found;
    return true;
}

/* Sorts the tables and links elements to their nodes. */
static bool link_elements(struct inp_model *m)
{
    const struct inp_entry *repeated;
    for (int what = INP_NODE; what <= INP_ELEMENT; what++) {
        repeated = inp_numbers_sort(what == INP_NODE ? &m->nodes : &m->elements);
        if (repeated)
            return inp_fail(&m->lines, repeated->at, "%s %d is defined twice", what_name[what],
                            inp_number_of(repeated->key));
    }
    for (size_t i = 0; i < m->elements.n; i++)
        if (!link_nodes(m, &m->elements.entry[i]))
            return false;
    return true;
}

struct inp_model *inp_read(const char *path, struct diag *d)
{
    struct inp_model *m = new_array(1, sizeof *m);
    struct inp_reader r = {.m = m};
    const bool done = inp_open(&m->lines, path, d) && read_lines(&r) && link_elements(m) && inp_instances_place(m);
    free(r.assembly);
    if (done)
        return m;
    inp_free(m);
    return NULL;
}

void inp_free(struct inp_model *m)
{
    if (!m)
        return;
    for (size_t i = 0; i < m->sets; i++)
        free(m->set[i].items.item);
    for (size_t i = 0; i < m->surfaces; i++) {
        free(m->surface[i].items.item);
        inp_cover_free(m->surface[i].cover);
    }
    for (size_t i = 0; i < m->parts; i++)
        free(m->part[i].name);
    for (size_t i = 0; i < m->instances; i++)
        free(m->instance[i].name);
    free(m->part);
    free(m->instance);
    free(m->exposed);
    for (size_t i = 0; i < m->others; i++) {
        free((char *)m->other[i]->name);
        free(m->other[i]);
    }
    free(m->other);
    inp_close(&m->lines);
    inp_names_clear(&m->names);
    free(m->nodes.entry);
    free(m->elements.entry);
    free(m->xyz);
    free(m->element);
    free(m->connectivity);
    free(m->set);
    free(m->surface);
    free(m->pair);
    free(m);
}
