# Fuzzing of the genome reader, compiler and proof for about a minute; skipped where clang has no fuzzer.
. tests/cli/expect.inc
fuzzer=$work/fuzz_genome
if ! { echo 'int LLVMFuzzerTestOneInput(const unsigned char *, unsigned long);'
       echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { return (void)d, (void)n, 0; }'; } |
    clang -fsanitize=fuzzer,address,undefined -x c - -o "$fuzzer" 2> /dev/null; then
    echo 'ok 1 - fuzzing # SKIP no clang with -fsanitize=fuzzer (Debian: libclang-rt-14-dev)'
    exit 0
fi
sources=$(ls codegen/*/*.c)
awk -f codegen/print/templates.awk codegen/print/templates/*.h codegen/print/templates/*/*.h > "$work/templates.inc"
clang -std=c11 -D_DEFAULT_SOURCE -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all \
    -I"$work" tests/fuzz/fuzz_genome.c $sources $(pkg-config --libs libmd) -lflint-arb -lflint -lmpfr -lgmp -lm -o "$fuzzer"
report $((! $?)) 'the fuzzer builds'
printf '"%s"\n' 'footpoint-genome 1\x0a' 'input ' 'note ' 'segment quad4 any\x0a' 'range x ' 'require ' 'least ' ', ' 'let a = ' 'genome h\x0a' \
    'end\x0a' ' = ' ' + ' ' - ' ' * ' ' / ' ' % ' ' min ' ' max ' ' neg ' ' sqrt ' ' abs ' ' dot ' ' cross ' ' vector ' ' -> ' ' step 1' 'footpoint-genome 2\x0a' 'footpoint-genome 3\x0a' '(' ')' 'f(x, ' '*' '-' 'function f u v -> w\x0a' ' 0.5' ' -1e3' ' 1e-300' ' x' ' y' > "$work/words"
mkdir "$work/corpus"
cp tests/fuzz/corpus/*.gen "$work/corpus"
"$fuzzer" -dict="$work/words" -max_len=600 -timeout=20 -rss_limit_mb=2048 -max_total_time=${FUZZ_SECONDS:-60} -seed=1 -print_final_stats=1 \
    -artifact_prefix="$work/" "$work/corpus" > "$work/log" 2>&1
status=$?
[ $status -eq 0 ] || { grep -v '^#' "$work/log" | tail -40 | sed 's/^/# /'; cat "$work"/crash-* "$work"/timeout-* 2> /dev/null | base64 | sed 's/^/# /'; }
sed -n 's/^stat::number_of_executed_units: */# runs: /p' "$work/log"
report $((! status)) 'a minute of fuzzing'
