# Measures the worth of each pass of codegen: operations, in the throughput model, of functions compiled with all passes
# and with one left out. Uses short expressions; FOOTPOINT_ABLATION=all uses all of them and the shipped genomes, which
# takes hours. FOOTPOINT_EFFORT is the search's (200): without any effort, some passes are not tried.
. tests/cli/expect.inc
if [ "$FOOTPOINT_ABLATION" = all ]; then
    files="$(ls tests/expressions/*.gen) $(ls evolve/genomes/*.gen codegen/derivatives/*.gen)"
else
    files=$(find tests/expressions -name '*.gen' -size -250c | sort)
fi

count() { # count PASS: the cost of each function, compiled without the pass
    for file in $files; do
        "$BIN/footpoint-codegen" --allow-poles --quiet --effort "${FOOTPOINT_EFFORT:-200}" --without "$1" --count "$file" 2> /dev/null |
            awk -F, 'NR > 1 { print $2 + $4 + 8 * $3 + 12 * $5 + $6 }'
    done
}

count nothing > "$work/nothing"
echo "# $(printf '%-11s %9s %6s %6s %6s' without functions dearer cheaper cost)"
echo "# $(awk '{ cost += $1 } END { printf "%-11s %9d %6d %6d %6d", "nothing", NR, 0, 0, cost }' "$work/nothing")"
for pass in combine dissolve factor join differences early horner sharing distribute scales groups multiples; do
    count $pass > "$work/without"
    paste -d ' ' "$work/nothing" "$work/without" | awk -v pass=$pass '
        { before += $1; cost += $2; dearer += $2 > $1; cheaper += $2 < $1 }
        END { printf "%-11s %9d %6d %6d %6d\n", pass, NR, dearer, cheaper, cost; exit cost < before }' > "$work/row"
    worth=$((!$?))
    echo "# $(cat "$work/row")"
    report $worth "without $pass no cost falls"
done
