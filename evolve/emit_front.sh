#!/bin/sh
# emit_front.sh SCENE FOLDER: turns members of a scene's fronts into methods of a bench.  Breeds from the committed genomes, which
# do not change, then emits and proves the members that may become tiers.  FOLDER gets the members as genomes and as a header,
# and the lists of functions to compile into the bench, including the shipped ones.  Reads BIN, MPIRUN (without -n), RANKS,
# GENERATIONS, SEED and MEMBERS from the environment.  `make front` calls it, times the members, and prints which to ship
# (which_ship.awk).
name=$(basename "$1" .scene)
id=$(echo "$name" | tr - _)
members=$2/$name-front.gen header=$2/footpoint_${id}_front.h
mkdir -p "$2" || exit 3
# shellcheck disable=SC2086
$MPIRUN -n "$RANKS" "$BIN/footpoint-evolve" --scene "$1" --generations "$GENERATIONS" --seed "$SEED" --quiet \
    -o "$2/$name.gen" --front "$members" --members "$MEMBERS" > "$2/log" || exit
"$BIN/footpoint-codegen" --allow-poles "$members" -o "$header" || exit
headers=$(ls "generated/footpoint_$id.h" "$header" 2> /dev/null)
for h in $headers; do
    case $h in /*) echo "#include \"$h\"" ;; *) echo "#include \"$PWD/$h\"" ;; esac
done > "$2/methods.h"
# shellcheck disable=SC2086
awk -f tests/bench/methods.awk $headers > "$2/methods.inc"
