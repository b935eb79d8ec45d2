/* Resolves names of surfaces to faces and nodes. The cover of a surface is a byte for each element with a bit for each
 * face, so that bit operations combine surfaces. The cover of a combined surface is computed once. */
#include "inp.h"

#include <stdlib.h>

enum { MOST_COMBINED = 100 };

static struct inp_cover *cover_new(const struct inp_model *m)
{
    struct inp_cover *c = new_array(1, sizeof *c);
    c->face = new_array(m->elements.n, 1);
    c->node = new_array(m->nodes.n, 1);
    return c;
}

void inp_cover_free(struct inp_cover *c)
{
    if (!c)
        return;
    free(c->face);
    free(c->node);
    free(c);
}

bool inp_has_faces(const struct inp_model *m, int name)
{
    return m->names.name[name].surface[INP_ELEMENT] >= 0;
}

/* Returns the surface with this name, the preferred type if there are both. */
static struct inp_surface *surface_of(const struct inp_model *m, int name, enum inp_what preferred, struct inp_place at)
{
    const int *s = m->names.name[name].surface;
    if (s[preferred] >= 0)
        return &m->surface[s[preferred]];
    if (s[!preferred] >= 0)
        return &m->surface[s[!preferred]];
    inp_fail(&m->lines, at, "surface '%s' is not defined", inp_name_shown(m, name).s);
    return NULL;
}

/* Adds the faces of an element that a line's label names, or its exposed faces if there is no label. Elements without
 * known faces contribute their nodes. */
static bool add_element(struct inp_model *m, size_t at, const struct inp_item *line, struct inp_cover *cover)
{
    const struct inp_entry *entry = &m->elements.entry[at];
    const struct inp_element *e = &m->element[entry->order];
    if (!e->type->shape) {
        for (int k = 0; k < e->nodes; k++)
            cover->node[m->connectivity[e->first + (size_t)k]] = 1;
        if (!cover->other) {
            cover->other = entry;
            cover->at = line->at;
        }
        return true;
    }
    if (line->face == INP_FACE_NONE && !e->type->shell) {
        if (!m->exposed)
            inp_find_exposed(m);
        cover->face[at] |= m->exposed[at];
        return true;
    }
    const int face = inp_face_index(e->type, line->face);
    if (face == INP_EDGE)
        cover->edges = true;
    else if (face >= 0)
        cover->face[at] = (unsigned char)(cover->face[at] | (1 << face));
    return face != INP_NO_FACE || inp_fail(&m->lines, line->at, "element %d of type %s has no face %s",
                                           inp_number_of(entry->key), e->type->name, inp_face_name(line->face));
}

static bool add_lines(struct inp_model *m, const struct inp_surface *s, struct inp_cover *cover)
{
    struct inp_list found = {0};
    unsigned char *mark = new_array(m->elements.n, 1);
    bool done = true;
    for (size_t i = 0; i < s->items.n && done; i++) {
        const struct inp_item *line = &s->items.item[i];
        done = inp_members(m, INP_ELEMENT, line, &found, mark);
        for (size_t k = 0; k < found.n; k++) {
            done = done && add_element(m, found.index[k], line, cover);
            mark[found.index[k]] = 0;
        }
        found.n = 0;
    }
    free(mark);
    free(found.index);
    return done;
}

static void combine(unsigned char *to, const unsigned char *with, size_t n, enum inp_combine how)
{
    for (size_t i = 0; i < n; i++)
        to[i] = (unsigned char)(how == INP_UNION          ? to[i] | with[i]
                                : how == INP_INTERSECTION ? to[i] & with[i]
                                                          : to[i] & ~with[i]);
}

/* Returns the cover of a surface of faces, or NULL with the diagnostic filled. The caller frees it if the surface is
 * not combined. */
static struct inp_cover *cover_of(struct inp_model *m, int name, struct inp_place at, int depth);

/* Frees a cover that its surface does not keep. */
static void cover_done(const struct inp_model *m, int name, struct inp_cover *cover)
{
    if (cover && m->surface[m->names.name[name].surface[INP_ELEMENT]].cover != cover)
        inp_cover_free(cover);
}

static bool combine_surfaces(struct inp_model *m, const struct inp_surface *s, struct inp_cover *cover, int depth)
{
    for (size_t i = 0; i < s->items.n; i++) {
        const struct inp_item *line = &s->items.item[i];
        if (line->refused)
            return inp_fail(&m->lines, line->at, "%s", line->refused);
        struct inp_cover *other = cover_of(m, line->name, line->at, depth + 1);
        if (!other)
            return false;
        const enum inp_combine how = i == 0 ? INP_UNION : s->combine;
        combine(cover->face, other->face, m->elements.n, how);
        combine(cover->node, other->node, m->nodes.n, how);
        cover->edges = cover->edges || other->edges;
        if (!cover->other) {
            cover->other = other->other;
            cover->at = other->at;
        }
        cover_done(m, line->name, other);
    }
    return true;
}

static struct inp_cover *cover_of(struct inp_model *m, int name, struct inp_place at, int depth)
{
    struct inp_surface *s = surface_of(m, name, INP_ELEMENT, at);
    if (!s || s->cover)
        return s ? s->cover : NULL;
    if (s->what == INP_NODE || s->open || depth > MOST_COMBINED) {
        inp_fail(&m->lines, at,
                 s->what == INP_NODE ? "surface '%s' is made of nodes; it must be made of element faces"
                 : s->open           ? "surface '%s' must not be combined of itself"
                                     : "surface '%s' is combined of combined surfaces, nested more than 100 "
                                       "levels deep",
                 inp_name_shown(m, name).s);
        return NULL;
    }
    struct inp_cover *cover = cover_new(m);
    s->open = true;
    const bool done = s->combine == INP_SINGLE ? add_lines(m, s, cover) : combine_surfaces(m, s, cover, depth);
    s->open = false;
    if (!done) {
        inp_cover_free(cover);
        return NULL;
    }
    if (cover->edges)
        inp_note(&m->lines, s->at, "surface '%s': edges of shells are skipped", inp_name_shown(m, name).s);
    if (s->combine != INP_SINGLE)
        s->cover = cover;
    return cover;
}

static void list_faces(const struct inp_model *m, const struct inp_cover *cover, struct inp_list *faces)
{
    for (size_t at = 0; at < m->elements.n; at++)
        for (size_t face = 0; face < INP_MAX_FACES; face++)
            if (cover->face[at] & (1 << face))
                APPEND(faces->index, faces->n, faces->room) = INP_MAX_FACES * at + face;
}

int inp_face_nodes(const struct inp_model *m, size_t face, int node[9])
{
    const struct inp_element *e = &m->element[m->elements.entry[face / INP_MAX_FACES].order];
    const struct inp_shape *shape = e->type->shape;
    const int corners = shape->face[face % INP_MAX_FACES].corners;
    const int sides = corners > 2 ? corners : 1;
    const int n = e->type->order == INP_LINEAR ? corners : corners + sides + (e->type->order == INP_BIQUADRATIC);
    for (int i = 0; i < n; i++)
        node[i] = m->connectivity[e->first + shape->face[face % INP_MAX_FACES].node[i] - 1];
    return n;
}

/* Fails if a surface is empty. */
static bool finish(const struct inp_model *m, int name, struct inp_place at, const struct inp_list *list)
{
    return list->n > 0 || inp_fail(&m->lines, at, "surface '%s' is empty", inp_name_shown(m, name).s);
}

bool inp_master_faces(struct inp_model *m, const struct inp_pair *pair, struct inp_list *faces)
{
    const struct inp_surface *s = surface_of(m, pair->master, INP_ELEMENT, pair->at);
    if (s && s->what == INP_NODE)
        return inp_fail(&m->lines, pair->at, "master surface '%s' is made of nodes; it must be made of element faces",
                        inp_name_shown(m, pair->master).s);
    struct inp_cover *cover = s ? cover_of(m, pair->master, pair->at, 0) : NULL;
    if (!cover)
        return false;
    const struct inp_entry *other = cover->other;
    if (other)
        inp_fail(&m->lines, cover->at,
                 "element %d of a master surface has type %s without known faces; it must be a solid, shell or "
                 "membrane",
                 inp_number_of(other->key), m->element[other->order].type->name);
    list_faces(m, cover, faces);
    cover_done(m, pair->master, cover);
    return !other && finish(m, pair->master, s->at, faces);
}

/* Finds the nodes of element faces, and of elements without known faces. */
static bool slave_faces(struct inp_model *m, const struct inp_pair *pair, struct inp_list *faces, unsigned char *mark)
{
    struct inp_cover *cover = cover_of(m, pair->slave, pair->at, 0);
    if (!cover)
        return false;
    list_faces(m, cover, faces);
    for (size_t i = 0; i < faces->n; i++) {
        int node[9];
        for (int k = inp_face_nodes(m, faces->index[i], node); k-- > 0;)
            mark[node[k]] = 1;
    }
    combine(mark, cover->node, m->nodes.n, INP_UNION);
    cover_done(m, pair->slave, cover);
    return true;
}

bool inp_slave_nodes(struct inp_model *m, const struct inp_pair *pair, struct inp_list *nodes, struct inp_list *faces)
{
    const struct inp_surface *s = surface_of(m, pair->slave, INP_NODE, pair->at);
    unsigned char *mark = new_array(m->nodes.n, 1);
    bool done = s && (s->what == INP_NODE || slave_faces(m, pair, faces, mark));
    for (size_t i = 0; done && s->what == INP_NODE && i < s->items.n; i++)
        done = inp_members(m, INP_NODE, &s->items.item[i], nodes, mark);
    nodes->n = 0;
    for (size_t at = 0; at < m->nodes.n; at++)
        if (mark[at])
            APPEND(nodes->index, nodes->n, nodes->room) = at;
    free(mark);
    return done && finish(m, pair->slave, s->at, nodes);
}
