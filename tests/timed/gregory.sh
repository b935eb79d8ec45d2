# Times hand-written searches on Gregory patches, built for this machine, with their errors. Checks that converged
# Newton finds every foot point of the smooth bodies and nearly every foot point of the paper's.
. tests/cli/expect.inc
FAST='-ffp-contract=fast -fno-math-errno -fno-trapping-math -fno-signed-zeros -ffinite-math-only'
parts="tests/support/error_stats.c $(ls codegen/base/*.c codegen/genome/*.c runtime/geometry/*.c evolve/*/*.c | grep -vE '_main\.c$|/mpi/|/run/')"

# shellcheck disable=SC2046,SC2086
{
    ${CC:-gcc} -std=gnu11 -O3 -march=native $FAST -c tests/bench/bench_gregory.c -o "$work/methods.o" &&
        ${CC:-gcc} -std=gnu11 -O2 -o "$work/bench" tests/bench/bench_gregory_main.c "$work/methods.o" $parts \
            $(pkg-config --cflags --libs gsl libconfig libmd) -lm
} > "$work/log" 2>&1
good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log"
report $((!good)) 'the bench of Gregory patches builds'
[ $good = 0 ] || exit 1
"$work/bench" > "$work/table"
report $((!$?)) 'it runs'
sed 's/^/# /' "$work/table"
report "$(awk -F, '$1 == "bodies" && $3 == "newton" { print ($8 < 1e-9 && $9 == 0) }' "$work/table")" \
    'bodies: Newton finds every foot point'
report "$(awk -F, '$1 == "paper" && $3 == "newton" { print ($6 < 5e-4 && $7 < 1e-9 && $9 <= $2 / 1000) }' "$work/table")" \
    'paper: Newton finds nearly every foot point'
report "$(awk -F, '$1 == "sphere" && $2 == 384 && $3 == "0.0" { worst[$4] = $7 }
    END { print (worst["facets"] > 20 * worst["gregory (44)"] && worst["facets"] > 100 * worst["gregory"]) }' \
    "$work/table")" 'sphere of 6 x 8 x 8: 20 times nearer than facets, 100 times with exact normals'
