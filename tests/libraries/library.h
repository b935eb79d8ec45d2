/* What the searches of a library look like to the program that judges and times them (libraries_main.c).  Each library
 * has one file here, which is built as a shared object with one function, library_open().
 *
 * A face has its nodes in the order of the generated headers: corners, middles of edges, centre.  Local coordinates are
 * theirs, too: xi, eta in [-1,1] on quadrilaterals, xi, eta >= 0 and xi + eta <= 1 on triangles. */
#ifndef FOOTPOINT_LIBRARY_H
#define FOOTPOINT_LIBRARY_H

#ifdef __cplusplus
extern "C" {
#endif

enum library_kind { LIBRARY_QUAD4, LIBRARY_TRI6, LIBRARY_QUAD8, LIBRARY_QUAD9, LIBRARY_KINDS };
enum { LIBRARY_NODES = 9 };

/* What is asked for. */
enum library_question {
    LIBRARY_FOOT,    /* where xS - r is normal to the face, on it or beside it */
    LIBRARY_INSIDE,  /* the same on the face alone: not judged where the closest point of the face is none */
    LIBRARY_CLOSEST, /* the closest point of the closed face */
    LIBRARY_POINT    /* local coordinates of a point that lies on the face */
};

struct library_answer {
    double loc[2];
    double point[3]; /* what counts instead of loc, if is_point */
    int is_point;
};

enum { LIBRARY_ANSWER, LIBRARY_NONE }; /* NONE: it says that it has none */

/** A search.  `kinds` is a set of bits 1 << kind. */
struct library_search {
    const char *name;
    unsigned kinds;
    enum library_question question;
    const char *note; /* which routine, and what is to be known of it */
    void *(*open)(int kind);
    void (*set)(void *work, const double *x); /* another face: nodes x 3 */
    int (*find)(void *work, const double xs[3], struct library_answer *a);
    void (*close)(void *work);
};

/** First derivatives of xi, eta and gap of a four-node face by the coordinates of A, B, C, D, xS: d[3][15].  loc: the
 *  foot point, to 1e-4 or better.  0: it has none. */
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
