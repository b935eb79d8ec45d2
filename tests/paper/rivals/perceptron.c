/* Evaluates networks and their derivatives; see perceptron.h. */
#include "perceptron.h"

#include "../../../evolve/common/stream.h"
#include "../../../evolve/eval/frame.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

size_t perceptron_weights(const struct perceptron *p)
{
    size_t n = 0;
    for (size_t l = 1; l < p->layers; l++)
        n += p->size[l] * (1 + p->size[l - 1]);
    return n;
}

void perceptron_draw(const struct perceptron *p, uint64_t seed, double *weight)
{
    gsl_rng *stream = stream_new();
    for (size_t l = 1; l < p->layers; l++) {
        const double most = sqrt(3 / (double)(1 + p->size[l - 1]));
        stream_key(stream, seed, l, p->size[l - 1], p->size[l]);
        for (size_t i = p->size[l] * (1 + p->size[l - 1]); i > 0; i--)
            *weight++ = most * (2 * gsl_rng_uniform(stream) - 1);
    }
    gsl_rng_free(stream);
}

void perceptron_forward(const struct perceptron *p, const double *weight, const double *in, struct perceptron_state *s)
{
    memcpy(s->value[0], in, p->size[0] * sizeof *in);
    for (size_t l = 1; l < p->layers; l++)
        for (size_t j = 0; j < p->size[l]; j++) {
            double sum = *weight++;
            for (size_t i = 0; i < p->size[l - 1]; i++)
                sum += *weight++ * s->value[l - 1][i];
            s->sum[l][j] = sum;
            s->value[l][j] = l < p->layers - 1 ? sum / sqrt(1 + sum * sum) : sum;
        }
}

/* Returns the derivative of the sigmoid. */
static double sigmoid_slope(double sum)
{
    const double square = 1 + sum * sum;
    return 1 / (square * sqrt(square));
}

void perceptron_backward(const struct perceptron *p, const double *weight, const struct perceptron_state *s, size_t k,
                         double *slope, size_t stride)
{
    double by_sum[PERCEPTRON_WIDTH] = {0}, by_value[PERCEPTRON_WIDTH];
    size_t end = perceptron_weights(p);
    by_sum[k] = 1;
    for (size_t l = p->layers - 1; l > 0; l--) {
        const size_t inputs = p->size[l - 1], first = end - p->size[l] * (1 + inputs);
        memset(by_value, 0, sizeof by_value);
        for (size_t j = 0, at = first; j < p->size[l]; j++, at += 1 + inputs) {
            slope[at * stride] = by_sum[j];
            for (size_t i = 0; i < inputs; i++) {
                slope[(at + 1 + i) * stride] = by_sum[j] * s->value[l - 1][i];
                by_value[i] += by_sum[j] * weight[at + 1 + i];
            }
        }
        for (size_t i = 0; l > 1 && i < inputs; i++)
            by_sum[i] = by_value[i] * sigmoid_slope(s->sum[l - 1][i]);
        end = first;
    }
}

/* ---- genome text ---- */

/* Rounds the weight to the written digits. */
static int constant_of(double *weight, struct genome_file *program)
{
    char text[32];
    snprintf(text, sizeof text, "%.7g", *weight);
    *weight = strtod(text, NULL);
    return -1 - (int)genome_add_constant(program, text);
}

/* Writes genes of bias + sum of weight * input: 4 for each input, and 1.  Returns their number. */
static size_t weighted_sum(double *weight, const int *input, size_t inputs, struct genome_file *program, int *gene)
{
    size_t n = 0;
    for (size_t i = 0; i < inputs; i++) {
        gene[n++] = GENE_ADD;
        gene[n++] = GENE_MUL;
        gene[n++] = constant_of(&weight[1 + i], program);
        gene[n++] = input[i];
    }
    gene[n++] = constant_of(weight, program);
    return n;
}

static int add_let(struct genome_file *program, const char *name, char kind, size_t layer, size_t neuron,
                   const int *gene, size_t length)
{
    char let[100];
    snprintf(let, sizeof let, "%s_%c%zu_%zu", name, kind, layer, neuron + 1);
    genome_add_let(program, let, gene, length);
    return GENE_SYMBOL + (int)genome_find_symbol(program, let);
}

struct genome *perceptron_add(const struct perceptron *p, double *weight, const int *input, const char *name,
                              struct genome_file *program)
{
    int from[PERCEPTRON_WIDTH], to[PERCEPTRON_WIDTH], gene[4 * PERCEPTRON_WIDTH + 1];
    const int one = -1 - (int)genome_add_constant(program, "1");
    struct genome *g = genome_add(program, name);
    memcpy(from, input, p->size[0] * sizeof *from);
    for (size_t l = 1; l < p->layers; l++) {
        for (size_t j = 0; j < p->size[l]; j++, weight += 1 + p->size[l - 1]) {
            const size_t length = weighted_sum(weight, from, p->size[l - 1], program, gene);
            if (l == p->layers - 1) {
                genome_add_expr(&g->out, &g->outs, &g->out_room, frame_output[j], gene, length);
                continue;
            }
            const int s = add_let(program, name, 's', l, j, gene, length);
            const int sigmoid[] = {GENE_DIV, s, GENE_SQRT, GENE_ADD, one, GENE_MUL, s, s};
            to[j] = add_let(program, name, 'y', l, j, sigmoid, sizeof sigmoid / sizeof *sigmoid);
        }
        memcpy(from, to, sizeof from);
    }
    return g;
}
