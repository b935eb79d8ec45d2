# The last word of a run on a mesh of one's own: which functions to use, beside those that ship.  Fresh samples of the mesh
# confirm what it states, and no band of |gap| is worse.
. tests/cli/expect.inc
export OMPI_MCA_btl_base_warn_component_unused=0
evolve=$BIN/footpoint-evolve
awk -v what=wavy -f tests/meshes/own.awk > "$work/own.inp"
scene() { echo "training = $1; heldout = 4000; seed = $2; mesh: { file = \"own.inp\"; };"; }
scene 2000 1 > "$work/mine.scene"
scene 4000 7 > "$work/fresh.scene"
run() { "$evolve" --quiet --islands 1 --population 100 "$@"; }
expect 'a run' 0 '*' '*' run --scene "$work/mine.scene" --generations 2 -o "$work/mine.gen"
cp "$work/stdout" "$work/said"
! grep -q '^front' "$work/said"; report $((! $?)) 'has no list of fronts, which --front asks for'
sed '1,/^full /d' "$work/said" > "$work/last"
n=$(wc -l < "$work/last")
[ "$n" -ge 1 ] && [ "$n" -le 5 ] && ! grep -qv '^use footpoint_mine_[a-z0-9]*: error [0-9.e-]* at cost [0-9]*; footpoint_quad4_[a-z0-9]* has [0-9.e-]* at [0-9]*$' \
    "$work/last"; report $((! $?)) 'ends in a verdict of five lines at most'
grep -q '^use footpoint_mine_balanced: ' "$work/last"; report $((! $?)) 'which names a function that is better'

# Errors on samples of another seed, by what measures and writes: the training column of the table.
for from in "$work/mine.gen" evolve/genomes/quad4.gen; do
    run --scene "$work/fresh.scene" --generations 0 --start "$from" -o "$work/again.gen" > "$work/table" 2> /dev/null
    awk '$4 == "->" { print $1, $5 }' "$work/table" > "$work/errors.$(basename "$from")"
    awk '/^genome / { name = $2 } /^note gaps_both/ { for (i = 8; i <= NF; i++) if ($i ~ /^[0-9.]+e-[0-9]+,?$/ && $(i - 1) != "to") print name, $i + 0 }' \
        "$work/again.gen" > "$work/bands.$(basename "$from")"
done
awk 'FILENAME ~ /errors.mine/ { own[$1] = $2; next } FILENAME ~ /errors.quad4/ { old[$1] = $2; next }
    { t = $2; sub(/^footpoint_mine_/, "", t); sub(/:$/, "", t); n++
      if (own[t] > 2 * $4 + 1e-16 || $4 > 2 * own[t] + 1e-16 || old[t] > 2 * $10 + 1e-16 || $10 > 2 * old[t] + 1e-16) { bad++; print "# " $0, own[t], old[t] } }
    END { exit !(n > 0 && bad == 0) }' "$work/errors.mine.gen" "$work/errors.quad4.gen" "$work/last"
report $((! $?)) 'fresh samples confirm its errors'
[ -s "$work/bands.mine.gen" ] && paste "$work/bands.mine.gen" "$work/bands.quad4.gen" |
    awk '$1 != $3 || $2 > 1.1 * $4 + 1e-15 { bad++; print "# " $0 } END { exit bad > 0 }'
report $((! $?)) 'and no band of |gap| is worse'

expect 'a run from scratch' 0 '*' '*' run --scene "$work/mine.scene" --generations 1 --from-scratch --population 20 -o "$work/scratch.gen"
tail -n 1 "$work/stdout" | grep -q 'footpoint_quad4'; report $((! $?)) 'is compared with what ships, too'
