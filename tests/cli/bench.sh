# Checks footpoint-bench: usage and diagnostics; a complete CSV; functions for callers, right in each of its rows; the
# rivals below the front of invented figures; maps.
. tests/cli/expect.inc
bench=$BIN/footpoint-bench
scene=tests/scenes/small.scene

expect 'help' 0 '*' '' "$bench" --help
expect 'version' 0 'footpoint-bench 0.3.0' '' "$bench" --version
expect 'an argument too many' 2 '' "footpoint-bench: unexpected argument 'x'" "$bench" x
expect 'unknown instruction set' 2 '' "footpoint-bench: error: no methods for 'z80' here" "$bench" --isa z80
expect 'no rounds' 2 '' "footpoint-bench: error: --rounds 0 is out of range" "$bench" --rounds 0
expect 'unknown scene' 3 '' '*' "$bench" --scene none.scene

# The perceptrons' header is what codegen writes of their genomes: of the first, line by line.
header=tests/bench/footpoint_perceptron.h
later 'bench: all perceptrons as codegen writes them'
awk -v all="$FOOTPOINT_LONG" '/^genome / && n++ && all == "" { exit } { print }' tests/paper/perceptron.gen > "$work/perceptron.gen"
"$BIN/footpoint-codegen" --allow-poles --effort 0 --quiet "$work/perceptron.gen" -o "$work/perceptron.h"
if [ -n "$FOOTPOINT_LONG" ]; then
    cmp "$work/perceptron.h" $header
else
    [ -s "$work/perceptron.h" ] && ! grep -vxF -f $header "$work/perceptron.h" | grep -v ' sha256: \|  rounding: '
fi
report $((! $?)) 'the perceptrons are as codegen writes them (else make regenerate)'
expect 'of this genome' 0 " * sha256: $(sha256sum < tests/paper/perceptron.gen | cut -d ' ' -f 1)" '' grep -m 1 sha256 $header

expect 'a scene of no function' 0 '*' '' "$bench" --csv --quiet --rounds 1 --scene $scene
cp "$work/stdout" "$work/small.csv"
awk -F, '
    NR == 1 { columns = NF; bad += !/^scene,sample,method,ours,mode,mul,div,add,sqrt,ns,ratio,mean_xi,p99_xi,/; next }
    { bad += NF != columns || $1 != "small" || $4 != 0 || !($10 > 0) || !($11 > 0) || $12 + 0 > $14 + 0
      bad += seen[$3 "," $5]++ > 0; modes[$5]++ }
    $3 ~ /^(newton|trust_region)/ && $18 == 0 { bad += $14 > 1e-7; converged[$3]++ }
    $3 ~ /^newton(_fair)?$/ { bad += $11 > 1; quicker[$5] += $11 == 1 }
    END { for (m in converged) n++
          for (m in modes) bad += !quicker[m]
          exit !(bad == 0 && n == 6 && modes["scalar"] > 70 && modes["chain"] == modes["scalar"] &&
              modes["batch"] == modes["scalar"] - 1) }
' "$work/small.csv"
report $((! $?)) 'every line is whole, and what converges is right'
alike() { # alike FILE: calls that wait for one another find what independent calls find
    awk -F, '{ key = $3; found = ""; for (i = 12; i <= 21; i++) found = found " " $i }
        $5 == "chain" { chain[key] = found }
        $5 == "scalar" { n++; if (chain[key] != found) { print "# " key ":" chain[key] " beside" found; bad++ } }
        END { exit bad > 0 || n == 0 }' "$1"
}
alike "$work/small.csv"; report $((! $?)) 'dependent calls find what independent calls find'

# Ours: 10 ns at 1e-2, 20 ns at 1e-6, and checked 40 ns at 1e-8, noise 1 %; one fails.  What the names of the rivals say.
{
    echo scene,sample,method,ours,mode,ns,mean_xi,p99_xi,mean_eta,p99_eta,failures,noise,question
    while read -r method ours ns error failures noise question; do
        echo "s,random,$method,$ours,scalar,$ns,$error,$error,1e-17,1e-17,$failures,$noise,${question:-bare}"
    done << END
quick 1 10 1e-2 0 0.01
exact 1 20 1e-6 0 0.01
broken 1 1 1e-9 3 0.01
checked 1 40 1e-8 0 0.01 checked
matched 0 15 1e-2 0 0.01
within_noise 0 9.9 1e-2 0 0.03
equal_error 0 20 1e-6 0 0.01
no_answer 0 1 2 0 0.01
faster 0 9 1e-2 0 0.01
better 0 30 1e-7 0 0.01
between 0 15 1e-3 0 0.01
less_than_checked 0 41 1e-8 0 0.01
END
} > "$work/front.csv"
expect 'rivals below the front' 0 's random scalar, mean: faster, 9.00 ns, 1.0e-02
s random scalar, mean: better, 30.00 ns, 1.0e-07
s random scalar, mean: between, 15.00 ns, 1.0e-03
s random scalar, 99 %: faster, 9.00 ns, 1.0e-02
s random scalar, 99 %: better, 30.00 ns, 1.0e-07
s random scalar, 99 %: between, 15.00 ns, 1.0e-03
6 rivals below the front' '' awk -f tests/report/front.awk "$work/front.csv"
sed -i 's/,1e-6,1e-6,/,1e-15,1e-15,/; s/,1e-7,1e-7,/,1e-16,1e-16,/' "$work/front.csv"
expect 'rounding errors are alike' 0 '4 rivals below the front' '' \
    sh -c "awk -f tests/report/front.awk '$work/front.csv' | tail -n 1"

mkdir "$work/maps"
sed 's/^heldout.*/heldout = 300;/; s/^training.*/training = 300;/' evolve/scenes/quad4.scene > "$work/quad4.scene"
expect 'maps' 0 '*' '*' "$bench" --csv --rounds 1 --scene "$work/quad4.scene" --map "$work/maps"
cp "$work/stdout" "$work/quad4.csv"
[ "$(sed 's/[0-9]* s$/N s/' "$work/stderr")" = 'bench: quad4.scene, 1 of 1, N s' ]; report $((! $?)) 'what is done is told'
awk '$1 == "DIMENSIONS" { cells = ($2 - 1) * ($3 - 1) } $1 == "CELL_DATA" { bad += $2 != cells } /^[0-9.e+-]+$/ { n++ }
    END { exit !(!bad && n == 3 * cells) }' "$work"/maps/quad4-footpoint_quad4_accurate.vtk
report $((! $?)) 'a value for each cell'
if command -v gnuplot > /dev/null; then
    for norm in mean p99; do
        awk -f tests/report/picture.awk -v scene=quad4 -v sample=random -v mode=batch -v norm=$norm \
            -v out="$work/picture" "$work/quad4.csv" > "$work/picture.gp" && gnuplot "$work/picture.gp" 2>&1 &&
            [ -s "$work/picture.png" ] && grep -q '>accurate<' "$work/picture.svg"
        report $((! $?)) "picture, $norm"
    done
    awk -f tests/report/map.awk -v title=quad4 -v out="$work/map" "$work"/maps/*.vtk | gnuplot 2>&1 &&
        [ -s "$work/map.png" ]
    report $((! $?)) 'picture of the maps'
else
    report 1 'skipped: pictures (no gnuplot)'
fi

# What callers get.  right FILE CONDITION COUNT: awk's condition holds of all COUNT rows that it is about, where it is not
# "", with q for the question, m for the method, e for the larger error of xi and eta, d for that of the gap or distance, all
# of them the worst of the samples.
right() {
    awk -F, -v count="$3" '
        NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
        function larger(a, b) { return a + 0 > b + 0 ? a + 0 : b + 0 }
        { q = $c["question"]; m = $c["method"]; mode = $c["mode"]; ours = $c["ours"]; none = $c["failures"]; ratio = $c["ratio"]
          e = larger($c["max_xi"], $c["max_eta"]); d = $c["max_gap"] + 0
          holds = ""; '"$2"'
          if (holds == "") next
          n++
          if (!holds) { print "# " $0; bad++ } }
        END { if (n != count) print "# " n " rows"; exit bad > 0 || n != count }' "$1"
}
of_quad4() { right "$work/quad4.csv" "$2" "$3"; report $((! $?)) "quad4: $1"; }
of_quad4 'every function has an answer, but footpoint_locate beside the segment' \
    'if (q != "bare" && ours) holds = m == "footpoint_locate" ? none > 0 : none == 0' 116
of_quad4 'converged Newton asked the same is what a ratio is of' \
    'if (m ~ /^newton_(clamped|along|implicit)$/) holds = ratio == 1' 9
of_quad4 'or fair Newton, if that is quicker' 'if (m ~ /^newton(_fair)?(_checked|_over|_from_1e-[123])?$/) {
    holds = ratio <= 1; key = mode " " q; if (key in other) holds = holds && (ratio == 1 || other[key] == 1); other[key] = ratio }' 36
of_quad4 'checked' 'if (m ~ /(accurate|full|newton|newton_fair)_checked|locate/) holds = e < 1e-4 && d < 1e-9' 15
of_quad4 'eight slave nodes over each segment' 'if (m ~ /(accurate|newton|newton_fair)_over/) holds = none == 0 && e < 1e-4 && d < 1e-9' 9
of_quad4 'from the last answer' 'if (m ~ /full_from_|newton(_fair)?_from_1e-[23]/) holds = none == 0 && e < 1e-9 && d < 1e-9' 21
awk -f tests/report/from_last.awk "$work/quad4.csv" > "$work/last"
[ "$(grep -c '^<tr><td>quad4, random, footpoint_quad4_.*[0-9].*</td></tr>' "$work/last")" = 4 ]
report $((! $?)) 'from the last answer: a row a function'
of_quad4 'closest points' 'if (m ~ /(accurate|full)_closest|robust/) holds = e < 1e-4 && d < 1e-9' 8
of_quad4 'four triangles are off where the face is warped, their points are not' \
    'if (m ~ /triangles/) holds = none == 0 && d > 1e-4 && d < 2e-2 && e < 0.2' 3
of_quad4 'Newton clamped is not the closest point' 'if (m == "newton_clamped") holds = d > 1e-2' 3
of_quad4 'along a direction' 'if (q == "along") holds = none == 0 && e < 1e-9 && d < 1e-9' 6
of_quad4 'derivatives, four ways' 'if (q == "derivatives") holds = none == 0 &&
    (m ~ /full|implicit|forward/ ? e < 1e-9 : e < 1e-4) && (m ~ /full|implicit|forward/ ? d < 1e-9 : d < 1e-4)' 21
alike "$work/quad4.csv"; report $((! $?)) 'quad4: dependent calls find what independent calls find'

# The most accurate search of each kind; faces have all of it, patches are checked.
later 'bench: quad8, quad9 and bezier'
while read -r kind search questions by_hand; do
    case $kind in quad8 | quad9 | bezier) [ -n "$FOOTPOINT_LONG" ] || continue ;; esac
    sed 's/^heldout.*/heldout = 200;/; s/^training.*/training = 200;/' "evolve/scenes/$kind.scene" > "$work/$kind.scene"
    "$bench" --csv --quiet --rounds 1 --scene "$work/$kind.scene" > "$work/$kind.csv"
    right "$work/$kind.csv" 'if (q != "bare" && ours) holds = none == 0; if (q != "bare" && ours && e >= 1) holds = 0
        if (m == "footpoint_'"${kind}_$search"'_" q || m == "footpoint_'"$kind"'_along" || m ~ /_gradients|_hessian|_robust$/)
            holds = none == 0 && e < 1e-3 && d < 1e-3' "$questions"
    report $((! $?)) "$kind: what callers get"
    right "$work/$kind.csv" 'if (m ~ /(newton|areas)_(checked|over|along|implicit)$|newton(_fair)?_from_1e-[23]$|regions$|attach_2d$/)
        holds = none == 0 && e < 1e-7 && d < 1e-9' "$by_hand"
    report $((! $?)) "$kind: what is written by hand"
done << END
tri3 exact 16 12
tri6 accurate 87 26
quad8 full 98 26
quad9 full 96 24
gregory full 39 15
bezier full 36 15
END

cat > "$work/hard.csv" << END
# a case
family,method,n,ok,outside,not_unique,unproved,refused,worst,wrong,wrong_status
flat,newton,9,4,1,1,0,2,1e-3,2,1
flat,robust,9,8,1,0,0,0,1e-12,0,0
END
flat='<td></td><td></td><td>0</td><td></td><td></td><td></td><td></td><td><b>3</b></td><td></td>'
expect 'table of the hard cases' 0 "<tr class=ours><td>robust</td><td>9</td><td>9</td><td>0</td><td>0</td></tr>
<tr><td>newton</td><td>9</td><td>5</td><td>3</td><td><b>3</b></td></tr>
<tr><td>flat</td>$flat</tr>" '' \
    sh -c "awk -f tests/report/hard.awk '$work/hard.csv' | grep '<tr.*<td>'"

# The front alone: methods in the order of their errors, each faster than those after it in one of the modes.
expect 'the front' 0 '*' '*' "$bench" --quiet --rounds 1 --scene $scene
awk '/^[* ] [a-z]/ && NF > 9 && !/ method / { k = /^\*/; n++; bad += n > 1 && $(12 + k) + 0 > last; last = $(12 + k) + 0 }
    END { exit !(n > 3 && n < 40 && !bad) }' "$work/stdout"
report $((! $?)) 'is some dozen lines, the most accurate last'
