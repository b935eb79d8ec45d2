# The README keeps its word: its program compiles and runs, its genome compiles, its figures are those of the headers.
. tests/cli/expect.inc
CC=${CC:-gcc}
cp generated/footpoint_quad4.h "$work/"
awk '/^```c$/ { on = 1; next } /^```$/ { on = 0 } on' README.md > "$work/use.c"
$CC -std=c99 -Wall -Wextra -Wpedantic -Werror "$work/use.c" -o "$work/use" -lm
expect 'the program' 0 'xi -0.349489 eta 0.395534 gap 0.193207' '' "$work/use"
awk '/^footpoint-genome/ { on = 1 } /^```$/ { on = 0 } on' README.md > "$work/example.gen"
expect 'the genome' 0 'genome,mul,div,add,sqrt,compare
example,1,1,2,0,1' '' "$BIN/footpoint-codegen" --count "$work/example.gen"
for f in fast coarse gauss2 medium balanced fine precise accurate full; do
    row=$(sed -n "s/^| \*\*footpoint_quad4_$f\*\* | \([0-9]*\) | \([0-9]*\) | \([0-9]*\) |.*/\1 \2 \3/p" README.md)
    counted=$(awk -v f="footpoint_quad4_$f" '$2 == f { on = 1 } on && /operations:/ { print $3, $5, $7; exit }' generated/footpoint_quad4.h)
    [ -n "$row" ] && [ "$row" = "$counted" ]; report $((! $?)) "operations of quad4_$f"
    row=$(awk -F' \\| ' -v f="footpoint_quad4_$f" 'index($1, "**" f "**") { sub(/ \|$/, "", $9); print $7, $8, $9 }' README.md)
    noted=$(awk -v f=$f '/^genome/ { on = $2 == f } on && /^note heldout_xi/ { printf "%.1e %.1e %.1e\n", $6, $8, $10 }' \
        evolve/genomes/quad4.gen | sed 's/e-0/e-/g')
    [ -n "$row" ] && [ "$row" = "$noted" ]; report $((! $?)) "errors of quad4_$f"
done
