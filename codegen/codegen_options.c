/* Reads the command line; see codegen_options.h. */
#include "codegen_options.h"

#include <ctype.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: footpoint-codegen GENOMES -o FILE       write code: a header of static inline C functions\n"
    "       footpoint-codegen --count GENOMES       print genome,mul,div,add,sqrt,compare of each genome as CSV\n"
    "\n"
    "  -o, --output FILE     file to write; its name without .h (.f90) begins every function's name\n"
    "      --prefix NAME     begin the names with NAME instead\n"
    "      --language NAME   c (default); fortran: a module; infix, latex: a formula a line\n"
    "      --precision NAME  double or float (default: what the genomes' scene says, or double)\n"
    "      --samples FILE    of footpoint-evolve --samples: float code of a segment is measured on them, takes\n"
    "                        edges of any size, and gets NAME_sure, which checks answers for the worst error measured\n"
    "      --allow-poles     accept genomes that may divide by 0: functions of scalars then return a status\n"
    "      --count           operation counts to standard output\n"
    "\n"
    "  search for the cheapest form:\n"
    "      --cost MODEL      throughput (default), paper, latency, or a file that footpoint-calibrate wrote\n"
    "      --effort N        work that the search may do (default %ld); same effort, same bytes\n"
    "      --seed N          seed of the search (default %lu)\n"
    "      --explain         each pass and its counts to standard error\n"
    "\n"
    "      --quiet           say nothing while working (otherwise on standard error: a line for each function "
    "written;\n"
    "                        on a terminal one line, with the time left)\n"
    "\n"
    "  -h, --help            this text\n"
    "      --version         version\n"
    "\n"
    "Every function is checked to equal its genome in exact rational arithmetic before anything is written.\n"
    "Infix is read by Python, SymPy, Maxima and FORM: constants are exact quotients, pdiv(a,b) is a/b, and 1 where b\n"
    "is 0.  NAME_n, the loop over arrays in C, vectorises with -O3, and needs -fno-math-errno for square roots and\n"
    "-fno-trapping-math for minima, maxima and protected quotients; neither changes a result.\n"
    "Exit status: 0 done, 1 input rejected, 2 usage, 3 memory or I/O.\n";

static bool refuse(const char *what, const char *argument, int *status)
{
    fprintf(stderr, "footpoint-codegen: %s%s (try --help)\n", what, argument);
    *status = EXIT_USAGE;
    return false;
}

static const char *ending_of(enum language language)
{
    return language == LANGUAGE_FORTRAN ? ".f90" : ".h";
}

/* "path/Some-name.h" to "some-name" as a C identifier that begins with footpoint_. */
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

enum { COUNT = 256, PREFIX, VERSION, LANGUAGE, PRECISION, POLES, COST, EFFORT, SEED, EXPLAIN, SAMPLES, QUIET };

static const struct option long_options[] = {{"output", required_argument, NULL, 'o'},
                                             {"help", no_argument, NULL, 'h'},
                                             {"count", no_argument, NULL, COUNT},
                                             {"prefix", required_argument, NULL, PREFIX},
                                             {"version", no_argument, NULL, VERSION},
                                             {"language", required_argument, NULL, LANGUAGE},
                                             {"precision", required_argument, NULL, PRECISION},
                                             {"samples", required_argument, NULL, SAMPLES},
                                             {"allow-poles", no_argument, NULL, POLES},
                                             {"cost", required_argument, NULL, COST},
                                             {"effort", required_argument, NULL, EFFORT},
                                             {"seed", required_argument, NULL, SEED},
                                             {"explain", no_argument, NULL, EXPLAIN},
                                             {"quiet", no_argument, NULL, QUIET},
                                             {NULL, 0, NULL, 0}};

/* One option with its argument. */
static bool read_option(int option, const char *argument, struct codegen_options *o, int *status)
{
    static const char *const languages[] = {"c", "fortran", "infix", "latex", NULL};
    static const char *const precisions[] = {"double", "float", NULL};
    struct compile_options *compile = &o->unit.compile;
    struct diag d;
    unsigned long long number;
    int word;
    switch (option) {
    case 'o':
        o->output = argument;
        return true;
    case PREFIX:
        if (!is_identifier(argument))
            return refuse("not a C identifier: ", argument, status);
        snprintf(o->prefix, sizeof o->prefix, "%s", argument);
        return true;
    case LANGUAGE:
        if ((word = text_word(argument, languages)) < 0)
            return refuse("unknown language: ", argument, status);
        o->language = (enum language)word;
        return true;
    case PRECISION:
        if ((word = text_word(argument, precisions)) < 0)
            return refuse("unknown precision: ", argument, status);
        o->unit.precision = (enum precision)word;
        o->precision_given = true;
        return true;
    case SAMPLES:
        o->samples = argument;
        return true;
    case POLES:
        o->unit.allow_poles = true;
        return true;
    case COST:
        o->cost = argument;
        if (cost_model_find(argument, &compile->cost, &d))
            return true;
        fprintf(stderr, "%s\n", d.text);
        *status = (int)d.code;
        return false;
    case EFFORT:
        if (!text_whole(argument, &number) || number > 1000000000)
            return refuse("effort is a number from 0 to 1000000000, not ", argument, status);
        compile->effort = (long)number;
        return true;
    case SEED:
        if (!text_whole(argument, &number))
            return refuse("the seed is a number from 0 to 18446744073709551615, not ", argument, status);
        compile->seed = number;
        return true;
    case EXPLAIN:
        compile->explain = stderr;
        return true;
    case QUIET:
        o->unit.quiet = true;
        return true;
    default:
        return false;
    }
}

/* The call that a header names, options first: files without their folders, which are others elsewhere, and the output
 * by what its names begin with, so that the same text goes wherever it is written. */
static void write_command(int argc, char **argv, struct codegen_options *o)
{
    const size_t room = sizeof o->command;
    size_t n = (size_t)snprintf(o->command, room, "footpoint-codegen");
    for (int i = 1; i < argc && n < room; i++) {
        const char *slash = strrchr(argv[i], '/'), *value = strchr(argv[i], '=');
        const int option = argv[i][0] == '-' && value && slash ? (int)(value + 1 - argv[i]) : 0;
        if (argv[i] == o->output)
            n += (size_t)snprintf(o->command + n, room - n, " %s%s", o->prefix, ending_of(o->language));
        else
            n += (size_t)snprintf(o->command + n, room - n, " %.*s%s", option, argv[i], slash ? slash + 1 : argv[i]);
    }
}

bool codegen_options_read(int argc, char **argv, struct codegen_options *o, int *status)
{
    const struct compile_options defaults = compile_defaults();
    bool count = false;
    *o = (struct codegen_options){.unit = {.compile = defaults}};
    *status = EXIT_DONE;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, "o:h", long_options, NULL)) != -1;) {
        if (c == 'h') {
            printf(usage, defaults.effort, defaults.seed);
            return false;
        }
        if (c == VERSION) {
            puts("footpoint-codegen " FOOTPOINT_VERSION);
            return false;
        }
        if (c == '?')
            return refuse("unknown option or missing value: ", argv[optind - 1], status);
        if (c == COUNT)
            count = true;
        else if (!read_option(c, optarg, o, status))
            return false;
    }
    if (optind + 1 != argc)
        return refuse("one genome file, please", "", status);
    if (count == (o->output != NULL))
        return refuse("either -o FILE or --count, please", "", status);
    if (o->output && !*o->prefix)
        prefix_from_path(o->output, ending_of(o->language), o->prefix);
    write_command(argc, argv, o);
    o->genomes = argv[optind];
    o->unit.prefix = o->prefix;
    o->unit.command = o->command;
    o->unit.evidence = !count;
    return true;
}
