# Times the adapters of runtime/replace/ beside our equivalents of the searches that they replace, for the table of
# runtime/README.md. Their answers must agree.
. tests/cli/expect.inc
CXX=${CXX:-g++} CC=${CC:-gcc}
for file in hard draw wild; do
    $CC -std=c11 -D_DEFAULT_SOURCE -O2 -c tests/hard/$file.c -o "$work/$file.o" || exit 1
done
$CXX -std=c++14 -O3 -march=native -Wall -Wextra -Werror -Iruntime -Igenerated tests/bench/bench_replace_main.cpp \
    "$work/hard.o" "$work/draw.o" "$work/wild.o" "$BIN/libfootpoint.a" -lm -o "$work/times" && "$work/times" > "$work/times.csv"
report $((! $?)) 'runs'
sed 's/^/# /' "$work/times.csv"
awk -F, 'NR > 1 && $5 != "-" { n++; bad = bad || $5 > 1e-6 || $6 > 1e-12 } END { exit bad || n != 5 }' "$work/times.csv"
report $((! $?)) 'the same foot points'
