/* Answers of checked functions with a proof; see header_promise.h. */
#include "header_promise.h"

#include "../../base/text.h"
#include "../../program/dialects.h"
#include "../header_sizes.h"
#include "../templates.h"
#include "header_gap.h"
#include "header_lines.h"
#include "header_vectors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Promises by the names of functions, of faces and of patches; other functions are right to rounding. */
static const struct {
    const char *name;
    double promise[2];
} promises[] = {
    {"fast", {1e-1, 1e-1}},     {"coarse", {1e-1, 1e-1}},   {"facet", {1e-1, 1e-1}},     {"gauss", {1e-1, 1e-1}},
    {"taper", {1e-1, 1e-1}},    {"newton", {1e-2, 1e-2}},   {"gauss2", {1e-2, 1e-2}},    {"medium", {1e-2, 1e-2}},
    {"normals", {1e-2, 1e-2}},  {"balanced", {1e-3, 1e-3}}, {"smooth", {1e-3, 1e-3}},    {"fine", {1e-5, 1e-5}},
    {"program1", {1e-3, 1e-3}}, {"program2", {1e-7, 1e-7}}, {"weighted", {1e-5, 1e-5}},  {"corrected", {1e-5, 1e-5}},
    {"precise", {1e-7, 1e-7}},  {"exact", {1e-12, 1e-10}},  {"accurate", {1e-10, 1e-10}}};
static const double finest[] = {[PRECISION_DOUBLE] = 1e-12, [PRECISION_FLOAT] = 1e-5};

static bool single(const struct unit *u)
{
    return u->options.precision == PRECISION_FLOAT;
}

enum promise_kind promise_kind_of(const struct unit *u)
{
    const struct segment_kind *k = u->file->segment;
    const bool any = u->file->order == CORNERS_ANY;
    if (*k->normals)
        return single(u) ? PROMISE_NONE : PROMISE_PATCH;
    if (!lines_straight(u))
        return PROMISE_CURVED;
    if (k->bilinear)
        return any ? PROMISE_BILINEAR : single(u) ? PROMISE_NONE : PROMISE_BOX;
    return any ? PROMISE_LINEAR : PROMISE_NONE;
}

const char *promise_answers(const struct unit *u)
{
    return promise_kind_of(u) == PROMISE_BOX ? "quad4_box" : u->file->segment->name;
}

bool promise_follows(const struct unit *u)
{
    const enum promise_kind kind = promise_kind_of(u);
    return !single(u) && (kind == PROMISE_BILINEAR || kind == PROMISE_CURVED || kind == PROMISE_PATCH);
}

/* Returns the promise of f's name. */
static double name_promise(const struct unit *u, const struct function *f)
{
    const double least = finest[u->options.precision];
    for (size_t i = 0; i < sizeof promises / sizeof *promises; i++)
        if (promise_kind_of(u) != PROMISE_LINEAR && strcmp(promises[i].name, f->genome->name) == 0)
            return fmax(promises[i].promise[promise_kind_of(u) == PROMISE_PATCH], least);
    return least;
}

/* Returns errors on held-out samples, the larger of xi and eta; infinite if they are unknown. */
static struct measure_error held_out(const struct function *f)
{
    struct measure_error e[2] = {{.mean = INFINITY, .p99 = INFINITY}, {.mean = INFINITY, .p99 = INFINITY}};
    const char *said = genome_find_note(f->genome->note, f->genome->notes, "heldout_both");
    if (f->measured)
        memcpy(e, f->measured->error[0], sizeof e);
    else if (said && !measure_errors_read(said, e))
        e[0].mean = e[0].p99 = INFINITY;
    return (struct measure_error){.mean = fmax(e[0].mean, e[1].mean), .p99 = fmax(e[0].p99, e[1].p99)};
}

/* Returns true if one step should bring an error e below `promise`. The step is of third order, in float of second. */
static bool one_step_does(const struct unit *u, double e, double promise)
{
    return single(u) ? e < 0.005 && e * e < 0.5 * promise : e < 0.02 && e * e * e < 20.0 * promise;
}

/* Returns true if the same holds for all but a few in a hundred. */
static bool one_step_suffices(const struct unit *u, double e, double promise)
{
    return e < 0.004 && one_step_does(u, e, (single(u) ? 0.02 : 0.015) * promise);
}

/* Returns the start of NAME: the cheapest function from which one step is usually enough. */
static const struct function *start_of(const struct unit *u, const struct function *f)
{
    const struct function *start = NULL;
    const struct cost_model *model = &u->options.compile.cost;
    for (size_t i = 0; i < u->file->genomes; i++) {
        const struct function *other = &u->function[i];
        const double e = held_out(other).p99;
        if (one_step_does(u, e, name_promise(u, f)) &&
            (!start || operations_cost(&other->code.ops, model) < operations_cost(&start->code.ops, model)))
            start = other;
    }
    return start ? start : f;
}

/* The most steps on a patch before the proved step, and the approximate cost of each over arrays and in calls. */
enum { PATCH_STEPS = 4, LOOP_STEP_COST = 500, CALL_STEP_COST = 350 };

/* Returns a bound of the error after a step from an error e, for 99 % of the samples of gregory: measured 1.3e-4 from
 * 0.084, 2.3e-6 from 0.027, 6e-7 from 0.013. */
static double step_leaves(double e)
{
    return e * e * (0.3 * e + 0.003);
}

/* Returns the steps on a patch after which a proved step mostly succeeds, from an error e: if e is below `near` and 20 e^2 below
 * the promise. */
static int patch_steps(double e, double near, double promise)
{
    int steps = 0;
    for (; steps < PATCH_STEPS && !(e < near && 20 * e * e < promise); steps++)
        e = step_leaves(e);
    return steps;
}

/* The way to a proof on a patch: a function, and the steps that follow before the proved step. */
struct way {
    const struct function *start;
    int steps;
};

/* Returns the cheapest way. With `once`, the first proof must nearly always succeed, as other pairs are searched anew;
 * otherwise it is repeated at the cost of a step, and a third of the mean is taken for the usual error. */
static struct way patch_way(const struct unit *u, const struct function *f, bool once)
{
    struct way best = {f, 0};
    double least = INFINITY;
    for (size_t i = 0; i < u->file->genomes; i++) {
        const struct function *start = &u->function[i];
        const struct measure_error e = held_out(start);
        const double promise = name_promise(u, f);
        const int steps = once ? patch_steps(e.p99, 0.005, promise) : patch_steps(e.mean / 3, 1, promise);
        const double cost = operations_cost(&start->code.ops, &u->options.compile.cost) +
                            (once ? LOOP_STEP_COST : CALL_STEP_COST) * steps;
        if (cost < least) {
            least = cost;
            best = (struct way){start, steps};
        }
    }
    return best;
}

static bool is_gregory(const struct unit *u)
{
    return strcmp(u->file->segment->name, "gregory") == 0;
}

/* The approximate cost of a step in a call of NAME_at, with its share of what steps share, by kind. */
static double bare_step_cost(const struct unit *u)
{
    return is_gregory(u) ? 780 : 330;
}

/* Returns about the error that such a step leaves of e, for 99 % of the samples of bezier and gregory: measured 3.1e-4 and
 * 4.0e-4 from 0.083 and 0.084, 1.5e-5 and 2.5e-5 from 0.027. */
static double bare_step_leaves(double e)
{
    return e * e * (0.3 * e + 0.03);
}

/* Returns true if a let of the frame is this number. */
static bool is_let(const struct genome_file *f, const char *name, double value)
{
    const long symbol = genome_find_symbol(f, name);
    const struct genome_expr *let = symbol >= (long)f->inputs ? &f->let[(size_t)symbol - f->inputs] : NULL;
    return let && let->length == 1 && let->gene[0] < 0 && f->constant[-1 - let->gene[0]].value == value;
}

/* Returns true if steps on the patch may stand for a genome: one of corners in any order, for contact points on the
 * whole patch and nowhere else. */
static bool may_step(const struct unit *u)
{
    const struct genome_file *f = u->file;
    return promise_kind_of(u) == PROMISE_PATCH && f->order == CORNERS_ANY && is_let(f, "xi_lo", -1) &&
           is_let(f, "xi_hi", 1) && is_let(f, "eta_lo", -1) && is_let(f, "eta_hi", 1);
}

/* Returns the cheapest way of NAME_at on a patch: steps with vector instructions if they cost less than the genome and
 * leave about a fifth of its errors or less. Two steps and more go on until one is small. */
static struct way bare_way(const struct unit *u, const struct function *f)
{
    struct way best = {f, 0};
    const struct cost_model *model = &u->options.compile.cost;
    double least = operations_cost(&f->code.ops, model);
    for (size_t i = 0; i < u->file->genomes && may_step(u); i++) {
        const struct function *start = &u->function[i];
        double e = held_out(start).p99, cost = operations_cost(&start->code.ops, model);
        for (int steps = 1; isfinite(e) && steps <= PATCH_STEPS; steps++) {
            e = bare_step_leaves(e);
            cost += bare_step_cost(u);
            if (5 * e <= held_out(f).p99 && cost < least) {
                least = cost;
                best = (struct way){start, steps > 1 ? 2 * PATCH_STEPS : 1};
            }
        }
    }
    return best;
}

/* Returns the step after which the error of nearly all samples is less than a promise. */
static double small_step(const struct unit *u, double promise)
{
    return is_gregory(u) ? sqrt(promise) : cbrt(promise);
}

bool promise_walks(const struct unit *u, const struct function *f)
{
    return bare_way(u, f).steps > 0;
}

/* Returns the number of steps that f takes for all pairs of a loop over arrays, on bilinear segments. The few pairs
 * that need more are repeated after the loop. */
static int fixed_steps(const struct unit *u, const struct function *f)
{
    return one_step_suffices(u, held_out(start_of(u, f)).p99, name_promise(u, f)) ? 1 : 2;
}

/* Promises below this need steps of third order. */
#define THIRD 1e-3

/* Returns true if checked functions of f and g differ only in their promise. */
static bool are_alike(const struct unit *u, const struct function *f, const struct function *g)
{
    return start_of(u, f) == start_of(u, g) && fixed_steps(u, f) == fixed_steps(u, g) &&
           (name_promise(u, f) < THIRD) == (name_promise(u, g) < THIRD);
}

double promise_of(const struct unit *u, const struct function *f)
{
    if (promise_kind_of(u) == PROMISE_NONE)
        return 0.0;
    double promise = name_promise(u, f);
    for (size_t i = 0; i < u->file->genomes && promise_kind_of(u) == PROMISE_BILINEAR; i++)
        if (promise >= THIRD && are_alike(u, f, &u->function[i]))
            promise = fmin(promise, name_promise(u, &u->function[i]));
    return promise;
}

/* Returns the name of the promise's macro, or a number that means no promise. */
static char *promise_text(const struct unit *u, const struct function *f)
{
    if (promise_of(u, f) == 0.0)
        return new_format(single(u) ? "-1.0f" : "0.0");
    char *capitals = new_capitals(f->name), *name = new_format("%s_PROMISE", capitals);
    free(capitals);
    return name;
}

void promise_define(const struct unit *u, const struct function *f, FILE *out)
{
    char *name = promise_text(u, f);
    if (promise_of(u, f) > 0.0)
        fprintf(out, "#define %s %g%s /* the largest error of xi and eta behind FOOTPOINT_OK */\n\n", name,
                promise_of(u, f), single(u) ? "f" : "");
    free(name);
}

const struct function *promise_start(const struct unit *u, const struct function *f)
{
    const enum promise_kind kind = promise_kind_of(u);
    return kind == PROMISE_BILINEAR ? start_of(u, f) : kind == PROMISE_PATCH ? patch_way(u, f, false).start : f;
}

/* Returns how many steps on a curved face precede the first proved step; from there most steps are proved. */
static int curved_steps(const struct unit *u, double promise)
{
    return promise < 0.99e-7 ? 2 : promise < (u->file->segment->triangle ? 0.99e-3 : 0.99e-2) ? 1 : 0;
}

/* Returns how many steps NAME takes in a loop over arrays, or a call on a patch, before the first proof. */
static int promise_steps(const struct unit *u, const struct function *f)
{
    switch (promise_kind_of(u)) {
    case PROMISE_CURVED:
        return curved_steps(u, promise_of(u, f));
    case PROMISE_PATCH:
        return patch_way(u, f, false).steps;
    default:
        return fixed_steps(u, f);
    }
}

bool promise_starts(const struct unit *u, const struct function *f)
{
    bool is = false;
    for (size_t i = 0; i < u->file->genomes; i++)
        is = is || (promise_kind_of(u) == PROMISE_PATCH ? patch_way(u, &u->function[i], true).start
                                                        : promise_start(u, &u->function[i])) == f;
    return is;
}

struct words promise_words(const struct unit *u, const struct function *f)
{
    struct words w = lines_words(u, f, promise_start(u, f));
    words_add(&w, "PROMISE", promise_text(u, f));
    words_add(&w, "START", new_format("%s", promise_start(u, f)->name));
    words_set(&w, "KIND", new_format("%s", promise_answers(u)));
    words_add(&w, "EXACT", new_format("footpoint_detail_%s%s", single(u) ? "f_" : "", promise_answers(u)));
    words_add(&w, "STEPS", new_format("%d", promise_steps(u, f)));
    const struct way walk = bare_way(u, f);
    words_add(&w, "WALKED", new_format("%s", walk.start->name));
    words_add(&w, "WALK_STEPS", new_format("%d", walk.steps));
    words_add(&w, "WALK_TEXT",
              walk.steps > 1 ? new_format("steps until one is below %.1e", small_step(u, name_promise(u, f)))
                             : new_format("a step"));
    words_add(&w, "WALK_SMALL", new_format("%.1e", small_step(u, name_promise(u, f))));
    if (promise_kind_of(u) == PROMISE_PATCH) {
        const struct way way = patch_way(u, f, true);
        words_add(&w, "ONCE", new_format("%s", way.start->name));
        words_add(&w, "ONCE_STEPS", new_format("%d", way.steps));
    }
    return w;
}

void promise_print_terms(const struct unit *u, enum precision precision, FILE *out)
{
    struct words w = lines_words(u, NULL, NULL);
    char *guard = new_format("FOOTPOINT_%s_TERMS", u->file->segment->name);
    char *terms = new_format("curved_%s", u->file->segment->name);
    templates_print(guard, (const char *const[]){terms, "curved_start", NULL}, precision, w.word, out);
    free(terms);
    free(guard);
    words_clear(&w);
}

static char *products_text(const struct unit *u, const struct vectors_found *w, struct printer *r)
{
    struct memory *m = memory_open();
    for (size_t k = 0; k < PRODUCTS; k++) {
        char *text = vectors_product(w, r, k);
        fputs(k == 0 ? "" : k % 5 ? ", " : ",\n        ", m->stream);
        c_print(text, u->options.precision, m->stream);
        free(text);
    }
    return memory_close(m);
}

void promise_print(const struct unit *u, const struct function *f, FILE *out)
{
    if (promise_kind_of(u) != PROMISE_BILINEAR || !promise_starts(u, f))
        return;
    struct vectors_found v;
    struct words w = lines_words(u, f, f);
    vectors_find(&v, u, f);
    vectors_find_products(&v, f);
    struct printer *r = gap_add_words(&w, u, f, &v);
    words_add(&w, "PRODUCT_LIST", products_text(u, &v, r));
    words_add(&w, "OVER", new_format("%.17g", v.factor[0] / v.factor[1]));
    words_add(&w, "UNITS", new_format("%g", ceil(v.product_rounding) + 10.0));
    words_add(&w, "TWIST", new_format("%d", v.twist));
    fputc('\n', out);
    templates_print_blocks("quad4_prove", u->options.precision, w.word, NULL, out);
    fputc('\n', out);
    templates_print_blocks("quad4_approach", u->options.precision, w.word, NULL, out);
    words_clear(&w);
    printer_free(r);
    vectors_clear(&v);
}
