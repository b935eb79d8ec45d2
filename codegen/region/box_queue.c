/* A binary heap of boxes; see box_queue.h. */
#include "box_queue.h"

#include "../base/base.h"

#include <stdlib.h>
#include <string.h>

void box_half(const struct interval *box, size_t variables, size_t k, int which, struct interval *half)
{
    memcpy(half, box, variables * sizeof *box);
    *(which ? &half[k].lo : &half[k].hi) = interval_middle(box[k]);
}

static bool comes_before(struct waiting a, struct waiting b)
{
    return a.key != b.key ? a.key > b.key : a.age < b.age;
}

static size_t new_slot(struct boxes *b)
{
    if (b->vacancies > 0)
        return b->vacant[--b->vacancies];
    for (size_t k = 0; k < b->variables; k++)
        grow_array(&b->side, b->slots * b->variables + k, &b->side_room, sizeof *b->side);
    return b->slots++;
}

void boxes_push(struct boxes *b, double key, const struct interval *box)
{
    const struct waiting new = {key, b->born++, new_slot(b)};
    if (b->variables > 0)
        memcpy(b->side + new.slot * b->variables, box, b->variables * sizeof *box);
    grow_array(&b->heap, b->n, &b->room, sizeof *b->heap);
    size_t at = b->n++;
    for (; at > 0 && comes_before(new, b->heap[(at - 1) / 2]); at = (at - 1) / 2)
        b->heap[at] = b->heap[(at - 1) / 2];
    b->heap[at] = new;
}

double boxes_pop(struct boxes *b, struct interval *box)
{
    const struct waiting first = b->heap[0], last = b->heap[--b->n];
    size_t at = 0;
    for (size_t child; (child = 2 * at + 1) < b->n; at = child) {
        if (child + 1 < b->n && comes_before(b->heap[child + 1], b->heap[child]))
            child++;
        if (!comes_before(b->heap[child], last))
            break;
        b->heap[at] = b->heap[child];
    }
    b->heap[at] = last;
    if (b->variables > 0)
        memcpy(box, b->side + first.slot * b->variables, b->variables * sizeof *box);
    APPEND(b->vacant, b->vacancies, b->vacant_room) = first.slot;
    return first.key;
}

void boxes_free(struct boxes *b)
{
    free(b->heap);
    free(b->side);
    free(b->vacant);
    *b = (struct boxes){.variables = b->variables};
}
