# The hard cases at length: compilers, optimisation, fused operations, sanitizers; then 200,000 calls of each certain
# function, in two processes; with HARD_CALLS=5500000 ten million (some 40 minutes of two processors) and all levels of both
# compilers.  The judge is built alike each time; only the library changes.
. tests/cli/expect.inc
. tests/hard/build.inc
fused=
! grep -q -w fma /proc/cpuinfo 2> /dev/null || fused='-mfma -ffp-contract=fast'
for compiler in gcc clang; do
    command -v $compiler > /dev/null || continue
    for level in -O0 -O1 -O2 -O3; do
        for contract in '-ffp-contract=off' "$fused"; do
            case $compiler$level$contract in
            gcc-O3*=off | clang-O0*=off | gcc-O2-mfma* | clang-O1-mfma* | clang-O3-mfma*) ;;
            *) [ -n "$HARD_CALLS" ] || continue ;;
            esac
            [ -n "$contract" ] || continue
            hard_build "$work/hard" $compiler $level $contract
            hard_check "families, $compiler $level $contract" "$work/hard" 200
            hard_check "certain functions, $compiler $level $contract" "$work/hard" --certain 10000
        done
    done
done
hard_build "$work/hard" gcc -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all
hard_check 'families, sanitizers' "$work/hard" 100
hard_build "$work/hard" gcc -O3 -ffp-contract=off
calls=${HARD_CALLS:-110000}
for seed in 1 2; do
    "$work/hard" --certain "$calls" $seed > "$work/certain$seed" & # not all families are for all functions
done
wait
for seed in 1 2; do
    grep -e '^#' -e '^all' "$work/certain$seed" | sed 's/^[^#]/# &/' | head -80
    awk -F, '$1 == "all" { wrong += $10 + $11; n++ } END { exit !(n == 9 && wrong == 0) }' "$work/certain$seed"
    report $((! $?)) "$calls cases for the certain functions, seed $seed: 0 wrong"
done
for seed in 11 12; do
    hard_check "families, 5000 of each, seed $seed" "$work/hard" 5000 $seed
done
gcc -std=c11 -D_DEFAULT_SOURCE -O3 -DNDEBUG -ffp-contract=off tests/hard/time_main.c tests/hard/hard.c tests/hard/draw.c tests/hard/wild.c runtime/geometry/*.c runtime/search/*.c runtime/certain/*.c -lm -o "$work/time"
report $((! $?)) 'the searches are timed'
twice() { "$work/time" > "$work/table"; }
steady 'footpoint_robust takes at most twice the time of the expression on ordinary segments' twice
sed 's/^/# /' "$work/table"
