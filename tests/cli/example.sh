# Checks the examples to copy. Impact compiles alone, keeps momentum to rounding and energy nearly, and both searches
# agree. Slide: contact with Gregory patches makes forces smoother and is never lost. Press: Newton's residuals fall
# quadratically on every kind of face, with and without friction, and equally in Fortran. Grid: nearest faces of a large
# sheet.
. tests/cli/expect.inc
CC=${CC:-gcc}
strict='-std=c11 -D_DEFAULT_SOURCE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror'
value() { awk -v what="$1" 'index($0, what) == 1 { print $'"$2"' }' "$work/table"; }
below() { # below NAME VALUE LIMIT
    awk -v x="$2" -v limit="$3" 'BEGIN { exit !(x != "" && x + 0 < limit) }'
    good=$?
    [ $good = 0 ] || echo "# $2, not below $3"
    report $((!good)) "$1"
}

$CC $strict -O1 tests/example/impact.c -o "$work/impact" -lm > "$work/log" 2>&1
good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log"
report $((!good)) 'compiles'
mkdir "$work/frames"
"$work/impact" 1 "$work/frames" > "$work/table"; report $((! $?)) 'runs'
for search in Newton footpoint; do
    column=$(case $search in Newton) echo NF-1 ;; *) echo NF ;; esac)
    below "momentum is kept, $search" "$(value 'momentum error' "($column)")" 1e-13
    below "moment of momentum is kept, $search" "$(value 'moment of momentum error' "($column)")" 1e-8
    below "energy is kept, $search" "$(value 'energy error' "($column)")" 3e-3
done
below "xi and eta agree" "$(value "xi, eta off Newton's, worst" NF)" 1e-4
below 'and so do the nodes at the end' "$(value 'nodes apart' NF)" 1e-8
below 'from the last answers energies of each step are the same, Newton' "$(value 'last: energies off' '(NF-1)')" 1e-13
below 'and footpoint' "$(value 'last: energies off' NF)" 1e-10
[ "$(ls "$work"/frames/impact_*.vtk | wc -l)" = 20 ]; report $((! $?)) 'a series of 20 frames'
awk '/^POINTS/ { points = $2 } /^CELLS/ { cells = $2; on = 1; next } /^CELL_TYPES/ { on = 0 }
     on { n++; for (i = 2; i <= 9; i++) if ($i < 0 || $i >= points) exit 1 } END { exit n != cells }' \
    "$work/frames/impact_0020.vtk"
report $((! $?)) 'whose cells have nodes'
awk -F, 'NF != 9 { exit 1 } $4 > 0 { touched = 1 } END { exit !(touched && $4 == 0) }' "$work/frames/energy.csv"
report $((! $?)) 'the plates meet and part'
expect 'usage' 2 '' 'usage: impact [SCALE [FOLDER]] | --inp       0 < SCALE <= 1: of the time step' "$work/impact" 0

# ---- slide ----
$CC $strict -O1 tests/example/slide.c runtime/geometry/gregory.c runtime/geometry/bezier.c runtime/geometry/node_normals.c -o "$work/slide" -lm \
    > "$work/log" 2>&1
good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log"
report $((!good)) 'slide compiles'
"$work/slide" 1 "$work" > "$work/table"; report $((! $?)) 'slide runs'
FACETS='(NF-3)' PATCHES='(NF-2)' EVEN='(NF-1)' BODY='NF'
smoother() { # smoother WHAT COLUMN FACTOR: the facets' figure is at least FACTOR times that of COLUMN
    below "$1: $3 times less" "$(value "$1" "$2")" "$(value "$1" "$FACETS / $3")"
}
smoother 'its jitter / mean' "$PATCHES" 5
smoother 'its jitter / mean' "$EVEN" 50
smoother 'its jitter, rms' "$PATCHES" 2
smoother 'its jitter, rms' "$EVEN" 30
smoother 'tangential force, rms' "$PATCHES" 2
smoother 'tangential force, rms' "$EVEN" 15
smoother 'its largest change in a step' "$PATCHES" 100
smoother 'normal turned' "$PATCHES" 500
below 'one gap on both sides of a patch edge, mm' "$(value "gap's jump" "$PATCHES")" 1e-4
for column in "$PATCHES" "$EVEN" "$BODY"; do
    below 'no node loses contact' "$(value 'nodes that lost' "$column")" 1
    below 'energy is kept' "$(value 'energy error' "$column")" 1e-4
    below 'momentum is kept' "$(value 'momentum error' "$column")" 1e-14
done
awk -F, 'NF != 9 { exit 1 } END { exit !(NR > 1000 && $1 > 15.99) }' "$work/slide.csv"
report $((! $?)) 'forces over the way'
expect 'usage of slide' 2 '' 'usage: slide [SCALE [FOLDER]]       0 < SCALE <= 1: of the time step' "$work/slide" 2

# ---- press ----
$CC $strict -O1 tests/example/press.c "$BIN/libfootpoint.a" -o "$work/press" -lm > "$work/log" 2>&1
good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log"
report $((!good)) 'press compiles'
later 'example: quad8 in Fortran, tri6, quad9 and edge3'
kinds='tri3 quad4 quad8 edge2'
[ -z "${FOOTPOINT_LONG:-}" ] || kinds='tri3 tri6 quad4 quad8 quad9 edge2 edge3'
for kind in $kinds; do
    for friction in 0 0.3; do
        "$work/press" $kind $friction > "$work/table"; report $((! $?)) "press finds equilibrium, $kind, friction $friction"
        cp "$work/table" "$work/press-$kind-$friction"
        awk 'NR > 2 { steps++; b = $(NF - 2); c = $(NF - 1); d = $NF; slid += $6
                      if (c > 300 * b * b && c > 1e-12 || d > 300 * c * c && d > 1e-12) { print "# " $0; bad = 1 } }
             END { exit bad || steps != 8 || (slid > 0) != ('$friction' > 0) }' "$work/table"
        report $((! $?)) 'its last three residuals fall quadratically'
        awk 'NR == 10 { exit !($4 / $3 > '$friction' - 0.05 && $4 / $3 < '$friction' + 0.05) }' "$work/table"
        report $((! $?)) 'and it is drawn with the force of friction'
    done
done
if [ -e "$BIN/footpoint.mod" ]; then
    gfortran -std=f2018 -Wall -Wextra -Wno-compare-reals -Werror -O1 -J"$work" -I"$BIN" tests/example/blocks.f90 tests/example/press.f90 \
        "$BIN/libfootpoint.a" -o "$work/press_f" -lm > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) 'press compiles in Fortran'
    for kind in quad4 ${FOOTPOINT_LONG:+quad8}; do
        awk 'NR > 2 { print $1, $2, $3, $4, $5, $6 }' "$work/press-$kind-0.3" > "$work/table"
        expect "and is the same on $kind" 0 "$(cat "$work/table")" '' \
            sh -c "'$work/press_f' $kind 0.3 | awk 'NR > 2 { print \$1, \$2, \$3, \$4, \$5, \$6 }'"
    done
else
    report 1 'skipped: no gfortran'
fi
expect 'usage of press' 2 '' 'usage: press [KIND [FRICTION]]       KIND: tri3, tri6, quad4, quad8, quad9, edge2, edge3; 0 <= FRICTION <= 1' \
    "$work/press" quad5
expect 'and of its friction' 2 '' 'usage: press [KIND [FRICTION]]       KIND: tri3, tri6, quad4, quad8, quad9, edge2, edge3; 0 <= FRICTION <= 1' \
    "$work/press" quad4 -1

# ---- grid ----
$CC $strict -Iruntime -O1 tests/example/grid.c "$BIN/libfootpoint.a" -o "$work/grid" -lm > "$work/log" 2>&1
good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log"
report $((!good)) 'grid compiles'
"$work/grid" $([ -n "$FOOTPOINT_LONG" ] && echo 100000 || echo 1000) > "$work/log"
good=$?
sed 's/^/# /' "$work/log"
report $((!good)) 'the grid finds the faces that a search of all finds'
expect 'usage of grid' 2 '' 'usage: grid [FACES]       from 4 to 10000000' "$work/grid" 1
