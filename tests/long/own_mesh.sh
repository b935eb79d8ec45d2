# A header for one's own mesh, as the README tells it: the example's mesh becomes an input file, that a scene, that a
# header, and the example runs with it.  The error that the banner states for its gaps is not exceeded in the run; so a
# quicker function will do than the general header's banner would allow.  And evolution makes functions of the kind
# better for the mesh.
. tests/cli/expect.inc
CC=${CC:-gcc}
logged() { # logged NAME COMMAND...: as `report`, with what the command says where it fails
    name=$1
    shift
    "$@" > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) "$name"
}
holds() { # holds NAME CONDITION: of awk
    awk "BEGIN { exit !($2) }"
    good=$?
    [ $good = 0 ] || echo "# not so: $2"
    report $((!good)) "$1"
}
value() { awk -v what="$1" 'index($0, what) == 1 { print $'"$2"' }' "$work/table"; }
# banner HEADER FUNCTION: mean error of xi on held-out samples, random ones where the scene has both
banner() {
    { told "$1" "$2" heldout; told "$1" "$2" heldout_random; } | awk '{ e = $2 } END { print e }'
}
run_with() { # run_with HEADER FUNCTION PROGRAM: compile the example and run it; $error
    logged "the example with $2" \
        $CC -O3 -march=native -DHEADER="\"$1\"" -DLOCATE="$2" tests/example/impact.c -o "$work/$3" -lm
    "$work/$3" 0.5 > "$work/table"
    error=$(value "xi, eta off Newton's, mean" NF)
    echo "# $2: banner $(banner "$1" "$2"), in the run $error;" \
        "$(value 'local search, ns' '(NF-2)') ns a pair, $(value 'local search, ns' '(NF-1)') times"
}

# ---- before: the header for ordinary meshes, and its function of an error below 1e-7 ----
general=$PWD/generated/footpoint_quad4.h
run_with "$general" footpoint_quad4_precise before
precise=$(banner "$general" footpoint_quad4_precise)
holds 'whose banner states an error below 1e-7' "$precise < 1e-7 && $(banner "$general" footpoint_quad4_fine) > 1e-7"

# ---- mesh, scene, header ----
mkdir "$work/mine"
"$work/before" --inp > "$work/mine/plates.inp"
cp tests/example/plates-quad4.scene "$work/mine/"
status=$(git status --porcelain 2> /dev/null)
logged 'make regenerate' \
    make -s regenerate SCENE="$work/mine/plates-quad4.scene" GENERATIONS=20 CC="$CC"
grep -h 'segments are\|times less error\|right to rounding' "$work/log" | sed 's/^/# /'
[ "$(grep -c 'times less error' "$work/log")" -ge 3 ]; report $((! $?)) 'three functions have less error than those of quad4'
grep -q 'right to rounding as before' "$work/log"; report $((! $?)) 'one has no more than rounding, for less'
own=$work/mine/footpoint_plates_quad4.h
tail -n 1 "$work/log" | grep -q '^use footpoint_plates_quad4_'; report $((! $?)) 'the last line names a function to use'
[ -e "$own" ]; report $((! $?)) 'the header is there'
[ "$status" = "$(git status --porcelain 2> /dev/null)" ]; report $((! $?)) 'and the source tree as it was'

# ---- after ----
run_with "$own" footpoint_plates_quad4_balanced after
balanced=$(banner "$own" footpoint_plates_quad4_balanced)
holds 'its quicker function is below 1e-7 on this mesh' "$balanced < 1e-7"
beyond=$(awk '/^genome / { on = $2 == "balanced" } on && /^note gaps_both/ { print $NF }' "$work/mine/plates-quad4.gen")
holds 'in the run, where plates deform and most gaps are large, it has no more error than the banner states for these' \
    "$error < 2 * $beyond"
holds 'with energy and momentum as before' "$(value 'energy error' NF) < 6e-4 && $(value 'momentum error' NF) < 1e-13"
quicker() { # the least of runs in turn
    for program in before after; do
        "$work/$program" > "$work/table" && value 'local search, ns' '(NF-2)' >> "$work/$program.ns"
    done
    before=$(sort -n "$work/before.ns" | head -n 1) after=$(sort -n "$work/after.ns" | head -n 1)
    echo "# $before ns a pair before, $after after"
    awk "BEGIN { exit !($after < $before) }"
}
steady 'at less time' quicker
