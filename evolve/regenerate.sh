#!/bin/sh
# regenerate.sh SCENE...: the main job.  Evolve each scene from its committed genomes; where these change, or there is no
# header yet, emit the header.  Several scenes are done side by side, as many as there are ranks.  Reads BIN, MPIRUN
# (without -n), RANKS, GENERATIONS, SEED and FROM (scratch, or nothing) from the environment; `make regenerate` calls it.
# What a scene's run says is in $BIN/regenerate/NAME.log, if there are several.
progress() { printf '%s\n' "$*" >&2; }

# The header of a scene, if its genomes are others than before.
emit() { # emit SCENE GENOMES HEADER
    samples=
    if grep -q '^note precision float' "$2"; then
        samples=$BIN/$(basename "$2").samples
        "$BIN/footpoint-evolve" --scene "$1" --samples "$samples" || return
    fi
    "$BIN/footpoint-codegen" --allow-poles ${samples:+--samples "$samples"} "$2" -o "$3" || return
    rm -f "$samples"
    echo "$3"
}

regenerate() { # regenerate SCENE RANKS
    name=$(basename "$1" .scene)
    genomes=evolve/genomes/$name.gen header=generated/footpoint_$(echo "$name" | tr - _).h
    before=$(cat "$genomes" 2> /dev/null | cksum)
    # shellcheck disable=SC2086
    $MPIRUN -n "$2" "$BIN/footpoint-evolve" --scene "$1" --generations "$GENERATIONS" --seed "$SEED" \
        ${FROM:+--from-scratch} || return
    if [ "$GENERATIONS" -gt 0 ] && [ -e "$header" ] && [ "$(cksum < "$genomes")" = "$before" ]; then
        echo "$header is as it was"
    else
        emit "$1" "$genomes" "$header"
    fi
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

if [ $# = 1 ]; then
    regenerate "$1" "$RANKS"
    exit
fi
mkdir -p "$BIN/regenerate" && rm -f "$BIN/regenerate/"* || exit 3
STARTED=$(date +%s) SCENES=$#
at_once=$((RANKS < SCENES ? RANKS : SCENES))
export STARTED SCENES
printf '%s\n' "$@" | xargs -P "$at_once" -I{} sh "$0" --one {} $((RANKS / at_once))
status=$?
# What got better: rows of the runs' tables.
grep -H 'times less error' "$BIN/regenerate/"*.log | sed "s|^$BIN/regenerate/\(.*\)\.log:|\1 |" |
    awk 'BEGIN { n = 0 } { n++; print } END { if (n == 0) print "nothing got better by one in a hundred" }'
exit $status
