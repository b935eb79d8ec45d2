# Checks footpoint-perceptron: usage, diagnostics, its page; same seed, same bytes; its output compiles with codegen.
# And the pinball test's table.
. tests/cli/expect.inc
perceptron=$BIN/footpoint-perceptron
scene=tests/scenes/small.scene
error='footpoint-perceptron: error:'

expect 'help' 0 '*' '' "$perceptron" --help
expect 'version' 0 'footpoint-perceptron 0.3.0' '' "$perceptron" --version
expect 'no scene' 2 '' "$error --scene is missing; try --help" "$perceptron"
expect 'no output' 2 '' "$error --output is missing; try --help" "$perceptron" --scene $scene
expect 'unknown option' 2 '' "$error unknown option '--speed'; try --help" "$perceptron" --speed
expect 'no option' 2 '' "$error 'x' is not an option; try --help" "$perceptron" x
expect 'no argument' 2 '' "$error --hidden needs an argument" "$perceptron" --hidden
expect 'no neurons' 2 '' "$error --hidden 0 is out of range" "$perceptron" --hidden 8,0
expect 'no number' 2 '' "$error --hidden needs a whole number, not 'x'" "$perceptron" --hidden 8,x
expect 'empty list' 2 '' "$error --hidden needs whole numbers, not ','" "$perceptron" --hidden ,
expect 'too deep' 2 '' "$error --hidden 1,1,1,1,1 has too many layers" "$perceptron" --hidden 1,1,1,1,1
expect 'twice' 2 '' "$error --hidden 3 is given twice" "$perceptron" --hidden 3 --hidden 4 --hidden 3
expect 'no samples' 2 '' "$error --samples 0 is out of range" "$perceptron" --samples 0
expect 'unknown scene' 3 '' '*' "$perceptron" --scene tests/none.scene -o "$work/o.gen"
expect 'unwritable output' 3 '' '*' "$perceptron" --scene $scene -o "$work/none/o.gen"
cp $scene "$work/own.scene"
expect 'onto its scene' 2 '' '*' "$perceptron" --scene "$work/own.scene" -o "$work/own.scene"
grep -q '^footpoint-perceptron: error: --output and the scene are one file: ' "$work/stderr" && cmp $scene "$work/own.scene"
report $((! $?)) 'which is refused in one line, and stays'
no_room_for_help footpoint-perceptron
documented "$perceptron" tests/paper/rivals/footpoint-perceptron.1

run="--scene $scene --hidden 4 --hidden 3,2 --iterations 30 --samples 500 --seed 4"
expect 'a run' 0 '' '*' "$perceptron" $run -o "$work/1.gen"
expect 'again' 0 '' '' "$perceptron" $run --quiet -o "$work/2.gen"
cmp "$work/1.gen" "$work/2.gen"; report $((! $?)) 'the same bytes'
expect 'another seed' 0 '' '' "$perceptron" $run --seed 5 --quiet -o "$work/3.gen"
! cmp -s "$work/1.gen" "$work/3.gen"; report $((! $?)) 'other bytes'
[ "$(grep '^genome ' "$work/1.gen" | tr '\n' ' ')" = 'genome hidden_4 genome hidden_3_2 ' ]
report $((! $?)) 'a genome for each network'
expect 'codegen takes it' 0 '*' '' "$BIN/footpoint-codegen" --count --effort 0 --allow-poles "$work/1.gen"
# A sigmoid is a quotient and a root; the frame has a quotient and two roots.
awk -F, 'NR > 1 { neurons = NR == 2 ? 4 : 5; ok += $3 == 1 + neurons && $5 == 2 + neurons } END { exit ok != 2 }' \
    "$work/stdout"
report $((! $?)) 'and counts a quotient and a root a neuron'

expect 'pinball decisions' 0 '*' '' "$BIN/footpoint-bench" --scene quad4 --contact
awk -F, 'NR == 2 { ok = $1 == "quad4" && $3 == "pinball" && $4 > 0 && $5 < $4 && ($6 + $7 + $8 - 1) ^ 2 < 1e-6 }
         END { exit !(ok && NR == 2) }' "$work/stdout"
report $((! $?)) 'right, missed and invented make up all'
