/* The built-in cost models, and files of measured models, written by footpoint-calibrate:
 *
 *   footpoint-costs 1
 *   # comment
 *   mul 1.00
 *   ...                   add, div, sqrt, compare, each 0 or more, in any one unit
 *   chain 0               optional; from files of older versions
 *
 * One key a line, each key once. */
#include "cost.h"

#include "../genome/genes.h"
#include "../genome/genome_reader.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const struct cost_model known[] = {
    /* How long an operation occupies its unit, in units of an addition, on vectors of 128 bits. Measured on Sapphire
     * Rapids: mul 1.0, div 7.9, sqrt 11.8, compare 1.2. Vectors of 256 and 512 bits: codegen/costs/. */
    {"throughput", 1, 1, 8, 12, 1},
    /* Fixed prices, independent of machines, for comparing counts with those of algebra systems. */
    {"operations", 1, 1, 8, 12, 1},
    /* The multiplications and divisions that the paper's tables count; the rest only breaks ties. */
    {"paper", 1, 0.001, 1, 1, 0.001}};

const struct cost_model cost_cycles = {"cycles", 4, 4, 13, 18, 4};

enum key { MUL, ADD, DIV, SQRT, COMPARE, REQUIRED, CHAIN = REQUIRED, KEYS };
static const char *const key_name[KEYS] = {"mul", "add", "div", "sqrt", "compare", "chain"};

#define MOST 1e9 /* keeps sums of costs from overflowing */

struct cost_reader {
    const char *path;
    struct diag *d;
    struct words w;
};

/* Reports an error about the current word, which the format may contain. */
static bool refuse(const struct cost_reader *r, const char *format)
{
    return word_fail(&r->w, format, r->path, r->d);
}

/* Checks that the line has no more words. */
static bool last_word(struct cost_reader *r, const char *format)
{
    return !words_next(&r->w, true) || refuse(r, format);
}

static bool read_version(struct cost_reader *r)
{
    if (!words_next(&r->w, true) || !word_is(&r->w, "footpoint-costs"))
        return refuse(r, "not a cost file: the first word must be 'footpoint-costs'");
    if (!words_next(&r->w, true) || !word_is(&r->w, "1"))
        return refuse(r, "format version '%s' is not supported; this program reads version 1");
    return last_word(r, "unexpected '%s' after the version");
}

static bool read_cost(struct cost_reader *r, double value[KEYS], bool given[KEYS])
{
    char number[48], *rest;
    int k = 0;
    while (k < KEYS && !word_is(&r->w, key_name[k]))
        k++;
    if (k == KEYS)
        return refuse(r, memchr(r->w.word, '\0', r->w.length) ? "text contains a NUL character" : "unknown key '%s'");
    if (given[k])
        return refuse(r, "key '%s' is given twice");
    given[k] = true;
    if (!words_next(&r->w, true))
        return refuse(r, "expected a number");
    if (!word_copy(&r->w, number, sizeof number) || strspn(number, "+-.0123456789eE") < r->w.length)
        return refuse(r, "'%s' must be a decimal number");
    value[k] = strtod(number, &rest);
    if (*rest)
        return refuse(r, "'%s' must be a decimal number");
    if (!(value[k] >= 0 && value[k] <= MOST))
        return refuse(r, "cost '%s' must be between 0 and 1e9");
    if (k == CHAIN && value[k] != 0)
        return refuse(r, "'chain' must be 0, not '%s': costs of the longest chain are no longer supported");
    return last_word(r, "unexpected '%s' after the number");
}

static bool read_costs(struct cost_reader *r, double value[KEYS])
{
    bool given[KEYS] = {false};
    if (!read_version(r))
        return false;
    while (words_next(&r->w, false))
        if (!read_cost(r, value, given))
            return false;
    for (int k = 0; k < REQUIRED; k++)
        if (!given[k])
            return diag_at(r->d, r->path, r->w.word_line, r->w.word_column, "key '%s' is missing", key_name[k]);
    return true;
}

static bool read_model(const char *path, struct cost_model *m, struct diag *d)
{
    double value[KEYS];
    size_t size;
    char *text = read_text(path, &size, d);
    if (!text)
        return false;
    struct cost_reader r = {path, d, words_of(text, size)};
    const bool good = read_costs(&r, value);
    free(text);
    if (!good)
        return false;
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    *m = (struct cost_model){
        .mul = value[MUL], .add = value[ADD], .div = value[DIV], .sqrt = value[SQRT], .compare = value[COMPARE]};
    snprintf(m->name, sizeof m->name, "%.*s", (int)sizeof m->name - 1, name);
    return true;
}

bool cost_model_find(const char *name, struct cost_model *m, struct diag *d)
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcmp(name, known[i].name) == 0) {
            *m = known[i];
            return true;
        }
    if (access(name, F_OK) != 0)
        return diag_system(d, name, "must be throughput, operations, paper or a cost file");
    return read_model(name, m, d);
}

double operations_cost(const struct operations *ops, const struct cost_model *m)
{
    return m->mul * (double)ops->mul + m->add * (double)ops->add + m->div * (double)ops->div +
           m->sqrt * (double)ops->sqrt + m->compare * (double)ops->compare;
}

double unary_cost(const struct cost_model *m, unsigned k)
{
    return unary_of[k].rising ? m->sqrt : m->compare;
}

void unary_count(struct operations *ops, unsigned k, long n)
{
    *(unary_of[k].rising ? &ops->sqrt : &ops->compare) += n;
}
