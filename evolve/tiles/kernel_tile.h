/* Macros of the interpreter kernel_engine.h. A tile is eight named vectors, so that they stay in registers. */
#define PASTE_(x, y) x##y
#define PASTE(x, y) PASTE_(x, y)

#define EIGHT(M, x) M(0, x), M(1, x), M(2, x), M(3, x), M(4, x), M(5, x), M(6, x), M(7, x)
#define NAMES(i, t) t##i
#define EIGHT_DO(M, x) M(0, x) M(1, x) M(2, x) M(3, x) M(4, x) M(5, x) M(6, x) M(7, x)
#define AT(p, i) (*(VECTOR *)((p) + (i)*BYTES))
#define AT_CONST(p, i) (*(const VECTOR *)((p) + (i)*BYTES))
#define CLEAR(i, t) t##i = (VECTOR){0};
#define LOAD(i, p) a##i = AT_CONST(p, i);
#define FILL(i, c) a##i = c;
#define SAVE(i, p) AT(p, i) = a##i;
#define PUT(i, p) *(ELSEWHERE *)(void *)((char *)(p) + (i)*BYTES) = a##i;
#define DIFFERENCE(i, p) a##i = (VECTOR)((BITS)(a##i - AT_CONST(p, i)) & magnitude);
#define ADD_TO_LANE(i, first) *(VECTOR *)(lane + ((first) + (i)*BYTES / sizeof(double)) % KERNEL_LANES) += a##i;

/* The operators: t##i = x op y. */
#define OPERATE_ADD(i, t, x, y) t##i = (x) + (y);
#define OPERATE_SUB(i, t, x, y) t##i = (x) - (y);
#define OPERATE_MUL(i, t, x, y) t##i = (x) * (y);
#define OPERATE_DIV(i, t, x, y) t##i = (x) / (y);
#define OPERATE_PDIV(i, t, x, y)                                                                                       \
    {                                                                                                                  \
        const VECTOR divisor = (y);                                                                                    \
        const BITS zero = (BITS)(divisor == (VECTOR){0});                                                              \
        t##i = (VECTOR)(((BITS)((x) / divisor) & ~zero) | ((BITS)((VECTOR){0} + 1) & zero));                           \
    }
/* Selects x where `first` is true, otherwise y: one instruction if the machine has it. */
#define OPERATE_CHOICE(t, x, y, first)                                                                                 \
    {                                                                                                                  \
        const VECTOR one = (x), other = (y);                                                                           \
        const BITS chosen = (BITS)(first);                                                                             \
        t = (VECTOR)(((BITS)one & chosen) | ((BITS)other & ~chosen));                                                  \
    }
#define OPERATE_MIN(i, t, x, y) OPERATE_CHOICE(t##i, x, y, one < other)
#define OPERATE_MAX(i, t, x, y) OPERATE_CHOICE(t##i, x, y, one > other)
#define PLAIN_TILE(op, t, X, Y)                                                                                        \
    OPERATE_##op(0, t, X(0), Y(0)) OPERATE_##op(1, t, X(1), Y(1)) OPERATE_##op(2, t, X(2), Y(2))                       \
        OPERATE_##op(3, t, X(3), Y(3)) OPERATE_##op(4, t, X(4), Y(4)) OPERATE_##op(5, t, X(5), Y(5))                   \
            OPERATE_##op(6, t, X(6), Y(6)) OPERATE_##op(7, t, X(7), Y(7))
#define TILE_ADD PLAIN_TILE
#define TILE_SUB PLAIN_TILE
#define TILE_MUL PLAIN_TILE
#define TILE_MIN PLAIN_TILE
#define TILE_MAX PLAIN_TILE
#define TILE_DIV DIVIDE_TILE
#define TILE_PDIV DIVIDE_TILE
#define OF_A(i) a##i
#define OF_B(i) b##i
#define OF_P(i) AT_CONST(p, i)
#define OF_Q(i) AT_CONST(q, i)
#define OF_C(i) c

#define LABEL(name) __extension__ &&name
#define NEXT                                                                                                           \
    at++;                                                                                                              \
    goto *label[at->code];
#define WITH_P(base) const char *p = (base) + at->a;
#define WITH_PQ                                                                                                        \
    WITH_P(column)                                                                                                     \
    const char *q = column + at->u.b;
#define WITH_C const VECTOR c = at->u.number - (VECTOR){0};
#define WITH_PC WITH_P(column) WITH_C
#define HANDLER(name, op, t, WITH, X, Y)                                                                               \
    name : {                                                                                                           \
        WITH TILE_##op(op, t, X, Y) NEXT                                                                               \
    }
#define LABELS_OF_ONE(op, t)                                                                                           \
    LABEL(op##_##t##_column), LABEL(op##_column_##t), LABEL(op##_##t##_constant), LABEL(op##_constant_##t),            \
        LABEL(op##_##t##_from_columns), LABEL(op##_##t##_from_column_constant), LABEL(op##_##t##_from_constant_column)
#define LABELS(op, ...)                                                                                                \
    LABELS_OF_ONE(op, a), LABELS_OF_ONE(op, b), LABEL(op##_a_b), LABEL(op##_b_a), LABEL(op##_a_slot),                  \
        LABEL(op##_slot_a),
#define HANDLERS_OF_ONE(op, t, T)                                                                                      \
    HANDLER(op##_##t##_column, op, t, WITH_P(column), T, OF_P)                                                         \
    HANDLER(op##_column_##t, op, t, WITH_P(column), OF_P, T)                                                           \
    HANDLER(op##_##t##_constant, op, t, WITH_C, T, OF_C)                                                               \
    HANDLER(op##_constant_##t, op, t, WITH_C, OF_C, T)                                                                 \
    HANDLER(op##_##t##_from_columns, op, t, WITH_PQ, OF_P, OF_Q)                                                       \
    HANDLER(op##_##t##_from_column_constant, op, t, WITH_PC, OF_P, OF_C)                                               \
    HANDLER(op##_##t##_from_constant_column, op, t, WITH_PC, OF_C, OF_P)
#define HANDLERS(op, ...)                                                                                              \
    HANDLERS_OF_ONE(op, a, OF_A)                                                                                       \
    HANDLERS_OF_ONE(op, b, OF_B)                                                                                       \
    HANDLER(op##_a_b, op, a, , OF_A, OF_B)                                                                             \
    HANDLER(op##_b_a, op, a, , OF_B, OF_A)                                                                             \
    HANDLER(op##_a_slot, op, a, WITH_P(r->slot), OF_A, OF_P)                                                           \
    HANDLER(op##_slot_a, op, a, WITH_P(r->slot), OF_P, OF_A)

/* A loop that the compiler may vectorise. */
#if defined __clang__
#define INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define INDEPENDENT _Pragma("GCC ivdep")
#endif
#define SLOW_CASE(op, ...)                                                                                             \
    case GENE_##op:                                                                                                    \
        INDEPENDENT for (size_t i = 0; i < TILE; i++) x[i] = gene_value(GENE_##op, x[i], 0);                           \
        break;
