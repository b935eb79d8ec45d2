/* Prints templates; see templates.h.  The Makefile makes templates.inc from them. */
#include "templates.h"

#include "../base/text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 118 };

static const struct {
    const char *name, *text;
} line[] = {
#include "templates.inc"
};

static const struct {
    const char *word, *text[2]; /* by precision */
} real[] = {
    {"REAL", {"double", "float"}},
    {"REAL_BITS", {"unsigned long long", "unsigned int"}}, /* an integer of its width */
    {"REAL_TOP", {"63", "31"}},                            /* the number of its highest bit */
    {"REAL_DIGITS", {"53", "24"}},                         /* of the mantissa */
    {"REAL_UNIT", {"1.12e-16", "6e-8f"}},                  /* relative rounding error, rounded up */
    {"REAL_MIN", {"2.2250738585072014e-308", "1.1754944e-38f"}},
    {"REAL_MIDDLE", {"511", "31"}}, /* middle of biased exponents from 2^-LOW to 2^HIGH */
    {"REAL_LOW", {"512", "96"}},
    {"REAL_HIGH", {"512", "32"}},
    {"REAL_ORDINARY", {"32", "12"}},    /* products of edges from 2^-this to 2^this stay in range */
    {"REAL_CLOSE", {"1e-9", "3e-4f"}},  /* proved for a whole segment if promises are finer */
    {"REAL_WITHIN", {"1e-9", "1e-4f"}}, /* the same of curved faces */
    {"REAL_NEAR", {"4e-10", "4e-6f"}},  /* to a border; less where promises are finer and slopes do not lead outwards */
    {"REAL_EDGE", {"1e-15", "4e-7f"}},  /* some units of rounding, from an edge */
    {"REAL_STEP", {"2.3e-16", "1.2e-7f"}}, /* the distance of 1 and the next number, rounded up */
    {"REAL_STILL", {"1e-9", "1e-5f"}},     /* steps below may be rounding */
    {"REAL_FAINT", {"1e-300", "5e-26f"}},  /* more than products of eight lengths underflow by */
    {"REAL_WEAK", {"1e-6", "1.2e-3f"}},    /* least determinant, over the squares that it is a difference of */
    {"REAL_CRAMER", {"1e-8", "1.5e-3f"}},  /* relative error of a quotient by that determinant */
    {"REAL_FINE", {"1e-11", "1e-3f"}},     /* fine promises are below this */
    {"REAL_APART", {"1e-6", "1e-3f"}},     /* steps above change the distance by more than rounding */
    {"REAL_TIE", {"1e-10", "3e-5f"}},      /* below, rounding decides between distances, over the longest edge */
    {"REAL_FLAT", {"1e-20", "1e-9f"}},     /* the square of the sine below which tangents are parallel */
    {"REAL_MARGIN", {"4e-16", "2e-7f"}},   /* rounding errors of the square of a distance */
    {"REAL_ANGLE", {"1e-24", "1e-12f"}},   /* the square of the sine below which a vector lies in a plane */
    {"REAL_TURN", {"1e-12", "1e-6f"}},     /* its root */
    {"REAL_SMALL", {"1e-29", "1e-12f"}},   /* the square of the rounding errors of a vector, over its parts */
    {"REAL_ALONG", {"1e-9", "1e-3f"}},     /* promise of projection along a direction; its name */
    {"ALONG_PROMISE", {"FOOTPOINT_ALONG_PROMISE", "FOOTPOINT_ALONG_PROMISE_F"}},
    {"REAL_ROOT", {"0x5fe6eb50c7b537a9ull", "0x5f3759dfu"}}, /* see patch_lane.h */
    {"REAL_INWARD", {"0.0009765625", "0.03125f"}},           /* part of the way to the middle, for normals of corners */
    {"atan2", {"atan2", "atan2f"}},
    {"copysign", {"copysign", "copysignf"}},
    {"fabs", {"fabs", "fabsf"}},
    {"frexp", {"frexp", "frexpf"}},
    {"ldexp", {"ldexp", "ldexpf"}},
    {"sqrt", {"sqrt", "sqrtf"}}};

static const char *find_text(const char *word, size_t n, enum precision precision, const struct placeholder *own)
{
    for (; own && own->word; own++)
        if (strlen(own->word) == n && memcmp(own->word, word, n) == 0)
            return own->text;
    for (size_t i = 0; i < sizeof real / sizeof *real; i++)
        if (strlen(real[i].word) == n && memcmp(real[i].word, word, n) == 0)
            return real[i].text[precision == PRECISION_FLOAT];
    return NULL;
}

/* Prints an identifier that is not a placeholder itself, part by part. */
static void print_parts(const char *word, size_t n, enum precision precision, const struct placeholder *own, FILE *out)
{
    static const char detail[] = "footpoint_detail_";
    const size_t beginning = strlen(detail);
    if (precision == PRECISION_FLOAT && n > beginning && memcmp(word, detail, beginning) == 0) {
        fprintf(out, "%sf_", detail);
        word += beginning;
        n -= beginning;
    }
    for (size_t i = 0, part; i < n; i += part + 1) {
        part = strcspn(word + i, "_");
        part = part < n - i ? part : n - i;
        const char *text = own ? find_text(word + i, part, precision, own) : NULL;
        fprintf(out, "%s%.*s", i ? "_" : "", text ? (int)strlen(text) : (int)part, text ? text : word + i);
    }
}

/* Returns the length of the word or number at `text`. */
static size_t token_length(const char *text)
{
    size_t n = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    if (!isdigit((unsigned char)*text))
        return n ? n : 1;
    n = strspn(text, "0123456789.");
    if (text[n] == 'e') {
        n += strspn(text + n, "e-+");
        n += strspn(text + n, "0123456789");
    }
    return n;
}

static void print_text(const char *text, enum precision precision, const struct placeholder *own, FILE *out)
{
    for (size_t n; *text; text += n) {
        n = token_length(text);
        const bool number = isdigit((unsigned char)*text), name = isalpha((unsigned char)*text);
        const char *instead = name ? find_text(text, n, precision, own) : NULL;
        const bool ends = n > 0 && text[n - 1] == '.'; /* a sentence */
        const bool real_number = number && !ends && strcspn(text, ".e") < n;
        const char *type = real_number && own ? find_text("REAL_NUMBER", strlen("REAL_NUMBER"), precision, own) : NULL;
        if (instead)
            fputs(instead, out);
        else if (type)
            fprintf(out, "%s(%.*s)", type, (int)n, text);
        else if (name)
            print_parts(text, n, precision, own, out);
        else
            fwrite(text, 1, n, out);
        if (real_number && precision == PRECISION_FLOAT && text[n] != 'f')
            fputc('f', out);
    }
}

void c_print(const char *text, enum precision precision, FILE *out)
{
    print_text(text, precision, NULL, out);
}

void c_print_words(const char *text, const struct placeholder *own, FILE *out)
{
    print_text(text, PRECISION_DOUBLE, own, out);
}

/* Returns the column after the last parenthesis that the line leaves open, or 0. */
static size_t open_column(const char *text)
{
    size_t column[20], depth = 0;
    for (size_t i = 0; text[i] && depth < sizeof column / sizeof *column; i++)
        if (text[i] == '(')
            column[depth++] = i + 1;
        else if (text[i] == ')' && depth > 0)
            depth--;
    return depth > 0 ? column[depth - 1] : 0;
}

/* Prints a line of the text.  A long line is broken after commas, and continued below its first parenthesis or, inside a
 * parenthesis, with the current indent. */
static void print_line(const char *rest, bool goes_on, FILE *out)
{
    const int indent = (int)(goes_on ? strspn(rest, " ") : strcspn(rest, "(") + 1);
    const char *end = rest + strlen(rest);
    const bool breaks = strncmp(rest, "/*", 2) != 0 && *rest != '#' && (goes_on || *rest != ' ');
    for (int before = 0; breaks && end - rest + before > WIDTH; before = indent) {
        const char *comma = rest + WIDTH - before;
        while (comma > rest && memcmp(comma, ", ", 2) != 0)
            comma--;
        if (comma <= rest)
            break;
        fprintf(out, "%.*s\n%*s", (int)(comma - rest) + 1, rest, indent, "");
        rest = comma + 2;
    }
    fputs(rest, out);
}

/* Joins two lists; caller frees. */
static struct placeholder *joined_words(const struct placeholder *first, const struct placeholder *second)
{
    size_t n = 0, m = 0;
    while (first && first[n].word)
        n++;
    while (second && second[m].word)
        m++;
    struct placeholder *all = new_array(n + m + 1, sizeof *all);
    for (size_t i = 0; i < n + m; i++)
        all[i] = i < n ? first[i] : second[i - n];
    return all;
}

struct printed {
    enum precision precision;
    const struct block *block; /* not owned: ends with a word NULL; or NULL */
    FILE *out;
};

/* Returns the block that begins with the line, or NULL. */
static const struct block *block_at(const struct block *b, const char *text)
{
    for (text += strspn(text, " "); b && b->word; b++)
        if (strncmp(text, "WITH_", 5) == 0 && strlen(b->word) + 6 == strlen(text) &&
            strncmp(text + 5, b->word, strlen(b->word)) == 0)
            return b;
    return NULL;
}

/* Returns the line that ends the block. */
static size_t block_end(const struct block *b, size_t i)
{
    char *end = new_format("END_%s\n", b->word);
    while (strcmp(line[i].text + strspn(line[i].text, " "), end) != 0)
        i++;
    free(end);
    return i;
}

/* Prints the text of a word instead of a line that consists of this word.  Returns false for other lines. */
static bool print_instead(const char *text, const struct placeholder *own, FILE *out)
{
    for (text += strspn(text, " "); own && own->word; own++)
        if (strlen(own->word) + 1 == strlen(text) && strncmp(own->word, text, strlen(own->word)) == 0)
            return fputs(own->text, out) >= 0;
    return false;
}

/* Continues inside a parenthesis with the indent that it now has. */
static void print_lines(size_t begin, size_t end, const struct placeholder *own, const struct printed *p)
{
    size_t before = 0, now = 0;
    for (size_t i = begin; i < end; i++) {
        const struct block *b = block_at(p->block, line[i].text);
        if (b) {
            const size_t last = block_end(b, i);
            for (size_t k = 0; k < b->passes; k++) {
                struct placeholder *all = joined_words(b->pass ? b->pass[k] : NULL, own);
                print_lines(i + 1, last, all, p);
                free(all);
            }
            i = last;
            continue;
        }
        if (print_instead(line[i].text, own, p->out))
            continue;
        const size_t indent = strspn(line[i].text, " ");
        const bool goes_on = before > 0 && indent == before;
        struct memory *m = memory_open();
        fprintf(m->stream, "%*s", (int)(goes_on ? now : indent), "");
        print_text(line[i].text + indent, p->precision, own, m->stream);
        char *text = memory_close(m);
        print_line(text, goes_on, p->out);
        if (!goes_on || open_column(line[i].text)) {
            before = open_column(line[i].text);
            now = open_column(text);
        }
        free(text);
    }
}

void templates_print_blocks(const char *name, enum precision precision, const struct placeholder *own,
                            const struct block *block, FILE *out)
{
    const struct printed p = {precision, block, out};
    const size_t all = sizeof line / sizeof *line;
    size_t begin = 0, end;
    while (begin < all && strcmp(line[begin].name, name) != 0)
        begin++;
    for (end = begin; end < all && strcmp(line[end].name, name) == 0; end++)
        continue;
    print_lines(begin, end, own, &p);
}

void templates_print(const char *guard, const char *const *name, enum precision precision,
                     const struct placeholder *own, FILE *out)
{
    char *upper = new_format("%s%s", guard ? guard : "", precision == PRECISION_FLOAT ? "_F" : "");
    for (char *c = upper; *c; c++)
        *c = (char)toupper((unsigned char)*c);
    if (guard)
        fprintf(out, "\n#ifndef %s\n#define %s", upper, upper);
    for (size_t i = 0; name[i]; i++) {
        fputc('\n', out);
        templates_print_blocks(name[i], precision, own, NULL, out);
    }
    fputs(guard ? "#endif\n" : "", out);
    free(upper);
}
