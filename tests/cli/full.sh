# What a program prints on standard output arrives, or it ends with exit status 3 and one line.
. tests/cli/expect.inc
[ -c /dev/full ] || { echo 'ok 1 - standard output # SKIP no /dev/full'; exit 0; }
to_full() { "$@" > /dev/full; }
full='standard output: error: cannot write: No space left on device'

for program in codegen calibrate evolve pga perceptron bench; do
    for option in --help --version; do
        expect "footpoint-$program $option to a full device" 3 '' "$full" to_full "$BIN/footpoint-$program" $option
    done
done
printf 'footpoint-genome 1\ninput x\ngenome g\nr = * x x\nend\n' > "$work/g.gen"
expect 'counts to a full device' 3 '' "$full" to_full "$BIN/footpoint-codegen" --count "$work/g.gen"
{ printf 'footpoint-genome 1\ninput x\n'; seq -f 'genome g%g
r = * x x
end' 1000; } > "$work/many.gen"
# more than a buffer holds: the device refuses the first part before the end
"$BIN/footpoint-codegen" --count --effort 0 "$work/many.gen" > /dev/full 2> "$work/log"
[ $? = 3 ] && [ "$(wc -l < "$work/log")" = 1 ]; report $((! $?)) 'many counts to a full device'
