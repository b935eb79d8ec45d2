# Judges some hard cases of each family: the search never errs without a status, in double or in float, footpoint_robust finds the
# closest point or returns a status, and no certificate is wrong.  long/hard_cases.sh does so at length.
. tests/cli/expect.inc
. tests/hard/build.inc
FOOTPOINT_BUILT=
[ -n "$FOOTPOINT_LONG" ] || [ "$BIN" != build ] || FOOTPOINT_BUILT=1
expect 'the hard cases judge by what the check vouches for' 0 "$(sed -n 's/^#define FOOTPOINT_CHECK_WORST //p' runtime/certain/check.h)" '' \
    sed -n 's/^#define BANNER_WORST //p' tests/hard/judges.h
LIBRARY="$BIN/libfootpoint_ccx.a $BIN/libfootpoint.a"
later 'hard: optimised headers'
[ -n "$FOOTPOINT_LONG" ] && level=-O1 || level="-O0 $called"
# shellcheck disable=SC2086
hard_build "$work/hard" "${CC:-gcc}" $level -ffp-contract=off
hard_check 'families' "$work/hard" 100
columns() { awk -F, '!/^#/ && NF { print $1, $2, $3, $10, $11 }' "$1"; }
columns tests/hard/hard.csv > "$work/recorded"
expect 'as many are wrong as is recorded (make figures RECORD=1)' 0 "$(cat "$work/recorded")" '' columns "$work/table"
later 'hard: 200,000 calls of each certain function, not 5,000'
hard_check '5,000 calls of each certain function' "$work/hard" --certain 5000
"$work/hard" 1 > "$work/one"
expect 'a table of all families' 0 36 '' grep -c ',robust,' "$work/one"
expect 'in float, too' 0 42 '' grep -c ',float' "$work/one"
hard_replay() {
    "${CC:-gcc}" -std=c11 -D_DEFAULT_SOURCE -O1 -DREPLAY -ffp-contract=off tests/fuzz/fuzz_closest.c $LIBRARY -lm -o "$work/replay" &&
        "$work/replay" tests/fuzz/closest/*
}
expect 'the corpus of the search functions' 0 '' '' hard_replay
for compiler in gcc clang; do
    command -v $compiler > /dev/null || continue
    for file in runtime/certain/*.c; do
        ! $compiler -std=c11 -D_DEFAULT_SOURCE -Ofast -fsyntax-only "$file" 2> "$work/fast" && grep -q 'error.*proofs need IEEE arithmetic' "$work/fast" || echo "$file"
    done > "$work/taken"
    report $((! $(wc -l < "$work/taken"))) "nothing with proofs compiles under -Ofast, $compiler"
done
