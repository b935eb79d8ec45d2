/* The pipeline of passes for a genome; see compile.h. */
#include "compile.h"

#include "../base/text.h"
#include "../graph/from_genome.h"
#include "../passes/expand.h"
#include "../program/dialects.h"
#include "search.h"

#include <stdlib.h>

enum { WRITTEN = 2 };             /* shapes as written that are searched in full */
static const double BEHIND = 1.5; /* largest initial cost of a shape, relative to the genome as written */

struct compile_options compile_defaults(void)
{
    struct diag d;
    struct compile_options o = {.seed = 1, .effort = 2000};
    cost_model_find("throughput", &o.cost, &d);
    return o;
}

/* Adds the genome as written. If differences come first, uses the cheapest of many ways to compute the vectors. */
static void add_written(struct form_search *s, const struct genome_file *f, struct dag *g, const char *what)
{
    enum { WAYS = 32 };
    struct dag *made = NULL;
    for (uint64_t seed = 1; f->segment && shape_differs_first(f->segment) && seed <= WAYS; seed++)
        if ((made = shape_differences(g, f->segment, seed)))
            search_add(s, made, BEHIND, what);
    if (made)
        dag_free(g);
    else
        search_add(s, g, BEHIND, what);
}

/* Adds the genome multiplied out, with and without common denominators, and factored. */
static void add_factored(struct form_search *s)
{
    const struct policy all = {.dissolve = 1, .combine = 1};
    for (int combine = 0; combine <= 1; combine++) {
        struct dag *g = dag_copy(search_first(s));
        for (int pass = !combine; pass < 3 && g; pass++) {
            struct dag *made = pass == 0   ? shape_combine(g, &all, NULL)
                               : pass == 1 ? shape_dissolve(g, &all, NULL)
                                           : shape_factor(g);
            dag_free(g);
            g = made;
        }
        if (rational_take_overflow()) {
            dag_free(g);
            g = NULL;
        }
        if (g)
            search_add(s, g, BEHIND, combine ? "combined, multiplied out and factored" : "multiplied out and factored");
    }
}

/* Prints the text and reads it back. From here on, the program to prove is defined by the text. */
static bool print_and_read(const struct genome_file *f, const struct genome *genome, const struct lowered *l,
                           struct compiled *c, struct diag *d)
{
    struct memory *m = memory_open();
    printer_free(c_statements(f, genome, l->program, &c_double, m->stream));
    c->text = memory_close(m);
    c->ops = l->ops;
    c->program = program_read(f, genome, c->text, d);
    if (c->program && program_equal(c->program, l->program))
        return true;
    const bool read = c->program != NULL;
    compiled_free(c);
    *c = (struct compiled){0};
    return read && diag_at(d, f->path, genome->line, 1,
                           "internal error: the code of genome '%s' reads back "
                           "differently",
                           genome->name);
}

bool compile_genome(const struct genome_file *f, const struct genome *genome, const struct compile_options *o,
                    struct compiled *c, struct diag *d)
{
    struct form_search *s = search_new(f, o);
    *c = (struct compiled){0};
    if (o->explain)
        fprintf(o->explain, "%s\n", genome->name);
    bool large = false;
    for (int keep = KEEP_QUOTIENTS; keep <= KEEP_ALL && !large; keep++) {
        struct dag *g = simplify_genome(f, genome, (enum keep_lets)keep, d);
        if (!g) {
            search_free(s);
            return false;
        }
        large = g->nodes > SEARCH_MOST_NODES;
        add_written(s, f, g, keep == KEEP_ALL ? "as written, named products whole" : "as written");
    }
    search_select(s, WRITTEN);
    if (!large && o->without != WITHOUT_FACTOR)
        add_factored(s);
    struct lowered best;
    c->removed = search_run(s, &best);
    search_free(s);
    const bool good = best.out_of_range
                          ? diag_at(d, f->path, genome->line, 1,
                                    "genome '%s' has a constant outside the range of double", genome->name)
                          : print_and_read(f, genome, &best, c, d);
    program_free(best.program);
    return good;
}

void compiled_free(struct compiled *c)
{
    free(c->text);
    program_free(c->program);
}
