/* Prints the evidence about a function; see banner_evidence.h.  Meaningless bounds are left out: for a denominator above its least
 * modulus, for xi and eta above 1.  A row, d_xi[0], d_xi[1], ..., is represented by its worst element. */
#include "banner_evidence.h"

#include "banner_line.h"

#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_LISTED = 12, NUMBER = 32 };

/* Prints three digits, rounded away from 0 (sign 1) or towards it (-1). */
static const char *rounded(double x, int sign, char text[NUMBER])
{
    mpfr_t y;
    mpfr_init2(y, 53);
    mpfr_set_d(y, x, MPFR_RNDN);
    if (sign > 0)
        mpfr_snprintf(text, NUMBER, "%.2RUg", y);
    else
        mpfr_snprintf(text, NUMBER, "%.2RZg", y);
    mpfr_clear(y);
    return text;
}

static bool is_fixed(const struct genome_file *f, size_t input)
{
    const struct genome_range *r = &f->range[input];
    return r->given && strcmp(f->constant[r->lo].text, f->constant[r->hi].text) == 0;
}

/* Prints the ranges of inputs, or of the numbers of the region block that vary. */
void banner_region(const struct genome_file *f, FILE *out)
{
    const struct genome_file *from = f->region ? f->region : f;
    size_t left = 0;
    for (size_t i = 0; i < from->inputs; i++)
        left += from->range[i].given && !(f->region && is_fixed(from, i));
    if (left == 0)
        return;
    struct banner_line l = banner_about_file("region", out);
    if (f->region)
        banner_add(&l, "as the genomes place it,");
    for (size_t i = 0; i < from->inputs; i++) {
        if (!from->range[i].given || (f->region && is_fixed(from, i)))
            continue;
        const char *lo = from->constant[from->range[i].lo].text, *hi = from->constant[from->range[i].hi].text;
        const char *end = --left > 0 ? "," : f->requires ? "; all requires > 0" : "";
        if (is_fixed(from, i))
            banner_add(&l, "%s = %s%s", from->input[i], lo, end);
        else
            banner_add(&l, "%s in [%s,%s]%s", from->input[i], lo, hi, end);
    }
    banner_end(&l);
}

/* Returns the inputs on which operation `op` depends, indexed by input; caller frees. */
static bool *find_inputs(const struct program *p, int op)
{
    bool *needed = new_array(p->ops, sizeof *needed);
    needed[op] = true;
    for (int i = op; i >= (int)p->inputs; i--)
        for (int k = 0; needed[i] && k < 2; k++)
            if ((k ? p->op[i].b : p->op[i].a) >= 0)
                needed[k ? p->op[i].b : p->op[i].a] = true;
    return needed;
}

static void add_witness(struct banner_line *l, const struct genome_file *f, const struct program *p,
                        const struct denominator *d)
{
    bool *needed = find_inputs(p, d->op);
    const char *before = "a zero exists near";
    for (size_t i = 0; i < f->inputs; i++) {
        if (!needed[i] || is_fixed(f, i))
            continue;
        banner_add(l, "%s %s = %.6g", before, f->input[i], d->witness[i]);
        before = "and";
    }
    if (strcmp(before, "and") != 0)
        banner_add(l, "is 0");
    free(needed);
}

/* Adds the rounding error of a denominator without zeros and, if it matters, when the status reports it. */
static void add_rounding(struct banner_line *l, const struct unit *u, const struct denominator *d, const char *name)
{
    char number[NUMBER];
    const double threshold = unit_threshold(u, d);
    if (d->error < d->least)
        banner_add(l, "(rounding error <= %s)", rounded(d->error, 1, number));
    else if (d->apart)
        banner_add(l, "(as computed, too)");
    if (denominator_is_safe(d))
        return;
    if (threshold > 0)
        banner_add(l, "status if |%s| <= %s, the rounding error", name, rounded(threshold, 1, number));
    else if (u->file->segment || d->sign == 0)
        banner_add(l, "status if computed as 0 or not finite");
    else
        banner_add(l, "status if computed as 0, not finite or %s", d->sign > 0 ? "negative" : "positive");
}

static void print_denominator(const struct unit *u, const struct program *p, const struct denominator *d, FILE *out)
{
    char number[NUMBER];
    struct banner_line l = banner_about_function("poles", out);
    banner_add(&l, "%s:", d->name);
    if (d->verdict == POLE_EXISTS)
        add_witness(&l, u->file, p, d);
    else if (d->verdict == POLE_UNDECIDED)
        banner_add(&l, "undecided");
    else if (d->verdict == POLE_REQUIRED)
        banner_add(&l, "no zero where the region's requires hold, by no proved margin");
    else {
        const char *name = d->name[strcspn(d->name, " (")] ? "..." : d->name;
        banner_add(&l, "proved free of zeros, |%s| >= %s%s", name, rounded(d->least, -1, number),
                   denominator_is_safe(d) ? "" : ";");
        add_rounding(&l, u, d, name);
    }
    banner_end(&l);
}

static void print_poles(const struct unit *u, const struct program *p, const struct evidence *e, FILE *out)
{
    struct banner_line l;
    size_t proved = 0, safe = 0;
    for (size_t i = 0; i < e->denominators; i++) {
        if (i < MOST_LISTED)
            print_denominator(u, p, &e->denominator[i], out);
        else {
            proved += e->denominator[i].verdict == POLE_FREE;
            safe += denominator_is_safe(&e->denominator[i]);
        }
    }
    if (e->denominators > MOST_LISTED) {
        l = banner_about_function("poles", out);
        banner_add(&l, "of %zu more denominators, %zu are proved free of zeros, %zu of these as computed, too",
                   e->denominators - MOST_LISTED, proved, safe);
        banner_end(&l);
    }
    for (size_t i = 0; i < e->protecteds; i++) {
        l = banner_about_function("poles", out);
        banner_add(&l, "%s: protected, the quotient is 1 where it is 0", e->protected_name[i]);
        banner_end(&l);
    }
    if (e->denominators + e->protecteds == 0) {
        l = banner_about_function("poles", out);
        banner_add(&l, "none, nothing is divided by");
        banner_end(&l);
    }
}

/* Adds an error; `end` follows the last word. */
static void add_error(struct banner_line *l, const struct output_error *e, const char *name, size_t length, double most,
                      const char *end)
{
    char number[NUMBER];
    const bool bounded = output_error_is_bounded(e) && e->bound <= most;
    banner_add(l, "%.*s", (int)length, name);
    if (bounded)
        banner_add(l, "<= %s proved%s", rounded(e->bound, 1, number), e->sampled >= 0 ? "," : end);
    if (e->sampled >= 0)
        banner_add(l, "%s sampled%s", rounded(e->sampled, 1, number), end);
    else if (!bounded)
        banner_add(l, "no bound found%s", end);
}

/* Adds the errors of all rows except tested values, or of all outputs if the function has no rows. */
static void add_errors(struct banner_line *l, const struct genome_file *f, const struct function *function)
{
    const struct evidence *e = function->evidence;
    const struct genome_expr *out = function->genome->out;
    for (size_t i = 0; i < e->outputs;) {
        struct output_error worst = e->error[i];
        const char *name = out[i].name;
        const size_t length = strcspn(name, "[");
        for (i++; i < e->outputs && strncmp(out[i].name, name, length + 1) == 0 && name[length]; i++) {
            worst.bound = fmax(worst.bound, e->error[i].bound);
            worst.sampled = fmax(worst.sampled, e->error[i].sampled);
        }
        if (strncmp(name, "require[", length + 1) != 0)
            add_error(l, &worst, name, length, f->segment && !f->face ? 1 : INFINITY, i < e->outputs ? ";" : "");
    }
}

void banner_evidence(const struct unit *u, const struct function *function, FILE *out)
{
    const struct evidence *e = function->evidence;
    print_poles(u, function->program, e, out);
    struct banner_line l = banner_about_function("rounding", out);
    if (!e->region)
        banner_add(&l, "no bound, as no ranges are given");
    else
        add_errors(&l, u->file, function);
    if (e->samples > 0)
        banner_add(&l, "(%ld points)", e->samples);
    banner_end(&l);
}
