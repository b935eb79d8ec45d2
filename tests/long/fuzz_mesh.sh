# Fuzzes the reader of contact meshes under the sanitizers with libFuzzer: a minute (FUZZ_SECONDS=; 0: until FUZZ_RUNS= inputs
# are read).  Skipped if clang has none.
. tests/cli/expect.inc
sources="tests/fuzz/fuzz_mesh.c $(ls evolve/input/inp_*.c codegen/base/*.c) evolve/input/mesh.c codegen/genome/names.c \
    codegen/genome/segment_kind.c"
# shellcheck disable=SC2086
if ! clang -std=c11 -D_DEFAULT_SOURCE -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all $sources \
    $(pkg-config --libs libmd) -lm -o "$work/fuzzer" > "$work/log" 2>&1; then
    echo "ok 1 - fuzzing # SKIP no clang with -fsanitize=fuzzer (Debian: libclang-rt-14-dev)"
    exit 0
fi
printf '"%s"\n' '*NODE' '*ELEMENT, TYPE=C3D8, ELSET=' '*ELEMENT, TYPE=S4' '*NSET, NSET=' '*ELSET, ELSET=' ', ELSET=' ', GENERATE' \
    ', INSTANCE=' '*SURFACE, NAME=' ', TYPE=NODE' ', COMBINE=UNION' ', COMBINE=DIFFERENCE' '*CONTACT PAIR' '*TIE' \
    '*CONTACT INCLUSIONS' '*PART, NAME=' '*END PART' '*INSTANCE, NAME=' ', PART=' '*END INSTANCE' '*ASSEMBLY, NAME=' \
    '*END ASSEMBLY' '*INCLUDE, INPUT=' ', S1' ', SPOS' ', E1' '\x0a' '\x0d' ', ' '**' > "$work/words"
mkdir "$work/corpus" "$work/beside"
cp tests/meshes/decks/*.inp tests/meshes/*[0-9].inp tests/meshes/wedges.inp "$work/corpus"
printf '*NODE, NSET=N\n1, 0, 0, 0\n' > "$work/beside/1"
(cd "$work/beside" && "$work/fuzzer" -dict="$work/words" -max_len=4000 -timeout=20 -rss_limit_mb=2048 -max_total_time="${FUZZ_SECONDS:-60}" -runs="${FUZZ_RUNS:--1}" -seed=1 \
    -print_final_stats=1 -artifact_prefix="$work/" "$work/corpus") > "$work/log" 2>&1
status=$?
[ $status -eq 0 ] || { grep -v '^#' "$work/log" | tail -40; cat "$work"/crash-* "$work"/timeout-* 2> /dev/null | base64; } | sed 's/^/# /'
sed -n 's/^stat::number_of_executed_units: */# runs: /p' "$work/log"
report $((! status)) 'fuzzing contact meshes'
