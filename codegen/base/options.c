/* Command lines from tables; see options.h. */
#include "options.h"

#include "text.h"

#include <ctype.h>
#include <getopt.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 40, FIRST = 256, HELP_COLUMN = 30, HELP_WIDTH = 118 };

bool options_refuse(const struct option_table *t, struct diag *d, const char *sentence, ...)
{
    va_list arguments;
    const int n = snprintf(d->text, sizeof d->text, "%s: ", t->program);
    va_start(arguments, sentence);
    vsnprintf(d->text + n, sizeof d->text - (size_t)n, sentence, arguments);
    va_end(arguments);
    d->code = EXIT_USAGE;
    return false;
}

bool options_need(const struct option_table *t, const char *name, const char *value, struct diag *d)
{
    return value || options_refuse(t, d, "error: --%s is missing; try --help", name);
}

/* Reports an error by the table's own sentence or the usual sentence. */
static enum options_outcome refuse_argument(const struct option_table *t, struct diag *d, const char *own,
                                            const char *usual, const char *argument)
{
    options_refuse(t, d, own ? own : usual, argument);
    return OPTIONS_WRONG;
}

static bool refuse_value(const struct option_table *t, const struct option_row *r, struct diag *d, const char *usual,
                         const char *text)
{
    return r->refusal ? options_refuse(t, d, r->refusal, text) : options_refuse(t, d, usual, r->name, text);
}

static bool read_whole(const struct option_table *t, const struct option_row *r, const char *text, uint64_t *value,
                       struct diag *d)
{
    unsigned long long v;
    if (!text_whole(text, &v))
        return refuse_value(t, r, d, "error: --%s needs a whole number, not '%s'", text);
    *value = v;
    return r->kind == OPTION_SEED || ((double)v >= r->low && (double)v <= r->high) ||
           refuse_value(t, r, d, "error: --%s %s is out of range", text);
}

static bool read_part(const struct option_table *t, const struct option_row *r, const char *text, double *value,
                      struct diag *d)
{
    char *rest;
    *value = strtod(text, &rest);
    if (rest == text || *rest)
        return refuse_value(t, r, d, "error: --%s needs a number, not '%s'", text);
    return (*value >= 0 && *value <= r->high) ||
           options_refuse(t, d, "error: --%s %s is out of range (0 to %g)", r->name, text, r->high);
}

/* Reads seconds, M:SS or H:MM:SS. */
static bool read_time(const struct option_table *t, const struct option_row *r, const char *text, double *value,
                      struct diag *d)
{
    const char *at = text;
    bool good = true;
    *value = 0;
    for (int part = 0; good; part++) {
        char *rest;
        const double v = strtod(at, &rest);
        good = part < 3 && isdigit((unsigned char)at[0]) && (part == 0 || v < 60);
        *value = *value * 60 + v;
        if (*rest != ':') {
            good = good && *rest == '\0';
            break;
        }
        at = rest + 1;
    }
    if (!good)
        return refuse_value(t, r, d, "error: --%s needs seconds or H:MM:SS, not '%s'", text);
    return *value <= 1e9 || refuse_value(t, r, d, "error: --%s %s is out of range", text);
}

bool option_set(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                struct diag *d)
{
    void *member = (char *)values + r->at;
    uint64_t whole = 0;
    switch (r->kind) {
    case OPTION_FLAG:
        return *(bool *)member = true;
    case OPTION_MAYBE:
        *(const char **)member = text ? text : "";
        return true;
    case OPTION_TEXT:
    case OPTION_OPERAND:
        *(const char **)member = text;
        return (*text && !strchr(text, '\n')) ||
               refuse_value(t, r, d, "error: --%s needs a name without line breaks", text);
    case OPTION_WHOLE:
        if (!read_whole(t, r, text, &whole, d))
            return false;
        *(size_t *)member = (size_t)whole;
        return true;
    case OPTION_SEED:
        return read_whole(t, r, text, member, d);
    case OPTION_PART:
        return read_part(t, r, text, member, d);
    case OPTION_TIME:
        return read_time(t, r, text, member, d);
    case OPTION_CHOICE:
        *(int *)member = text_word(text, r->choice);
        return *(int *)member >= 0 || refuse_value(t, r, d, "error: --%s has no choice '%s'", text);
    default:
        return r->read(t, r, text, values, d);
    }
}

bool option_text(const struct option_row *r, const void *values, char *text, size_t n)
{
    const void *member = (const char *)values + r->at;
    switch (r->kind) {
    case OPTION_TEXT: {
        const char *name = *(const char *const *)member;
        return name && snprintf(text, n, "%s", name) < (int)n;
    }
    case OPTION_SEED:
        return snprintf(text, n, "%llu", (unsigned long long)*(const uint64_t *)member) > 0;
    case OPTION_WHOLE:
        return snprintf(text, n, "%zu", *(const size_t *)member) > 0;
    case OPTION_PART:
    case OPTION_TIME:
        return snprintf(text, n, "%.17g", *(const double *)member) > 0;
    case OPTION_CHOICE:
        return snprintf(text, n, "%s", r->choice[*(const int *)member]) > 0;
    default:
        return false;
    }
}

size_t option_wholes(const struct option_table *t, const struct option_row *r, const char *text, size_t *value,
                     size_t most, struct diag *d)
{
    const char *at = text;
    for (size_t n = 0; n < most; at++) {
        const size_t length = strcspn(at, ",");
        char one[32];
        uint64_t whole = 0;
        snprintf(one, sizeof one, "%.*s", (int)(length < sizeof one ? length : sizeof one), at);
        if (length == 0)
            return refuse_value(t, r, d, "error: --%s needs whole numbers, not '%s'", text);
        if (!read_whole(t, r, one, &whole, d))
            return 0;
        value[n++] = (size_t)whole;
        at += length;
        if (!*at)
            return n;
    }
    return most + 1;
}

size_t option_find(const struct option_table *t, const char *name)
{
    for (size_t i = 0; i < t->rows; i++)
        if (t->row[i].name && strcmp(t->row[i].name, name) == 0)
            return i;
    return t->rows;
}

/* Builds the tables for getopt_long; its codes are FIRST and the row. */
static void describe(const struct option_table *t, struct option options[MOST + 1], char letters[2 * MOST])
{
    size_t n = 0, k = (size_t)snprintf(letters, 2 * MOST, ":h");
    for (size_t i = 0; i < t->rows; i++) {
        const struct option_row *r = &t->row[i];
        if (!r->name)
            continue;
        const int argument = r->kind == OPTION_FLAG    ? no_argument
                             : r->kind == OPTION_MAYBE ? optional_argument
                                                       : required_argument;
        options[n++] = (struct option){r->name, argument, NULL, FIRST + (int)i};
        if (r->letter)
            k += (size_t)snprintf(letters + k, 2 * MOST - k, "%c:", r->letter);
    }
    options[n++] = (struct option){"help", no_argument, NULL, 'h'};
    options[n++] = (struct option){"version", no_argument, NULL, OPTIONS_VERSION};
    options[n] = (struct option){NULL, 0, NULL, 0};
}

static size_t row_of_code(const struct option_table *t, int code)
{
    for (size_t i = 0; code < FIRST && i < t->rows; i++)
        if (t->row[i].letter == code)
            return i;
    return (size_t)(code - FIRST);
}

static size_t row_of_operand(const struct option_table *t)
{
    size_t i = 0;
    while (i < t->rows && t->row[i].kind != OPTION_OPERAND)
        i++;
    return i;
}

enum options_outcome options_read(const struct option_table *t, int argc, char **argv, void *values, bool *given,
                                  struct diag *d)
{
    struct option options[MOST + 1];
    char letters[2 * MOST];
    const size_t operand = row_of_operand(t);
    describe(t, options, letters);
    opterr = 0;
    optind = 0; /* GNU: restarts */
    for (int code; (code = getopt_long(argc, argv, letters, options, NULL)) != -1;) {
        if (code == 'h')
            return OPTIONS_HELP;
        if (code == OPTIONS_VERSION)
            return OPTIONS_VERSION;
        if (code == ':')
            return refuse_argument(t, d, t->lacking, "error: %s needs an argument", argv[optind - 1]);
        if (code == '?')
            return refuse_argument(t, d, t->unknown, "error: unknown option '%s'; try --help", argv[optind - 1]);
        const size_t i = row_of_code(t, code);
        if (!option_set(t, &t->row[i], optarg, values, d))
            return OPTIONS_WRONG;
        if (given)
            given[i] = true;
    }
    if (optind + (operand < t->rows ? 1 : 0) < argc)
        return refuse_argument(t, d, t->surplus, "error: '%s' is not an option; try --help", argv[optind]);
    return optind == argc || option_set(t, &t->row[operand], argv[optind], values, d) ? OPTIONS_READ : OPTIONS_WRONG;
}

static void print_row(const struct option_row *r)
{
    static const char indented[] = "\n                              ";
    char head[120];
    const char dash[] = {' ', ' ', '-', r->letter, ',', ' ', '\0'};
    int n = snprintf(head, sizeof head, "%s--%s", r->letter ? dash : "  ", r->name);
    if (r->value)
        n += snprintf(head + n, sizeof head - (size_t)n, " %s", r->value);
    for (const char *const *word = r->choice; word && *word; word++)
        n += snprintf(head + n, sizeof head - (size_t)n, "%c%s", word == r->choice ? ' ' : '|', *word);
    printf("%-*s", HELP_COLUMN, head);
    if (n >= HELP_COLUMN - 1)
        fputs(indented, stdout);
    print_broken(r->help, HELP_COLUMN, HELP_WIDTH, indented, NULL, stdout);
    putchar('\n');
}

void options_tell(const struct option_table *t, enum options_outcome asked)
{
    static const struct option_row help = {.name = "help", .letter = 'h', .help = "this text"},
                                   version = {.name = "version", .help = "version"};
    static char buffer[1 << 16]; /* written at once, so that whoever closes the stream sees the error */
    setvbuf(stdout, buffer, _IOFBF, sizeof buffer);
    if (asked == OPTIONS_VERSION) {
        printf("%s " FOOTPOINT_VERSION "\n", t->program);
        return;
    }
    printf("%s\n", t->usage);
    for (size_t i = 0; i < t->rows; i++)
        if (t->row[i].name)
            print_row(&t->row[i]);
        else if (t->row[i].help)
            printf("\n  %s:\n", t->row[i].help);
    print_row(&help);
    print_row(&version);
    if (t->notes)
        printf("\n%s", t->notes);
}

int options_end(const struct option_table *t, enum options_outcome outcome, struct diag *d)
{
    if (outcome != OPTIONS_WRONG)
        options_tell(t, outcome);
    return exit_status(outcome != OPTIONS_WRONG, d);
}
