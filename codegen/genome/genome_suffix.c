/* Statements with other names, so that a frame can stand in a program more than once. */
#include "genome.h"
#include "names.h"
#include "text.h"
#include "words.h"

#include <stdlib.h>
#include <string.h>

/* What statement k, or one that it needs, defines in the file; a function's own names stay as they are. */
static const struct name *find_defined(const struct genome_file *f, size_t k, const char *text)
{
    const struct genome_statement *s = &f->statement[k];
    const struct name *n = names_find(&f->names, text);
    bool defined = n && n->statement == k;
    for (size_t i = 0; n && i < s->needs; i++)
        defined = defined || s->need[i] == n->statement;
    return defined ? n : NULL;
}

/* Of a component, the vector's name is the one that is changed. */
static bool is_component(const struct genome_file *f, size_t k, const struct name *n)
{
    char *vector = new_text(n->text, strlen(n->text) - 1);
    const struct name *v = n->kind == NAME_NUMBER ? find_defined(f, k, vector) : NULL;
    free(vector);
    return v && v->kind == NAME_VECTOR && v->statement == n->statement && n->gene >= v->gene && n->gene < v->gene + 3;
}

char *genome_statement_suffixed(const struct genome_file *f, size_t k, const char *suffix)
{
    const struct genome_statement *s = &f->statement[k];
    struct memory *m = memory_open();
    struct words w = words_of(s->text, strlen(s->text));
    for (const char *end = s->text; words_next(&w, false); end = w.at) {
        char text[NAME_ROOM];
        const struct name *n = word_copy(&w, text, sizeof text) ? find_defined(f, k, text) : NULL;
        const size_t stem = n && is_component(f, k, n) ? w.length - 1 : w.length;
        fwrite(end, 1, (size_t)(w.word - end), m->stream);
        fprintf(m->stream, "%.*s%s%.*s", (int)stem, w.word, n ? suffix : "", (int)(w.length - stem), w.word + stem);
    }
    return memory_close(m);
}
