/* Input files of Abaqus and CalculiX: lines, tables of numbers and names, and the model as written. Shared by
 * evolve/input/inp_*.c and mesh.c; other files include mesh.h. */
#ifndef FOOTPOINT_INP_H
#define FOOTPOINT_INP_H

#include "../../codegen/base/base.h"

#include <stdint.h>
#include <sys/stat.h>

/* ---- lines: inp_line.c ---- */

/** A position in the input, for diagnostics. */
struct inp_place {
    int file, line; /* index into inp_lines.file; line from 1 */
};

/** Part of the text of an open file. It has no NUL at its end and is valid until the next line is read. */
struct inp_text {
    const char *s;
    size_t n;
};

/** Reader of lines. It drops blank lines and comments, follows *INCLUDE, and joins continued keyword lines. */
struct inp_lines {
    struct diag *d; /* not owned */
    struct inp_file {
        char *path; /* owned */
        dev_t device;
        ino_t inode;
    } * file; /* owned: every file opened so far */
    size_t files, file_room;
    struct inp_open {
        char *text;           /* owned */
        const char *at, *end; /* unread */
        char newline;         /* line terminator: a line feed, or a carriage return in files without line feeds */
        bool again;           /* a part that is read again, for an instance */
        struct inp_place place;
    } * open; /* owned: stack of the model, the file that it includes, and so on */
    size_t depth, open_room;
    int includes;
    char *notes; /* owned: lines "file:line: note: ..." about skipped input; or NULL */
    int noted;

    enum inp_kind { INP_END, INP_KEYWORD, INP_DATA } kind; /* of the current line */
    struct inp_place place;
    char keyword[32]; /* in capitals, without blanks and asterisk; truncated */
    struct inp_parameter {
        struct inp_text key, value;
    } * parameter; /* owned */
    size_t parameters, parameter_room;
    struct inp_text rest; /* of a data line */
    bool continues;       /* the data line ends with a comma */
};

bool inp_open(struct inp_lines *l, const char *path, struct diag *d);
void inp_close(struct inp_lines *l);

/** Reads the next line. Returns false with the diagnostic filled. */
bool inp_next(struct inp_lines *l);

/** Continues reading in another file and returns after it. The name is relative to the model's own folder, as in both
 *  codes, or to the folder of the including file if there is no such file. Returns false with the diagnostic filled. */
bool inp_include(struct inp_lines *l, struct inp_text name);

/** A position in a file from which to read again. */
struct inp_mark {
    struct inp_place place;
    size_t offset; /* of the line that follows */
};
/** Returns the place after the current line. */
struct inp_mark inp_here(const struct inp_lines *l);
/** Reads on from a mark until inp_go_back. Returns false with the diagnostic filled. */
bool inp_go_to(struct inp_lines *l, struct inp_mark mark);
void inp_go_back(struct inp_lines *l);

/** Finds the value of a keyword line's parameter (any case, blanks ignored). Returns false if it is absent. */
bool inp_parameter(const struct inp_lines *l, const char *key, struct inp_text *value);

/** Reads the next field of a data line, without its outer blanks and quotes. Returns false after the last. */
bool inp_field(struct inp_lines *l, struct inp_text *field);

/** Compares, ignoring case and blanks. */
bool inp_equals(struct inp_text t, const char *word);

/** Reads a node or element number, 1..INT_MAX. Returns false if the text is not a valid number. */
bool inp_number(struct inp_text t, int *number);

/** Reads a real number with exponent letter E or D, possibly not finite. Returns false if the text is not a number. */
bool inp_real(struct inp_text t, double *x);

/** Reports "file:line: error: ..."; returns false. */
bool inp_fail(const struct inp_lines *l, struct inp_place at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Notes "file:line: note: ...", each once, at most 20 in all. */
void inp_note(struct inp_lines *l, struct inp_place at, const char *format, ...) __attribute__((format(printf, 3, 4)));

/** Printable start of a text, for messages. */
struct inp_shown {
    char s[44];
};
struct inp_shown inp_show(struct inp_text t);

/* ---- tables: inp_table.c ---- */

/** Returns the key of a node or element number in an instance, from 1; instance 0 is the model itself. */
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
        size_t order; /* of definition, from 0: index of the entry's data */
    } * entry;        /* owned; ascending by key after inp_numbers_sort */
    size_t n, room;
};

void inp_numbers_add(struct inp_numbers *t, int64_t key, struct inp_place at);

/** Sorts the table. Returns the first entry in the file whose key is a duplicate, or NULL. */
const struct inp_entry *inp_numbers_sort(struct inp_numbers *t);

/** Returns the position of the first entry not below `key`, or t->n. The table must be sorted. */
size_t inp_numbers_find(const struct inp_numbers *t, int64_t key);

enum inp_what { INP_NODE, INP_ELEMENT };

/** Names of sets and surfaces, in any case. The four kinds of names are independent. */
struct inp_names {
    struct inp_name {
        char *text;     /* owned; as first spelt, without blanks */
        int set[2];     /* node set, element set: index into inp_model.set, or -1 */
        int surface[2]; /* of nodes, of element faces: index into inp_model.surface, or -1 */
    } * name;           /* owned */
    size_t n, room;
    void *tree; /* owned: of names.h, which returns indices into name */
};

/** Returns the index of a name, which is added if it is new. instance: the instance of "INSTANCE.NAME", or NULL. */
int inp_names_index(struct inp_names *t, const char *instance, struct inp_text name);
void inp_names_clear(struct inp_names *t);

/* ---- elements: inp_element.c ---- */

enum { INP_MAX_NODES = 27, INP_MAX_FACES = 6 };

/** Face S1..S6 of a solid is 0..5. A shell has only SNEG and SPOS, its 0 and 1. Its edges are S3 to S6 in CalculiX, E1
 *  to E4 in Abaqus. */
enum inp_face_label { INP_FACE_NONE = -1, INP_FACE_SNEG = INP_MAX_FACES, INP_FACE_SPOS, INP_FACE_EDGE };

struct inp_shape {
    int faces;
    struct {
        int corners; /* 2: an edge of a plane element */
        /* from 1: corners counter-clockwise seen from outside, then mid-side nodes, then the middle */
        unsigned char node[9];
    } face[INP_MAX_FACES];
};

/** Nodes of a face: corners; with mid-side nodes; with mid-side nodes and the middle. */
enum inp_order { INP_LINEAR, INP_QUADRATIC, INP_BIQUADRATIC };

struct inp_type {
    const char *name;
    int nodes;
    bool shell;
    enum inp_order order;
    const struct inp_shape *shape; /* NULL: a type without known faces, with any number of nodes */
};

/** Returns the element type for a name such as "C3D8R" (any case), or NULL. */
const struct inp_type *inp_type_find(struct inp_text name);

/** Reads a label: "S1".."S6", "SPOS", "SNEG", or an edge's or end's (any case). Returns false for other text. */
bool inp_face_read(struct inp_text t, int *label);
const char *inp_face_name(int label);

/** Returns the face of an element type with this label, INP_NO_FACE, or INP_EDGE for an edge of a shell. */
enum { INP_NO_FACE = -1, INP_EDGE = -2 };
int inp_face_index(const struct inp_type *type, int label);

/* ---- model: inp_read.c ---- */

/** The defined keys of first, first + step, ..., last; or all members of another set or a surface. */
struct inp_item {
    int name;            /* index into inp_names.name, or -1: numbers */
    bool lent;           /* nodes of the elements of that element set */
    const char *refused; /* not owned; why the item is not supported, or NULL */
    int64_t first, last;
    int step;
    int face; /* enum inp_face_label, in lines of element surfaces */
    struct inp_place at;
};

struct inp_items {
    struct inp_item *item; /* owned */
    size_t n, room;
};

enum inp_combine { INP_SINGLE, INP_UNION, INP_INTERSECTION, INP_DIFFERENCE };

/** Faces and nodes that a surface covers. */
struct inp_cover {
    unsigned char *face;           /* owned; indexed by position of the element, a bit for each face */
    unsigned char *node;           /* owned; indexed by position: 1 for nodes of elements without known faces */
    bool edges;                    /* it had edges of shells, which are skipped */
    const struct inp_entry *other; /* not owned: an element without known faces, or NULL */
    struct inp_place at;           /* the line that names it */
};

struct inp_model {
    struct inp_lines lines;
    struct inp_names names;
    struct inp_numbers nodes, elements;
    double (*xyz)[3]; /* owned; indexed by inp_entry.order; mesh length */
    size_t xyz_room;
    struct inp_element {
        const struct inp_type *type; /* not owned */
        size_t first;                /* index of its first node in connectivity */
        int nodes;
    } * element; /* owned; indexed by inp_entry.order */
    size_t element_room;
    struct inp_type **other; /* owned, with their names: element types without known faces */
    size_t others, other_room;
    int *connectivity; /* owned; positions in the sorted node table */
    size_t connections, connection_room;
    struct inp_set {
        struct inp_items items;
        size_t visit; /* number of the last search that visited it */
    } * set;          /* owned */
    size_t sets, set_room, visits;
    struct inp_surface {
        enum inp_what what;       /* lines are nodes or element faces */
        enum inp_combine combine; /* lines are names of surfaces to be combined */
        struct inp_place at;      /* its first line */
        struct inp_items items;
        struct inp_cover *cover; /* owned: of combined surfaces, once computed */
        bool open;               /* its cover is being computed */
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
        double place[10]; /* translation, then two points of an axis and the angle of rotation about it, in degrees */
    } * instance;         /* owned; numbered from 1 */
    size_t instances, instance_room;
    unsigned char *exposed; /* owned: indexed by position of the element, a bit for each face that no other element has;
                             * or NULL */
};

/** Reads a model, with node and element tables sorted and connectivity resolved. Returns NULL with *d filled. */
struct inp_model *inp_read(const char *path, struct diag *d);
void inp_free(struct inp_model *m);

/* ---- parts and instances: inp_assembly.c ---- */

/** Records where the text of a part begins: after the current line. Returns false with the diagnostic filled. */
bool inp_part_add(struct inp_model *m, struct inp_text name);
/** Adds an instance and starts reading the text of its part. Returns false with the diagnostic filled. */
bool inp_instance_add(struct inp_model *m, struct inp_text name, struct inp_text part);
/** Returns the instance with this name, from 1, or 0. */
int inp_instance_find(const struct inp_model *m, struct inp_text name);
/** Moves the nodes of all instances to their places. Numbers must be sorted. Returns false with the diagnostic
 *  filled. */
bool inp_instances_place(struct inp_model *m);

/* ---- sets: inp_sets.c ---- */

/** Positions in a table, or faces. */
struct inp_list {
    size_t *index; /* owned, by the caller even after an error; no duplicates */
    size_t n, room;
};

/** Adds the positions of the nodes or elements that a line of a surface names. Undefined members of sets are noted and
 *  skipped. Returns false with the diagnostic filled.
 *  @param[in,out] mark  1 for members of the list, by position */
bool inp_members(struct inp_model *m, enum inp_what what, const struct inp_item *line, struct inp_list *list,
                 unsigned char *mark);
struct inp_shown inp_name_shown(const struct inp_model *m, int name);

/* ---- surfaces: inp_surface.c ---- */

/** Finds the nodes of a contact pair's slave surface, made of nodes or otherwise of faces, as positions in the sorted
 *  node table. An element without known faces contributes all its nodes. *faces: the surface's faces, numbered as
 *  below. Both lists must be empty on entry and are ascending on return. Returns false with the diagnostic filled if a
 *  surface, set or number is not defined, or the surface is empty. */
bool inp_slave_nodes(struct inp_model *m, const struct inp_pair *pair, struct inp_list *nodes, struct inp_list *faces);

/** Finds the faces of a contact pair's master surface: INP_MAX_FACES * position in the sorted element table + face.
 *  Errors as above; also for a surface of nodes and for elements without known faces. */
bool inp_master_faces(struct inp_model *m, const struct inp_pair *pair, struct inp_list *faces);

void inp_cover_free(struct inp_cover *c);

/** Returns true if a surface with this name is made of faces. */
bool inp_has_faces(const struct inp_model *m, int name);

/** Finds m->exposed: faces of solids that are not shared with another solid (inp_exposed.c). */
void inp_find_exposed(struct inp_model *m);

/** Finds the nodes of such a face, counter-clockwise from outside, then mid-side nodes, as positions in the sorted node
 *  table. Returns their number. */
int inp_face_nodes(const struct inp_model *m, size_t face, int node[9]);

#endif
