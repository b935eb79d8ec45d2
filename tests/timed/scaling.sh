# Two ranks on two free cores do nearly twice the work of one, and so have twice the islands in the same time.  Measured at
# a moment when nobody else uses the machine; skipped where there is none.
. tests/cli/expect.inc
evolve=$BIN/footpoint-evolve
mpirun="mpirun -q --bind-to none"
[ "$(id -u)" != 0 ] || mpirun="$mpirun --allow-run-as-root"
[ "$(nproc)" -ge 2 ] || { echo 'ok 1 - # skip one core'; exit 0; }
sed 's/^training .*/training = 20000;/' tests/scenes/small.scene > "$work/small.scene"

busy() { awk '/^cpu / { print $2 + $3 + $4 + $7 + $8 + $9 }' /proc/stat; } # ticks of all cores
quiet() { # within half a minute: a second with less than a tenth of a core in use
    for try in $(seq 30); do
        before=$(busy); sleep 1; after=$(busy)
        [ $((after - before)) -lt $(($(getconf CLK_TCK) / 10)) ] && return 0
    done
    return 1
}
rate() { # rate RANKS: genes x samples per second
    $mpirun -n "$1" "$evolve" --scene "$work/small.scene" --from-scratch --islands $((2 * $1)) \
        --generations 60 -o "$work/o.gen" 2>&1 > /dev/null |
        sed -n 's|^generation .* left  \([^ ]*\) genes x samples/s.*|\1|p' | tail -n 1
}
best=0
for round in 1 2 3 4 5; do
    quiet || break
    best=$(echo "$(rate 1) $(rate 2) $best" | awk '{ r = $1 > 0 ? $2 / $1 : 0; print (r > $3 ? r : $3) }')
    echo "# two ranks: $best times one"
    awk "BEGIN { exit !($best >= 1.9) }" && break
done
[ "$best" != 0 ] || { echo 'ok 1 - # skip the machine is busy'; exit 0; }
awk "BEGIN { exit !($best >= 1.9) }"
report $((! $?)) "two ranks do $best times the work of one"
