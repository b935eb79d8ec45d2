# footpoint-bench: usage and diagnostics; a CSV that is whole; the rivals below the front of made-up figures; maps.
. tests/cli/expect.inc
bench=$BIN/footpoint-bench
scene=tests/scenes/small.scene

expect 'help' 0 '*' '' "$bench" --help
expect 'version' 0 'footpoint-bench 0.2.0' '' "$bench" --version
expect 'an argument too many' 2 '' "footpoint-bench: unexpected argument 'x'" "$bench" x
expect 'unknown instruction set' 2 '' "footpoint-bench: error: no methods for 'z80' here" "$bench" --isa z80
expect 'no rounds' 2 '' "footpoint-bench: error: --rounds 0 is out of range" "$bench" --rounds 0
expect 'unknown scene' 3 '' '*' "$bench" --scene none.scene

expect 'a scene of no function' 0 '*' '' "$bench" --csv --quiet --rounds 5 --scene $scene
cp "$work/stdout" "$work/small.csv"
awk -F, '
    NR == 1 { columns = NF; bad += !/^scene,sample,method,ours,mode,mul,div,add,sqrt,ns,ratio,mean_xi,p99_xi,/; next }
    { bad += NF != columns || $1 != "small" || $4 != 0 || !($10 > 0) || !($11 > 0) || $12 + 0 > $14 + 0
      bad += seen[$3 "," $5]++ > 0; modes[$5]++ }
    $3 ~ /^(newton|trust_region)/ && $18 == 0 { bad += $14 > 1e-7; converged[$3]++ }
    $3 == "newton" { bad += $11 != 1 }
    END { for (m in converged) n++
          exit !(bad == 0 && n == 5 && modes["scalar"] > 70 && modes["batch"] == modes["scalar"] - 1) }
' "$work/small.csv"
report $((! $?)) 'every line is whole, and what converges is right'

# Ours: 10 ns at 1e-2 and 20 ns at 1e-6, noise 1 %; a third one fails.  What the names of the rivals say.
{
    echo scene,sample,method,ours,mode,ns,mean_xi,p99_xi,mean_eta,p99_eta,failures,noise
    while read -r method ours ns error failures noise; do
        echo "s,random,$method,$ours,scalar,$ns,$error,$error,1e-17,1e-17,$failures,$noise"
    done << END
quick 1 10 1e-2 0 0.01
exact 1 20 1e-6 0 0.01
broken 1 1 1e-9 3 0.01
matched 0 15 1e-2 0 0.01
within_noise 0 9.9 1e-2 0 0.03
equal_error 0 20 1e-6 0 0.01
no_answer 0 1 2 0 0.01
faster 0 9 1e-2 0 0.01
better 0 30 1e-7 0 0.01
between 0 15 1e-3 0 0.01
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
expect 'maps' 0 '*' '*' "$bench" --csv --rounds 5 --scene "$work/quad4.scene" --map "$work/maps"
[ "$(sed 's/[0-9]* s$/N s/' "$work/stderr")" = 'bench: quad4.scene, 1 of 1, N s' ]; report $((! $?)) 'what is done is told'
awk '$1 == "DIMENSIONS" { cells = ($2 - 1) * ($3 - 1) } $1 == "CELL_DATA" { bad += $2 != cells } /^[0-9.e+-]+$/ { n++ }
    END { exit !(!bad && n == 3 * cells) }' "$work"/maps/quad4-footpoint_quad4_accurate.vtk
report $((! $?)) 'a value for each cell'
if command -v gnuplot > /dev/null; then
    for norm in mean p99; do
        awk -f tests/report/picture.awk -v scene=quad4 -v sample=random -v mode=batch -v norm=$norm \
            -v out="$work/picture" "$work/stdout" > "$work/picture.gp" && gnuplot "$work/picture.gp" 2>&1 &&
            [ -s "$work/picture.png" ] && grep -q '>accurate<' "$work/picture.svg"
        report $((! $?)) "picture, $norm"
    done
    awk -f tests/report/map.awk -v title=quad4 -v out="$work/map" "$work"/maps/*.vtk | gnuplot 2>&1 &&
        [ -s "$work/map.png" ]
    report $((! $?)) 'picture of the maps'
else
    report 1 'skipped: pictures (no gnuplot)'
fi

cat > "$work/hard.csv" << END
# a case
family,method,n,ok,outside,not_unique,unproved,refused,worst,wrong,wrong_status
flat,newton,9,4,1,1,0,2,1e-3,2,1
flat,robust,9,8,1,0,0,0,1e-12,0,0
END
flat='<td>5</td><td>3</td><td><b>3</b></td><td>1e-3</td><td>9</td><td>0</td><td>0</td><td>1e-12</td>'
expect 'table of the hard cases' 0 "<tr><td>flat</td>$flat</tr>" '' \
    sh -c "awk -f tests/report/hard.awk '$work/hard.csv' | grep flat"

# The front alone: methods in the order of their errors, each faster than those after it in one of the modes.
expect 'the front' 0 '*' '*' "$bench" --quiet --rounds 5 --scene $scene
awk '/^[* ] [a-z]/ && NF > 9 && !/ method / { k = /^\*/; n++; bad += n > 1 && $(9 + k) + 0 > last; last = $(9 + k) + 0 }
    END { exit !(n > 3 && n < 40 && !bad) }' "$work/stdout"
report $((! $?)) 'is some dozen lines, the most accurate last'
