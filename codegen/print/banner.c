/* Prints the banner; see banner.h.  It contains no date, host or path: the same genome and options write the same bytes. */
#include "banner.h"

#include "../base/text.h"
#include "banner_evidence.h"
#include "banner_line.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const output[] = {"xi", "eta"};

static void print_line(struct banner_line l, const char *text)
{
    banner_add(&l, "%s", text);
    banner_end(&l);
}

/* ---- a function ---- */

enum { MILLION = 1000000 };

/* Prints mean, 99 % and worst error of xi and eta on a part of the samples, and of another distribution if it differs. */
static void print_errors(const struct measured *m, FILE *out)
{
    for (int part = 0; part < MEASURE_PARTS; part++) {
        const struct measure_error *e = m->error[part], *first = m->error[0];
        const bool same =
            part == MEASURE_EVEN && !measure_differs(&e[0], &first[0]) && !measure_differs(&e[1], &first[1]);
        if (e[0].n == 0 || same)
            continue;
        struct banner_line l = banner_about_function(measure_part[part], out);
        for (int k = 0; k < 2; k++)
            banner_add(&l, "%s %.3e %.3e %.3e,", output[k], e[k].mean, e[k].p99, fmax(e[k].max, e[k].climbed));
        if (e[0].n == MILLION)
            banner_add(&l, "of 1e6 samples");
        else
            banner_add(&l, "of %zu samples", e[0].n);
        if (e[0].climbed > 0 || e[1].climbed > 0)
            banner_add(&l, "and climbing");
        banner_end(&l);
    }
}

/* Enters a note about errors into the table.  Returns false for other notes. */
static bool take_errors(const struct genome_note *note, struct measured *m)
{
    for (int part = 0; part < MEASURE_PARTS; part++) {
        const size_t length = strlen(measure_part[part]);
        if (strncmp(note->key, measure_part[part], length) == 0 && strcmp(note->key + length, "_both") == 0)
            return measure_errors_read(note->text, m->error[part]);
    }
    return false;
}

/* Returns the text of the note about output k that belongs to `key`, a note about the other output, or NULL. */
static const char *partner(const struct genome *g, const char *key, int k)
{
    const char *tail = strrchr(key, '_');
    if (!tail || strcmp(tail + 1, output[!k]) != 0)
        return NULL;
    char *other = new_format("%.*s_%s", (int)(tail - key), key, output[k]);
    const char *text = genome_find_note(g->note, g->notes, other);
    free(other);
    return text;
}

/* Prints a note.  Notes about xi and eta share a line, so notes about eta print nothing themselves. */
static void print_note(const struct genome *g, const struct genome_note *note, FILE *out)
{
    const char *eta = partner(g, note->key, 1);
    if (partner(g, note->key, 0))
        return;
    if (!eta) {
        print_line(banner_about_function(note->key, out), note->text);
        return;
    }
    char *key = new_text(note->key, strlen(note->key) - strlen("_xi"));
    struct banner_line l = banner_about_function(key, out);
    free(key);
    if (strcmp(note->text, eta) == 0)
        banner_add(&l, "%s", eta);
    else
        banner_add(&l, "xi %s; eta %s", note->text, eta);
    banner_end(&l);
}

/* Prints all notes.  Errors that evolution measured, for the genome in double, follow as a table unless there are errors in
 * float. */
static void print_notes(const struct function *f, FILE *out)
{
    const struct genome *g = f->genome;
    struct measured m = {0};
    for (size_t k = 0; k < g->notes; k++)
        if (!take_errors(&g->note[k], &m))
            print_note(g, &g->note[k], out);
    print_errors(f->measured ? f->measured : &m, out);
}

/* Prints the flags with which a compiler vectorises the loop over arrays. */
static void print_loop(const struct genome_file *file, const struct function *f, FILE *out)
{
    const bool roots = f->code.ops.sqrt > 0, hides = program_hides_constants(file);
    bool chooses = false;
    for (size_t i = 0; i < f->program->ops; i++) {
        const enum op_kind kind = f->program->op[i].kind;
        chooses = chooses || (!hides && (kind == OP_MIN || kind == OP_MAX)) || kind == OP_PDIV;
    }
    struct banner_line l = banner_about_function("vectorises", out);
    banner_add(&l, "-O3%s%s", roots ? " -fno-math-errno" : "", chooses ? " -fno-trapping-math" : "");
    banner_end(&l);
}

static void print_function(const struct unit *u, const struct function *f, FILE *out)
{
    const struct operations *ops = &f->code.ops;
    char proof[120];
    fprintf(out, " * %s\n", f->name);
    struct banner_line l = banner_about_function("operations", out);
    banner_add(&l, "%ld mul, %ld div, %ld add, %ld sqrt, %ld compare; %ld temporaries", ops->mul, ops->div, ops->add,
               ops->sqrt, ops->compare, ops->temporaries);
    banner_end(&l);
    proof_print(&f->proof, proof);
    print_line(banner_about_function("proof", out), proof);
    print_line(banner_about_function("genome_sha256", out), f->sha256);
    char *cancelled = function_cancelled(f);
    if (cancelled) {
        l = banner_about_function("cancelled", out);
        banner_add(&l, "%s: the genome is singular where the code is not", cancelled);
        banner_end(&l);
    }
    free(cancelled);
    banner_evidence(u, f, out);
    print_notes(f, out);
}

/* ---- the file ---- */

static void print_cost(const struct compile_options *o, FILE *out)
{
    const struct cost_model *m = &o->cost;
    struct banner_line l = banner_about_file("cost model", out);
    banner_add(&l, "%s (mul %g, add %g, div %g, sqrt %g, compare %g); seed %lu, effort %ld", m->name, m->mul, m->add,
               m->div, m->sqrt, m->compare, o->seed, o->effort);
    banner_end(&l);
}

/* Explains the lines about a function that do not explain themselves. */
static void print_legend(const struct unit *u, FILE *out)
{
    const bool single = u->options.precision == PRECISION_FLOAT, measured = u->options.samples != NULL;
    fputs(" *\n"
          " * Above each function: poles and rounding errors are bounded over the region, with or without FMA; of the "
          "latter\n"
          " * the worst that were met at random points and uphill from these (sampled), and bounds within 100 times "
          "that\n"
          " * (proved); heldout...: mean, 99 % and worst error of xi and eta on samples that were not used to find "
          "it,\n"
          " * worst errors also by climbing from the worst hundred samples where this is said.\n",
          out);
    if (u->file->segment && *u->file->segment->normals && !single)
        fputs(" * at_heldout: the same of NAME_at, if it takes steps on the patch instead.\n", out);
    if (single && !measured)
        fputs(" * heldout... are those of the same code in double.\n", out);
}

static void print_file(const struct unit *u, FILE *out)
{
    const struct genome_file *f = u->file;
    const char *name = strrchr(f->path, '/') ? strrchr(f->path, '/') + 1 : f->path;
    const bool scene = genome_find_note(f->note, f->notes, "scene") != NULL;
    fprintf(out, " * GENERATED by footpoint-codegen " FOOTPOINT_VERSION ". DO NOT EDIT; run `%s`.\n",
            scene || !u->options.command ? "make regenerate" : u->options.command);
    print_line(banner_about_file("genomes", out), name);
    print_line(banner_about_file("sha256", out), u->sha256);
    print_cost(&u->options.compile, out);
    print_line(banner_about_file("precision", out), u->options.precision == PRECISION_FLOAT ? "float" : "double");
    for (size_t i = 0; i < f->notes; i++)
        if (strcmp(f->note[i].key, "precision") != 0)
            print_line(banner_about_file(f->note[i].key, out), f->note[i].text);
    if (f->segment) {
        struct banner_line l = banner_about_file("corners", out);
        banner_add(&l, "%s%s", corner_order_name(f->order),
                   f->order == CORNERS_ANY ? " (as the mesh has them)" : " (NAME_at assumes it; NAME arranges it)");
        banner_end(&l);
    }
    banner_region(f, out);
    print_legend(u, out);
}

/* ---- comments ---- */

static char *lines(const struct unit *u, const struct function *f)
{
    struct memory *m = memory_open();
    if (f)
        print_function(u, f, m->stream);
    else
        print_file(u, m->stream);
    return memory_close(m);
}

static void print_comment(char *text, FILE *out)
{
    text[0] = '/';
    fprintf(out, "%s */\n", text);
    free(text);
}

void banner_print_file(const struct unit *u, FILE *out)
{
    print_comment(lines(u, NULL), out);
}

void banner_print_function(const struct unit *u, const struct function *f, FILE *out)
{
    struct memory *m = memory_open();
    print_function(u, f, m->stream);
    print_loop(u->file, f, m->stream);
    print_comment(memory_close(m), out);
}

void banner_print_as(const struct unit *u, const struct function *f, const char *mark, size_t width, FILE *out)
{
    char *text = lines(u, f), *broken = new_format("\n%s     ", mark);
    for (char *line = text; *line;) {
        char *end = strchr(line, '\n');
        *end = '\0';
        fputs(mark, out);
        print_broken(line + strlen(" *"), strlen(mark), width, broken, broken, out);
        fputc('\n', out);
        line = end + 1;
    }
    free(broken);
    free(text);
}
