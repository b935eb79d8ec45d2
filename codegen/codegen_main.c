/* footpoint-codegen: reads genomes and writes code or a table of operation counts. */
#include "base/outfile.h"
#include "codegen_options.h"
#include "print/formulas.h"
#include "print/fortran.h"
#include "print/header/header.h"
#include "print/header/header_along.h"
#include "print/header/header_edge.h"
#include "print/header/header_generic.h"
#include "print/header/header_place.h"
#include "print/points.h"

#include <stdlib.h>
#include <string.h>

static void print_counts(const struct unit *u)
{
    puts("genome,mul,div,add,sqrt,compare");
    for (size_t i = 0; i < u->file->genomes; i++) {
        const struct operations *o = &u->function[i].code.ops;
        printf("%s,%ld,%ld,%ld,%ld,%ld\n", u->file->genome[i].name, o->mul, o->div, o->add, o->sqrt, o->compare);
    }
}

static bool write_points(const struct unit *u, const char *path, struct diag *d)
{
    struct outfile out;
    if (!outfile_open(&out, path, d))
        return false;
    points_print(u, out.stream);
    return outfile_commit(&out, d);
}

static bool write_code(const struct unit *u, const struct codegen_options *o, struct diag *d)
{
    struct outfile out;
    bool good = true;
    if (o->language == LANGUAGE_C && !(u->file->face ? place_check(u, d) : along_check(u, d)))
        return false;
    if ((o->points && !write_points(u, o->points, d)) || !outfile_open(&out, o->output, d))
        return false;
    if (o->language == LANGUAGE_C)
        header_print(u, out.stream);
    else if (o->language == LANGUAGE_GENERIC)
        good = generic_print(u, out.stream, d);
    else if (o->language == LANGUAGE_FORTRAN)
        good = fortran_print(u, out.stream, d);
    else
        good = formulas_print(u, o->language == LANGUAGE_LATEX, out.stream, d);
    if (good)
        return outfile_commit(&out, d);
    outfile_discard(&out);
    return false;
}

/* Reads samples and the settings that depend on the genome file: the precision, unless given, and whether test points
 * exist. */
static bool read_samples(const struct codegen_options *o, const struct genome_file *f, struct unit_options *unit,
                         struct measure_samples *samples, struct diag *d)
{
    const char *precision = genome_find_note(f->note, f->notes, "precision");
    if (!o->precision_given && precision && strcmp(precision, "float") == 0)
        unit->precision = PRECISION_FLOAT;
    if (o->points && (unit->precision == PRECISION_FLOAT || f->face || o->language != LANGUAGE_C))
        return diag_at(d, f->path, 0, 0, "--points are for C code in double, but not at places of faces");
    if (!o->samples)
        return true;
    if (unit->precision != PRECISION_FLOAT || !f->segment || f->face || o->language != LANGUAGE_C)
        return diag_at(d, f->path, 0, 0, "--samples are for C code of a segment in float");
    unit->samples = samples;
    return measure_read(o->samples, f, samples, d);
}

static bool write_edge(const struct codegen_options *o, struct diag *d)
{
    struct outfile out;
    if (!outfile_open(&out, o->output, d))
        return false;
    edge_print(edge_find(o->edge), o->prefix, o->unit.precision, out.stream);
    return outfile_commit(&out, d);
}

static bool run(const struct codegen_options *o, struct diag *d)
{
    const struct file_use file[] = {{"the output", o->output, true, 0},
                                    {"--points", o->points, true, 0},
                                    {"the genome file", o->genomes, false, 0},
                                    {"--samples", o->samples, false, 0},
                                    {"--cost", o->cost, false, 0}};
    char sha256[65];
    size_t size;
    if (!files_apart("footpoint-codegen", file, sizeof file / sizeof *file, d))
        return false;
    char *text = read_text(o->genomes, &size, d);
    if (!text)
        return false;
    sha256_hex(text, size, sha256);
    struct genome_file *f = genome_parse(o->genomes, text, size, d);
    free(text);
    if (!f)
        return false;
    struct unit_options options = o->unit;
    struct measure_samples samples = {0};
    bool good = read_samples(o, f, &options, &samples, d);
    struct unit *u = good ? unit_new(f, sha256, &options, d) : NULL;
    good = u != NULL;
    if (u) {
        if (o->output)
            good = write_code(u, o, d);
        else
            print_counts(u);
        unit_free(u);
    }
    measure_samples_free(&samples);
    genome_file_free(f);
    return good;
}

int main(int argc, char **argv)
{
    struct codegen_options o;
    struct diag d;
    const enum options_outcome outcome = codegen_options_read(argc, argv, &o, &d);
    if (outcome == OPTIONS_READ && o.edge)
        return exit_status(write_edge(&o, &d), &d);
    return outcome == OPTIONS_READ ? exit_status(run(&o, &d), &d) : options_end(&codegen_option_table, outcome, &d);
}
