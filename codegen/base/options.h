/* Command lines: one table for each program, from which its options are read and checked, --help is printed, and a
 * checkpoint keeps what a run was told.  --help (-h) and --version are in no table: each program has them. */
#ifndef FOOTPOINT_OPTIONS_H
#define FOOTPOINT_OPTIONS_H

#include "base.h"

enum option_kind {
    OPTION_TITLE,   /* none: its help is a line between others */
    OPTION_FLAG,    /* bool */
    OPTION_TEXT,    /* const char *, not owned */
    OPTION_MAYBE,   /* the same, --option=TEXT; "" of --option alone */
    OPTION_WHOLE,   /* size_t, from low to high */
    OPTION_SEED,    /* uint64_t */
    OPTION_PART,    /* double, from 0 to high */
    OPTION_TIME,    /* double, seconds */
    OPTION_CHOICE,  /* an enum, which counts the words of `choice` */
    OPTION_OWN,     /* what `read` makes of it */
    OPTION_OPERAND, /* const char *, not owned: the argument that is no option */
};

struct option_table;
struct option_row {
    const char *name;
    char letter; /* 0: none */
    enum option_kind kind;
    size_t at;         /* the member's offset in the program's struct */
    const char *value; /* "FILE"; choices are their own */
    double low, high;
    const char *help;          /* what it is for, in one line of any length */
    const char *const *choice; /* ends with NULL */
    int role;                  /* the program's own */
    const char *refusal;       /* said of any bad value, %s; NULL: the usual sentences */
    bool (*read)(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                 struct diag *d);
};

/** No upper limit. */
#define OPTION_ANY 0x1p64

struct option_table {
    const char *program, *usage, *notes; /* notes: printed below the options */
    const struct option_row *row;
    size_t rows;
    const char *unknown, *lacking, *surplus; /* said of an option, one without value, an argument; NULL: as usual */
};

enum options_outcome { OPTIONS_READ, OPTIONS_WRONG, OPTIONS_HELP, OPTIONS_VERSION };

/** Read the command line into *values, which holds what is valid otherwise.  given: by row, set true where it occurs;
 *  or NULL.  OPTIONS_WRONG with *d filled, code EXIT_USAGE. */
enum options_outcome options_read(const struct option_table *t, int argc, char **argv, void *values, bool *given,
                                  struct diag *d);

/** Print what was asked for, help or version, to standard output. */
void options_tell(const struct option_table *t, enum options_outcome asked);
/** What main() returns where there is nothing to do: help and version are printed, or what is wrong. */
int options_end(const struct option_table *t, enum options_outcome outcome, struct diag *d);

/** The row of that name, or t->rows. */
size_t option_find(const struct option_table *t, const char *name);
/** One value, as on the command line. */
bool option_set(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                struct diag *d);
/** A value as the command line would have it; false where there is none. */
bool option_text(const struct option_row *r, const void *values, char *text, size_t n);

/** Whole numbers within the row's limits, "8,8": how many, most + 1 if there are more, 0 with *d if one is none. */
size_t option_wholes(const struct option_table *t, const struct option_row *r, const char *text, size_t *value,
                     size_t most, struct diag *d);

/** Whether an option has a value; else *d says that it is missing. */
bool options_need(const struct option_table *t, const char *name, const char *value, struct diag *d);

/** Fill *d with "program: sentence", code EXIT_USAGE.  Returns false. */
bool options_refuse(const struct option_table *t, struct diag *d, const char *sentence, ...)
    __attribute__((format(printf, 3, 4)));

#endif
