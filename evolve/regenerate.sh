#!/bin/sh
# regenerate.sh SCENE...: the main job.  Evolve each scene from its committed genomes, then emit the headers that were not
# emitted from these genomes, or all if GENERATIONS is 0.  Several scenes are done side by side, as many as there are ranks.
# A scene given by its name is the tree's.  A scene given by a path is somebody's own: genomes and header stand beside it, or
# in the folder OUT.  Genomes take the place of those before when a run has ended; an interrupted run changes nothing.
# regenerate.sh --derivatives FACE...: emit the headers of derivatives, as above.  regenerate.sh --table: a line a function of
# all headers, and what changed since the committed ones.  Reads BIN, MPIRUN (without -n), RANKS,
# GENERATIONS, ISLANDS (of each tier, or nothing), SEED, OUT and FROM (scratch, or nothing) from the environment; `make
# regenerate` calls it.  What a scene's run says is in $BIN/regenerate/NAME.log, if there are several.
progress() { printf '%s\n' "$*" >&2; }

# emit GENOMES HEADER [SCENE whose samples single precision is measured on]: the header, and in the tree the test points of
# searches in double
emit() {
    if [ "$GENERATIONS" -gt 0 ] && grep -q "sha256: $(sha256sum < "$1" | cut -d ' ' -f 1)" "$2" 2> /dev/null; then
        echo "$2 is as it was"
        return
    fi
    samples='' points=''
    if grep -q '^note precision float' "$1"; then
        samples=$BIN/$(basename "$1").samples
        "$BIN/footpoint-evolve" --scene "$3" --start "$1" --samples "$samples" || return
    elif ! grep -q '^face ' "$1" && [ "${2%/*}" = generated ]; then
        points=tests/generated/points/$(basename "$2" .h)_points.h
    fi
    "$BIN/footpoint-codegen" --allow-poles ${samples:+--samples "$samples"} ${points:+--points "$points"} "$1" -o "$2" || return
    rm -f "$samples"
    echo "$2"
}

is_own() { case $1 in evolve/scenes/*) return 1 ;; */* | *.scene) return 0 ;; esac; return 1; }

# What a run says comes first, its verdict last.
is_verdict='^use footpoint_\|^nothing found '
regenerate() { # regenerate SCENE RANKS
    name=$(basename "$1" .scene)
    header=footpoint_$(echo "$name" | tr - _).h
    genomes=evolve/genomes/$name.gen start='' page=''
    if is_own "$1"; then
        folder=${OUT:-$(dirname "$1")}
        mkdir -p "$folder" || return 3
        genomes=$folder/$name.gen header=$folder/$header page=$BIN/regenerate/$name.svg
        if [ -z "$FROM" ] && [ -e "$genomes" ]; then start=$genomes; fi
    else
        header=generated/$header
    fi
    mkdir -p "$BIN/regenerate" || return 3
    new=$BIN/regenerate/$name.gen found=$BIN/regenerate/$name.found
    rm -f "$new"
    # shellcheck disable=SC2086
    $MPIRUN -n "$2" "$BIN/footpoint-evolve" --scene "$1" --generations "$GENERATIONS" --seed "$SEED" -o "$new" \
        ${ISLANDS:+--islands "$ISLANDS"} ${FROM:+--from-scratch} ${start:+--start "$start"} ${page:+--page "$page"} > "$found"
    status=$?
    grep -v "$is_verdict" "$found"
    if [ $status -ne 0 ]; then
        [ ! -e "$new" ] || progress "$name: interrupted; genomes and header stand as they were, what was found is in $new"
        return $status
    fi
    [ ! -e "$page" ] || mv "$page" "$folder/$name.svg" || return
    mv "$new" "$genomes" && emit "$genomes" "$header" "$1" || return
    grep "$is_verdict" "$found" > "$found.verdict" && sh evolve/verdict.sh "$found.verdict" "$header" "$BIN/regenerate/$name.times"
    rm -rf "$found" "$found.verdict" "$BIN/regenerate/$name.times"
}

if [ "$1" = --one ]; then # regenerate.sh --one SCENE RANKS: one of several
    name=$(basename "$2" .scene)
    log=$BIN/regenerate/$name.log
    regenerate "$2" "$3" > "$log" 2>&1
    status=$?
    echo "$name $status" >> "$BIN/regenerate/done"
    done=$(grep -c . "$BIN/regenerate/done")
    left=$((($(date +%s) - STARTED) * (SCENES - done) / done))
    [ $status -eq 0 ] || tail -n 5 "$log" >&2
    progress "$name: scene $done of $SCENES, about $(((left + 59) / 60)) min left"
    exit $status
fi

if [ "$1" = --derivatives ]; then
    shift
    for face in "$@"; do
        emit "codegen/derivatives/$face.gen" "generated/footpoint_${face}_derivatives.h" || exit
    done
    exit
fi

if [ "$1" = --table ]; then
    awk -f evolve/what_ships.awk -v before="$BIN/regenerate/before" generated/footpoint_*.h > "$BIN/regenerate/table"
    cat "$BIN/regenerate/table"
    cat << END

origin:       bred by evolution, or derived by hand
promise:      largest error of xi and eta with FOOTPOINT_OK
mean error:   of xi as NAME_at computes it, on held-out samples
proved equal: to its genome, as rational functions, or at random points modulo primes
changed:      since the commit; "emitted anew" means the same formula in a header with other text

END
    awk 'NR > 1 { n++; same += $NF == "none" } END { print n " functions, " n - same " changed" }' "$BIN/regenerate/table"
    # Rows of the runs' tables.
    grep -H 'times less error\|right to rounding' "$BIN/regenerate/"*.log 2> /dev/null |
        sed "s|^$BIN/regenerate/\(.*\)\.log:|\1 |" > "$BIN/regenerate/better"
    [ -s "$BIN/regenerate/better" ] && cat "$BIN/regenerate/better" || echo 'evolution improved no function by 1 % or more; this is usual for one generation (GENERATIONS=)'
    echo 'make report draws time against error, build/report/index.html'
    exit
fi

if [ $# = 1 ]; then
    regenerate "$1" "$RANKS"
    exit
fi
rm -rf "${BIN:?}/regenerate" && mkdir -p "$BIN/regenerate/before" || exit 3
for header in generated/*.h; do # as committed, or as they are where git cannot tell
    git show "HEAD:$header" > "$BIN/regenerate/before/${header##*/}" 2> /dev/null || cp "$header" "$BIN/regenerate/before/"
done
STARTED=$(date +%s) SCENES=$#
at_once=$((RANKS < SCENES ? RANKS : SCENES))
export STARTED SCENES
printf '%s\n' "$@" | xargs -P "$at_once" -I{} sh "$0" --one {} $((RANKS / at_once))
status=$?
exit $status
