# Checks batches with OpenMP: the bits of single searches on any number of threads, and no data race.
. tests/cli/expect.inc
CC=${CC:-gcc}
flags='-std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -fno-math-errno -fno-trapping-math -fopenmp'
sources="tests/runtime/test_batch.c tests/support/ordinary_quad.c evolve/common/stream.c $(ls runtime/geometry/*.c runtime/search/*.c runtime/certain/*.c runtime/batch/*.c)"
libraries=$(pkg-config --libs cmocka gsl)
# shellcheck disable=SC2086
$CC $flags -O3 $sources $libraries -lm -o "$work/threads" > "$work/log" 2>&1
report $((! $?)) 'batches build with OpenMP'
for threads in 1 2 3 7; do
    OMP_NUM_THREADS=$threads "$work/threads" > "$work/log" 2>&1
    good=$((! $?))
    [ "$good" = 1 ] || sed 's/^/# /' "$work/log"
    report "$good" "$threads threads"
done

# GNU's OpenMP hides its synchronisation from the sanitizer; LLVM's tells it, through the tool Archer.
archer=$(ls /usr/lib/llvm-*/lib/libarcher.so 2> /dev/null | tail -1)
cat > "$work/race.c" << 'END'
int main(void)
{
    int sum = 0;
#pragma omp parallel for
    for (int i = 0; i < 1000; i++)
        sum += i;
    return sum == 1;
}
END
export OMP_NUM_THREADS=4 OMP_TOOL_LIBRARIES="$archer" TSAN_OPTIONS='ignore_noninstrumented_modules=1 exitcode=66'
if [ -z "$archer" ] || ! clang -g -fopenmp -fsanitize=thread "$work/race.c" -o "$work/race" 2> /dev/null; then
    report 1 'skipped: thread sanitizer (Debian: libclang-rt-14-dev libomp-14-dev)'
    exit 0
fi
"$work/race" > "$work/log" 2>&1
[ $? = 66 ]; report $((! $?)) 'the thread sanitizer sees a race'
# shellcheck disable=SC2086
clang $flags -O1 -g -fsanitize=thread $sources $libraries -lm -o "$work/threads" > "$work/log" 2>&1 &&
    "$work/threads" > "$work/log" 2>&1
good=$((! $?))
[ "$good" = 1 ] || sed 's/^/# /' "$work/log"
report "$good" 'and none in batches'
