/* Reads terms given by hand; see pga_terms.h. */
#include "pga_terms.h"

#include <stdlib.h>
#include <string.h>

struct term_reader {
    const char *path;
    int line;
    const struct genome_file *program;
    const struct polynomials *p;
    struct diag *d;
};

static bool has_factors(const struct monomial *m, const int *symbol, size_t n)
{
    bool used[MONOMIAL_DEGREE] = {false};
    for (size_t i = 0; i < n; i++) {
        size_t k = 0;
        while (k < m->degree && (used[k] || m->symbol[k] != symbol[i]))
            k++;
        if (k == m->degree)
            return false;
        used[k] = true;
    }
    return m->degree == n;
}

/* Reads a product, "xc xc yd" or "1". */
static bool read_term(const struct term_reader *r, char *text, gene_bit *chosen)
{
    int symbol[MONOMIAL_DEGREE];
    size_t n = 0, factors = 0;
    char *rest;
    for (char *name = strtok_r(text, " \t", &rest); name; name = strtok_r(NULL, " \t", &rest), factors++) {
        if (strcmp(name, "1") == 0)
            continue;
        const long k = genome_find_symbol(r->program, name);
        if (k < 0)
            return diag_at(r->d, r->path, r->line, 0, "unknown symbol '%.64s'", name);
        if (n == MONOMIAL_DEGREE)
            return diag_at(r->d, r->path, r->line, 0, "a term of more than %d factors", MONOMIAL_DEGREE);
        symbol[n++] = GENE_SYMBOL + (int)k;
    }
    if (factors == 0)
        return diag_at(r->d, r->path, r->line, 0, "an empty term");
    for (size_t i = 0; i < r->p->count; i++)
        if (has_factors(&r->p->term[i], symbol, n)) {
            chosen[i] = 1;
            return true;
        }
    return diag_at(r->d, r->path, r->line, 0, "a term is no monomial of the tier's terminals and this order");
}

static bool read_line(const struct term_reader *r, char *list, gene_bit *chosen)
{
    char *rest;
    bool good = true;
    for (char *term = strtok_r(list, ",", &rest); good && term; term = strtok_r(NULL, ",", &rest))
        good = read_term(r, term, chosen);
    return good;
}

bool pga_terms_read(const char *path, const char *output, const struct genome_file *program,
                    const struct polynomials *p, gene_bit *chosen, struct diag *d)
{
    struct term_reader r = {path, 0, program, p, d};
    size_t size;
    char *text = read_text(path, &size, d), *rest;
    bool good = text != NULL, found = false;
    for (char *line = text; good && line && !found; line = rest) {
        r.line++;
        rest = strchr(line, '\n');
        if (rest)
            *rest++ = '\0';
        line[strcspn(line, "#")] = '\0';
        char *equals = strchr(line, '=');
        if (!equals)
            continue;
        *equals = '\0';
        line[strcspn(line, " \t")] = '\0';
        found = strcmp(line, output) == 0;
        good = !found || read_line(&r, equals + 1, chosen);
    }
    free(text);
    return good && (found || diag_at(d, path, 0, 0, "no terms for '%s'", output));
}
