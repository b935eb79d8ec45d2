/* Queue of boxes for branch and bound, by largest key; of equal keys, the oldest first. */
#ifndef FOOTPOINT_BOX_QUEUE_H
#define FOOTPOINT_BOX_QUEUE_H

#include "interval.h"

#include <stddef.h>

struct waiting {
    double key;
    size_t age, slot;
};

struct boxes {
    size_t variables;      /* sides of a box */
    struct waiting *heap;  /* owned */
    struct interval *side; /* owned: by slot and variable */
    size_t *vacant;        /* owned: slots of boxes taken out */
    size_t n, room, slots, side_room, vacancies, vacant_room, born;
};

/** Halves a box across variable k and returns the lower (0) or upper (1) half. */
void box_half(const struct interval *box, size_t variables, size_t k, int which, struct interval *half);

void boxes_push(struct boxes *b, double key, const struct interval *box);
/** Removes the first box, copies it, and returns its key. */
double boxes_pop(struct boxes *b, struct interval *box);
void boxes_free(struct boxes *b);

#endif
