/* Keywords of surfaces and pairs: contact pairs, general contact of named surfaces, and ties. */
#include "inp_reader.h"

#include <string.h>

/* Returns an item for an unsupported feature, an error only if contact needs it. */
static struct inp_item refused_item(const struct inp_reader *r, const char *why)
{
    return (struct inp_item){.name = -1, .refused = why, .face = INP_FACE_NONE, .at = r->m->lines.place};
}

/* Reads the operation of COMBINE=. */
static bool read_combine(struct inp_reader *r, enum inp_combine *combine)
{
    static const char *const word[] = {"", "UNION", "INTERSECTION", "DIFFERENCE"};
    struct inp_text t;
    *combine = INP_SINGLE;
    if (!inp_parameter(&r->m->lines, "COMBINE", &t))
        return true;
    for (int i = INP_UNION; i <= INP_DIFFERENCE; i++)
        if (inp_equals(t, word[i])) {
            *combine = (enum inp_combine)i;
            return true;
        }
    return FAIL(r, "COMBINE=%s must be UNION, INTERSECTION or DIFFERENCE", inp_show(t).s);
}

/* Begins a surface. Faces and nodes may share a surface's name; a second *SURFACE extends the first, as in CalculiX. */
bool inp_begin_surface(struct inp_reader *r)
{
    struct inp_model *m = r->m;
    struct inp_text t = {"ELEMENT", 7};
    enum inp_combine combine;
    int name;
    inp_parameter(&m->lines, "TYPE", &t);
    r->what = inp_equals(t, "NODE") ? INP_NODE : INP_ELEMENT;
    r->skip = r->what == INP_ELEMENT && !inp_equals(t, "ELEMENT");
    if (!inp_parameter(&m->lines, "NAME", &t))
        return FAIL(r, "*SURFACE needs NAME=");
    if (!inp_read_name(r, r->instance, t, &name) || !read_combine(r, &combine) || !inp_choose_instance(r))
        return false;
    int *surface = &m->names.name[name].surface[r->what];
    if (*surface < 0) {
        grow_array(&m->surface, m->surfaces, &m->surface_room, sizeof *m->surface);
        *surface = (int)m->surfaces;
        m->surface[m->surfaces++] = (struct inp_surface){.what = r->what, .combine = combine, .at = m->lines.place};
    } else if (m->surface[*surface].combine != combine)
        return FAIL(r, "surface '%s' is defined both with COMBINE= and without", inp_show(t).s);
    r->surface = (size_t)*surface;
    if (r->skip)
        inp_add_item(&m->surface[r->surface].items, refused_item(r, "surface type must be ELEMENT or NODE"));
    return inp_follow_input(r);
}

/* Reads all names of surfaces on the line. */
static bool read_surfaces(struct inp_reader *r)
{
    struct inp_text t;
    struct inp_item item = {.name = -1, .face = INP_FACE_NONE, .at = r->m->lines.place};
    while (inp_field(&r->m->lines, &t)) {
        if (t.n == 0)
            continue;
        const int instance = inp_read_instance(r, &t);
        if (!inp_read_name(r, instance, t, &item.name))
            return false;
        inp_add_item(&r->m->surface[r->surface].items, item);
    }
    return true;
}

/* Reads a node or node set (the next field is a node's area), or an element or element set and a face label. */
bool inp_read_surface(struct inp_reader *r)
{
    struct inp_text t;
    struct inp_item item;
    if (r->skip)
        return true;
    if (r->m->surface[r->surface].combine != INP_SINGLE)
        return read_surfaces(r);
    if (!inp_field(&r->m->lines, &t) || !inp_read_member(r, t, &item))
        return false;
    if (r->what == INP_ELEMENT && inp_field(&r->m->lines, &t) && t.n > 0 && !inp_face_read(t, &item.face))
        return FAIL(r, "face label '%s' must be S1 to S6, SPOS or SNEG", inp_show(t).s);
    inp_add_item(&r->m->surface[r->surface].items, item);
    return true;
}

bool inp_begin_pair(struct inp_reader *r)
{
    r->needs_pair = true;
    r->kind = INP_CONTACT;
    return true;
}

bool inp_begin_inclusions(struct inp_reader *r)
{
    r->kind = INP_INCLUSION;
    return true;
}

/* Begins a tie; other types of tie, between distant faces, are skipped. */
bool inp_begin_tie(struct inp_reader *r)
{
    static const char *const other[] = {"CYCLICSYMMETRY", "MULTISTAGE", "FLUIDPERIODIC", "FLUIDCYCLIC"};
    r->kind = INP_TIE;
    r->skip = false;
    for (size_t i = 0; i < sizeof other / sizeof *other; i++)
        r->skip = r->skip || inp_parameter(&r->m->lines, other[i], &(struct inp_text){0});
    return true;
}

static bool add_pair(struct inp_reader *r, struct inp_text slave, struct inp_text master)
{
    struct inp_pair pair = {.kind = r->kind, .at = r->m->lines.place};
    const int of[2] = {inp_read_instance(r, &slave), inp_read_instance(r, &master)};
    if (!inp_read_name(r, of[0], slave, &pair.slave) || !inp_read_name(r, of[1], master, &pair.master))
        return false;
    APPEND(r->m->pair, r->m->pairs, r->m->pair_room) = pair;
    return true;
}

/* Reads two surfaces, or a surface in contact with itself. */
bool inp_read_pair(struct inp_reader *r)
{
    struct inp_text slave, master;
    if (!inp_field(&r->m->lines, &slave) || slave.n == 0)
        return FAIL(r, "contact pair needs a slave and a master surface, or one surface for self contact");
    if (!inp_field(&r->m->lines, &master) || master.n == 0)
        master = slave;
    r->needs_pair = false;
    return add_pair(r, slave, master);
}

/* Reads a pair of which either surface is master of the other. A surface without a name contains all exterior faces. */
bool inp_read_inclusion(struct inp_reader *r)
{
    struct inp_text a, b;
    if (!inp_field(&r->m->lines, &a) || a.n == 0) {
        inp_note(&r->m->lines, r->m->lines.place, "contact of all exterior faces is skipped; name both surfaces");
        return true;
    }
    if (!inp_field(&r->m->lines, &b) || b.n == 0 || (b.n == a.n && memcmp(a.s, b.s, a.n) == 0))
        return add_pair(r, a, a);
    return add_pair(r, a, b) && add_pair(r, b, a);
}

bool inp_read_tie(struct inp_reader *r)
{
    struct inp_text slave, master;
    if (r->skip || !inp_field(&r->m->lines, &slave) || !inp_field(&r->m->lines, &master) || slave.n == 0 ||
        master.n == 0)
        return true;
    return add_pair(r, slave, master);
}
