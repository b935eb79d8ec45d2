/* Selects a table of methods that this machine can run; see bench_methods.h. */
#include "bench_methods.h"

#include <string.h>

/* Tables that are linked, by ISAS= of the Makefile. Tests compile "quick", with little optimisation. */
extern const struct bench_table bench_table_quick __attribute__((weak));
#ifdef __x86_64__
extern const struct bench_table bench_table_x86_64 __attribute__((weak)), bench_table_x86_64_v3 __attribute__((weak)),
    bench_table_x86_64_v4 __attribute__((weak));

static int has_v3(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
}

static int has_v4(void)
{
    return has_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}

/* Lists the tables, best first, and returns their number. */
static int tables(const struct bench_table *found[4])
{
    int n = 0;
    __builtin_cpu_init();
    if (&bench_table_x86_64_v4 && has_v4())
        found[n++] = &bench_table_x86_64_v4;
    if (&bench_table_x86_64_v3 && has_v3())
        found[n++] = &bench_table_x86_64_v3;
    if (&bench_table_x86_64)
        found[n++] = &bench_table_x86_64;
    if (&bench_table_quick)
        found[n++] = &bench_table_quick;
    return n;
}
#else
extern const struct bench_table bench_table_portable __attribute__((weak));

static int tables(const struct bench_table *found[4])
{
    int n = 0;
    if (&bench_table_portable)
        found[n++] = &bench_table_portable;
    if (&bench_table_quick)
        found[n++] = &bench_table_quick;
    return n;
}
#endif

const struct bench_table *bench_table_for(const char *isa)
{
    const struct bench_table *found[4];
    const int n = tables(found);
    for (int i = 0; i < n; i++)
        if (!isa || strcmp(found[i]->isa, isa) == 0)
            return found[i];
    return NULL;
}
