/* Keywords of parts and instances. A part is skipped at first, then read for each of its instances (inp_assembly.c). */
#include "inp_reader.h"

#include "../../codegen/base/text.h"

#include <math.h>

/* Begins a part, whose text is skipped until an instance needs it. */
bool inp_begin_part(struct inp_reader *r)
{
    struct inp_text t;
    if (r->instance)
        return FAIL(r, "*PART must not be inside an instance");
    if (!inp_parameter(&r->m->lines, "NAME", &t))
        return FAIL(r, "*PART needs NAME=");
    r->depth = r->m->lines.depth;
    r->over = true;
    return inp_part_add(r->m, t);
}

bool inp_end_part(struct inp_reader *r)
{
    if (r->depth != r->m->lines.depth)
        return FAIL(r, r->depth ? "*PART and *END PART must be in the same file" : "*END PART without *PART");
    if (!r->over)
        inp_go_back(&r->m->lines);
    r->over = false;
    r->depth = 0;
    return true;
}

bool inp_begin_instance(struct inp_reader *r)
{
    struct inp_text name, part;
    if (r->instance)
        return FAIL(r, "*INSTANCE must not be inside an instance");
    if (!inp_parameter(&r->m->lines, "NAME", &name) || !inp_parameter(&r->m->lines, "PART", &part))
        return FAIL(r, "*INSTANCE needs NAME= and PART=");
    r->begun = r->m->lines.place;
    if (!inp_instance_add(r->m, name, part))
        return false;
    r->depth = r->m->lines.depth;
    r->instance = (int)r->m->instances;
    r->numbers = 0;
    return true;
}

/* Reads an instance's place: translation, then two points of an axis and an angle. */
bool inp_read_place(struct inp_reader *r)
{
    enum { TRANSLATION = 3, ALL = 10 };
    struct inp_text t;
    if (!r->instance)
        return true;
    const int end = r->numbers < TRANSLATION ? TRANSLATION : ALL;
    double *place = r->m->instance[r->instance - 1].place;
    while (r->numbers < end && inp_field(&r->m->lines, &t)) {
        if (t.n > 0 && !(inp_real(t, &place[r->numbers]) && isfinite(place[r->numbers])))
            return FAIL(r, "'%s' must be a number", inp_show(t).s);
        r->numbers++;
    }
    r->numbers = end;
    return true;
}

bool inp_end_instance(struct inp_reader *r)
{
    if (!r->instance || r->depth)
        return FAIL(r, "*END INSTANCE without *INSTANCE");
    r->instance = r->members = 0;
    return true;
}

bool inp_begin_assembly(struct inp_reader *r)
{
    struct inp_text t;
    if (!r->assembly && inp_parameter(&r->m->lines, "NAME", &t))
        r->assembly = new_text(t.s, t.n);
    return true;
}
