/* The interpreter, included once for each register width. The includer must define BYTES (of a register), TARGET
 * (attribute of the function), ENGINE (its name) and DIVIDE_TILE (PLAIN_TILE, or a quicker division). */

#define TILE (8 * BYTES / sizeof(double)) /* samples */
#define VECTOR PASTE(ENGINE, _vector)
#define BITS PASTE(ENGINE, _bits)
#define ELSEWHERE PASTE(ENGINE, _elsewhere)

typedef double VECTOR __attribute__((vector_size(BYTES), may_alias));
typedef int64_t BITS __attribute__((vector_size(BYTES), may_alias));
typedef double ELSEWHERE __attribute__((vector_size(BYTES), may_alias, aligned(sizeof(double))));

/* Excluded from sanitizers, which would take minutes to compile it. */
TARGET __attribute__((no_sanitize("address", "undefined"))) static double ENGINE(struct kernel_run *r)
{
    static const void *const label[CODES] = {
        GENES_OF_TWO(LABELS) LABEL(load_column), LABEL(load_constant), LABEL(store), LABEL(slow), LABEL(end),
    };
    const BITS magnitude = (BITS){0} + INT64_MAX;
    double sum = 0;
    VECTOR EIGHT(NAMES, a), EIGHT(NAMES, b);
    EIGHT_DO(CLEAR, a)
    EIGHT_DO(CLEAR, b)
    for (size_t row = 0; row < r->table.n; row += KERNEL_BLOCK) {
        const size_t rest = r->table.n - row, left = rest < KERNEL_BLOCK ? rest : KERNEL_BLOCK;
        double lane[KERNEL_LANES] __attribute__((aligned(64))) = {0};
        for (size_t first = 0; first < left; first += TILE) {
            const char *const column = (const char *)r->table.data + (row + first) * sizeof(double);
            const struct instruction *at = r->code - 1;
            NEXT GENES_OF_TWO(HANDLERS) load_column:
            {
                const char *p = column + at->a;
                EIGHT_DO(LOAD, p)
                NEXT
            }
        load_constant : {
            const VECTOR c = at->u.number - (VECTOR){0};
            EIGHT_DO(FILL, c)
            NEXT
        }
        store : {
            char *p = r->slot + at->a;
            EIGHT_DO(SAVE, p)
            NEXT
        }
        slow : {
            double *x = (double *)r->slot;
            EIGHT_DO(SAVE, r->slot)
            switch (at->gene) {
                GENES_OF_ONE(SLOW_CASE)
            }
            EIGHT_DO(LOAD, r->slot)
            EIGHT_DO(CLEAR, b) /* tells the compiler that b is dead here: no value lives across the loops */
            NEXT
        }
        end:
            if (r->value && first + TILE <= left) {
                double *to = r->value + row + first;
                EIGHT_DO(PUT, to)
            } else if (r->value) {
                EIGHT_DO(SAVE, r->slot)
                memcpy(r->value + row + first, r->slot, (left - first) * sizeof(double));
            } else {
                const char *goal = column + r->target;
                EIGHT_DO(DIFFERENCE, goal)
                if (first + TILE <= left) {
                    EIGHT_DO(ADD_TO_LANE, first)
                } else {
                    EIGHT_DO(SAVE, r->slot)
                    for (size_t j = 0; first + j < left; j++)
                        lane[(first + j) % KERNEL_LANES] += ((const double *)r->slot)[j];
                }
            }
        }
        r->done += left;
        if (r->value)
            continue;
        for (size_t half = KERNEL_LANES / 2; half > 0; half /= 2)
            for (size_t j = 0; j < half; j++)
                lane[j] += lane[j + half];
        sum += lane[0];
        if (!(sum <= r->bound))
            return INFINITY;
    }
    return isfinite(sum) ? sum : INFINITY;
}

#undef TILE
#undef VECTOR
#undef BITS
#undef ELSEWHERE
#undef ENGINE
#undef BYTES
#undef TARGET
#undef DIVIDE_TILE
