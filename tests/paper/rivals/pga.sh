# Checks footpoint-pga: usage, diagnostics, its page; same bytes on any number of ranks; its output compiles with
# codegen.
. tests/cli/expect.inc
pga=$BIN/footpoint-pga
export OMPI_MCA_btl_base_warn_component_unused=0
mpirun="mpirun --oversubscribe"
[ "$(id -u)" != 0 ] || mpirun="$mpirun --allow-run-as-root"
scene=tests/scenes/small.scene

expect 'help' 0 '*' '' "$pga" --help
expect 'version' 0 'footpoint-pga 0.3.0' '' "$pga" --version
expect 'no scene' 2 '' 'footpoint-pga: error: --scene is missing; try --help' "$pga"
expect 'no output' 2 '' 'footpoint-pga: error: --output is missing; try --help' "$pga" --scene $scene
expect 'unknown option' 2 '' "footpoint-pga: error: unknown option '--speed'; try --help" "$pga" --speed
expect 'no argument' 2 '' 'footpoint-pga: error: --order needs an argument' "$pga" --order
expect 'order 9' 2 '' 'footpoint-pga: error: --order 9 is out of range' "$pga" --order 9
expect 'no number' 2 '' "footpoint-pga: error: --seed needs a whole number, not '-1'" "$pga" --seed -1
expect 'no part' 2 '' 'footpoint-pga: error: --mutation 1.5 is out of range (0 to 1)' "$pga" --mutation 1.5
expect 'unknown coefficients' 2 '' "footpoint-pga: error: --coefficients has no choice 'best'" "$pga" --coefficients best
expect 'bad list' 2 '' "footpoint-pga: error: --restrict needs a whole number, not 'x'" "$pga" --restrict 10,x
expect 'bad name' 2 '' "footpoint-pga: error: --name needs letters, digits and _, not 'a b'" "$pga" --name 'a b'
expect 'unknown tier' 1 '' "./$scene: error: no tier 'x'" "$pga" --scene ./$scene --tier x -o "$work/o.gen"
expect 'unwritable output' 3 '' '*' "$pga" --scene $scene --tier paper --generations 0 --quiet -o "$work/none/o.gen"
cp $scene "$work/own.scene"
expect 'onto its scene' 2 '' '*' "$pga" --scene "$work/own.scene" -o "$work/own.scene"
grep -q '^footpoint-pga: error: --output and the scene are one file: ' "$work/stderr" && cmp $scene "$work/own.scene"
report $((! $?)) 'which is refused in one line, and stays'
no_room_for_help footpoint-pga
documented "$pga" tests/paper/rivals/footpoint-pga.1

run="--scene $scene --tier paper --generations 20 --population 20 --restrict 12 --seed 4 --quiet"
expect 'a run' 0 '*' '' "$pga" $run --log "$work/1.csv" -o "$work/1.gen"
cp "$work/stdout" "$work/1.out"
later 'pga: 2 ranks, the cheapest form of what it writes'
[ -n "$FOOTPOINT_LONG" ] && effort= || effort='--effort 1'
for ranks in ${FOOTPOINT_LONG:+2} 3; do
    expect "$ranks ranks" 0 "$(cat "$work/1.out")" '*' \
        $mpirun -n $ranks "$pga" $run --log "$work/2.csv" -o "$work/2.gen"
    cmp "$work/1.gen" "$work/2.gen" && cmp "$work/1.csv" "$work/2.csv"
    report $((! $?)) "same bytes on $ranks ranks"
done
expect 'codegen takes it' 0 '*' '' "$BIN/footpoint-codegen" $effort --count "$work/1.gen"
[ "$(awk -F, 'NR > 1 && $6 > 12' "$work/1.csv" | wc -l)" = 0 ] && [ "$(wc -l < "$work/1.csv")" = 43 ]
report $((! $?)) 'at most 12 terms in every generation'
expect 'terms exchanged, mean error' 0 '*' '' "$pga" $run --exchange --coefficients mean -o "$work/e.gen"
awk 'FNR == NR { a[$3] = $7; next } { bad += $7 > a[$3] } END { exit bad > 0 }' "$work/1.out" "$work/stdout"
report $((! $?)) 'and never worse on the training samples'

printf 'xi = xs, 1, xs ys # no comma\neta = 1, yq\n' > "$work/terms"
expect 'unknown symbol in terms' 1 '' "$work/terms:2: error: unknown symbol 'yq'" \
    "$pga" --scene $scene --tier paper --terms "$work/terms" -o "$work/o.gen"
sed -i 's/yq/ys ys xs/' "$work/terms"
expect 'terms by hand' 0 '*' '' "$pga" --scene $scene --tier paper --terms "$work/terms" -o "$work/t.gen"
expect 'several limits' 0 '*' '' \
    "$pga" --scene $scene --tier paper --generations 5 --restrict 12,3,0 --quiet -o "$work/s.gen"
[ "$(grep '^genome ' "$work/s.gen" | tr '\n' ' ')" = 'genome pga_12 genome pga_3 genome pga_0 ' ]
report $((! $?)) 'a genome for each'
