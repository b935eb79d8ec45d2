/* Draws a picture of a run's results on a mesh; see archive_write.h. Above: the verdict, and a cell for each function and band of
 * |gap|, of this run and of the shipped functions, coloured by the logarithm of the error. Below: histograms, with the
 * limits of the shipped functions. All letters have 15 units or more of 640: 9 pixels on a screen of 400. */
#include "archive_write.h"

#include "../../codegen/base/outfile.h"
#include "../../codegen/base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 640, MARGIN = 16, LABEL = 96, CELL = 61, LINE = 26, GAP = 20, BINS = 24, PANEL = 192, HEIGHT = 92 };

/* Draws formatted text. Markup is kept out of it. */
__attribute__((format(printf, 5, 6))) static void text(FILE *f, double x, double y, const char *how, const char *format,
                                                       ...)
{
    char words[1024];
    va_list args;
    va_start(args, format);
    vsnprintf(words, sizeof words, format, args);
    va_end(args);
    fprintf(f, "<text x=\"%g\" y=\"%g\"%s%s>", x, y, *how ? " " : "", how);
    for (const char *c = words; *c; c++)
        fputc(strchr("&<>", *c) ? '_' : *c, f);
    fputs("</text>\n", f);
}

/* Draws the verdict, each half of a sentence on a line; returns the last line. */
static double draw_verdict(FILE *f, double y, char *verdict)
{
    text(f, MARGIN, y, "class=\"h\"", "Functions to use on this mesh (cost: price of the operations)");
    for (char *end; *verdict; verdict = end + 1) {
        const bool first = strncmp(verdict, "footpoint_", 10) != 0;
        end = verdict + strcspn(verdict, ";\n");
        *end = '\0';
        y += 20;
        text(f, first ? MARGIN : MARGIN + 32, y, first ? "" : "fill=\"#666\"", "%s", verdict);
        end += end[1] == ' ';
    }
    return y;
}

/* Draws a cell in the colour of an error: red for 0.1 and above, through yellow and green to blue for rounding. */
static void draw_cell(FILE *f, double x, double y, double error, double other)
{
    const double part = fmin(1, fmax(0, (-1 - log10(fmax(error, 1e-16))) / 15));
    if (error < 0)
        return;
    fprintf(f, "<rect x=\"%g\" y=\"%g\" width=\"%d\" height=\"%d\" fill=\"hsl(%.0f,65%%,78%%)\"/>\n", x, y, CELL - 2,
            LINE - 2, 10 + 210 * part);
    text(f, x + CELL / 2.0 - 1, y + LINE - 8, 2 * fmax(error, 1e-15) <= other ? "class=\"m h\"" : "class=\"m\"",
         error < INFINITY ? "%.0e" : "none", error);
}

static double draw_errors(FILE *f, double y, const char *scene, const char *kind, const struct page_row *row,
                          size_t rows)
{
    const double left[2] = {MARGIN + LABEL, MARGIN + LABEL + GAP_BANDS * CELL + GAP};
    const char *const name[2] = {scene, kind};
    text(f, MARGIN, y, "class=\"h\"", "Mean error of xi and eta, by function and gap");
    text(f, MARGIN, y + 22, "", "On samples held out. Bold: at most half of the other's. Edge: the face's shortest.");
    text(f, MARGIN, y + 49, "", "Colours:");
    for (int k = 0; k < 6; k++)
        draw_cell(f, left[0] + k * CELL, y + 31, pow(10, -1 - 3 * k), -1);
    text(f, left[0] + 6.1 * CELL, y + 49, "", "empty: no function");
    y += 82;
    for (int k = 0; k < 2; k++) {
        char words[80];
        snprintf(words, sizeof words, "footpoint_%.14s_...", name[k]);
        for (char *c = words; *c; c++) /* as in names of functions */
            *c = *c == '-' ? '_' : *c;
        text(f, left[k], y, "class=\"h\"", "%s", words);
        for (int b = 0; b < GAP_BANDS; b++)
            text(f, left[k] + (b + 0.5) * CELL, y + 20, "class=\"m\"", "%s", gap_band_name[b]);
    }
    text(f, MARGIN, y + 20, "", "|gap| / edge");
    for (size_t i = 0; i < rows; i++) {
        const double top = y + 28 + LINE * (double)i;
        text(f, MARGIN, top + LINE - 8, "", "%s", row[i].tier);
        for (int b = 0; b < GAP_BANDS; b++) {
            draw_cell(f, left[0] + b * CELL, top, row[i].own[b], row[i].shipped[b]);
            draw_cell(f, left[1] + b * CELL, top, row[i].shipped[b], row[i].own[b]);
        }
    }
    return y + 28 + LINE * (double)rows;
}

/* Draws bars from 0 or the smallest value to the largest value or the limit, whichever is larger; red beyond it. */
static void draw_histogram(FILE *f, double x, double y, const struct page_measure *m)
{
    size_t count[BINS] = {0}, most = 1;
    double least = INFINITY, highest = 1.05 * m->limit;
    for (size_t i = 0; i < m->n; i++) {
        least = fmin(least, m->value[i]);
        highest = fmax(highest, m->value[i]);
    }
    const double lowest = least < 1 ? 0 : 1;
    highest = fmax(highest, lowest + 1e-3);
    const double width = (highest - lowest) / BINS, base = y + 24 + HEIGHT;
    for (size_t i = 0; i < m->n; i++) {
        const size_t bin = (size_t)fmin(BINS - 1, (m->value[i] - lowest) / width);
        count[bin]++;
        most = count[bin] > most ? count[bin] : most;
    }
    text(f, x, y + 18, "class=\"h\"", "%s", m->name);
    text(f, x + PANEL, y + 18, "class=\"e\"", "%.0f %%", 100 * (double)most / (double)m->n);
    for (int b = 0; b < BINS; b++) {
        const double high = HEIGHT * (double)count[b] / (double)most;
        fprintf(f, "<rect x=\"%g\" y=\"%.1f\" width=\"%g\" height=\"%.1f\" fill=\"%s\"/>\n", x + b * PANEL / BINS,
                base - high, PANEL / (double)BINS - 1, high,
                m->limit >= 0 && lowest + b * width > m->limit ? "#c33" : "#4a78b5");
    }
    fprintf(f, "<path d=\"M%g %gh%dM%g %gh%d\" stroke=\"#888\"/>\n", x, y + 23.5, PANEL, x, base + 0.5, PANEL);
    const double at = m->limit < 0 ? -INFINITY : x + PANEL * (m->limit - lowest) / (highest - lowest);
    if (m->limit >= 0) {
        fprintf(f, "<path d=\"M%.1f %gv%d\" stroke=\"#c33\" stroke-width=\"2\" stroke-dasharray=\"5 3\"/>\n", at,
                y + 24, HEIGHT);
        text(f, at, base + 16, "class=\"m\" fill=\"#c33\"", "%.2g", m->limit);
    }
    if (fabs(at - x) > 48)
        text(f, x, base + 16, "", "%.2g", lowest);
    if (fabs(at - x - PANEL) > 48)
        text(f, x + PANEL, base + 16, "class=\"e\"", "%.2g", highest);
}

static double draw_histograms(FILE *f, double y, const struct page_measure *m, size_t n)
{
    enum { COLUMNS = 3, STEP = HEIGHT + 60 };
    text(f, MARGIN, y, "class=\"h\"", "Shapes of the faces, and gaps");
    text(f, MARGIN, y + 22, "", "Bars: parts of the samples. Dashed: limits of the shipped functions.");
    for (size_t i = 0; i < n; i++)
        draw_histogram(f, MARGIN + (double)(i % COLUMNS) * (PANEL + 16), y + 32 + (double)(i / COLUMNS) * STEP, &m[i]);
    return y + 32 + (double)((n + COLUMNS - 1) / COLUMNS) * STEP;
}

bool page_write(const char *path, const char *scene, const char *kind, char *verdict, const struct page_row *row,
                size_t rows, const struct page_measure *measure, size_t measures, struct diag *d)
{
    struct outfile out;
    if (!outfile_open(&out, path, d))
        return false;
    struct memory *m = memory_open();
    double y = *verdict ? draw_verdict(m->stream, 30, verdict) : -4;
    if (rows > 0)
        y = draw_errors(m->stream, y + 34, scene, kind, row, rows);
    y = draw_histograms(m->stream, y + 34, measure, measures);
    char *drawn = memory_close(m);
    fprintf(out.stream,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %g\" preserveAspectRatio=\"xMidYMin\" "
            "font-family=\"sans-serif\" "
            "font-size=\"15\">\n"
            "<style>.h { font-weight: bold } .m { text-anchor: middle } .e { text-anchor: end }</style>\n"
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n%s</svg>\n",
            WIDTH, y, drawn);
    free(drawn);
    return outfile_commit(&out, d);
}
