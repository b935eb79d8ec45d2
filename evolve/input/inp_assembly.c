/* Parts and their instances. A part is a position in a file. It is read again for each instance, so that its numbers
 * and names become the instance's own. At the end, nodes are moved and then turned about an axis. */
#include "inp.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool inp_part_add(struct inp_model *m, struct inp_text name)
{
    for (size_t i = 0; i < m->parts; i++)
        if (inp_equals(name, m->part[i].name))
            return inp_fail(&m->lines, m->lines.place, "part '%s' is defined twice", inp_show(name).s);
    APPEND(m->part, m->parts, m->part_room) = (struct inp_part){new_text(name.s, name.n), inp_here(&m->lines)};
    return true;
}

int inp_instance_find(const struct inp_model *m, struct inp_text name)
{
    for (size_t i = 0; i < m->instances; i++)
        if (inp_equals(name, m->instance[i].name))
            return (int)i + 1;
    return 0;
}

bool inp_instance_add(struct inp_model *m, struct inp_text name, struct inp_text part)
{
    if (name.n == 0 || inp_instance_find(m, name))
        return inp_fail(&m->lines, m->lines.place, name.n ? "instance '%s' is defined twice" : "instance has no name%s",
                        inp_show(name).s);
    for (size_t i = 0; i < m->parts; i++)
        if (inp_equals(part, m->part[i].name)) {
            APPEND(m->instance, m->instances, m->instance_room) =
                (struct inp_instance){.name = new_text(name.s, name.n)};
            return inp_go_to(&m->lines, m->part[i].text);
        }
    return inp_fail(&m->lines, m->lines.place, "part '%s' must be defined before its instance", inp_show(part).s);
}

/* Turns x about the axis from a to b (Rodrigues). */
static void turn(const double *a, const double *b, double degrees, double x[3])
{
    const double length = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]), angle = degrees / 180 * acos(-1);
    double n[3], d[3], along = 0;
    if (!(length > 0))
        return;
    for (int k = 0; k < 3; k++) {
        n[k] = (b[k] - a[k]) / length;
        d[k] = x[k] - a[k];
        along += n[k] * d[k];
    }
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        x[k] = a[k] + cos(angle) * d[k] + sin(angle) * (n[i] * d[j] - n[j] * d[i]) + (1 - cos(angle)) * along * n[k];
    }
}

bool inp_instances_place(struct inp_model *m)
{
    for (size_t i = 0; i < m->nodes.n; i++) {
        const struct inp_entry *entry = &m->nodes.entry[i];
        const int instance = inp_instance_of(entry->key);
        double *x = m->xyz[entry->order];
        if (!instance)
            continue;
        const double *place = m->instance[instance - 1].place;
        for (int k = 0; k < 3; k++)
            x[k] += place[k];
        if (place[9] != 0)
            turn(&place[3], &place[6], place[9], x);
        if (!isfinite(x[0]) || !isfinite(x[1]) || !isfinite(x[2]))
            return inp_fail(&m->lines, entry->at, "node %d of instance '%s' is not finite after placement",
                            inp_number_of(entry->key), m->instance[instance - 1].name);
    }
    return true;
}
