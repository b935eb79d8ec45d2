# The hard cases at length: compilers, optimisation, fused operations, sanitizers; then ten million certificates.  The
# judge is built alike each time; only the library changes.
. tests/cli/expect.inc
. tests/hard/build.inc
fused=
! grep -q -w fma /proc/cpuinfo 2> /dev/null || fused='-mfma -ffp-contract=fast'
for compiler in gcc clang; do
    command -v $compiler > /dev/null || continue
    for level in -O0 -O1 -O2 -O3; do
        for contract in '-ffp-contract=off' "$fused"; do
            [ -n "$contract" ] || continue
            hard_build "$work/hard" $compiler $level $contract
            hard_check "families, $compiler $level $contract" "$work/hard" 500
            hard_check "certificates, $compiler $level $contract" "$work/hard" --certify 100000
        done
    done
done
hard_build "$work/hard" gcc -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all
hard_check 'families, sanitizers' "$work/hard" 300
hard_build "$work/hard" gcc -O3 -ffp-contract=off
for seed in 1 2 3 4 5; do
    hard_check "2.1 million certificates, seed $seed" "$work/hard" --certify 2100000 $seed
done
for seed in 11 12 13 14; do
    hard_check "families, 5000 of each, seed $seed" "$work/hard" 5000 $seed
done
gcc -std=c11 -D_DEFAULT_SOURCE -O3 -DNDEBUG -ffp-contract=off tests/hard/time_main.c tests/hard/hard.c runtime/*.c -lm -o "$work/time" &&
    "$work/time" > "$work/table"
good=$?
sed 's/^/# /' "$work/table"
report $((! good)) 'footpoint_robust takes at most twice the time of the expression on ordinary segments'
