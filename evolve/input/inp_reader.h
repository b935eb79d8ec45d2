/* State of the reader of input files, and the handlers of its keywords: what inp_item.c and inp_read*.c share. */
#ifndef FOOTPOINT_INP_READER_H
#define FOOTPOINT_INP_READER_H

#include "inp.h"

struct inp_reader {
    struct inp_model *m;
    size_t set;                  /* that receives nodes or elements, if any */
    bool in_set, run, generate;  /* run: its last item may grow */
    enum inp_what what;          /* of the set or surface */
    size_t surface;              /* that receives lines */
    bool skip;                   /* the lines are of a surface that is not supported */
    bool open;                   /* the last element goes on in the next line */
    const struct inp_type *type; /* of the elements */
    bool needs_pair;             /* *CONTACT PAIR without a data line so far */
    enum inp_pair_kind kind;     /* of the pairs */
    struct inp_place keyword;
    struct inp_place begun; /* the instance */
    int instance;           /* that nodes, elements and names belong to; 0: the model itself */
    int members;            /* that members of the set belong to */
    size_t depth;           /* of the file whose part is passed over or read again; 0: none is */
    bool over;              /* it is passed over */
    int numbers;            /* of the instance's place so far */
    char *assembly;         /* owned: its name; NULL: there is none */
};

#define FAIL(r, ...) inp_fail(&(r)->m->lines, (r)->m->lines.place, __VA_ARGS__)

/* ---- names, numbers and items: inp_item.c ---- */

bool inp_read_number(struct inp_reader *r, struct inp_text t, int *number);
/** A name of an instance, or, for instance 0, of the model, which may be written ASSEMBLY.NAME. */
bool inp_read_name(struct inp_reader *r, int instance, struct inp_text t, int *name);
/** Takes "INSTANCE." off a member of a set or surface; returns the instance, or that of all members. */
int inp_read_instance(const struct inp_reader *r, struct inp_text *t);
/** Member of a set or surface: a number, or the name of a set. */
bool inp_read_member(struct inp_reader *r, struct inp_text t, struct inp_item *item);
void inp_add_item(struct inp_items *items, struct inp_item item);
/** Chooses the instance that INSTANCE= names, or that is open, for members. */
bool inp_choose_instance(struct inp_reader *r);
/** Data lines may lie in a file of their own. */
bool inp_follow_input(struct inp_reader *r);

/* ---- surfaces and pairs: inp_read_surface.c ---- */

bool inp_begin_surface(struct inp_reader *r);
bool inp_read_surface(struct inp_reader *r);
bool inp_begin_pair(struct inp_reader *r);
bool inp_begin_inclusions(struct inp_reader *r);
bool inp_begin_tie(struct inp_reader *r);
bool inp_read_pair(struct inp_reader *r);
bool inp_read_inclusion(struct inp_reader *r);
bool inp_read_tie(struct inp_reader *r);

/* ---- parts and instances: inp_read_part.c ---- */

bool inp_begin_part(struct inp_reader *r);
bool inp_end_part(struct inp_reader *r);
bool inp_begin_assembly(struct inp_reader *r);
bool inp_begin_instance(struct inp_reader *r);
bool inp_end_instance(struct inp_reader *r);
bool inp_read_place(struct inp_reader *r);

#endif
