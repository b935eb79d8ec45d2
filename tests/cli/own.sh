# Checks a user's scene, given by a path: genomes, header and page are written beside it, or into a folder, and the tree stays
# unchanged.  The verdict of a run names the functions to use beside the shipped ones.  Fresh samples must confirm it, and no band of
# |gap| may be worse.
. tests/cli/expect.inc
export OMPI_MCA_btl_base_warn_component_unused=0
state() { find evolve generated tests/generated -type f -newer "$work/begun" | sort; }
printf '#!/bin/sh\nshift 2\nexec "$@"\n' > "$work/alone"
cat > "$work/ended" <<'END'
#!/bin/sh
# Ends the run soon after it listens to SIGTERM, bit 15 of the signals that are caught.
shift 2
"$@" &
pid=$! tries=400
until grep -q '^SigCgt:.*[4-7c-f]...$' "/proc/$pid/status" || [ $((tries -= 1)) = 0 ]; do sleep 0.05; done
sleep 0.5
kill -TERM $pid
wait $pid
END
chmod +x "$work/alone" "$work/ended"
regenerate() { env BIN="$BIN" MPIRUN="$work/alone" RANKS=1 GENERATIONS=1 SEED=1 OUT= FROM= "$@"; }
mkdir "$work/mine"
cp tests/meshes/tetra4.inp "$work/mine/"
echo 'training = 10; heldout = 10; mesh: { file = "tetra4.inp"; };' > "$work/mine/faces-1.scene"
touch "$work/begun"
expect 'a scene beside its mesh' 0 '*' '*' regenerate sh evolve/regenerate.sh "$work/mine/faces-1.scene"
[ -s "$work/mine/faces-1.gen" ] && [ -s "$work/mine/footpoint_faces_1.h" ] && [ -s "$work/mine/faces-1.svg" ]; report $((! $?)) 'genomes, header and page are there, too'
expect 'a second run begins there' 0 "*" '*' regenerate sh evolve/regenerate.sh "$work/mine/faces-1.scene"
grep -q "footpoint_faces_1.h is as it was" "$work/stdout"; report $((! $?)) 'and emits nothing anew'
expect 'OUT=' 0 '*' '*' regenerate OUT="$work/other" sh evolve/regenerate.sh "$work/mine/faces-1.scene"
cmp -s "$work/mine/footpoint_faces_1.h" "$work/other/footpoint_faces_1.h"; report $((! $?)) 'is where they go'
OUT=/elsewhere make -n regenerate SCENE="$work/mine/faces-1.scene" > "$work/plan" 2>&1
grep -q "OUT='' " "$work/plan"; report $((! $?)) 'from the command line only'
make -n bench SCENE="$work/mine/faces-1.scene" > "$work/plan" 2>&1
grep -q "$work/mine/footpoint_faces_1.h" "$work/plan"; report $((! $?)) 'the bench finds the header'

awk -v what=wavy -f tests/meshes/own.awk > "$work/mine/own.inp"
echo 'training = 1000; heldout = 1000; mesh: { file = "own.inp"; };' > "$work/mine/long.scene"
echo before > "$work/mine/long.gen"
regenerate MPIRUN="$work/ended" GENERATIONS=100000 FROM=scratch sh evolve/regenerate.sh "$work/mine/long.scene" > "$work/stdout" 2> "$work/stderr"
[ $? -ne 0 ] && grep -q '^long: interrupted; genomes and header stand as they were, what was found is in ' "$work/stderr"
report $((! $?)) 'an interrupted run says that it was'
[ "$(cat "$work/mine/long.gen")" = before ] && [ ! -e "$work/mine/footpoint_long.h" ]; report $((! $?)) 'and changes nothing'
state > "$work/after"
expect 'the tree is as it was' 0 '' '' cat "$work/after"

# ---- the verdict ----
evolve=$BIN/footpoint-evolve
awk -v what=wavy -f tests/meshes/own.awk > "$work/own.inp"
own_scene() { echo "training = $1; heldout = 4000; seed = $2; mesh: { file = \"own.inp\"; };"; }
own_scene 2000 1 > "$work/mine.scene"
own_scene 4000 7 > "$work/fresh.scene"
bred() { "$evolve" --quiet --islands 1 --population 100 "$@"; }
expect 'a run' 0 '*' '*' bred --scene "$work/mine.scene" --generations 2 -o "$work/mine.gen" --page "$work/mine.svg"
cp "$work/stdout" "$work/said"
! grep -q '^front' "$work/said"; report $((! $?)) 'has no list of fronts, which --front asks for'
sed '1,/^full /d' "$work/said" > "$work/last"
n=$(wc -l < "$work/last")
[ "$n" -ge 1 ] && [ "$n" -le 5 ] && ! grep -qv '^use footpoint_mine_[a-z0-9]*: error [0-9.e-]* at cost [0-9]*; footpoint_quad4_[a-z0-9]* has [0-9.e-]* at [0-9]*$' \
    "$work/last"; report $((! $?)) 'ends in a verdict of five lines at most'
grep -q '^use footpoint_mine_' "$work/last"; report $((! $?)) 'which names a function that is better'
members=$(grep -c '^genome ' "$work/mine.gen")
[ "$members" -le 6 ]; report $((! $?)) 'of at most six, at the knees of the front'
[ $((2 * $(wc -l < "$work/last"))) -ge "$members" ]; report $((! $?)) 'half of which are better than shipped ones'

grep -q '>footpoint_mine_\.\.\.<' "$work/mine.svg" && grep -q '>footpoint_quad4_\.\.\.<' "$work/mine.svg" && grep -q '>warp, degrees<' "$work/mine.svg"
report $((! $?)) 'the page has both, and the shapes of the faces'
[ "$(grep -c '<rect [^>]*fill="hsl' "$work/mine.svg")" = $((4 * (members + 9) + 6)) ]
report $((! $?)) 'a cell for each function and band, and a key to colours'
[ "$(sed -n 's/^<text.*>\(use .*\)<.*/\1/p' "$work/mine.svg")" = "$(sed 's/;.*//' "$work/last")" ]; report $((! $?)) 'and the verdict'

# Prints errors on held-out samples of another seed, from a run that only measures and writes.
for from in "$work/mine.gen" evolve/genomes/quad4.gen; do
    bred --scene "$work/fresh.scene" --generations 0 --start "$from" -o "$work/again.gen" > /dev/null 2>&1
    awk '/^genome / { name = $2 } /^note heldout_both/ { print name, ($6 + $7) / 2 }' "$work/again.gen" > "$work/errors.$(basename "$from")"
    awk '/^genome / { name = $2 } /^note gaps_both/ { for (i = 8; i <= NF; i++) if ($i ~ /^[0-9.]+e-[0-9]+,?$/ && $(i - 1) != "to") print name, i, $i + 0 }' \
        "$work/again.gen" > "$work/bands.$(basename "$from")"
done
awk 'FILENAME ~ /errors.mine/ { own[$1] = $2; next } FILENAME ~ /errors.quad4/ { old[$1] = $2; next }
    { t = $2; sub(/^footpoint_mine_/, "", t); sub(/:$/, "", t); r = $8; sub(/^footpoint_quad4_/, "", r); n++
      if (own[t] > 2 * $4 + 1e-16 || $4 > 2 * own[t] + 1e-16 || old[r] > 2 * $10 + 1e-16 || $10 > 2 * old[r] + 1e-16) { bad++; print "# " $0, own[t], old[r] } }
    END { exit !(n > 0 && bad == 0) }' "$work/errors.mine.gen" "$work/errors.quad4.gen" "$work/last"
report $((! $?)) 'fresh samples confirm its errors'
awk 'FILENAME ~ /bands.mine/ { own[$1, $2] = $3; next } FILENAME ~ /bands.quad4/ { old[$1, $2] = $3; next }
    { t = $2; sub(/^footpoint_mine_/, "", t); sub(/:$/, "", t); r = $8; sub(/^footpoint_quad4_/, "", r)
      for (i = 8; i < 40; i++) if ((t, i) in own) { n++; if (!((r, i) in old) || own[t, i] > 1.1 * old[r, i] + 1e-15) { bad++; print "# " $0, i, own[t, i] } } }
    END { exit !(n > 0 && bad == 0) }' "$work/bands.mine.gen" "$work/bands.quad4.gen" "$work/last"
report $((! $?)) 'and no band of |gap| is worse'

expect 'a run from scratch' 0 '*' '*' bred --scene "$work/mine.scene" --generations 1 --from-scratch --population 20 -o "$work/scratch.gen"
tail -n 1 "$work/stdout" | grep -q 'footpoint_quad4'; report $((! $?)) 'is compared with what ships, too'
