/* Draws a picture of a run's results on a mesh; see page.h. Above: a cell for each function and band of |gap|, of this
 * run and of the shipped functions, coloured by the logarithm of the error. Below: histograms, with the limits of the
 * shipped functions. */
#include "page.h"

#include "../../codegen/base/outfile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 640, MARGIN = 16, LABEL = 92, CELL = 54, LINE = 26, GAP = 24, BINS = 24, PANEL = 192, HEIGHT = 92 };

static void text(FILE *f, double x, double y, const char *how, const char *words)
{
    fprintf(f, "<text x=\"%g\" y=\"%g\"%s%s>%s</text>\n", x, y, *how ? " " : "", how, words);
}

/* Maps an error to a colour: red for 0.1 and above, through yellow and green to blue for rounding. */
static void fill(double error, char colour[24])
{
    const double part = fmin(1, fmax(0, (-1 - log10(fmax(error, 1e-16))) / 15));
    snprintf(colour, 24, "hsl(%.0f,65%%,78%%)", 10 + 210 * part);
}

static void draw_cell(FILE *f, double x, double y, double error)
{
    char colour[24], words[16];
    if (error < 0)
        return;
    fill(error, colour);
    fprintf(f, "<rect x=\"%g\" y=\"%g\" width=\"%d\" height=\"%d\" fill=\"%s\"/>\n", x, y, CELL - 2, LINE - 2, colour);
    snprintf(words, sizeof words, error < INFINITY ? "%.0e" : "none", error);
    text(f, x + CELL / 2.0 - 1, y + LINE - 9, "text-anchor=\"middle\" class=\"n\"", words);
}

static double draw_errors(FILE *f, double y, const char *scene, const char *kind, const struct page_row *row,
                          size_t rows)
{
    const double left[2] = {MARGIN + LABEL, MARGIN + LABEL + GAP_BANDS * CELL + GAP};
    const char *const name[2] = {scene, kind};
    for (int k = 0; k < 2; k++) {
        char words[80];
        snprintf(words, sizeof words, "footpoint_%.50s_...", name[k]);
        for (char *c = words; *c; c++) /* as in names of functions; keeps markup out of the text */
            *c = strchr("-&<>", *c) ? '_' : *c;
        text(f, left[k], y, "class=\"h\"", words);
        for (int b = 0; b < GAP_BANDS; b++)
            text(f, left[k] + (b + 0.5) * CELL, y + 20, "text-anchor=\"middle\" class=\"n\"", gap_band_name[b]);
    }
    text(f, MARGIN, y + 20, "class=\"n\"", "|gap| / edge");
    for (size_t i = 0; i < rows; i++) {
        const double top = y + 28 + LINE * (double)i;
        text(f, MARGIN, top + LINE - 9, "", row[i].tier);
        for (int b = 0; b < GAP_BANDS; b++) {
            draw_cell(f, left[0] + b * CELL, top, row[i].own[b]);
            draw_cell(f, left[1] + b * CELL, top, row[i].shipped[b]);
        }
    }
    return y + 28 + LINE * (double)rows;
}

static int ascending(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

/* Draws bars from 0 or the smallest value to the largest value or the limit, whichever is larger. */
static void draw_histogram(FILE *f, double x, double y, struct page_measure *m)
{
    size_t count[BINS] = {0}, most = 1;
    char words[120];
    qsort(m->value, m->n, sizeof *m->value, ascending);
    const double lowest = m->value[0] < 1 ? 0 : 1, highest = fmax(m->value[m->n - 1], 1.05 * m->limit);
    const double width = (highest > lowest ? highest - lowest : 1) / BINS;
    for (size_t i = 0; i < m->n; i++) {
        const size_t bin = (size_t)fmin(BINS - 1, (m->value[i] - lowest) / width);
        count[bin]++;
        most = count[bin] > most ? count[bin] : most;
    }
    text(f, x, y + 14, "class=\"h\"", m->name);
    for (int b = 0; b < BINS; b++) {
        const double high = HEIGHT * (double)count[b] / (double)most;
        fprintf(f, "<rect x=\"%g\" y=\"%.1f\" width=\"%g\" height=\"%.1f\" fill=\"#4a78b5\"/>\n", x + b * PANEL / BINS,
                y + 24 + HEIGHT - high, PANEL / (double)BINS - 1, high);
    }
    fprintf(f, "<path d=\"M%g %gh%d\" stroke=\"#555\"/>\n", x, y + 24.5 + HEIGHT, PANEL);
    snprintf(words, sizeof words, "%.2g", lowest);
    text(f, x, y + HEIGHT + 40, "class=\"n\"", words);
    snprintf(words, sizeof words, "%.2g", highest);
    text(f, x + PANEL, y + HEIGHT + 40, "text-anchor=\"end\" class=\"n\"", words);
    if (m->limit < 0)
        return;
    const double at = x + PANEL * (m->limit - lowest) / (highest - lowest);
    fprintf(f, "<path d=\"M%.1f %gv%d\" stroke=\"#c33\" stroke-width=\"2\" stroke-dasharray=\"5 3\"/>\n", at, y + 20,
            HEIGHT + 4);
    snprintf(words, sizeof words, "%.2g", m->limit);
    if (m->limit < 0.85 * highest && m->limit > 0.15 * highest)
        text(f, at, y + HEIGHT + 40, "text-anchor=\"middle\" class=\"n\" fill=\"#c33\"", words);
}

static double draw_histograms(FILE *f, double y, const char *kind, struct page_measure *m, size_t n)
{
    enum { COLUMNS = 3, STEP = HEIGHT + 56 };
    char words[120];
    snprintf(words, sizeof words, "faces and gaps of the samples; dashed: limits that footpoint_%.20s.h was bred in",
             kind);
    text(f, MARGIN, y, "", words);
    for (size_t i = 0; i < n; i++)
        draw_histogram(f, MARGIN + (double)(i % COLUMNS) * (PANEL + 16), y + 10 + (double)(i / COLUMNS) * STEP, &m[i]);
    return y + 10 + (double)((n + COLUMNS - 1) / COLUMNS) * STEP;
}

bool page_write(const char *path, const char *scene, const char *kind, const struct page_row *row, size_t rows,
                struct page_measure *measure, size_t measures, struct diag *d)
{
    struct outfile out;
    if (!outfile_open(&out, path, d))
        return false;
    const size_t lines = (measures + 2) / 3;
    fprintf(out.stream,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %zu\" font-family=\"sans-serif\" "
            "font-size=\"15\">\n"
            "<style>.h { font-weight: bold } .n { font-size: 13px }</style>\n"
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
            WIDTH, 120 + LINE * rows + lines * (HEIGHT + 56));
    text(out.stream, MARGIN, 26, "", "mean error of xi and eta on samples held out, by function and by gap");
    const double y = draw_errors(out.stream, 52, scene, kind, row, rows);
    draw_histograms(out.stream, y + 32, kind, measure, measures);
    fputs("</svg>\n", out.stream);
    return outfile_commit(&out, d);
}
