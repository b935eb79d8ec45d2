/* The evaluator of evolution. A prefix genome is translated once (kernel_translate.c) to instructions that each work on
 * a tile of eight vectors. The tile stays in registers from instruction to instruction; with 512 bits it holds 64
 * samples. Leaves are operands of their operators: columns are read in place from the first-level cache, constants are
 * broadcast from the instruction. A second tile of registers holds the shorter branch of an operator with two branches.
 * Rarely a branch does not fit there and is stored in a memory slot. The error |value - target| is summed at the end of
 * the tile's run; no value is written back.
 *
 * The interpreter (kernel_engine.h) is direct threaded: each instruction ends in its own jump to the next, and its body
 * is eight vector operations. The same source is compiled for registers of 128, 256 and 512 bits; a new workspace
 * selects the widest that the machine supports.
 *
 * All widths give the same bits. Values agree because every sample goes through the same correctly rounded,
 * uncontracted operations, whatever its tile; the quick division is also correctly rounded (kernel_divide.h). Sums
 * agree because their order is fixed: the errors of a block of 512 samples go to 64 lanes, sample i to lane i mod 64;
 * lanes are then added by halves, j + j + 32 and so on; block sums are added in double, in order. The bound is compared
 * after each block, so all widths stop at the same block. */
#include "kernel.h"

#include "../../codegen/genome/gene_value.h"
#include "kernel_code.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic" /* goto *label */
#if defined __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* for INDEPENDENT, in unoptimised builds */
#endif
#include "kernel_tile.h"

#if defined __x86_64__
#define TARGET_256 __attribute__((target("avx2,fma,bmi2")))
#define TARGET_512 __attribute__((target("avx2,fma,bmi2,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")))
#include "kernel_divide.h"
#endif

#if defined __AVX512F__
#define PLAIN_BYTES 64 /* set by the compiler's target options */
#elif defined __AVX__
#define PLAIN_BYTES 32
#else
#define PLAIN_BYTES 16
#endif

#define ENGINE plain
#define DIVIDE_TILE PLAIN_TILE
#define BYTES PLAIN_BYTES
#define TARGET
#include "kernel_engine.h"
#if defined __x86_64__
#define ENGINE with_256
#define DIVIDE_TILE PLAIN_TILE
#define BYTES 32
#define TARGET TARGET_256
#include "kernel_engine.h"
#define ENGINE with_512
#define DIVIDE_TILE QUICK_TILE
#define BYTES 64
#define TARGET TARGET_512
#include "kernel_engine.h"
#endif
#pragma GCC diagnostic pop

typedef double engine_fn(struct kernel_run *);
static const struct {
    int bits;
    engine_fn *run;
} engine[KERNEL_WIDTHS] = {
    {8 * PLAIN_BYTES, plain},
#if defined __x86_64__
    {256, with_256},
    {512, with_512},
#endif
};

struct kernel {
    enum kernel_width width;
    double work;
    struct translator *translator; /* owned */
    char *slot, *memory;           /* slots of tiles, aligned in `memory`, which is owned */
    size_t slots;
};

int kernel_bits(enum kernel_width width)
{
    return engine[width].bits;
}

bool kernel_supports(enum kernel_width width)
{
#if defined __x86_64__
    switch (width) {
    case KERNEL_256:
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
    case KERNEL_512:
        return kernel_supports(KERNEL_256) && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
    default:
        return true;
    }
#else
    return width == KERNEL_PLAIN;
#endif
}

struct kernel *kernel_new(enum kernel_width width)
{
    struct kernel *k = new_array(1, sizeof *k);
    *k = (struct kernel){.width = width, .translator = translator_new()};
    return k;
}

struct kernel *kernel_new_widest(void)
{
    enum kernel_width width = KERNEL_512;
    while (!kernel_supports(width))
        width--;
    return kernel_new(width);
}

void kernel_free(struct kernel *k)
{
    if (!k)
        return;
    translator_free(k->translator);
    free(k->memory);
    free(k);
}

static void reserve(struct kernel *k, size_t slots)
{
    if (slots <= k->slots)
        return;
    free(k->memory);
    k->slots = slots;
    k->memory = new_array(slots + 1, SLOT);
    k->slot = k->memory + (SLOT - (uintptr_t)k->memory % SLOT) % SLOT;
}

static double run(struct kernel *k, const struct kernel_task *t, struct kernel_run *r)
{
    size_t slots;
    r->code = translator_code(k->translator, t, &r->table, &slots);
    reserve(k, slots + 1);
    r->slot = k->slot;
    const double sum = engine[k->width].run(r);
    k->work += (double)t->length * (double)r->done;
    return sum;
}

double kernel_error_sum(struct kernel *k, const struct kernel_task *t, size_t target, double bound)
{
    const size_t stride = t->table->room * sizeof(double);
    struct kernel_run r = {.table = {t->table->data, t->table->n, stride}, .target = target * stride, .bound = bound};
    return run(k, t, &r);
}

void kernel_values(struct kernel *k, const struct kernel_task *t, double *value)
{
    struct kernel_run r = {.table = {t->table->data, t->table->n, t->table->room * sizeof(double)}, .value = value};
    run(k, t, &r);
}

double kernel_work(const struct kernel *k)
{
    return k->work;
}
