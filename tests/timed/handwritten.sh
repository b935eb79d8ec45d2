# Checks that the emitted code of the shipped scenes is no slower than the same formulas written by hand and compiled
# alike, in one run, within a noise of 5 %. A slower run is repeated, TRIES in all, and the best of each line counts; if
# that is slower, too, there is a warning for gcc. Asserts that the formulas agree. clang's figures are only shown,
# because clang compiles a clamp written as `?:` better than gcc, which uses jumps.
. tests/cli/expect.inc
TRIES=3
gcc -std=c11 -D_DEFAULT_SOURCE tests/rivals/as_written_main.c codegen/base/*.c codegen/genome/*.c $(pkg-config --libs libmd) -lm -o "$work/as_written" &&
    "$work/as_written" evolve/genomes/*.gen > "$work/as_written.h"
report $((! $?)) 'the genomes as they are written'

# best RUN...: the lines of all runs, each with its least times and largest ratios
best() {
    awk -F, -v OFS=, '
        $1 == "method" { next }
        { k = $1 FS $2; new = !(k in seen) }
        new { seen[k]; order[++n] = k }
        { for (i = 3; i <= 5; i++) if (new || $i < value[k, i]) value[k, i] = $i
          for (i = 6; i <= 7; i++) if (new || $i > value[k, i]) value[k, i] = $i }
        END {
            for (j = 1; j <= n; j++) {
                k = order[j]
                print k, value[k, 3], value[k, 4], value[k, 5], value[k, 6], value[k, 7]
            }
        }
    ' "$@"
}

for cc in gcc clang; do
    command -v $cc > /dev/null || continue
    for machine in '' ' -march=native'; do
        name="$cc -O3$machine"
        # shellcheck disable=SC2046,SC2086
        $cc -std=gnu11 -O3 $machine -fno-math-errno -fno-trapping-math -I"$work" -o "$work/handwritten" \
            tests/rivals/handwritten_main.c tests/support/ordinary_quad.c evolve/common/stream.c $(pkg-config --cflags --libs gsl) -lm \
            > "$work/log" 2>&1
        good=$?
        [ $good = 0 ] || sed 's/^/# /' "$work/log"
        report $((!good)) "$name builds"
        [ $good = 0 ] || continue
        rm -f "$work"/run.*
        for try in $(seq $TRIES); do
            "$work/handwritten" > "$work/run.$try" 2> "$work/log"
            agree=$?
            best "$work"/run.* > "$work/best"
            awk -F, '$6 * 1.05 < 1 { slow = 1 } END { exit slow }' "$work/best" && break
        done
        [ $agree = 0 ] || sed 's/^/# /' "$work/log"
        report $((!agree)) "$name: the formulas agree"
        echo '# ns of ours, by hand, as written; and how many times ours the other two are'
        awk -F, '{ printf "# %-24s %-6s %7.2f %7.2f %7.2f %7.3f %7.3f\n", $1, $2, $3, $4, $5, $6, $7 }' "$work/best"
        [ $cc = gcc ] || continue
        awk -F, -v name="$name" '$6 * 1.05 < 1 { print "# WARNING: " name ": " $1 " " $2 ", by hand " $6 " times ours" }' "$work/best"
    done
done
