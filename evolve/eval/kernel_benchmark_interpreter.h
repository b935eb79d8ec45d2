/* A plain interpreter, included for each precision: REAL, and INTERPRETER, the function's name. */
#define EACH(expression)                                                                                               \
    for (size_t i = 0; i < BLOCK; i++)                                                                                 \
    y[i] = (expression)

/* Sum of |value - target|: columns begin `room` apart, the target is the last of VARIABLES + 1. */
static inline __attribute__((always_inline)) double INTERPRETER(const struct tree *t, const REAL *column, size_t room,
                                                                const struct genome_constant *constant)
{
    static REAL stack[LONGEST][BLOCK] __attribute__((aligned(64)));
    double sum = 0;
    for (size_t row = 0; row < SAMPLES; row += BLOCK) {
        REAL(*top)[BLOCK] = stack; /* one past the top */
        for (size_t g = t->length; g-- > 0;) {
            const int gene = t->gene[g];
            if (gene_arity(gene) == 2)
                top--;
            else
                top++;
            REAL *y = top[-1];
            const REAL *x = top[0]; /* popped: the operand read last is the first one */
            switch (gene) {
            case GENE_ADD:
                EACH(x[i] + y[i]);
                break;
            case GENE_SUB:
                EACH(x[i] - y[i]);
                break;
            case GENE_MUL:
                EACH(x[i] * y[i]);
                break;
            case GENE_PDIV:
                EACH(y[i] == 0 ? 1 : x[i] / y[i]);
                break;
            default:
                if (gene >= GENE_SYMBOL)
                    memcpy(y, column + (size_t)(gene - GENE_SYMBOL) * room + row, sizeof *stack);
                else
                    EACH((REAL)constant[-1 - gene].value);
            }
        }
        REAL block = 0;
        for (size_t i = 0; i < BLOCK; i++) {
            const REAL difference = stack[0][i] - column[VARIABLES * room + row + i];
            block += difference < 0 ? -difference : difference;
        }
        sum += (double)block;
    }
    return sum;
}

#undef EACH
#undef REAL
#undef INTERPRETER
