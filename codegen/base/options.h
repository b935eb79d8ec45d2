/* Command lines. Each program has a table, from which options are read and checked, --help is printed, and a checkpoint
 * stores the run's options. --help (-h) and --version are not in the tables: every program has them. */
#ifndef FOOTPOINT_OPTIONS_H
#define FOOTPOINT_OPTIONS_H

#include "base.h"

enum option_kind {
    OPTION_TITLE,   /* not an option: its help is a line between others */
    OPTION_FLAG,    /* bool */
    OPTION_TEXT,    /* const char *, not owned */
    OPTION_MAYBE,   /* const char *, --option=TEXT; "" for --option without text */
    OPTION_WHOLE,   /* size_t, from low to high */
    OPTION_SEED,    /* uint64_t */
    OPTION_PART,    /* double, from 0 to high */
    OPTION_TIME,    /* double, seconds */
    OPTION_CHOICE,  /* an enum, an index into `choice` */
    OPTION_OWN,     /* parsed by `read` */
    OPTION_OPERAND, /* const char *, not owned: an argument that is not an option */
};

struct option_table;
struct option_row {
    const char *name;
    char letter; /* 0: no short form */
    enum option_kind kind;
    size_t at;         /* offset of the member in the program's struct */
    const char *value; /* "FILE"; choices name themselves */
    double low, high;
    const char *help;          /* its purpose, in a line of any length */
    const char *const *choice; /* ends with NULL */
    int role;                  /* for the program's own use */
    const char *refusal;       /* message for any bad value, with %s; NULL: the usual messages */
    bool (*read)(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                 struct diag *d);
};

/** No upper limit. */
#define OPTION_ANY 0x1p64

struct option_table {
    const char *program, *usage, *notes; /* notes: printed below the options */
    const struct option_row *row;
    size_t rows;
    const char *unknown, *lacking, *surplus; /* messages for an unknown option, a missing value, a surplus argument;
                                              * NULL: the usual messages */
};

enum options_outcome { OPTIONS_READ, OPTIONS_WRONG, OPTIONS_HELP, OPTIONS_VERSION };

/** Reads the command line into *values, which must contain the defaults. given: by row, set true for each option
 *  present; or NULL. Returns OPTIONS_WRONG with *d filled, code EXIT_USAGE, on failure. */
enum options_outcome options_read(const struct option_table *t, int argc, char **argv, void *values, bool *given,
                                  struct diag *d);

/** Prints help or version, as asked, to standard output. */
void options_tell(const struct option_table *t, enum options_outcome asked);
/** Returns the exit status of main() if there is nothing to do; prints help, version or the error. */
int options_end(const struct option_table *t, enum options_outcome outcome, struct diag *d);

/** Returns the row with this name, or t->rows. */
size_t option_find(const struct option_table *t, const char *name);
/** Sets a value, as on the command line. */
bool option_set(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                struct diag *d);
/** Writes a value as on the command line; returns false if the option has no value. */
bool option_text(const struct option_row *r, const void *values, char *text, size_t n);

/** Reads whole numbers within the row's limits, "8,8". Returns their number, most + 1 if there are more, or 0 with *d
 *  filled if one is invalid. */
size_t option_wholes(const struct option_table *t, const struct option_row *r, const char *text, size_t *value,
                     size_t most, struct diag *d);

/** Returns true if an option has a value; otherwise *d reports that it is missing. */
bool options_need(const struct option_table *t, const char *name, const char *value, struct diag *d);

/** Fills *d with "program: sentence", code EXIT_USAGE. Returns false. */
bool options_refuse(const struct option_table *t, struct diag *d, const char *sentence, ...)
    __attribute__((format(printf, 3, 4)));

#endif
