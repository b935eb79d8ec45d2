/* Memo of the scales of recent graphs; see scales_memo.h. A graph replaces another with a similar key. */
#include "scales_memo.h"

#include "../base/random.h"

#include <stdlib.h>

enum { REMEMBERED = 512 };

struct scales_memo {
    struct remembered {
        uint64_t key[2];
        rational *scale; /* owned: by place in the order; NULL: empty */
        double work;
    } slot[REMEMBERED];
};

struct scales_memo *scales_memo_new(void)
{
    return new_array(1, sizeof(struct scales_memo));
}

void scales_memo_free(struct scales_memo *m)
{
    for (size_t i = 0; m && i < REMEMBERED; i++)
        free(m->slot[i].scale);
    free(m);
}

static void mix(uint64_t key[2], uint64_t with)
{
    key[0] = random_mix(key[0] ^ with) + 1;
    key[1] = random_mix(key[1] + with) + 1;
}

/* Computes a key of everything that the search depends on: used nodes, operands, outputs. Two graphs share a key with a
 * chance of about 2^-100. */
static void find_key(const struct schedule *s, bool groups, uint64_t key[2])
{
    const struct dag *g = s->dag;
    key[0] = 1 + groups;
    key[1] = g->outputs;
    for (size_t i = 0; i < s->n; i++) {
        const struct node *n = &g->node[s->order[i]];
        mix(key, (uint64_t)n->kind << 48 ^ (uint64_t)n->edges << 32 ^ (uint64_t)s->order[i]);
        for (size_t k = 0; k < n->edges; k++) {
            mix(key, (uint64_t)n->edge[k].coef << 32 ^ (uint64_t)n->edge[k].node);
            mix(key, (uint64_t)n->edge[k].power);
        }
    }
    for (size_t o = 0; o < g->outputs; o++)
        mix(key, (uint64_t)g->output[o].coef << 32 ^ (uint64_t)g->output[o].node);
}

static struct remembered *place_of(struct scales_memo *m, const uint64_t key[2])
{
    return &m->slot[key[0] % REMEMBERED];
}

bool scales_recall(struct scales_memo *m, struct schedule *s, bool groups)
{
    uint64_t key[2];
    find_key(s, groups, key);
    const struct remembered *r = place_of(m, key);
    if (!r->scale || r->key[0] != key[0] || r->key[1] != key[1])
        return false;
    for (size_t i = 0; i < s->n; i++)
        s->scale[s->order[i]] = r->scale[i];
    s->work = r->work;
    return true;
}

void scales_remember(struct scales_memo *m, const struct schedule *s, bool groups)
{
    uint64_t key[2];
    find_key(s, groups, key);
    struct remembered *r = place_of(m, key);
    free(r->scale);
    *r = (struct remembered){{key[0], key[1]}, new_array(s->n, sizeof *r->scale), s->work};
    for (size_t i = 0; i < s->n; i++)
        r->scale[i] = s->scale[s->order[i]];
}
