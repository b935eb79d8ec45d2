# Fuzzing of the runtime library's searches under the sanitizers: a minute with libFuzzer, or random inputs without it.
. tests/cli/expect.inc
flags='-std=c11 -D_DEFAULT_SOURCE -O1 -g -ffp-contract=off -fsanitize=address,undefined -fno-sanitize-recover=all'
sources="tests/fuzz/fuzz_search.c $(ls runtime/geometry/*.c runtime/search/*.c runtime/certain/*.c runtime/batch/*.c)"
mkdir "$work/corpus"
cp tests/fuzz/search/*.bin "$work/corpus"
# shellcheck disable=SC2086
if clang $flags -fsanitize=fuzzer $sources -lm -o "$work/fuzzer" 2> /dev/null; then
    "$work/fuzzer" -max_len=800 -timeout=20 -rss_limit_mb=2048 -max_total_time=${FUZZ_SECONDS:-60} -seed=1 -print_final_stats=1 \
        -artifact_prefix="$work/" "$work/corpus" > "$work/log" 2>&1
    status=$?
    [ $status -eq 0 ] || { grep -v '^#' "$work/log" | tail -40 | sed 's/^/# /'; cat "$work"/crash-* "$work"/timeout-* 2> /dev/null | base64 | sed 's/^/# /'; }
    sed -n 's/^stat::number_of_executed_units: */# runs: /p' "$work/log"
    report $((! status)) 'a minute of fuzzing the searches'
else
    echo '# no clang with -fsanitize=fuzzer (Debian: libclang-rt-14-dev)'
fi
# shellcheck disable=SC2086
${CC:-gcc} $flags $sources tests/fuzz/replay_main.c -lm -o "$work/replay" &&
    "$work/replay" "$work"/corpus/* > "$work/log" 2>&1 && "$work/replay" --random 300000 1 > "$work/log" 2>&1
status=$?
[ $status -eq 0 ] || sed 's/^/# /' "$work/log"
report $((! status)) 'corpus and random inputs of the searches'
