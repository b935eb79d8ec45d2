/* Compiles genomes to proved functions; see compiled_file.h. */
#include "compiled_file.h"

#include "../base/console.h"
#include "../base/text.h"
#include "../program/degree.h"
#include "../program/evaluate_float.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 1000000, POINTS_FOR_EFFORT = 500, BOXES_FOR_EFFORT = 20 };

bool function_is_guarded(const struct function *f)
{
    bool guarded = false;
    for (size_t i = 0; f->evidence && i < f->evidence->denominators; i++)
        guarded = guarded || !denominator_is_safe(&f->evidence->denominator[i]);
    return guarded;
}

char *function_cancelled(const struct function *f)
{
    const size_t n[] = {f->code.removed.divisions, f->code.removed.roots};
    static const char *const name[] = {"division", "root"};
    char *text = NULL;
    for (int i = 0; i < 2; i++) {
        if (n[i] == 0)
            continue;
        char *longer =
            new_format("%s%s%zu %s%s", text ? text : "", text ? " and " : "", n[i], name[i], n[i] == 1 ? "" : "s");
        free(text);
        text = longer;
    }
    return text;
}

double unit_threshold(const struct unit *u, const struct denominator *d)
{
    if (u->file->region || u->file->face)
        return 0; /* faces have many sizes */
    const bool single = u->options.precision == PRECISION_FLOAT;
    const double least = (1 + 1e-4) * d->threshold; /* not smaller when printed with five digits */
    return least >= (single ? (double)FLT_MIN : DBL_MIN) ? least : 0.0;
}

/* Returns true if the ranges fix A = (0,0,0) and B = (1,0,0). */
static bool has_unit_edge(const struct genome_file *f)
{
    for (size_t i = 0; i < 6; i++) {
        const double only = i == 3 ? 1.0 : 0.0;
        const struct genome_range *r = &f->range[i];
        if (!r->given || f->constant[r->lo].value != only || f->constant[r->hi].value != only)
            return false;
    }
    return true;
}

int unit_degree(const struct unit *u, const struct function *f, const struct denominator *d)
{
    int degree = 0;
    if (!u->file->segment || !has_unit_edge(u->file) ||
        !homogeneous_degree(f->program, u->file->segment, d->op, &degree))
        return 0;
    return degree;
}

/* Returns true for names that headers use for helpers, macros, inputs and outputs. */
static bool is_taken(const struct genome_file *f, const char *name)
{
    if (strncmp(name, "footpoint_detail_", 17) == 0 || strncmp(name, "FOOTPOINT_", 10) == 0)
        return true;
    for (size_t i = 0; i < f->inputs && strncmp(name, "in_", 3) == 0 && !f->segment; i++)
        if (strcmp(name + 3, f->input[i]) == 0)
            return true;
    for (size_t k = 0; k < f->genomes && strncmp(name, "out_", 4) == 0 && !f->segment; k++)
        for (size_t i = 0; i < f->genome[k].outs; i++)
            if (strcmp(name + 4, f->genome[k].out[i].name) == 0)
                return true;
    return false;
}

char *unit_face_prefix(const struct genome_file *f, const struct unit_options *o)
{
    return o->face_prefix ? new_format("%s", o->face_prefix) : new_format("footpoint_%s", f->segment->name);
}

static char *new_name(const struct genome_file *f, const struct unit_options *o, const char *genome)
{
    char *prefix = f->face ? unit_face_prefix(f, o) : new_format("%s", o->prefix);
    char *name = new_format("%s_%s", prefix, genome);
    free(prefix);
    return name;
}

/* Checks for name conflicts. A genome NAME takes NAME, NAME_n, NAME_points and, for a segment, NAME_at, NAME_checked_n,
 * NAME_over_n, NAME_sure, NAME_closest, NAME_closest_n and NAME_closest_of; along and along_n belong to no genome.
 * Parts of functions over a face are called NAME_detail, NAME_detail_checked and so on, so genomes must not contain
 * that word. */
static bool check_names(const struct genome_file *f, const struct unit_options *o, struct diag *d)
{
    const char *const prefix = o->prefix;
    static const char *const suffix[] = {"_n",    "_points",  "_at",        "_checked_n", "_over_n",
                                         "_sure", "_closest", "_closest_n", "_closest_of"};
    for (size_t k = 0; k < f->genomes; k++) {
        char *own = new_name(f, o, f->genome[k].name), *guard = new_format("%s_h", prefix),
             *upper = new_capitals(guard);
        const bool detail = f->segment && strstr(f->genome[k].name, "detail");
        const bool taken = *prefix && (detail || is_taken(f, own) || strcmp(own, upper) == 0);
        free(upper);
        free(guard);
        free(own);
        if (taken)
            return diag_at(d, f->path, f->genome[k].line, 1,
                           "genome '%s' conflicts with a name of the header itself, with prefix %s", f->genome[k].name,
                           prefix);
        if (f->segment && (strcmp(f->genome[k].name, "along") == 0 || strcmp(f->genome[k].name, "along_n") == 0))
            return diag_at(d, f->path, f->genome[k].line, 1,
                           "genome '%s' conflicts with the name of another "
                           "function",
                           f->genome[k].name);
        for (size_t s = 0; s < (f->segment ? sizeof suffix / sizeof *suffix : 2); s++) {
            const char *name = f->genome[k].name;
            const size_t n = strlen(name), tail = strlen(suffix[s]);
            for (size_t i = 0; n > tail && strcmp(name + n - tail, suffix[s]) == 0 && i < f->genomes; i++)
                if (strlen(f->genome[i].name) == n - tail && memcmp(f->genome[i].name, name, n - tail) == 0)
                    return diag_at(d, f->path, f->genome[k].line, 1,
                                   "genome '%s' conflicts with a function of "
                                   "'%s'",
                                   name, f->genome[i].name);
        }
    }
    return true;
}

static bool check_poles(const struct genome_file *f, const struct function *function, struct diag *d)
{
    const struct evidence *e = function->evidence;
    for (size_t i = 0; i < e->denominators; i++)
        if (e->denominator[i].verdict != POLE_FREE)
            return diag_at(d, f->path, function->genome->line, 1,
                           "genome '%s' may divide by 0 (%s: %s); give the inputs' ranges, or --allow-poles",
                           function->genome->name, e->denominator[i].name,
                           e->denominator[i].verdict == POLE_EXISTS     ? "has a zero"
                           : e->denominator[i].verdict == POLE_REQUIRED ? "not 0 by requires, without a margin"
                                                                        : "undecided");
    return true;
}

/* Checks that constants are also normal numbers in float. */
static bool check_float(const struct genome_file *f, const struct function *function, struct diag *d)
{
    const struct program *p = function->program;
    for (size_t i = 0; i < p->constants; i++) {
        const double c = fabs(fmpq_get_d(&p->constant[i]));
        if (!fmpq_is_zero(&p->constant[i]) && !(c >= FLT_MIN && c <= FLT_MAX))
            return diag_at(d, f->path, function->genome->line, 1,
                           "genome '%s' has a constant outside the range of float", function->genome->name);
    }
    return true;
}

/* Hashes a genome and everything before it in its file, except other genomes. */
static void hash_genome(const struct genome_file *f, size_t k, char sha256[65])
{
    struct genome_file alone = *f;
    struct memory *m = memory_open();
    alone.genome += k;
    alone.genomes = 1;
    genome_print(&alone, m->stream);
    char *text = memory_close(m);
    sha256_hex(text, strlen(text), sha256);
    free(text);
}

/* Shows progress. All genomes are compiled, then all are examined: two steps a genome. */
static void tell(const struct steps *s, const struct genome_file *f, size_t k, bool compiled)
{
    char what[200];
    snprintf(what, sizeof what, "%.80s, %zu of %zu, %s", f->genome[k].name, k + 1, f->genomes,
             compiled ? "proofs and bounds" : "search for the cheapest form");
    steps_show(s, k + (compiled ? f->genomes : 0), what);
}

static void tell_done(struct steps *s, const struct genome_file *f, size_t k)
{
    const char *slash = strrchr(f->path, '/');
    char what[400];
    snprintf(what, sizeof what, "%.200s: %.80s, %zu of %zu", slash ? slash + 1 : f->path, f->genome[k].name, k + 1,
             f->genomes);
    steps_log(s, what);
}

static void warn_of_cancelled(const struct genome_file *f, const struct function *function, struct steps *s)
{
    char *cancelled = function_cancelled(function);
    if (cancelled) {
        console_line(s->terminal, "");
        fprintf(stderr, "%s:%d: warning: genome '%s': %s cancelled (a removed singularity)\n", f->path,
                function->genome->line, function->genome->name, cancelled);
    }
    free(cancelled);
}

/* Compiles a genome to its cheapest program and proves it equal. */
static bool compile(struct unit *u, size_t k, const struct unit_options *o, struct steps *s, struct diag *d)
{
    const struct genome_file *f = u->file;
    struct function *function = &u->function[k];
    function->genome = &f->genome[k];
    function->name = new_name(f, o, function->genome->name);
    tell(s, f, k, false);
    if (!compile_genome(f, function->genome, &o->compile, &function->code, d))
        return false;
    function->program = function->code.program;
    if (!prove_equal(f, function->genome, function->program, &function->proof, d))
        return false;
    warn_of_cancelled(f, function, s);
    function->scaled = o->samples && single_is_relative(f->segment, function->program);
    return !o->evidence || o->precision != PRECISION_FLOAT || check_float(f, function, d);
}

static const struct arithmetic *arithmetic_of(const struct function *function, const struct unit_options *o)
{
    return o->precision == PRECISION_DOUBLE ? &arithmetic_double
           : function->scaled               ? &arithmetic_single_scaled
                                            : &arithmetic_single;
}

/* Samples the errors of all functions at the same points. The caller frees the result. */
static struct sampled_errors *sample(const struct unit *u, const struct unit_options *o)
{
    const struct genome_file *f = u->file;
    const long points = POINTS_FOR_EFFORT * (1 + o->compile.effort);
    struct sampled *of = new_array(f->genomes, sizeof *of);
    for (size_t k = 0; k < f->genomes; k++)
        of[k] = (struct sampled){u->function[k].program, *arithmetic_of(&u->function[k], o)};
    struct sampled_errors *found =
        sampled_errors_new(f, of, f->genomes, points < POINTS ? points : POINTS, o->compile.seed);
    free(of);
    return found;
}

static bool find_evidence(struct unit *u, size_t k, const struct sampled_errors *sampled, const struct unit_options *o,
                          struct diag *d)
{
    const struct genome_file *f = u->file;
    struct function *function = &u->function[k];
    const struct evidence_options options = {.arithmetic = arithmetic_of(function, o),
                                             .sampled = sampled,
                                             .boxes = BOXES_FOR_EFFORT * (1 + o->compile.effort),
                                             .seed = o->compile.seed};
    function->evidence = evidence_new(f, function->genome, function->program, &options);
    if (function->evidence->empty)
        return diag_at(d, f->path, (f->requires > 0 ? f : f->region)->require[0].line, 1,
                       "no inputs in the ranges satisfy all requires");
    hash_genome(f, k, function->sha256);
    if (o->samples) {
        function->measured = new_array(1, sizeof *function->measured);
        *function->measured = measure_program(f, function->program, function->scaled, o->samples);
    }
    return o->allow_poles || check_poles(f, function, d);
}

static bool find_all_evidence(struct unit *u, const struct unit_options *o, struct steps *s, struct diag *d)
{
    const struct genome_file *f = u->file;
    bool good = true;
    tell(s, f, 0, true);
    struct sampled_errors *sampled = sample(u, o);
    for (size_t k = 0; good && k < f->genomes; k++) {
        tell(s, f, k, true);
        if ((good = find_evidence(u, k, &sampled[k], o, d)))
            tell_done(s, f, k);
    }
    for (size_t k = 0; k < f->genomes; k++)
        sampled_errors_free(&sampled[k]);
    free(sampled);
    return good;
}

struct unit *unit_new(const struct genome_file *f, const char sha256[65], const struct unit_options *o, struct diag *d)
{
    struct unit *u = new_array(1, sizeof *u);
    *u = (struct unit){.file = f, .options = *o};
    memcpy(u->sha256, sha256, sizeof u->sha256);
    u->function = new_array(f->genomes, sizeof *u->function);
    bool good = f->genomes > 0 || diag_at(d, f->path, 0, 0, "the file contains no genome");
    good = good && check_names(f, o, d);
    struct steps steps = steps_start(!o->quiet && !o->compile.explain, 2 * f->genomes);
    for (size_t k = 0; good && k < f->genomes; k++)
        good = compile(u, k, o, &steps, d);
    good = good && (!o->evidence || find_all_evidence(u, o, &steps, d));
    steps_end(&steps);
    if (good)
        return u;
    unit_free(u);
    return NULL;
}

void unit_free(struct unit *u)
{
    for (size_t k = 0; k < u->file->genomes; k++) {
        struct function *f = &u->function[k];
        free(f->name);
        compiled_free(&f->code);
        free(f->measured);
        if (f->evidence)
            evidence_free(f->evidence);
    }
    free(u->function);
    free(u);
}
