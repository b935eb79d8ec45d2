# What derivatives of quad4 cost, search and all, beside the implicit function theorem by hand, forward differentiation
# through Newton's iteration and central differences: the table of generated/README.md.  The header's are the quickest, at
# least fifteen times as quick as forward differentiation, and right to 1e-7.
. tests/cli/expect.inc
CC=${CC:-gcc}
isas=x86-64-v3
grep -q avx512f /proc/cpuinfo && isas="$isas x86-64-v4"
for isa in $isas; do
    $CC -std=c11 -D_DEFAULT_SOURCE -O3 -fno-math-errno -march=$isa -o "$work/derivatives" tests/bench/bench_derivatives_main.c \
        tests/hard/hard.c tests/hard/draw.c tests/hard/wild.c "$BIN/libfootpoint.a" -lm && "$work/derivatives" > "$work/derivatives.csv"
    report $((! $?)) "$isa: runs"
    sed 's/^/# /' "$work/derivatives.csv"
    awk -F, '/gradients"/ { if (!gradients || $(NF - 2) < gradients) gradients = $(NF - 2) } /by hand|differentiate|forward|differences/ { if (!least || $(NF - 2) < least) least = $(NF - 2) }
        END { exit !(gradients > 0 && gradients < least) }' "$work/derivatives.csv"
    report $((! $?)) "$isa: the header's are the quickest"
    awk -F, '/accurate_at, gradients/ { ratio = $(NF - 1); off = $NF } END { exit !(ratio >= 15 && off <= 1e-4) }' "$work/derivatives.csv"
    report $((! $?)) "$isa: fifteen times as quick as forward differentiation"
done
