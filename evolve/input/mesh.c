/* Contact surfaces of an Abaqus or CalculiX input file: reads the model (inp_read.c), resolves its sets and surfaces
 * (inp_surface.c), and copies node coordinates and each contact pair's slave nodes and master faces. */
#include "mesh.h"
#include "inp.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void copy_nodes(const struct inp_model *m, struct mesh *mesh)
{
    mesh->nodes = m->nodes.n;
    mesh->xyz = new_array(mesh->nodes, sizeof *mesh->xyz);
    mesh->label = new_array(mesh->nodes, sizeof *mesh->label);
    for (size_t i = 0; i < mesh->nodes; i++) {
        mesh->label[i] = inp_number_of(m->nodes.entry[i].key);
        memcpy(mesh->xyz[i], m->xyz[m->nodes.entry[i].order], sizeof mesh->xyz[i]);
    }
}

static void mark_faces(const struct inp_list *faces, unsigned char *carries)
{
    for (size_t i = 0; i < faces->n; i++)
        carries[faces->index[i] / INP_MAX_FACES] = 1;
}

static bool is_edge(const struct inp_model *m, size_t face)
{
    const struct inp_element *e = &m->element[m->elements.entry[face / INP_MAX_FACES].order];
    return e->type->shape->face[0].corners == 2;
}

/* Copies a pair. carries: 1 for elements with a face of the pair, by position. */
static bool copy_pair(struct inp_model *m, const struct inp_pair *pair, struct mesh_pair *to, unsigned char *carries)
{
    struct inp_list slaves = {0}, faces = {0}, masters = {0};
    const bool done = inp_slave_nodes(m, pair, &slaves, &faces) && inp_master_faces(m, pair, &masters);
    if (done) {
        mark_faces(&faces, carries);
        mark_faces(&masters, carries);
        to->slave = new_array(slaves.n, sizeof *to->slave);
        to->master = new_array(masters.n, sizeof *to->master);
        for (to->slaves = 0; to->slaves < slaves.n; to->slaves++)
            to->slave[to->slaves] = (int)slaves.index[to->slaves];
        for (to->masters = 0; to->masters < masters.n; to->masters++) {
            struct mesh_face *face = &to->master[to->masters];
            face->nodes = inp_face_nodes(m, masters.index[to->masters], face->node);
            face->edge = is_edge(m, masters.index[to->masters]);
        }
    }
    free(slaves.index);
    free(faces.index);
    free(masters.index);
    return done;
}

enum { IS_SLAVE = 1, IS_MASTER = 2 };

/* Returns IS_SLAVE and IS_MASTER for each node. */
static unsigned char *contact_nodes(const struct mesh *mesh)
{
    unsigned char *is = new_array(mesh->nodes, sizeof *is);
    for (const struct mesh_pair *p = mesh->pair; p < mesh->pair + mesh->pairs; p++) {
        for (size_t i = 0; i < p->slaves; i++)
            is[p->slave[i]] |= IS_SLAVE;
        for (size_t k = 0; k < p->masters; k++)
            for (int i = 0; i < p->master[k].nodes; i++)
                is[p->master[k].node[i]] |= IS_MASTER;
    }
    return is;
}

static void copy_elements(const struct inp_model *m, const unsigned char *carries, struct mesh *mesh)
{
    unsigned char *is = contact_nodes(mesh);
    size_t room = 0;
    for (size_t at = 0; at < m->elements.n; at++) {
        const struct inp_element *e = &m->element[m->elements.entry[at].order];
        struct mesh_element copy = {.nodes = carries[at] ? e->nodes : 0};
        int both = 0;
        for (int i = 0; i < copy.nodes; i++) {
            copy.node[i] = m->connectivity[e->first + (size_t)i];
            both |= is[copy.node[i]];
        }
        if (both == (IS_SLAVE | IS_MASTER))
            APPEND(mesh->element, mesh->elements, room) = copy;
    }
    free(is);
}

/* Returns true if a pair is used: contact pairs, or ties if the model has no contact. If a surface of nodes and a
 * surface of faces are paired, the nodes are slaves. */
static bool is_used(const struct inp_model *m, const struct inp_pair *pair, bool ties)
{
    return ties == (pair->kind == INP_TIE) && (pair->kind != INP_INCLUSION || inp_has_faces(m, pair->master));
}

static bool copy_pairs(struct inp_model *m, struct mesh *mesh, unsigned char *carries, struct diag *d)
{
    size_t contacts = 0;
    for (size_t i = 0; i < m->pairs; i++)
        contacts += is_used(m, &m->pair[i], false);
    const bool ties = contacts == 0;
    mesh->pair = new_array(m->pairs, sizeof *mesh->pair);
    for (size_t i = 0; i < m->pairs; i++)
        if (is_used(m, &m->pair[i], ties) && !copy_pair(m, &m->pair[i], &mesh->pair[mesh->pairs++], carries))
            return false;
    return mesh->pairs > 0 || diag_at(d, m->lines.file[0].path, 0, 0,
                                      "no contact pair; a model must contain *CONTACT PAIR, *CONTACT INCLUSIONS "
                                      "of named surfaces, or *TIE");
}

struct mesh *mesh_read(const char *path, struct diag *d)
{
    struct inp_model *m = inp_read(path, d);
    if (!m)
        return NULL;
    struct mesh *mesh = new_array(1, sizeof *mesh);
    copy_nodes(m, mesh);
    unsigned char *carries = new_array(m->elements.n, 1);
    const bool done = copy_pairs(m, mesh, carries, d);
    if (done)
        copy_elements(m, carries, mesh);
    free(carries);
    mesh->file = new_array(m->lines.files, sizeof *mesh->file);
    for (; mesh->files < m->lines.files; mesh->files++)
        mesh->file[mesh->files] = new_text(m->lines.file[mesh->files].path, strlen(m->lines.file[mesh->files].path));
    mesh->notes = m->lines.notes;
    m->lines.notes = NULL;
    inp_free(m);
    if (done)
        return mesh;
    mesh_free(mesh);
    return NULL;
}

bool mesh_is_plane(const struct mesh *m)
{
    for (size_t i = 0; i < m->pairs; i++)
        for (size_t k = 0; k < m->pair[i].masters; k++)
            if (!m->pair[i].master[k].edge)
                return false;
    return true;
}

const struct segment_kind *mesh_segment(const struct mesh *m, char *text, size_t size)
{
    size_t count[2][SEGMENT_VECTORS + 1] = {{0}}, kinds = 0, used = 0;
    const struct segment_kind *kind = NULL;
    for (size_t i = 0; i < m->pairs; i++)
        for (size_t k = 0; k < m->pair[i].masters; k++)
            count[m->pair[i].master[k].edge][m->pair[i].master[k].nodes]++;
    *text = '\0';
    for (int edge = 0; edge <= 1; edge++)
        for (size_t nodes = 0; nodes <= SEGMENT_VECTORS; nodes++)
            if (count[edge][nodes] > 0 && used < size) {
                kind = edge ? NULL : segment_of_face(nodes);
                used +=
                    (size_t)snprintf(text + used, size - used, "%s%zu of %s", kinds++ ? ", " : "", count[edge][nodes],
                                     kind         ? kind->name
                                     : nodes == 2 ? "edge2"
                                                  : "edge3");
            }
    return kinds == 1 ? kind : NULL;
}

size_t mesh_keep_faces(struct mesh *m, const struct segment_kind *kind)
{
    size_t kept = 0;
    for (size_t i = 0; i < m->pairs; i++) {
        struct mesh_pair *p = &m->pair[i];
        const size_t all = p->masters;
        p->masters = 0;
        for (size_t k = 0; k < all; k++)
            if (!p->master[k].edge && segment_of_face((size_t)p->master[k].nodes) == kind)
                p->master[p->masters++] = p->master[k];
        kept += p->masters;
    }
    return kept;
}

double mesh_shortest_edge(const struct mesh *m)
{
    double shortest = INFINITY;
    for (const struct mesh_pair *p = m->pair; p < m->pair + m->pairs; p++)
        for (size_t k = 0; k < p->masters; k++) {
            const struct mesh_face *f = &p->master[k];
            const size_t corners = f->edge ? 2 : segment_of_face((size_t)f->nodes)->corners;
            for (size_t i = 0; i < corners; i++) {
                const double *a = m->xyz[f->node[i]], *b = m->xyz[f->node[(i + 1) % corners]];
                const double edge = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
                if (edge > 0)
                    shortest = fmin(shortest, edge);
            }
        }
    return shortest;
}

void mesh_free(struct mesh *m)
{
    if (!m)
        return;
    for (size_t i = 0; i < m->pairs; i++) {
        free(m->pair[i].slave);
        free(m->pair[i].master);
    }
    free(m->xyz);
    free(m->label);
    free(m->notes);
    free(m->pair);
    free(m->element);
    for (size_t i = 0; i < m->files; i++)
        free(m->file[i]);
    free(m->file);
    free(m);
}
