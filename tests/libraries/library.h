/* Interface between a library's searches and the program that judges and times them (libraries_main.c). Each library
 * has one file here, built as a shared object with one function, library_open().
 *
 * Nodes of a face are ordered as in the generated headers: corners, mid-sides, centre. Local coordinates are theirs,
 * too: xi, eta in [-1,1] on quadrilaterals; xi, eta >= 0 and xi + eta <= 1 on triangles. */
#ifndef FOOTPOINT_LIBRARY_H
#define FOOTPOINT_LIBRARY_H

#ifdef __cplusplus
extern "C" {
#endif

enum library_kind { LIBRARY_QUAD4, LIBRARY_TRI6, LIBRARY_QUAD8, LIBRARY_QUAD9, LIBRARY_KINDS };
enum { LIBRARY_NODES = 9 };

/* The question that a search answers. */
enum library_question {
    LIBRARY_FOOT,    /* a point at which xS - r is normal to the face, on it or beside it */
    LIBRARY_INSIDE,  /* the same on the face; not judged if the closest point is no foot point */
    LIBRARY_CLOSEST, /* the closest point of the closed face */
    LIBRARY_POINT    /* local coordinates of a point on the face */
};

struct library_answer {
    double loc[2];
    double point[3]; /* used instead of loc if is_point is set */
    int is_point;
};

enum { LIBRARY_ANSWER, LIBRARY_NONE }; /* NONE: the library reports that there is no answer */

/** A search.  `kinds` is a set of bits 1 << kind. */
struct library_search {
    const char *name;
    unsigned kinds;
    enum library_question question;
    const char *note; /* the routine, and remarks about it */
    void *(*open)(int kind);
    void (*set)(void *work, const double *x); /* sets another face: nodes x 3 */
    int (*find)(void *work, const double xs[3], struct library_answer *a);
    void (*close)(void *work);
};

/** Computes first derivatives of xi, eta and gap of a four-node face by the coordinates of A, B, C, D, xS: d[3][15].
 *  loc: the foot point, to 1e-4 or better. Returns 0 if they do not exist. */
struct library_derivative {
    const char *name, *note;
    int (*differentiate)(const double *x, const double loc[2], double d[3][15]);
};

struct library {
    const char *name, *version;
    int searches;
    const struct library_search *search;
    int derivatives;
    const struct library_derivative *derivative;
};

#ifdef __GNUC__
__attribute__((visibility("default")))
#endif
const struct library *
library_open(void);

#ifdef __cplusplus
}
#endif

#endif
