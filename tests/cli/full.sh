# Checks that output on a full device ends a program with exit status 3 and one line.
. tests/cli/expect.inc
for program in codegen calibrate evolve bench; do
    no_room_for_help "footpoint-$program"
done
[ -c /dev/full ] || exit 0
printf 'footpoint-genome 1\ninput x\ngenome g\nr = * x x\nend\n' > "$work/g.gen"
expect 'counts to a full device' 3 '' "$full" to_full "$BIN/footpoint-codegen" --count "$work/g.gen"
{ printf 'footpoint-genome 1\ninput x\n'; seq -f 'genome g%g
r = * x x
end' 1000; } > "$work/many.gen"
# more than a buffer: the device refuses the first part before the end
"$BIN/footpoint-codegen" --count --effort 0 "$work/many.gen" > /dev/full 2> "$work/log"
[ $? = 3 ] && [ "$(wc -l < "$work/log")" = 1 ]; report $((! $?)) 'many counts to a full device'
