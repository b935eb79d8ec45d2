/* Statements with other names, so that a frame can stand in a program more than once. */
#include "genome.h"
#include "names.h"
#include "text.h"
#include "words.h"

#include <stdlib.h>
#include <string.h>

static const struct name *find_own(const struct genome_function *x, const struct genome_file *f, const char *text)
{
    const struct name *n = x ? names_find(&x->names, text) : NULL;
    n = n ? n : names_find(&f->names, text);
    return n && (n->statement != NO_STATEMENT) ? n : NULL;
}

/* Of a component, the vector's name is the one that is changed. */
static bool is_component(const struct genome_function *x, const struct genome_file *f, const struct name *n)
{
    char *vector = new_text(n->text, strlen(n->text) - 1);
    const struct name *v = n->kind == NAME_NUMBER ? find_own(x, f, vector) : NULL;
    free(vector);
    return v && v->kind == NAME_VECTOR && v->statement == n->statement && n->gene >= v->gene && n->gene < v->gene + 3;
}

char *genome_statement_suffixed(const struct genome_file *f, size_t k, const char *suffix)
{
    const struct genome_statement *s = &f->statement[k];
    const long function = genome_find_function(f, s->name);
    const struct genome_function *x = function < 0 ? NULL : &f->function[function];
    struct memory *m = memory_open();
    struct words w = words_of(s->text, strlen(s->text));
    for (const char *end = s->text; words_next(&w, false); end = w.at) {
        char text[NAME_ROOM];
        const struct name *n = word_copy(&w, text, sizeof text) ? find_own(x, f, text) : NULL;
        const size_t stem = n && is_component(x, f, n) ? w.length - 1 : w.length;
        fwrite(end, 1, (size_t)(w.word - end), m->stream);
        fprintf(m->stream, "%.*s%s%.*s", (int)stem, w.word, n ? suffix : "", (int)(w.length - stem), w.word + stem);
    }
    return memory_close(m);
}
