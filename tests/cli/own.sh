# A scene of one's own, given by a path: genomes and header stand beside it, or in a folder; the tree stays as it is.
. tests/cli/expect.inc
export OMPI_MCA_btl_base_warn_component_unused=0
state() { find evolve generated tests/generated -type f -newer "$work/begun" | sort; }
printf '#!/bin/sh\nshift 2\nexec "$@"\n' > "$work/alone"
printf '#!/bin/sh\nshift 2\nexec timeout -s TERM 6 "$@"\n' > "$work/ended"
chmod +x "$work/alone" "$work/ended"
regenerate() { env BIN="$BIN" MPIRUN="$work/alone" RANKS=1 GENERATIONS=1 SEED=1 OUT= FROM= "$@"; }
mkdir "$work/mine"
cp tests/meshes/tetra4.inp "$work/mine/"
echo 'training = 10; heldout = 10; mesh: { file = "tetra4.inp"; };' > "$work/mine/faces-1.scene"
touch "$work/begun"
expect 'a scene beside its mesh' 0 '*' '*' regenerate sh evolve/regenerate.sh "$work/mine/faces-1.scene"
[ -s "$work/mine/faces-1.gen" ] && [ -s "$work/mine/footpoint_faces_1.h" ]; report $((! $?)) 'genomes and header are there, too'
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
