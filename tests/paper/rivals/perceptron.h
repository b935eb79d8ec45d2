/* Multi-layer perceptrons, as in the neural-network approach of Oishi and Yoshimura (2007): fully connected layers,
 * hidden neurons with the sigmoid s / sqrt(1 + s^2) of a weighted sum s, linear outputs.  The sigmoid is made of genes,
 * so that a network is genome text like any other expression and its cost is counted alike. */
#ifndef FOOTPOINT_PERCEPTRON_H
#define FOOTPOINT_PERCEPTRON_H

#include "../../../codegen/genome/genome.h"

#include <stdint.h>

enum { PERCEPTRON_LAYERS = 6, PERCEPTRON_WIDTH = 64 };

/** Neurons of each layer: inputs, hidden layers, outputs; at most PERCEPTRON_WIDTH each. */
struct perceptron {
    size_t layers; /* 2..PERCEPTRON_LAYERS */
    size_t size[PERCEPTRON_LAYERS];
};

/** Returns the number of weights.  They are stored layer after layer and neuron after neuron: its bias, then the weights of the layer
 *  before. */
size_t perceptron_weights(const struct perceptron *p);

/** Draws weights to start from: uniform, of variance 1 / (inputs of the neuron); biases as well. */
void perceptron_draw(const struct perceptron *p, uint64_t seed, double *weight);

/** The values of the neurons for an input. */
struct perceptron_state {
    double sum[PERCEPTRON_LAYERS][PERCEPTRON_WIDTH], value[PERCEPTRON_LAYERS][PERCEPTRON_WIDTH];
};

/** Computes forwards: fills the state from in[size[0]]; the outputs are s->value[layers - 1]. */
void perceptron_forward(const struct perceptron *p, const double *weight, const double *in, struct perceptron_state *s);

/** Computes backwards: slope[i * stride] = derivative of output k by weight i, in the state of the last forward pass. */
void perceptron_backward(const struct perceptron *p, const double *weight, const struct perceptron_state *s, size_t k,
                         double *slope, size_t stride);

/** Appends the network as a genome with outputs xi and eta; every neuron of the hidden layers is two lets, NAME_sL_N
 * (its sum) and NAME_yL_N.  Rounds the weights to the seven digits that are written.
 *  @param[in] input  genes of the inputs in `program` */
struct genome *perceptron_add(const struct perceptron *p, double *weight, const int *input, const char *name,
                              struct genome_file *program);

#endif
