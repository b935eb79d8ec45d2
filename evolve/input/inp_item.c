/* Names, numbers and members in the lines of an input file, in the open instance or in an instance that they name. */
#include "inp_reader.h"

#include <ctype.h>
#include <string.h>

bool inp_read_number(struct inp_reader *r, struct inp_text t, int *number)
{
    return inp_number(t, number) || FAIL(r, "'%s' must be a whole number from 1 to 2147483647", inp_show(t).s);
}

bool inp_read_name(struct inp_reader *r, int instance, struct inp_text t, int *name)
{
    const size_t n = r->assembly ? strlen(r->assembly) : 0;
    if (n > 0 && t.n > n + 1 && t.s[n] == '.' && inp_equals((struct inp_text){t.s, n}, r->assembly))
        t = (struct inp_text){t.s + n + 1, t.n - n - 1};
    bool blank = true;
    for (size_t i = 0; i < t.n; i++)
        blank = blank && isspace((unsigned char)t.s[i]);
    *name = blank ? 0 : inp_names_index(&r->m->names, instance ? r->m->instance[instance - 1].name : NULL, t);
    return !blank || FAIL(r, "name expected");
}

void inp_add_item(struct inp_items *items, struct inp_item item)
{
    APPEND(items->item, items->n, items->room) = item;
}

int inp_read_instance(const struct inp_reader *r, struct inp_text *t)
{
    const char *dot = memchr(t->s, '.', t->n);
    const size_t n = dot ? (size_t)(dot - t->s) : 0;
    const int instance = dot ? inp_instance_find(r->m, (struct inp_text){t->s, n}) : 0;
    if (!instance)
        return r->members;
    *t = (struct inp_text){dot + 1, t->n - n - 1};
    return instance;
}

bool inp_read_member(struct inp_reader *r, struct inp_text t, struct inp_item *item)
{
    const int instance = inp_read_instance(r, &t);
    int number = 0;
    *item = (struct inp_item){.name = -1, .step = 1, .face = INP_FACE_NONE, .at = r->m->lines.place};
    bool digits = t.n > 0;
    for (size_t i = 0; i < t.n; i++)
        digits &= isdigit((unsigned char)t.s[i]) || t.s[i] == '-' || t.s[i] == '+';
    if (!digits)
        return inp_read_name(r, instance, t, &item->name);
    if (!inp_read_number(r, t, &number))
        return false;
    item->first = item->last = inp_key(instance, number);
    return true;
}

bool inp_follow_input(struct inp_reader *r)
{
    struct inp_text file;
    return inp_parameter(&r->m->lines, "INPUT", &file) ? inp_include(&r->m->lines, file) : true;
}

bool inp_choose_instance(struct inp_reader *r)
{
    struct inp_text t;
    r->members = r->instance;
    if (!inp_parameter(&r->m->lines, "INSTANCE", &t))
        return true;
    r->members = inp_instance_find(r->m, t);
    return r->members || FAIL(r, "instance '%s' is not defined", inp_show(t).s);
}
