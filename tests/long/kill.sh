# Kills jobs with kill -9 at 20 random moments, whole or a single rank, and resumes them on other numbers of ranks until
# they are done. Genomes and log must be the same as without; hostile checkpoints are tried on the way.
. tests/cli/expect.inc
evolve=$BIN/footpoint-evolve
export OMPI_MCA_btl_base_warn_component_unused=0
mpirun="mpirun -q --oversubscribe"
[ "$(id -u)" != 0 ] || mpirun="$mpirun --allow-run-as-root"
cp tests/scenes/small.scene "$work/"
generations=1000
options="--scene $work/small.scene --seed 5 --from-scratch --islands 3 --population 60 --quiet --generations $generations"
$mpirun -n 2 "$evolve" $options -o "$work/whole.gen" --log "$work/whole.csv" > /dev/null 2>&1
[ -s "$work/whole.gen" ]; report $((! $?)) 'a run without interruption'

random() { awk -v seed="$1" -v n="$2" 'BEGIN { srand(seed); rand(); print int(rand() * n) }'; }
ranks_of() { # ranks_of PID: processes of footpoint-evolve that this mpirun started
    ps -o pid=,comm= --ppid "$1" | awk '$2 ~ /^footpoint-evol/ { print $1 }'
}
generation() { sed -n 's/^generation //p;/^scene /q' "$work/ck" 2> /dev/null | head -1; }

kills=0 tries=0 bad=
rm -f "$work/k.gen" "$work/k.csv" "$work/ck"
while [ $kills -lt 20 ] && [ $((tries += 1)) -le 60 ]; do
    ranks=$((1 + tries % 4)) from=$(generation)
    if [ -e "$work/ck" ]; then
        set -- --resume "$work/ck" --quiet
        # While there is much to do yet, an odd copy must be refused and leave the checkpoint alone.
        size=$(wc -c < "$work/ck")
        head -c "$(random $((tries + 100)) "$size")" "$work/ck" > "$work/cut"
        cp "$work/ck" "$work/flipped"
        at=$(random $((tries + 200)) "$size")
        byte=$(dd if="$work/ck" bs=1 skip="$at" count=1 2> /dev/null | od -An -tu1)
        printf "\\$(printf %o $((${byte:-0} ^ 1 << tries % 8)))" | dd of="$work/flipped" bs=1 seek="$at" conv=notrunc 2> /dev/null
        for copy in cut flipped; do
            timeout 60 "$evolve" --resume "$work/$copy" -o "$work/none.gen" > /dev/null 2> "$work/err"
            status=$?
            [ $status = 1 ] && [ "$(grep -vc '^\[hwloc' "$work/err")" = 1 ] && [ ! -e "$work/none.gen" ] || bad="$bad $copy:$at:$status"
        done
    else
        set -- $options -o "$work/k.gen" --log "$work/k.csv" --checkpoint "$work/ck" --checkpoint-every 0.2
    fi
    $mpirun -n $ranks "$evolve" "$@" > /dev/null 2>&1 &
    pid=$!
    for wait in $(seq 600); do # seeds grow before the first checkpoint
        [ -e "$work/ck" ] && break
        sleep 0.1
    done
    sleep "$(random $tries 1500 | awk '{ print 0.4 + $1 / 1000 }')"
    victims=$(ranks_of $pid)
    if [ $((kills % 2)) = 0 ]; then
        kill -9 $pid $victims 2> /dev/null
    else
        kill -9 $(echo "$victims" | head -$((1 + tries % ranks)) | tail -1) 2> /dev/null
    fi
    wait $pid 2> /dev/null
    status=$?
    [ -e "$work/k.gen" ] && [ "$(generation)" = $generations ] && break
    [ $status -ne 0 ] && [ -n "$victims" ] && kills=$((kills + 1))
    echo "# $ranks ranks from generation ${from:-0}: exit status $status at $(generation)"
done
[ -z "$bad" ] || echo "# not refused:$bad"
[ -z "$bad" ]; report $((! $?)) 'cut and flipped checkpoints are refused in one line'
[ $kills -ge 20 ]; report $((! $?)) "killed at $kills random moments"
$mpirun -n 3 "$evolve" --resume "$work/ck" --quiet > /dev/null 2>&1
cmp -s "$work/whole.gen" "$work/k.gen"; report $((! $?)) 'resumed to the same genomes'
cmp -s "$work/whole.csv" "$work/k.csv"; report $((! $?)) 'resumed to the same log'
