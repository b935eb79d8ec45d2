# Checks footpoint-evolve: usage, diagnostics, exit statuses; the same bytes on any number of ranks; no loss on bad input.
. tests/cli/expect.inc
evolve=$BIN/footpoint-evolve
export OMPI_MCA_btl_base_warn_component_unused=0
mpirun="mpirun --oversubscribe"
[ "$(id -u)" != 0 ] || mpirun="$mpirun --allow-run-as-root"

scene() { sed "$1" tests/scenes/small.scene > "$work/s.scene"; }
refused() { expect "$1" 1 '' "$2" "$evolve" --scene "$work/s.scene" -o "$work/o.gen" --generations 1; }

expect 'help' 0 '*' '' "$evolve" --help
expect 'version' 0 'footpoint-evolve 0.3.0' '' "$evolve" --version
expect 'no scene' 2 '' 'footpoint-evolve: error: --scene is missing; try --help' "$evolve"
expect 'unknown option' 2 '' "footpoint-evolve: error: unknown option '--speed'; try --help" "$evolve" --speed
expect 'no islands' 2 '' 'footpoint-evolve: error: --islands 0 is out of range' "$evolve" --scene quad4 --islands 0
expect 'one individual' 2 '' 'footpoint-evolve: error: --population 1 is out of range' "$evolve" --scene quad4 --population 1
expect 'contradiction' 2 '' 'footpoint-evolve: error: --start and --from-scratch exclude each other' \
    "$evolve" --scene quad4 --start x --from-scratch
expect 'unknown scene' 3 '' './evolve/scenes/nowhere.scene: error: cannot open: No such file or directory' "$evolve" --scene nowhere

scene 's/^norm/colour/';           refused 'unknown key' "$work/s.scene:5: error: unknown key 'colour' in scene"
scene 's/"20 deg"/20.0/';          refused 'angle without a unit' "$work/s.scene:10: error: 'skew' must be an angle with its unit, \"45 deg\" or \"0.8 rad\""
scene 's/"20 deg"/"20 mm"/';       refused 'wrong unit' "$work/s.scene:10: error: 'skew' has the unknown unit 'mm'; it must be deg or rad"
scene 's/aspect = 2.0/aspect = 0.5/'; refused 'out of range' "$work/s.scene:10: error: 'aspect' must be in 1..1000; 5.0 is usual"
scene 's/training  = 700/training  = 0/'; refused 'zero samples' "$work/s.scene:8: error: 'training' must be in 1..100000000"
scene 's/"parallelogram"/"trapezium"/'; frames=$(ls evolve/frames | sed 's/.gen$//' | paste -s -d , | sed 's/,/, /g')
refused 'unknown frame' "$work/s.scene:11:9: error: tier 'steps': no frame 'trapezium'; available: $frames"
scene 's/"similarity"/"similar"/'; refused 'unknown frame of a tier' "$work/s.scene:14:31: error: tier 'paper': no frame 'similar'; available: $frames"
scene 's/"parallelogram"/"tri6"/'; refused 'frame of another kind' "$work/s.scene:11:9: error: tier 'steps': frame 'tri6' is for segment tri6"
scene 's/"xi0", "eta0", "p"/"xi0", "eta0", "pp"/'
refused 'unknown terminal' "$work/s.scene:13: error: tier 'steps': 'pp' is not a value of frame 'parallelogram'"

# A frame's value that is infinite on a sample is refused; constant values are accepted.
mkdir -p "$work/root/evolve" && cp -r evolve/frames "$work/root/evolve/" && echo 'let bad = 1/(xi0 - -0.5)' >> "$work/root/evolve/frames/parallelogram.gen"
scene 's/"xi0", "eta0", "p"/"xi0", "eta0", "bad"/'
expect 'infinite value' 1 '' "$work/s.scene:13: error: 'bad' is not finite on 700 of 700 training samples" \
    "$evolve" --root "$work/root" --scene "$work/s.scene" -o "$work/o.gen" --generations 1

# If a tier has no finite error, the other tiers are written with a message.
cp evolve/frames/parallelogram.gen "$work/root/evolve/frames/" && cat >> "$work/root/evolve/frames/parallelogram.gen" <<'FUNCTION'
function blow u v -> xi eta j
    let j = p - 0.01
    let xi = u/j
    let eta = v
end
FUNCTION
scene '0,/max_length = 30/s//last = "blow"; max_length = 30/'
expect 'a tier of which nothing is finite' 1 '*' "$work/s.scene: error: tier 'steps': no expression has a finite error on every sample" \
    "$evolve" --root "$work/root" --scene "$work/s.scene" -o "$work/o.gen" --generations 1 --islands 1 --quiet
grep -q '^genome paper' "$work/o.gen" && ! grep -q '^genome steps' "$work/o.gen"; report $((! $?)) 'is left out, the other is written'
rm -f "$work/o.gen"
scene 's/\["xi0", "eta0", "p", "q", "a", "b"\]/["xi0", "eta0"]/'
expect 'constant values alone' 0 '*' '' "$evolve" --scene "$work/s.scene" -o "$work/o.gen" --generations 1 --islands 1 --quiet
rm -f "$work/o.gen"
scene 's/max_length = 30/max_length = 30; budget = 0.5/'; refused 'budget below an operation' "$work/s.scene:13: error: 'budget' must be in 1..1e+06"

mesh() { sed 's|^shapes.*|mesh: { file = "m.inp"; distance = '"$1"'; };|' tests/scenes/small.scene > "$work/s.scene"; }
mesh 0.5; rm -f "$work/m.inp"; refused 'missing mesh' "$work/s.scene:10: error: cannot read mesh file '$work/m.inp'"
cp tests/meshes/wedges.inp "$work/m.inp"; mesh 0.5
sed -i 's/^S_BOTTOM, S2/BEAM, S1/' "$work/m.inp"
expect 'a master face on a beam' 1 '' '*' "$evolve" --scene "$work/s.scene" -o "$work/o.gen" --generations 1
grep -q "^$work/m.inp:$(grep -n 'BEAM, S1' "$work/m.inp" | head -1 | cut -d : -f 1): error: element 10 of a master surface has type B32R without known faces; it must be a solid, shell or membrane" \
    "$work/stderr"; report $((! $?)) 'is refused where its surface names it, with what is supported'

# Among beams, masses and springs: master faces of two kinds, between which the scene chooses.
cp tests/meshes/wedges.inp "$work/m.inp"
sed -i '/^segment/d' "$work/s.scene"
refused 'faces of two kinds' "$work/s.scene:9: error: master faces are of several kinds: 2 of tri3, 1 of quad4; choose one with segment = \"...\";"
mesh 0.5; sed -i 's/"quad4"/"tri6"/; s/"nearest"/"any"/' "$work/s.scene"
refused 'faces of neither' "$work/s.scene:10: error: no master face has segment 'tri6'; there are 2 of tri3, 1 of quad4"
tri3() { sed "$1"'; /^frame/,$d; s|^shapes.*|mesh: { file = "m.inp"; distance = 0.5; };|; s/"nearest"/"any"/; s/^reference.*/reference = [0.2, 0.2];/' \
    tests/scenes/small.scene > "$work/s.scene"
    echo 'tiers = ({ name = "exact"; frame = "tri3"; terminals = ["exact_xi", "exact_eta"]; max_length = 1; functions = "polynomial"; });' >> "$work/s.scene"; }
tri3 's/"quad4"/"tri3"/'
expect 'one kind is chosen' 0 '*' '' "$evolve" --scene "$work/s.scene" --from-scratch -o "$work/chosen.gen" --generations 1 --quiet
sed -i '/^S_TOP/d' "$work/m.inp"; tri3 '/^segment/d'
expect 'the only kind need not be named' 0 '*' '' "$evolve" --scene "$work/s.scene" --from-scratch -o "$work/only.gen" --generations 1 --quiet
grep -q '^segment tri3 ' "$work/chosen.gen" && grep -q '^segment tri3 ' "$work/only.gen"; report $((! $?)) 'segments are triangles'
rm -f "$work/o.gen"
cp tests/meshes/punch.inp "$work/m.inp"; mesh 1e-9
expect 'no node of the mesh is near enough' 0 '*' '*' "$evolve" --scene "$work/s.scene" --from-scratch -o "$work/o.gen" --generations 1 --islands 1 --quiet
grep -q '^s: 0 training samples are slave nodes of the mesh, too few to go by' "$work/stdout"; report $((! $?)) 'which is said'
grep -q '^note gaps_both mean at |gap| over shortest edge to 1e-3 ' "$work/o.gen"; report $((! $?)) 'errors are told by bands of the gap'
mesh 5; expect 'a distance of several edges' 0 '*' '*' "$evolve" --scene "$work/s.scene" --from-scratch -o "$work/o.gen" --generations 0 --quiet
grep -q "^$work/s.scene:10: warning: 'distance' of 5 is more than 0.5 times the shortest master edge, " "$work/stderr"; report $((! $?)) 'is warned of'
sed -i 's/ distance = 5;//' "$work/s.scene"
expect 'no distance' 0 '*' '' "$evolve" --scene "$work/s.scene" --from-scratch -o "$work/o.gen" --generations 0 --quiet
awk '/^note range contact/ { exit !($8 > 0.1 && $8 < 2) }' "$work/o.gen"; report $((! $?)) 'is a fifth of the shortest master edge'
rm -f "$work/o.gen"

scene ''
cp tests/scenes/small.scene "$work/"
[ -n "$FOOTPOINT_LONG" ] && population=40 || population=16
[ -n "$FOOTPOINT_LONG" ] && few=2 || few=1
on() { [ "$1$FOOTPOINT_LONG" = 1 ] || echo "$mpirun -n $1"; } # one rank needs no mpirun
run() { ranks=$1; shift; $(on "$ranks") "$evolve" --scene "$work/small.scene" --quiet --seed 5 --population $population --migrate-every 2 "$@"; }
expect 'from scratch on 1 rank' 0 '*' '' run 1 --from-scratch --generations 5 --islands 3 -o "$work/r1.gen"
later 'evolve: 2 and 4 ranks, one by mpirun, larger populations'
for ranks in ${FOOTPOINT_LONG:+2} 3 ${FOOTPOINT_LONG:+4}; do
    run $ranks --from-scratch --generations 5 --islands 3 -o "$work/r$ranks.gen" > /dev/null
    cmp -s "$work/r1.gen" "$work/r$ranks.gen"; report $((! $?)) "$ranks ranks, the same bytes"
done
if [ -n "$FOOTPOINT_LONG" ]; then
    expect 'without mpirun' 0 '*' '' "$evolve" --scene "$work/small.scene" --quiet --seed 5 --population $population --migrate-every 2 \
        --from-scratch --generations 5 --islands 3 -o "$work/r0.gen"
    cmp -s "$work/r1.gen" "$work/r0.gen"; report $((! $?)) 'and the same bytes'
fi
run $few --start "$work/r1.gen" --generations 0 -o "$work/again.gen" > /dev/null
cmp -s "$work/r1.gen" "$work/again.gen"; report $((! $?)) 'no generations: the same file again'
run 2 --start "$work/r1.gen" --generations 6 -o "$work/later.gen" > "$work/table"
worse=$(awk '/->/ && $5 + 0 > $3 + 0' "$work/table")
[ -z "$worse" ] && grep -q -- '->' "$work/table"; report $((! $?)) 'a second run makes nothing worse'
"$BIN/footpoint-codegen" --effort 1 --allow-poles "$work/later.gen" -o "$work/small.h" --prefix small 2> /dev/null &&
    grep -q 'small_paper_at' "$work/small.h"; report $((! $?)) 'both frames end in a header'
tr -s ' *\n' ' ' < "$work/small.h" | grep -q 'heldout: xi [^:]*, of [0-9]* samples and climbing'; report $((! $?)) 'whose banner has errors of climbing, too'
run 1 --seed 6 --start "$work/r1.gen" --generations 0 -o "$work/other.gen" > /dev/null
grep '^note heldout' "$work/r1.gen" | grep -qvxF -f "$work/other.gen" && grep -v '^note heldout\|^require\|^range' "$work/other.gen" | grep -qvxF -f "$work/r1.gen"
[ $? -eq 1 ]; report $((! $?)) 'another seed holds out other samples, and changes no expression'

sed 's/^xi = .*/xi = + p/' "$work/r1.gen" > "$work/bad.gen"
expect 'malformed start file' 1 '' '*' "$evolve" --scene "$work/small.scene" --start "$work/bad.gen" -o "$work/o.gen"
[ ! -e "$work/o.gen" ]; report $((! $?)) 'and nothing is written'
mkdir "$work/closed"
expect 'output folder missing' 3 '' "$work/none/o.gen: error: cannot write: No such file or directory" \
    "$evolve" --scene "$work/small.scene" --from-scratch -o "$work/none/o.gen" --generations 100000000

# A run may end before it begins to breed: existing genomes are written.
sed 's/training  = 700/training  = 30000/' tests/scenes/small.scene > "$work/large.scene"
interrupted() { # by SIGTERM, soon after it is listened to (bit 15 of those caught)
    "$evolve" --scene "$work/large.scene" --quiet --from-scratch --generations 100000000 --checkpoint "$work/ck" -o "$work/part.gen" &
    pid=$! tries=200
    until grep -q '^SigCgt:.*[4-7c-f]...$' "/proc/$pid/status" || [ $((tries -= 1)) = 0 ]; do sleep 0.05; done
    sleep 0.2
    kill -TERM $pid
    wait $pid
}
expect 'interrupted' 143 '*' '*' interrupted
"$BIN/footpoint-codegen" --effort 0 --allow-poles --count "$work/part.gen" > /dev/null 2>&1 && ! ls "$work" | grep -q tmp; report $((! $?)) 'genomes are there, nothing half-written'
! grep -q climbing "$work/part.gen"; report $((! $?)) 'measured in a hurry, without climbing'

# Missing frame and tiers follow from the segments; if a value of the frame is exact, nothing is evolved.
sed 's/taper = 0.2; warp = "10 deg"/taper = 0; warp = "0 deg"/; /^reference/d; /^frame/,$d' tests/scenes/small.scene \
    > "$work/lean.scene"
lean() { ranks=$1; shift; $(on "$ranks") "$evolve" --scene "$work/lean.scene" --quiet "$@"; }
lean 1 --from-scratch --generations 100000 -o "$work/l1.gen" > "$work/table"
grep -q '^lean: segments are parallelograms (.*), frame affine: nothing to evolve, the formula is exact$' "$work/table"
report $((! $?)) 'parallelograms say that their formula is exact'
grep -q '^xi = parallelogram_xi, eta = parallelogram_eta$' "$work/l1.gen" && grep -q '^note exact_eta nothing evolved' "$work/l1.gen"
report $((! $?)) 'and so does the genome'
lean 3 --from-scratch --generations 7 --islands 3 -o "$work/l3.gen" > /dev/null
lean $few --start "$work/l1.gen" --generations 3 -o "$work/l2.gen" | grep -c 'unchanged$' > "$work/count"
cmp -s "$work/l1.gen" "$work/l3.gen" && cmp -s "$work/l1.gen" "$work/l2.gen" && [ "$(cat "$work/count")" = 2 ]
report $((! $?)) 'the same bytes on any number of ranks, and from its own genome'
sed 's/"10 deg"/"0 deg"/; /^reference/d; /^frame/,$d' tests/scenes/small.scene > "$work/lean.scene"
lean $few --from-scratch --generations 2 -o "$work/l2.gen" > "$work/table"
grep -q '^lean: segments are plane (.*), frame plane: nothing to evolve for exact$' "$work/table" &&
    [ "$(grep -c '^note found_\|^note exact_' "$work/l2.gen")" = 6 ]
report $((! $?)) 'plane segments: two tiers are evolved, one is exact'

# Other kinds take those of the kind's scene; unusual limits are reported.
printf '%s\n' 'segment = "quad8"; training = 300; heldout = 200;' \
    'shapes: { aspect = 2.0; skew = "20 deg"; taper = 0.2; warp = "9 deg"; curve = 0.03; shift = 0.02; overhang = 0.1;' 'gap = 3.0; };' \
    > "$work/faces.scene"
expect 'a scene of few words' 0 '*' "$work/faces.scene:3: warning: 'gap' is 3; 0.2 is usual" \
    timeout 60 $mpirun -n 2 "$evolve" --scene "$work/faces.scene" --from-scratch --generations 1 --population 20 --quiet -o "$work/faces.gen"
grep -q '^faces: segments are quad8, frame quad8' "$work/stdout" && [ "$(grep -c '^genome' "$work/faces.gen")" = "$(grep -c 'name =' evolve/scenes/quad8.scene)" ]
report $((! $?)) 'has the frame and the tiers of its kind'
# Tiers of one gene are chosen at once, and others are evolved beside them.
grep -q '^faces: nothing to evolve for medium: one gene, chosen among the frame.s values$' "$work/stdout" &&
    grep -q '^faces: .*: nothing to evolve for full$' "$work/stdout" &&
    [ "$(grep -c '^note found_.* nothing to evolve, chosen among the frame' "$work/faces.gen")" = 2 ] &&
    grep -q '^xi = xi5t, eta = eta5t$' "$work/faces.gen"
report $((! $?)) 'tiers of one gene need no generations'
"$evolve" --scene "$work/faces.scene" --start "$work/faces.gen" --generations 0 --quiet -o "$work/again.gen" > /dev/null 2>&1
cmp -s "$work/faces.gen" "$work/again.gen"; report $((! $?)) 'and their genomes come again'
scene 's/max_length = 30/max_length = 1/; s/-0.5/0.0/g; s/nearest/any/; s/"xi0", "eta0", "p"/"p"/'
run $few --scene "$work/s.scene" --from-scratch --generations 5 -o "$work/one.gen" 2> /dev/null > "$work/table"
grep -q '^s: nothing to evolve for steps: ' "$work/table" && grep -q '^note found_both seed 5 generations 5 ' "$work/one.gen" &&
    [ "$(grep -c '^note found_.* nothing to evolve' "$work/one.gen")" = 2 ] && grep -q '^xi = p, eta = q$' "$work/one.gen"
report $((! $?)) 'one tier of one gene beside one that is evolved'

# On a terminal of 60 columns one line updates itself, under mpirun, too; elsewhere lines are plain.
if [ -n "$(command -v script)" ]; then
    script -qec "stty cols 60; $mpirun -n 2 $evolve --scene $work/small.scene --population 10 --generations 20 -o $work/t.gen" /dev/null > "$work/tty"
    tr '\r' '\n' < "$work/tty" | sed -n 's/\x1b\[K//; /^[0-9]*\/20 .* left /p' > "$work/lines"
    [ -s "$work/lines" ] && [ -z "$(awk 'length > 59' "$work/lines")" ] && tail -1 "$work/lines" | grep -q '^20/20 '
    report $((! $?)) 'a line on a terminal'
fi
$mpirun -n 2 "$evolve" --scene "$work/small.scene" --population 10 --generations 20 -o "$work/t.gen" 2>&1 > /dev/null | grep '^generation' > "$work/lines"
[ "$(wc -l < "$work/lines")" -gt 10 ] && ! grep -q "$(printf '[\r\033]')" "$work/lines" &&
    tail -1 "$work/lines" | grep -q '^generation 20/20  0 s left  .* genes x samples/s  steps both .*  paper both '
report $((! $?)) 'plain lines in a file'
