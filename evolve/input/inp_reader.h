/* State of the reader of input files and handlers of its keywords, shared by inp_item.c and inp_read*.c. */
#ifndef FOOTPOINT_INP_READER_H
#define FOOTPOINT_INP_READER_H

#include "inp.h"

struct inp_reader {
    struct inp_model *m;
    size_t set;                  /* open set for nodes or elements, if any */
    bool in_set, run, generate;  /* run: the last item of the set may grow */
    enum inp_what what;          /* of the set or surface */
    size_t surface;              /* open surface */
    bool skip;                   /* lines belong to an unsupported surface */
    bool open;                   /* the last element continues on the next line */
    const struct inp_type *type; /* of the elements */
    bool needs_pair;             /* a *CONTACT PAIR has no data line yet */
    enum inp_pair_kind kind;     /* of the pairs */
    struct inp_place keyword;
    struct inp_place begun; /* the instance */
    int instance;           /* instance of nodes, elements and names; 0: the model itself */
    int members;            /* instance of the set's members */
    size_t depth;           /* of the file whose part is skipped or read again; 0: not in a part */
    bool over;              /* the part is skipped */
    int numbers;            /* numbers of the instance's place read so far */
    char *assembly;         /* owned: its name, or NULL */
};

#define FAIL(r, ...) inp_fail(&(r)->m->lines, (r)->m->lines.place, __VA_ARGS__)

/* ---- names, numbers and items: inp_item.c ---- */

bool inp_read_number(struct inp_reader *r, struct inp_text t, int *number);
/** Reads a name in an instance; for instance 0, in the model, where it may be written ASSEMBLY.NAME. */
bool inp_read_name(struct inp_reader *r, int instance, struct inp_text t, int *name);
/** Removes "INSTANCE." from a member of a set or surface; returns that instance, or the common instance of all
 *  members. */
int inp_read_instance(const struct inp_reader *r, struct inp_text *t);
/** Reads a member of a set or surface: a number, or the name of a set. */
bool inp_read_member(struct inp_reader *r, struct inp_text t, struct inp_item *item);
void inp_add_item(struct inp_items *items, struct inp_item item);
/** Chooses the instance of members: the instance that INSTANCE= names, or the open instance. */
bool inp_choose_instance(struct inp_reader *r);
/** Follows INPUT=, a separate file of data lines. */
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
