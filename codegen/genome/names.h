/* Search trees of names, so that files of any size read in bounded time. */
#ifndef FOOTPOINT_NAMES_H
#define FOOTPOINT_NAMES_H

#include <stddef.h>

enum name_kind { NAME_NUMBER, NAME_VECTOR, NAME_FUNCTION, NAME_CONSTANT };

/** Longest name, that of a component of a vector, with its NUL. */
enum { NAME_ROOM = 65 };

/** A name that no statement defines, such as an input's. */
#define NO_STATEMENT ((size_t)-1)

/** What a name stands for: a number's gene, that of a vector's first component, or an index. */
struct name {
    enum name_kind kind;
    int gene;
    size_t statement; /* that defines it */
    char text[];
};

/** NULL if the tree, whose root is NULL while it is empty, has no such name. */
const struct name *names_find(void *const *tree, const char *text);
/** Adds a name that is new. */
void names_add(void **tree, const char *text, enum name_kind kind, int gene, size_t statement);
void names_free(void *tree);

#endif
