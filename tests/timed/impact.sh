# Runs the example to copy in full: the energy error is of second order in the time step with either search, and C and
# Fortran agree. Warns if local search is less than five times faster with footpoint than with Newton's iteration in
# each run.
. tests/cli/expect.inc
CC=${CC:-gcc}
value() { awk -v what="$1" 'index($0, what) == 1 { print $'"$2"' }' "$work/table"; }
holds() { # holds NAME CONDITION: of awk
    awk "BEGIN { exit !($2) }"
    good=$?
    [ $good = 0 ] || echo "# not so: $2"
    report $((!good)) "$1"
}
faster() { # faster PROGRAM FOLDER: in the run before, else in another one
    awk -v ratio="$(value 'local search, ns' '(NF-1)')" 'BEGIN { exit !(ratio >= 5) }' || { "$1" 0.5 "$2" > "$work/table"; false; }
}
optimise='-O3 -march=native'

$CC $optimise -fno-math-errno -fno-trapping-math tests/example/impact.c -o "$work/impact" -lm; report $((! $?)) 'compiles'
mkdir "$work/c"
for scale in 0.5 0.25 0.125; do
    "$work/impact" $scale > "$work/table"
    newton="$newton $(value 'energy error' '(NF-1)')" footpoint="$footpoint $(value 'energy error' NF)"
done
for errors in "Newton $newton" "footpoint $footpoint"; do
    set -- $errors
    holds "$1: half the time step, a quarter of the energy error ($2, $3, $4)" \
        "$2 / $3 > 3 && $2 / $3 < 5 && $3 / $4 > 3 && $3 / $4 < 5 && $2 / $4 > 12 && $2 / $4 < 20"
done

"$work/impact" 0.5 "$work/c" > "$work/table"
sed 's/^/# /' "$work/table"
steady 'C: local search is five times faster' faster "$work/impact" "$work/c"

if command -v gfortran > /dev/null; then
    "$BIN/footpoint-codegen" --effort 100 --allow-poles --language fortran evolve/genomes/quad4.gen \
        -o "$work/footpoint_quad4.f90"
    gfortran -std=f2008 -Wall -Wextra -Werror -Wno-compare-reals $optimise -flto -J"$work" "$work/footpoint_quad4.f90" \
        tests/example/plates.f90 tests/example/impact.f90 -o "$work/impact_f" > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) 'Fortran compiles'
    mkdir "$work/f"
    "$work/impact_f" 0.5 "$work/f" > "$work/table"
    sed 's/^/# /' "$work/table"
    steady 'Fortran: local search is five times faster' faster "$work/impact_f" "$work/f"
    for column in '(NF-1)' NF; do
        holds 'Fortran: momentum is kept' "$(value 'momentum error' "$column") < 1e-13"
    done
    holds 'Fortran: both searches agree' "$(value 'nodes apart' NF) < 1e-8"
    c=$(tail -n 1 "$work/c/energy.csv" | awk -F, '{ print $2 }') f=$(value 'kinetic energy' '(NF-1)')
    holds "C and Fortran end alike ($c, $f)" "($c - $f)^2 < (1e-7 * $c)^2"
    [ "$(cd "$work/c" && echo *.vtk)" = "$(cd "$work/f" && echo *.vtk)" ]; report $((! $?)) 'as many frames'
    for frame in 0001 0020; do # alike but for the last digits that are written
        paste -d ' ' "$work/c/impact_$frame.vtk" "$work/f/impact_$frame.vtk" |
            awk 'NF % 2 { exit bad = 1 }
                 { for (i = 1; i <= NF / 2; i++) {
                       a = $i; b = $(i + NF / 2)
                       if (a ~ /^[-0-9]/ ? (a - b)^2 > (1e-6 + 2e-4 * (a < 0 ? -a : a))^2 : a != b) exit bad = 1
                   } }
                 END { exit bad || NR < 1000 }'
        report $((! $?)) "frame $frame is the same"
    done
else
    report 1 'skipped: no gfortran'
fi
