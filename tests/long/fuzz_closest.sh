# Fuzzing of the search functions for half a minute; skipped where clang has no fuzzer.
. tests/cli/expect.inc
fuzzer=$work/fuzz_closest
if ! clang -std=c11 -D_DEFAULT_SOURCE -O1 -g -ffp-contract=off -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all \
    tests/fuzz/fuzz_closest.c runtime/geometry/*.c runtime/search/*.c runtime/certain/*.c -lm -o "$fuzzer" 2> "$work/log"; then
    if grep -q 'libclang_rt' "$work/log"; then
        echo 'ok 1 - fuzzing # SKIP no clang with -fsanitize=fuzzer (Debian: libclang-rt-14-dev)'
        exit 0
    fi
    sed 's/^/# /' "$work/log"
    report 0 'the fuzzer builds'
    exit 1
fi
mkdir "$work/corpus"
cp tests/fuzz/closest/* "$work/corpus"
"$fuzzer" -max_len=120 -timeout=20 -max_total_time=${FUZZ_SECONDS:-30} -seed=1 -print_final_stats=1 -artifact_prefix="$work/" "$work/corpus" \
    > "$work/log" 2>&1
status=$?
[ $status -eq 0 ] || { grep -v '^#' "$work/log" | tail -40 | sed 's/^/# /'; cat "$work"/crash-* "$work"/timeout-* 2> /dev/null | base64 | sed 's/^/# /'; }
sed -n 's/^stat::number_of_executed_units: */# runs: /p' "$work/log"
report $((! status)) 'half a minute of fuzzing'
