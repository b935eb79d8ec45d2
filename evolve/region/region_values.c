/* Values of genome files; see region_values.h. */
#include "region_values.h"

#include "../../codegen/base/simd.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void use_symbols(const struct genome_file *f, const struct genome_expr *e, bool *used)
{
    for (size_t i = 0; i < e->length; i++)
        if (e->gene[i] >= GENE_SYMBOL + (int)f->inputs)
            used[e->gene[i] - GENE_SYMBOL - (int)f->inputs] = true;
}

bool *used_lets(const struct genome_file *f)
{
    bool *used = new_array(f->lets, sizeof *used);
    for (size_t i = 0; i < f->genomes; i++)
        for (size_t k = 0; k < f->genome[i].outs; k++)
            use_symbols(f, &f->genome[i].out[k], used);
    for (size_t i = f->lets; i-- > 0;)
        if (used[i])
            use_symbols(f, &f->let[i], used);
    return used;
}

static bool has_quotient(const struct genome_file *f, const struct genome_expr *e, const bool *quotient)
{
    for (size_t i = 0; i < e->length; i++)
        if (e->gene[i] == GENE_DIV || e->gene[i] == GENE_PDIV ||
            (e->gene[i] >= GENE_SYMBOL + (int)f->inputs && quotient[e->gene[i] - GENE_SYMBOL - (int)f->inputs]))
            return true;
    return false;
}

/* Returns an array indexed by let: the let is a quotient or made of quotients. */
static bool *quotients(const struct genome_file *f)
{
    bool *quotient = new_array(f->lets, sizeof *quotient);
    for (size_t i = 0; i < f->lets; i++)
        quotient[i] = has_quotient(f, &f->let[i], quotient);
    return quotient;
}

bool *named_quotients(const struct genome_file *f, const bool *used)
{
    bool *named = quotients(f);
    for (size_t i = 0; i < f->lets; i++) /* values within a function have no name */
        named[i] =
            named[i] && used[i] && genome_find_symbol(f, genome_symbol_name(f, f->inputs + i)) == (long)(f->inputs + i);
    return named;
}

bool output_is_quotient(const struct genome_file *f, const struct genome_expr *out)
{
    bool *quotient = quotients(f);
    const bool is = out->length > 1 && has_quotient(f, out, quotient);
    free(quotient);
    return is;
}

#define LANES for (size_t j = 0; j < WIDE_LANES; j++)

WIDE void extend_range(const double *value, size_t n, double *lo, double *hi)
{
    double least[WIDE_LANES], most[WIDE_LANES];
    size_t i = 0;
    LANES least[j] = *lo, most[j] = *hi;
    for (; i + WIDE_LANES <= n; i += WIDE_LANES)
        LANES
        {
            const double x = value[i + j];
            least[j] = x < least[j] ? x : least[j];
            most[j] = x > most[j] ? x : most[j];
        }
    LANES *lo = least[j] < *lo ? least[j] : *lo, *hi = most[j] > *hi ? most[j] : *hi;
    for (; i < n; i++) {
        *lo = value[i] < *lo ? value[i] : *lo;
        *hi = value[i] > *hi ? value[i] : *hi;
    }
}

WIDE double farthest(const double *value, const double *mark, double factor, size_t n, double far)
{
    double most[WIDE_LANES] = {0};
    size_t i = 0;
    for (; i + WIDE_LANES <= n; i += WIDE_LANES)
        LANES
        {
            const double d = fabs(value[i + j] - factor * mark[i + j]);
            most[j] = d > most[j] ? d : most[j];
        }
    LANES far = most[j] > far ? most[j] : far;
    for (; i < n; i++)
        far = fmax(far, fabs(value[i] - factor * mark[i]));
    return far;
}

void add_range(struct genome_file *f, size_t input, double lo, double hi)
{
    char text[2][32];
    snprintf(text[0], sizeof text[0], "%.2f", floor(lo * 100) / 100);
    snprintf(text[1], sizeof text[1], "%.2f", ceil(hi * 100) / 100);
    genome_add_range(f, input, text[0], text[1]);
}

void require_magnitude(struct genome_file *f, const int *gene, size_t length, double most)
{
    char text[32];
    int *require = new_array(length + 3, sizeof *require);
    snprintf(text, sizeof text, "%.2g", most);
    require[0] = GENE_SUB;
    require[1] = -1 - (int)genome_add_constant(f, text);
    require[2] = GENE_ABS;
    memcpy(require + 3, gene, length * sizeof *gene);
    genome_add_require(f, require, length + 3);
    free(require);
}

void require_sign(struct genome_file *f, const int *gene, size_t length, double nearest)
{
    char text[32];
    int *require = new_array(length + 2, sizeof *require);
    snprintf(text, sizeof text, "%.2g", nearest);
    require[0] = GENE_SUB;
    require[nearest < 0 ? 1 : 1 + length] = -1 - (int)genome_add_constant(f, text);
    memcpy(require + 1 + (nearest < 0), gene, length * sizeof *gene);
    genome_add_require(f, require, length + 2);
    free(require);
}
