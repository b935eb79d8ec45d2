/* Search trees of names, so that files of any size are read in bounded time. */
#ifndef FOOTPOINT_NAMES_H
#define FOOTPOINT_NAMES_H

#include <stddef.h>

enum name_kind { NAME_NUMBER, NAME_VECTOR, NAME_FUNCTION, NAME_CONSTANT };

/** Room for the longest name, a component of a vector, with its NUL. */
enum { NAME_ROOM = 65 };

/** Marks a name that no statement defines, such as an input's. */
#define NO_STATEMENT ((size_t)-1)

/** The meaning of a name: a number's gene, the gene of a vector's first component, or an index. */
struct name {
    enum name_kind kind;
    int gene;
    size_t statement; /* statement that defines it */
    char text[];
};

/** Returns the name, or NULL if the tree does not contain it. The root of an empty tree is NULL. */
const struct name *names_find(void *const *tree, const char *text);
/** Adds a name, which must be new. */
void names_add(void **tree, const char *text, enum name_kind kind, int gene, size_t statement);
void names_free(void *tree);

#endif
