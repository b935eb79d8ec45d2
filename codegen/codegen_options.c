/* Reads the command line; see codegen_options.h. */
#include "codegen_options.h"

#include "compile/explain.h"
#include "print/header/header_edge.h"

#include <ctype.h>
#include <string.h>

/* Writes the prefix: "path/Some-name.h" becomes "some-name" as a C identifier that begins with footpoint_. */
static void prefix_from_path(const char *path, const char *ending, char prefix[160])
{
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    const bool has = strncmp(name, "footpoint_", 10) == 0;
    const size_t n = (size_t)snprintf(prefix, 160, "%s%.100s", has ? "" : "footpoint_", name), tail = strlen(ending);
    if (n > tail && strcmp(prefix + n - tail, ending) == 0)
        prefix[n - tail] = '\0';
    for (char *c = prefix; *c; c++)
        if (!isalnum((unsigned char)*c) || (unsigned char)*c > 127)
            *c = '_';
}

static bool is_identifier(const char *name)
{
    if (!isalpha((unsigned char)*name) || (unsigned char)*name > 127 || strlen(name) > 100)
        return false;
    for (; *name; name++)
        if ((unsigned char)*name > 127 || !(isalnum((unsigned char)*name) || *name == '_'))
            return false;
    return true;
}

static bool read_prefix(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                        struct diag *d)
{
    char *prefix = (char *)values + r->at;
    if (!is_identifier(text))
        return options_refuse(t, d, r->refusal, text);
    snprintf(prefix, CODEGEN_PREFIX, "%s", text);
    return true;
}

static bool read_without(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                         struct diag *d)
{
    /* in the order of enum left_out */
    static const char *const passes[] = {"nothing", "combine", "dissolve",   "factor", "join",   "differences", "early",
                                         "horner",  "sharing", "distribute", "scales", "groups", "multiples",   NULL};
    int *without = (int *)((char *)values + r->at);
    *without = text_word(text, passes);
    return *without >= 0 || options_refuse(t, d, r->refusal, text);
}

static const char *const languages[] = {"c", "c++", "fortran", "infix", "latex", NULL};
static const char *const precisions[] = {"double", "float", NULL};

#define AT(member) offsetof(struct codegen_options, member)
static const struct option_row rows[] = {
    {.kind = OPTION_OPERAND, .at = AT(genomes), .refusal = "one genome file, please (try --help)"},
    {"output", 'o', OPTION_TEXT, AT(output), "FILE",
     .help = "file to write; its name without .h (.hpp, .f90) begins every function's name"},
    {"prefix", 0, OPTION_OWN, AT(prefix), "NAME", .read = read_prefix, .refusal = "not a C identifier: %s (try --help)",
     .help = "begin the names with NAME instead"},
    {"language", 0, OPTION_CHOICE, AT(language), .choice = languages, .refusal = "unknown language: %s (try --help)",
     .help = "c++: function templates for numbers of any type; fortran: a module; infix, latex: a formula a line "
             "(default: c)"},
    {"precision", 0, OPTION_CHOICE, AT(unit.precision), .choice = precisions,
     .refusal = "unknown precision: %s (try --help)",
     .help = "of the code (default: what the genomes' scene says, or double)"},
    {"samples", 0, OPTION_TEXT, AT(samples), "FILE",
     .help = "of footpoint-evolve --samples: float code of a segment is measured on them, takes edges of any size, and "
             "begins its proofs with the function that fits"},
    {"points", 0, OPTION_TEXT, AT(points), "FILE",
     .help = "write test points to FILE, a C header for your tests: inputs, exact outputs and allowed errors"},
    {"allow-poles", 0, OPTION_FLAG, AT(unit.allow_poles),
     .help = "accept genomes that may divide by 0: functions of scalars then return a status"},
    {"edge", 0, OPTION_TEXT, AT(edge), "KIND",
     .help = "instead of genomes: write the header of edge2 or edge3, for contact in the plane"},
    {"count", 0, OPTION_FLAG, AT(count), .help = "operation counts to standard output"},
    {.kind = OPTION_TITLE, .help = "search for the cheapest form"},
    {"cost", 0, OPTION_TEXT, AT(cost), "MODEL",
     .help = "throughput (default), operations, paper, or a file that footpoint-calibrate wrote"},
    {"effort", 0, OPTION_WHOLE, AT(effort), "N", 0, 1000000000,
     .refusal = "effort is a number from 0 to 1000000000, not %s (try --help)",
     .help = "work that the search may do (default: 2000); same effort, same bytes"},
    {"seed", 0, OPTION_SEED, AT(seed), "N",
     .refusal = "the seed is a number from 0 to 18446744073709551615, not %s (try --help)",
     .help = "seed of the search (default: 1)"},
    {"explain", 0, OPTION_MAYBE, AT(explain),
     .help = "each pass and its counts to standard error; --explain=PASS: and the graph after that pass in infix, e.g. "
             "--explain=horner"},
    {"without", 0, OPTION_OWN, AT(unit.compile.without), "PASS", .read = read_without,
     .refusal = "unknown pass: %s (see the manual page)", .help = "leave a pass out, to measure what it is worth"},
    {.kind = OPTION_TITLE, .help = "messages"},
    {"quiet", 0, OPTION_FLAG, AT(unit.quiet),
     .help = "say nothing while working (otherwise on standard error: a line for each function written; on a terminal "
             "one line, with the time left)"}};

const struct option_table codegen_option_table = {
    .program = "footpoint-codegen",
    .usage =
        "usage: footpoint-codegen GENOMES -o FILE       write code: a header of static inline C functions\n"
        "       footpoint-codegen --edge KIND -o FILE   write the header of an edge\n"
        "       footpoint-codegen --count GENOMES       print genome,mul,div,add,sqrt,compare of each genome as CSV\n",
    .notes =
        "Every function is checked to equal its genome in exact rational arithmetic before anything is written.\n"
        "Infix is read by Python, SymPy, Maxima and FORM: constants are exact quotients, pdiv(a,b) is a/b, and 1\n"
        "where b is 0.  NAME_n, the loop over arrays in C, vectorises with -O3, and needs -fno-math-errno for square\n"
        "roots and -fno-trapping-math for protected quotients (where inputs are no segment's, for minima and maxima,\n"
        "too); neither changes a result.\n"
        "Exit status: 0 done, 1 input rejected, 2 usage, 3 memory or I/O.\n",
    .row = rows,
    .rows = sizeof rows / sizeof *rows,
    .unknown = "unknown option or missing value: %s (try --help)",
    .lacking = "unknown option or missing value: %s (try --help)",
    .surplus = "one genome file, please (try --help)"};

static const char *ending_of(enum language language)
{
    return language == LANGUAGE_FORTRAN ? ".f90" : language == LANGUAGE_GENERIC ? ".hpp" : ".h";
}

/* Completes the options for an edge, whose header has no genomes; only its names and precision can be chosen. */
static bool complete_edge(struct codegen_options *o, const bool *given, struct diag *d)
{
    static const char *const allowed[] = {"edge", "output", "prefix", "precision", "quiet"};
    const struct option_table *t = &codegen_option_table;
    size_t options = 0, known = 0;
    for (size_t i = 0; i < t->rows; i++)
        options += given[i];
    for (size_t i = 0; i < sizeof allowed / sizeof *allowed; i++)
        known += given[option_find(t, allowed[i])];
    if (options > known)
        return options_refuse(t, d, "--edge goes with -o FILE, --prefix, --precision and --quiet only (try --help)");
    if (o->genomes || !o->output)
        return options_refuse(t, d, "--edge goes with -o FILE, and no genome file (try --help)");
    if (!edge_find(o->edge))
        return options_refuse(t, d, "unknown edge: %s; there are edge2 and edge3", o->edge);
    if (!*o->prefix)
        prefix_from_path(o->output, ".h", o->prefix);
    return true;
}

/* Fills in options that follow from others. Returns false with *d filled if options contradict each other. */
static bool complete(struct codegen_options *o, const bool *given, struct diag *d)
{
    const struct option_table *t = &codegen_option_table;
    struct compile_options *compile = &o->unit.compile;
    if (o->edge)
        return complete_edge(o, given, d);
    if (!o->genomes)
        return options_refuse(t, d, "one genome file, please (try --help)");
    if (o->count == (o->output != NULL))
        return options_refuse(t, d, "either -o FILE or --count, please (try --help)");
    if (o->count && o->points)
        return options_refuse(t, d, "--points goes with -o FILE (try --help)");
    if (o->cost && !cost_model_find(o->cost, &compile->cost, d))
        return false;
    if (o->output && !*o->prefix)
        prefix_from_path(o->output, ending_of(o->language), o->prefix);
    o->precision_given = given[option_find(t, "precision")];
    compile->effort = (long)o->effort;
    compile->seed = (unsigned long)o->seed;
    if (o->explain && *o->explain && !explain_knows(o->explain))
        return options_refuse(t, d, "unknown pass: %s (--explain names them, with spaces for hyphens)", o->explain);
    compile->explain = o->explain ? stderr : NULL;
    compile->explained = o->explain;
    o->unit.prefix = o->prefix;
    o->unit.face_prefix = given[option_find(t, "prefix")] ? o->prefix : NULL;
    o->unit.evidence = !o->count && o->language != LANGUAGE_GENERIC;
    return true;
}

/* Writes the command that a header's banner quotes. Files have no folders, and the output is given by its prefix. The
 * options for messages and test points are omitted. So the same text results wherever the header is written. */
static void write_command(int argc, char **argv, struct codegen_options *o)
{
    const size_t room = sizeof o->command;
    size_t n = (size_t)snprintf(o->command, room, "footpoint-codegen");
    for (int i = 1; i < argc && n < room; i++) {
        i += strcmp(argv[i], "--points") == 0;
        if (strcmp(argv[i], "--quiet") == 0 || argv[i] == o->points || strncmp(argv[i], "--points=", 9) == 0)
            continue;
        const char *slash = strrchr(argv[i], '/'), *value = strchr(argv[i], '=');
        const int option = argv[i][0] == '-' && value && slash ? (int)(value + 1 - argv[i]) : 0;
        if (argv[i] == o->output)
            n += (size_t)snprintf(o->command + n, room - n, " %s%s", o->prefix, ending_of(o->language));
        else
            n += (size_t)snprintf(o->command + n, room - n, " %.*s%s", option, argv[i], slash ? slash + 1 : argv[i]);
    }
}

enum options_outcome codegen_options_read(int argc, char **argv, struct codegen_options *o, struct diag *d)
{
    const struct compile_options compile = compile_defaults();
    bool given[sizeof rows / sizeof *rows] = {false};
    *o = (struct codegen_options){.effort = (size_t)compile.effort, .seed = compile.seed, .unit = {.compile = compile}};
    const enum options_outcome outcome = options_read(&codegen_option_table, argc, argv, o, given, d);
    if (outcome == OPTIONS_READ && !complete(o, given, d))
        return OPTIONS_WRONG;
    write_command(argc, argv, o);
    o->unit.command = o->command;
    return outcome;
}
