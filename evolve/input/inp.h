/* Input files of Abaqus and CalculiX: lines, number and name tables, and the model as the file tells it.  What
 * evolve/inp_*.c and evolve/input/mesh.c share; everybody else includes mesh.h. */
#ifndef FOOTPOINT_INP_H
#define FOOTPOINT_INP_H

#include "../../codegen/base/base.h"

#include <stdint.h>
#include <sys/stat.h>

/* ---- lines: inp_line.c ---- */

/** Where something stands: for diagnostics. */
struct inp_place {
    int file, line; /* index into inp_lines.file; from 1 */
};

/** Part of the text of an open file: no NUL at its end; good until the next line is read. */
struct inp_text {
    const char *s;
    size_t n;
};

/** Reader of lines.  Blank lines and comments are dropped, *INCLUDE is followed, keyword lines are joined. */
struct inp_lines {
    struct diag *d; /* not owned */
    struct inp_file {
        char *path; /* owned */
        dev_t device;
        ino_t inode;
    } * file; /* owned: every file met so far */
    size_t files, file_room;
    struct inp_open {
        char *text;           /* owned */
        const char *at, *end; /* unread */
        char newline;         /* that ends its lines: a line feed, or in files without any a carriage return */
        bool again;           /* a part of it is read once more, for an instance */
        struct inp_place place;
    } * open; /* owned: the model, the file that it is including, and so on */
    size_t depth, open_room;
    int includes;
    char *notes; /* owned: lines about what was skipped, "file:line: note: ..."; or NULL */
    int noted;

    enum inp_kind { INP_END, INP_KEYWORD, INP_DATA } kind; /* of the current line */
    struct inp_place place;
    char keyword[32]; /* in capitals, without blanks and asterisk; cut off if longer */
    struct inp_parameter {
        struct inp_text key, value;
    } * parameter; /* owned */
    size_t parameters, parameter_room;
    struct inp_text rest; /* of a data line */
    bool continues;       /* the data line ends with a comma */
};

bool inp_open(struct inp_lines *l, const char *path, struct diag *d);
void inp_close(struct inp_lines *l);

/** Go to the next line.  False with the diagnostic filled. */
bool inp_next(struct inp_lines *l);

/** Reads on in another file and comes back after it.  The name is relative to the model's own folder, as in both codes, or
 *  to the folder of the including file if there is no such file.  False with the diagnostic filled. */
bool inp_include(struct inp_lines *l, struct inp_text name);

/** A place in a file, to read on from again. */
struct inp_mark {
    struct inp_place place;
    size_t offset; /* of the line after it */
};
/** Returns the place after the current line. */
struct inp_mark inp_here(const struct inp_lines *l);
/** Reads on from a mark until inp_go_back.  False with the diagnostic filled. */
bool inp_go_to(struct inp_lines *l, struct inp_mark mark);
void inp_go_back(struct inp_lines *l);

/** Value of a keyword line's parameter (any case, blanks ignored); false if there is none. */
bool inp_parameter(const struct inp_lines *l, const char *key, struct inp_text *value);

/** Next field of a data line, without its outer blanks and quotes; false after the last one. */
bool inp_field(struct inp_lines *l, struct inp_text *field);

/** Compare ignoring case and blanks. */
bool inp_equals(struct inp_text t, const char *word);

/** Node or element number, 1..INT_MAX; false if it is none. */
bool inp_number(struct inp_text t, int *number);

/** Real number with exponent letter E or D, possibly not finite; false if it is none. */
bool inp_real(struct inp_text t, double *x);

/** "file:line: error: ..." about a place; returns false. */
bool inp_fail(const struct inp_lines *l, struct inp_place at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Notes "file:line: note: ..." about a place, once, and no more than 20 of them. */
void inp_note(struct inp_lines *l, struct inp_place at, const char *format, ...) __attribute__((format(printf, 3, 4)));

/** Printable start of a text, for messages. */
struct inp_shown {
    char s[44];
};
struct inp_shown inp_show(struct inp_text t);

/* ---- tables: inp_table.c ---- */

/** A node or element number of an instance of a part, from 1; instance 0 is the model itself. */
static inline int64_t inp_key(int instance, int number)
{
    return ((int64_t)instance << 32) + number;
}
static inline int inp_instance_of(int64_t key)
{
    return (int)(key >> 32);
}
static inline int inp_number_of(int64_t key)
{
    return (int)(key & INT32_MAX);
}

/** Keys of nodes or elements, sparse and in any order. */
struct inp_numbers {
    struct inp_entry {
        int64_t key;
        struct inp_place at;
        size_t order; /* of definition, from 0: index of what belongs to it */
    } * entry;        /* owned; ascending by key after inp_numbers_sort */
    size_t n, room;
};

void inp_numbers_add(struct inp_numbers *t, int64_t key, struct inp_place at);

/** Sort; returns the first entry in the file whose key was taken already, or NULL. */
const struct inp_entry *inp_numbers_sort(struct inp_numbers *t);

/** Position of the first entry not below `key`, once sorted; t->n if there is none. */
size_t inp_numbers_find(const struct inp_numbers *t, int64_t key);

enum inp_what { INP_NODE, INP_ELEMENT };

/** Names of sets and surfaces, any case.  The four kinds of names do not disturb each other. */
struct inp_names {
    struct inp_name {
        char *text;     /* owned; as first spelt, without blanks */
        int set[2];     /* node set, element set: index into inp_model.set, or -1 */
        int surface[2]; /* of nodes, of element faces: index into inp_model.surface, or -1 */
    } * name;           /* owned */
    size_t n, room;
    void *tree; /* owned: of names.h, which give indices into name */
};

/** Index of a name, which is added if it is new.  `instance`, or NULL: the instance that the name is in, "INSTANCE.NAME". */
int inp_names_index(struct inp_names *t, const char *instance, struct inp_text name);
void inp_names_clear(struct inp_names *t);

/* ---- elements: inp_element.c ---- */

enum { INP_MAX_NODES = 27, INP_MAX_FACES = 6 };

/** Face S1..S6 of a solid is 0..5; a shell has SNEG and SPOS alone, which are its 0 and 1.  Its edges are S3 to S6 in
 *  CalculiX, E1 to E4 in Abaqus. */
enum inp_face_label { INP_FACE_NONE = -1, INP_FACE_SNEG = INP_MAX_FACES, INP_FACE_SPOS, INP_FACE_EDGE };

struct inp_shape {
    int faces;
    struct {
        int corners;
        /* from 1: corners counter-clockwise seen from outside, then the mid-side nodes, then the middle */
        unsigned char node[9];
    } face[INP_MAX_FACES];
};

/** Nodes of a face: its corners; mid-side nodes, too; and one in the middle. */
enum inp_order { INP_LINEAR, INP_QUADRATIC, INP_BIQUADRATIC };

struct inp_type {
    const char *name;
    int nodes;
    bool shell;
    enum inp_order order;
    const struct inp_shape *shape; /* NULL: none of the types whose faces are known; any number of nodes */
};

/** Element type of a name such as "C3D8R" (any case), or NULL. */
const struct inp_type *inp_type_find(struct inp_text name);

/** Label "S1".."S6", "SPOS", "SNEG", or that of an edge or an end (any case); false if it is none. */
bool inp_face_read(struct inp_text t, int *label);
const char *inp_face_name(int label);

/** Face of an element type with this label, INP_NO_FACE, or INP_EDGE: an edge of a shell. */
enum { INP_NO_FACE = -1, INP_EDGE = -2 };
int inp_face_index(const struct inp_type *type, int label);

/* ---- model: inp_read.c ---- */

/** The defined keys of first, first + step, ..., last; or all of another set, or a surface. */
struct inp_item {
    int name;            /* index into inp_names.name, or -1: numbers */
    bool lent;           /* nodes of the elements of that element set */
    const char *refused; /* not owned; why it stands for something that is not supported, or NULL */
    int64_t first, last;
    int step;
    int face; /* enum inp_face_label, on lines of element surfaces */
    struct inp_place at;
};

struct inp_items {
    struct inp_item *item; /* owned */
    size_t n, room;
};

enum inp_combine { INP_SINGLE, INP_UNION, INP_INTERSECTION, INP_DIFFERENCE };

/** Faces and nodes that a surface covers. */
struct inp_cover {
    unsigned char *face;           /* owned; by position of the element, a bit for each face */
    unsigned char *node;           /* owned; by position: 1 for nodes of elements whose faces are not known */
    bool edges;                    /* it had edges of shells, which are left out */
    const struct inp_entry *other; /* not owned: an element whose faces are not known, or NULL */
    struct inp_place at;           /* the line that names it */
};

struct inp_model {
    struct inp_lines lines;
    struct inp_names names;
    struct inp_numbers nodes, elements;
    double (*xyz)[3]; /* owned; by inp_entry.order; mesh length */
    size_t xyz_room;
    struct inp_element {
        const struct inp_type *type; /* not owned */
        size_t first;                /* of its nodes in connectivity */
        int nodes;
    } * element; /* owned; by inp_entry.order */
    size_t element_room;
    struct inp_type **other; /* owned, with their names: element types whose faces are not known */
    size_t others, other_room;
    int *connectivity; /* owned; positions in the sorted node table */
    size_t connections, connection_room;
    struct inp_set {
        struct inp_items items;
        size_t visit; /* last search that came by */
    } * set;          /* owned */
    size_t sets, set_room, visits;
    struct inp_surface {
        enum inp_what what;       /* lines are nodes or element faces */
        enum inp_combine combine; /* lines are names of surfaces that are combined */
        struct inp_place at;      /* where it begins */
        struct inp_items items;
        struct inp_cover *cover; /* owned: of combined surfaces, once it is known */
        bool open;               /* its cover is being found */
    } * surface;                 /* owned */
    size_t surfaces, surface_room;
    struct inp_pair {
        enum inp_pair_kind { INP_CONTACT, INP_INCLUSION, INP_TIE } kind;
        int slave, master; /* indices into inp_names.name; equal for self contact */
        struct inp_place at;
    } * pair; /* owned */
    size_t pairs, pair_room;
    struct inp_part {
        char *name; /* owned */
        struct inp_mark text;
    } * part; /* owned */
    size_t parts, part_room;
    struct inp_instance {
        char *name;       /* owned */
        double place[10]; /* translation; then two points of an axis and the angle of rotation about it, degrees */
    } * instance;         /* owned; of number 1 and on */
    size_t instances, instance_room;
    unsigned char *exposed; /* owned: by position of the element, a bit for each face that no other has; or NULL */
};

/** Read a model; node and element tables come sorted, connectivity resolved.  NULL with *d filled. */
struct inp_model *inp_read(const char *path, struct diag *d);
void inp_free(struct inp_model *m);

/* ---- parts and instances: inp_assembly.c ---- */

/** Remembers where the text of a part begins: after the current line.  False with the diagnostic filled. */
bool inp_part_add(struct inp_model *m, struct inp_text name);
/** Adds an instance and goes to the text of its part.  False with the diagnostic filled. */
bool inp_instance_add(struct inp_model *m, struct inp_text name, struct inp_text part);
/** Returns the instance of that name, from 1, or 0. */
int inp_instance_find(const struct inp_model *m, struct inp_text name);
/** Moves the nodes of all instances to their places, once numbers are sorted.  False with the diagnostic filled. */
bool inp_instances_place(struct inp_model *m);

/* ---- sets: inp_sets.c ---- */

/** Positions in a table, or faces. */
struct inp_list {
    size_t *index; /* owned, by the caller even after an error; each once */
    size_t n, room;
};

/** Adds the positions of the nodes or elements that a line of a surface names.  Those of sets that are not defined are noted
 *  and skipped.  False with the diagnostic filled.
 *  @param[in,out] mark  1 for members of the list, by position */
bool inp_members(struct inp_model *m, enum inp_what what, const struct inp_item *line, struct inp_list *list,
                 unsigned char *mark);
struct inp_shown inp_name_shown(const struct inp_model *m, int name);

/* ---- surfaces: inp_surface.c ---- */

/** Nodes of a contact pair's slave surface, of nodes or, where there is none, of faces: positions in the sorted node
 *  table.  An element whose faces are not known lends all its nodes.  *faces: the surface's faces, numbered as below.  Both
 *  lists empty on entry, ascending on return.  False with the diagnostic filled: surface, set or number not defined, or nothing in it. */
bool inp_slave_nodes(struct inp_model *m, const struct inp_pair *pair, struct inp_list *nodes, struct inp_list *faces);

/** Faces of a contact pair's master surface: INP_MAX_FACES * position in the sorted element table + face.  Errors as
 *  above, a surface made of nodes, and elements whose faces are not known. */
bool inp_master_faces(struct inp_model *m, const struct inp_pair *pair, struct inp_list *faces);

void inp_cover_free(struct inp_cover *c);

/** Returns true if a surface of that name is made of faces. */
bool inp_has_faces(const struct inp_model *m, int name);

/** Finds m->exposed: faces of solids that are no face of another solid (inp_exposed.c). */
void inp_find_exposed(struct inp_model *m);

/** Nodes of such a face, counter-clockwise from outside, then mid-side nodes: positions in the sorted node table.
 *  Returns how many. */
int inp_face_nodes(const struct inp_model *m, size_t face, int node[9]);

#endif
