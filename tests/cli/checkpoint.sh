# Interrupts footpoint-evolve: results have the same bytes after kill -9, signals and time limits, on any number of ranks.  Hostile
# checkpoints, full disks and contradictions end in one line and leave files unchanged.
. tests/cli/expect.inc
evolve=$BIN/footpoint-evolve
export OMPI_MCA_btl_base_warn_component_unused=0
mpirun="mpirun -q --oversubscribe"
[ "$(id -u)" != 0 ] || mpirun="$mpirun --allow-run-as-root"
cp tests/scenes/small.scene "$work/"
[ -n "$FOOTPOINT_LONG" ] && population=40 || population=20
options="--scene $work/small.scene --seed 5 --from-scratch --islands 3 --population $population --migrate-every 3 --quiet"
paper="$options --breeding paper" # trees
same() { cmp -s "$1" "$2"; report $((! $?)) "$3"; }

usage() { expect "$1" 2 '' "footpoint-evolve: error: $2" "$evolve" --scene quad4 $3; }
usage 'resume from scratch' '--resume and --from-scratch exclude each other' '--resume x --from-scratch'
usage 'resume and start' '--resume and --start exclude each other' '--resume x --start y'
usage 'checkpoints without a file' '--checkpoint-every needs --checkpoint' '--checkpoint-every 5'
usage 'no time' "--time-limit 0 is out of range" '--time-limit 0'
usage 'odd time' "--time-limit needs seconds or H:MM:SS, not '1:99'" '--time-limit 1:99'
usage 'odd topology' "--topology has no choice 'star'" '--topology star'
usage 'more migrants than individuals' '--migrate-fraction 1.5 is out of range (0 to 0.5)' '--migrate-fraction 1.5'
usage 'one file for two things' '--checkpoint and --log are one file: f' '--checkpoint f --log f'

# Runs without interruption, then in two parts on other numbers of ranks: genomes and log.
"$evolve" $options --generations 12 -o "$work/whole.gen" --log "$work/whole.csv" > /dev/null 2>&1
cp "$work/whole.csv" "$work/log.csv" && head -1 "$work/log.csv" | grep -q '^generation,island,tier,output,place,best_error,' &&
    [ "$(wc -l < "$work/log.csv")" = $((1 + 12 * 6)) ]; report $((! $?)) 'a line for each generation and island'
$mpirun -n 3 "$evolve" $options --generations 12 -o "$work/o.gen" --log "$work/log.csv" > /dev/null 2>&1
same "$work/whole.csv" "$work/log.csv" 'the same log from 3 ranks'
$mpirun -n 3 "$evolve" $options --generations 6 -o "$work/parts.gen" --log "$work/parts.csv" --checkpoint "$work/ck" > /dev/null 2>&1
mv "$work/ck" "$work/three"
"$evolve" $options --generations 6 -o "$work/parts.gen" --log "$work/parts.csv" --checkpoint "$work/ck" > /dev/null 2>&1
same "$work/ck" "$work/three" 'the same checkpoint from 1 and 3 ranks'
cp "$work/ck" "$work/good"; echo rubbish >> "$work/parts.csv"
look=$(sed -n 's/^# submit it again .*until `\(.*\) run\.ckpt` says 100000$/\1/p' evolve/README.md)
expect 'the generation, as the README'"'"'s job asks for it' 0 'generation 6' '' sh -c "$look '$work/good'"
$mpirun -n 2 "$evolve" --resume "$work/ck" --generations 12 --quiet > /dev/null 2>&1
same "$work/whole.gen" "$work/parts.gen" 'begun on 3 ranks, resumed on 2: the same genomes'
same "$work/whole.csv" "$work/parts.csv" 'and the same log'
later "checkpoint: two topologies, SIGUSR1, a full disk and what signals end on two ranks"
for topology in torus ${FOOTPOINT_LONG:+random none}; do
    "$evolve" $paper --topology $topology --generations 25 -o "$work/t1.gen" > /dev/null 2>&1
    $mpirun -n 2 "$evolve" $paper --topology $topology --generations 25 -o "$work/t2.gen" > /dev/null 2>&1
    same "$work/t1.gen" "$work/t2.gen" "$topology: the same genomes from 1 and 2 ranks"
done

# Kills runs, and ends them by signals.
options=$paper
started() { # started PID: its first checkpoint is there
    tries=200
    until [ -e "$work/ck" ] || [ $((tries -= 1)) = 0 ] || ! kill -0 "$1" 2> /dev/null; do sleep 0.05; done
}
interrupted() { # interrupted NAME SIGNAL STATUS [OPTIONS...]: then resumed to its end, compared with a run in one go
    name=$1 signal=$2 wanted=$3
    shift 3
    rm -f "$work/ck" "$work/i.gen" "$work/i.csv"
    "$evolve" $options --generations 100000000 -o "$work/i.gen" --log "$work/i.csv" --checkpoint "$work/ck" \
        --checkpoint-every 0.1 "$@" > /dev/null 2> "$work/err" &
    pid=$!
    started $pid
    [ "$signal" = none ] || kill -"$signal" $pid
    wait $pid 2> /dev/null
    [ $? = "$wanted" ]; report $((! $?)) "$name: exit status $wanted"
    generation=$(sed -n 's/^generation //p' "$work/ck" | head -1)
    to=$((generation - generation % 10 + 20))
    [ "$signal" = KILL ] || grep -q "ended at generation $generation of 100000000; go on with --resume $work/ck$" "$work/err" &&
        { [ "$signal" = KILL ] || [ -s "$work/i.gen" ]; }
    report $((! $?)) "$name: everything is written"
    [ -n "$FOOTPOINT_LONG" ] || [ "$signal" = KILL ] && on="$mpirun -n 2" || on=
    $on "$evolve" --resume "$work/ck" --generations $to --quiet > /dev/null 2>&1
    "$evolve" $options --generations $to -o "$work/j.gen" --log "$work/j.csv" > /dev/null 2>&1
    cmp -s "$work/i.gen" "$work/j.gen" && cmp -s "$work/i.csv" "$work/j.csv"
    report $((! $?)) "$name: resumed to the same bytes"
}
interrupted 'kill -9' KILL 137
interrupted SIGTERM TERM 143
[ -z "$FOOTPOINT_LONG" ] || interrupted SIGUSR1 USR1 0
interrupted 'time limit' none 0 --time-limit 0.3

# Checkpoints that must not be resumed; all files stay unchanged.
rm -f "$work/ck"
refused() { # refused NAME STATUS STDERR [OPTIONS...]: resumes $work/bad
    name=$1 status=$2 message=$3
    shift 3
    cp "$work/whole.gen" "$work/kept.gen"; cp "$work/bad" "$work/before"
    expect "$name" "$status" '' "$message" "$evolve" --resume "$work/bad" -o "$work/kept.gen" "$@"
    cmp -s "$work/kept.gen" "$work/whole.gen" && cmp -s "$work/bad" "$work/before" || report 0 "$name: files are left"
}
damaged="$work/bad: error: checkpoint is truncated or damaged"
head -c 100000 "$work/good" > "$work/bad"; refused 'cut' 1 "$damaged"
: > "$work/bad"; refused 'empty' 1 "$work/bad: error: no checkpoint"
cp "$work/good" "$work/bad"; printf x | dd of="$work/bad" bs=1 seek=200000 conv=notrunc 2> /dev/null
refused 'a byte changed' 1 "$damaged"
resealed() { # resealed SED: $work/bad with other facts and a good seal
    first=$(head -1 "$work/good") facts=$(printf %s "$first" | cut -d' ' -f3)
    lengths=$((8 * ${first##* }))
    tail -c +$((${#first} + 2)) "$work/good" | head -c "$facts" | sed "$1" > "$work/facts"
    { printf 'footpoint-checkpoint 2 %s %s\n' "$(wc -c < "$work/facts")" "${first##* }"; cat "$work/facts"
      tail -c +$((${#first} + 2 + facts)) "$work/good" | head -c $lengths; } > "$work/bad"
    sum=$(sha256sum "$work/bad")
    { printf '%s\n' "${sum%% *}"; tail -c +$((${#first} + 2 + facts + lengths + 65)) "$work/good"; } >> "$work/bad"
}
resealed 's/^version .*/version 9/'; refused 'another version' 1 "$work/bad: error: checkpoint has version 9; this program has 0.3.0"
resealed 's/^islands 3/islands 2/'; refused 'other islands' 1 "$work/bad: error: checkpoint lacks islands"
resealed "s/^population $population/population 50/"; refused 'other states' 1 "$work/bad: error: island 0 of the checkpoint is malformed"
resealed 's/^islands 3/islands x/'; refused 'no number' 2 "footpoint-evolve: error: --islands needs a whole number, not 'x'"
resealed '/^scene /d'; refused 'no scene' 2 'footpoint-evolve: error: --scene is missing; try --help'
resealed ''; refused 'another seed' 2 'footpoint-evolve: error: --seed 6 contradicts the checkpoint, which has 5' --seed 6
refused 'another preset' 2 'footpoint-evolve: error: --islands 5 contradicts the checkpoint, which has 3' --preset paper
refused 'too few generations' 2 "$work/bad: error: checkpoint is at generation 6, beyond --generations 5" --generations 5
sed 's/^seed .*/seed = 4;/' "$work/small.scene" > "$work/other.scene"
sum=$(sed -n 's/^scene-sha256 //p' "$work/good" | cut -c1-12)
other=$("$evolve" --scene "$work/other.scene" --resume "$work/bad" 2>&1 | sed -n 's/.*, not \(.*\)\.\.\.$/\1/p')
refused 'another scene' 1 "$work/bad: error: checkpoint belongs to another scene: SHA-256 $sum..., not $other..." --scene "$work/other.scene"
mkdir -p "$work/root/evolve" && cp -r evolve/frames "$work/root/evolve/"
sed 's/ p = dp\*inv, q = dq\*inv,/ q = dq*inv, p = dp*inv,/' evolve/frames/parallelogram.gen \
    > "$work/root/evolve/frames/parallelogram.gen"
sum=$(sed -n 's/^frames-sha256 //p' "$work/good" | cut -c1-12)
other=$("$evolve" --resume "$work/bad" --root "$work/root" 2>&1 | sed -n 's/.*, not \(.*\)\.\.\.$/\1/p')
refused 'another frame' 1 "$work/bad: error: checkpoint belongs to other frames: SHA-256 $sum..., not $other..." --root "$work/root"
echo x > "$work/log.csv"
refused 'another log' 1 "$work/log.csv: error: log does not belong to the checkpoint's run" --generations 40 --log "$work/log.csv"
rm "$work/bad"
expect 'no checkpoint' 3 '' "$work/bad: error: cannot open: No such file or directory" "$evolve" --resume "$work/bad"
expect 'no folder for checkpoints' 3 '' "$work/none/ck: error: cannot write: No such file or directory" \
    "$evolve" $options --checkpoint "$work/none/ck" -o "$work/o.gen"

# A disk too small for a checkpoint (MPI itself needs some MB): the last checkpoint stays, the genomes are written.
cp "$work/good" "$work/ck"; rm -f "$work/o.gen"
full() { (ulimit -f 32768; exec "$evolve" $options --islands 40 --generations 2 --checkpoint "$work/ck" -o "$work/o.gen"); }
full_on_two() { (ulimit -f 32768; exec $mpirun -n 2 "$evolve" $options --islands 40 --generations 2 --checkpoint "$work/ck" -o "$work/o.gen"); }
for ranks in full ${FOOTPOINT_LONG:+full_on_two}; do
    rm -f "$work/o.gen"
    expect "full disk ($ranks)" 3 '*' "$work/ck: error: cannot write: File too large" $ranks
    cmp -s "$work/ck" "$work/good" && [ -s "$work/o.gen" ] && ! ls "$work" | grep -q tmp
    report $((! $?)) 'full disk: the last checkpoint stays, the genomes are there, nothing else'
done
expect 'full log' 3 '*' '/dev/full: error: cannot write: No space left on device' \
    "$evolve" $options --generations 10 --log /dev/full -o "$work/o.gen"
