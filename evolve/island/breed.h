/* The two ways of breeding: how a population starts, makes a generation, and accepts n migrants from a parcel. */
#ifndef FOOTPOINT_BREED_H
#define FOOTPOINT_BREED_H

#include "population.h"

void breed_paper_start(struct island *is, const struct genes *seed, size_t n);
void breed_paper_step(struct island *is);
void breed_paper_receive(struct island *is, size_t n, int *parcel);

void breed_front_start(struct island *is, const struct genes *seed, size_t n);
void breed_front_step(struct island *is);
void breed_front_receive(struct island *is, size_t n, int *parcel);

#endif
