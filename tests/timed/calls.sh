# What a caller of quad4 pays, bare, checked and over arrays, beside converged Newton with the same checks: the table of
# README.md, for AVX2 and, where the machine has it, AVX-512.  A search without iteration is never slower bare than Newton.
# Along a direction is 1.5 times as quick as Newton in three unknowns, 4 times over arrays.  `bare` is what checking takes: NAME over
# NAME_at, NAME_checked_n over NAME_n.  Square roots over arrays vectorise with -fno-math-errno.
# Closest points of the closed face stand beside four triangles; over arrays their loops take -fno-trapping-math and
# -fno-math-errno to vectorise, with which they are printed once more, and are at least twice as quick.
. tests/cli/expect.inc
CC=${CC:-gcc}
isas=x86-64-v3
grep -q avx512f /proc/cpuinfo && isas="$isas x86-64-v4"
for isa in $isas; do
    wide=; [ $isa = x86-64-v4 ] && wide=-mprefer-vector-width=512
    for flags in '-fno-trapping-math -fno-math-errno' ''; do
        # shellcheck disable=SC2086
        $CC -std=c11 -D_DEFAULT_SOURCE -O3 $flags -march=$isa $wide -o "$work/calls" tests/bench/bench_calls_main.c \
            tests/hard/hard.c tests/hard/draw.c tests/hard/wild.c "$BIN/libfootpoint.a" -lm && "$work/calls" > "$work/calls.csv"
        report $((! $?)) "$isa: runs"
        [ -n "$flags" ] || break
        grep -E 'closest|four|_checked_n|along' "$work/calls.csv" | sed "s/^/# $flags: /"
        awk -F, '/_closest_n,/ { n++; bad = bad || $3 < 2 } END { exit bad || n != 9 }' "$work/calls.csv"
        report $((! $?)) "$isa: closest points over arrays"
        awk -F, '/_checked_n,/ { n++; bad = bad || $3 < 2 } /^along/ { n++; bad = bad || $3 < (/_n/ ? 4 : 1.5) } END { exit bad || n != 11 }' "$work/calls.csv"
        report $((! $?)) "$isa: checked searches over arrays, along a direction"
    done
    sed 's/^/# /' "$work/calls.csv"
    awk -F, '/_at,|_n,/ && $1 !~ /^(newton|full|four)|closest|checked/ && $3 < 1 { bad = 1 } END { exit bad || NR < 46 }' "$work/calls.csv"
    report $((! $?)) "$isa: bare searches are quicker than Newton"
    # Faces of six, eight and nine nodes.
    $CC -std=c11 -D_DEFAULT_SOURCE -O3 -fno-math-errno -march=$isa $wide -o "$work/curved" tests/bench/bench_curved_main.c tests/hard/draw.c \
        "$BIN/libfootpoint_ccx.a" "$BIN/libfootpoint.a" -lm && "$work/curved" > "$work/curved.csv"
    report $((! $?)) "$isa: curved faces run"
    sed 's/^/# /' "$work/curved.csv"
    awk -F, '/_along,/ && !/newton/ { n++; bad = bad || $3 < 1 } END { exit bad || n != 3 }' "$work/curved.csv"
    report $((! $?)) "$isa: along a direction through curved faces"
    awk -F, '/_checked_n,/ { n++; bad = bad || $3 < 2 } END { exit bad || n != 3 }' "$work/curved.csv"
    report $((! $?)) "$isa: checked searches over arrays of curved faces"
done
