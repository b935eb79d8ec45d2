/* footpoint-codegen: genomes in, a C header or a table of operation counts out. */
#include "header.h"
#include "prove.h"

#include <ctype.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: footpoint-codegen GENOMES -o HEADER     write a header of static inline C functions\n"
    "       footpoint-codegen --count GENOMES       print name,mul,div,add,sqrt,compare of each genome as CSV\n"
    "\n"
    "  -o, --output HEADER   file to write; its name without .h begins every function's name\n"
    "      --prefix NAME     begin the names with NAME instead\n"
    "      --count           operation counts to standard output\n"
    "  -h, --help            this text\n"
    "      --version         version\n"
    "\n"
    "Every function is checked to equal its genome in exact rational arithmetic before anything is written.\n"
    "Exit status: 0 done, 1 input rejected, 2 usage, 3 memory or I/O.\n";

static int refuse(const char *what, const char *argument)
{
    fprintf(stderr, "footpoint-codegen: %s%s (try --help)\n", what, argument);
    return EXIT_USAGE;
}

/* "path/Some-name.h" to "some-name" as a C identifier that begins with footpoint_. */
static void prefix_from_path(const char *path, char prefix[160])
{
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    const bool has = strncmp(name, "footpoint_", 10) == 0;
    size_t n = (size_t)snprintf(prefix, 160, "%s%.100s", has ? "" : "footpoint_", name);
    if (n > 2 && strcmp(prefix + n - 2, ".h") == 0)
        prefix[n - 2] = '\0';
    for (char *c = prefix; *c; c++)
        if (!isalnum((unsigned char)*c) || (unsigned char)*c > 127)
            *c = '_';
}

static bool is_identifier(const char *name)
{
    if (!isalpha((unsigned char)*name) || strlen(name) > 100)
        return false;
    for (; *name; name++)
        if ((unsigned char)*name > 127 || !(isalnum((unsigned char)*name) || *name == '_'))
            return false;
    return true;
}

static bool write_header(const struct genome_file *f, const struct compiled *c, const char *path, const char *prefix,
                         const char *sha256, struct diag *d)
{
    struct outfile out;
    if (!outfile_open(&out, path, d))
        return false;
    header_print(f, c, prefix, sha256, out.stream);
    return outfile_commit(&out, d);
}

/* A segment's genome NAME becomes NAME and NAME_at. */
static bool check_names(const struct genome_file *f, struct diag *d)
{
    for (size_t i = 0; f->segment && i < f->genomes; i++)
        for (size_t k = 0; k < f->genomes; k++) {
            const char *name = f->genome[i].name, *other = f->genome[k].name;
            const size_t n = strlen(name);
            if (strncmp(other, name, n) == 0 && strcmp(other + n, "_at") == 0)
                return diag_at(d, f->path, f->genome[k].line, 1, "genome '%s' takes the name of a function of '%s'",
                               other, name);
        }
    return true;
}

static bool compile_all(const struct genome_file *f, struct compiled *c, struct diag *d)
{
    const struct compile_options options = compile_defaults();
    for (size_t i = 0; i < f->genomes; i++) {
        if (!compile_genome(f, &f->genome[i], &options, &c[i], d) || !prove_equal(f, &f->genome[i], c[i].emission.text, d))
            return false;
        if (c[i].removed)
            fprintf(stderr, "%s:%d: warning: genome '%s': %zu division%s cancelled (a removed singularity)\n", f->path,
                    f->genome[i].line, f->genome[i].name, c[i].removed, c[i].removed == 1 ? "" : "s");
    }
    return true;
}

static bool run(const char *path, const char *output, const char *prefix, struct diag *d)
{
    char sha256[65];
    size_t size;
    char *text = read_text(path, &size, d);
    if (!text)
        return false;
    sha256_hex(text, size, sha256);
    struct genome_file *f = genome_parse(path, text, size, d);
    free(text);
    if (!f)
        return false;
    struct compiled *c = new_array(f->genomes, sizeof *c);
    bool good = f->genomes > 0 || diag_at(d, path, 0, 0, "the file holds no genome");
    good = good && check_names(f, d) && compile_all(f, c, d);
    if (good && output)
        good = write_header(f, c, output, prefix, sha256, d);
    else if (good) {
        puts("genome,mul,div,add,sqrt,compare");
        for (size_t i = 0; i < f->genomes; i++) {
            const struct operations *o = &c[i].emission.ops;
            printf("%s,%ld,%ld,%ld,%ld,%ld\n", f->genome[i].name, o->mul, o->div, o->add, o->sqrt, o->compare);
        }
        good = fflush(stdout) == 0 || diag_system(d, "standard output", "cannot write");
    }
    for (size_t i = 0; i < f->genomes; i++)
        free(c[i].emission.text);
    free(c);
    genome_file_free(f);
    return good;
}

int main(int argc, char **argv)
{
    enum { COUNT = 256, PREFIX, VERSION };
    static const struct option options[] = {
        {"output", required_argument, NULL, 'o'}, {"prefix", required_argument, NULL, PREFIX},
        {"count", no_argument, NULL, COUNT},      {"help", no_argument, NULL, 'h'},
        {"version", no_argument, NULL, VERSION},  {NULL, 0, NULL, 0}};
    const char *output = NULL;
    char prefix[160] = "";
    bool count = false;
    struct diag d;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, "o:h", options, NULL)) != -1;) {
        if (c == 'o')
            output = optarg;
        else if (c == PREFIX) {
            if (!is_identifier(optarg))
                return refuse("not a C identifier: ", optarg);
            snprintf(prefix, sizeof prefix, "%s", optarg);
        } else if (c == COUNT)
            count = true;
        else if (c == VERSION) {
            puts("footpoint-codegen " FOOTPOINT_VERSION);
            return EXIT_DONE;
        } else if (c == 'h') {
            fputs(usage, stdout);
            return EXIT_DONE;
        } else
            return refuse("unknown option or missing value: ", argv[optind - 1]);
    }
    if (optind + 1 != argc)
        return refuse("one genome file, please", "");
    if (count == (output != NULL))
        return refuse("either -o HEADER or --count, please", "");
    if (output && !*prefix)
        prefix_from_path(output, prefix);
    if (run(argv[optind], output, prefix, &d))
        return EXIT_DONE;
    fprintf(stderr, "%s\n", d.text);
    return (int)d.code;
}
