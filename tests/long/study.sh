# Runs the study of `make paper` at a very small size, on a coarse lattice. Run twice, once with interruptions, it must
# write the same tables except for times; a folder with runs of another size is refused.
. tests/cli/expect.inc
export OMPI_MCA_btl_base_warn_component_unused=0
export SEEDS='1 2' PGA_GENERATIONS=10 GP_GENERATIONS=6 GROUP_GENERATIONS=3 TIMED_GENERATIONS=3 RANKS=2 BIN
export SIXTEEN_GENERATIONS=8 SIXTEEN_TRAINING=500 SIXTEEN_LENGTH=30
export PERCEPTRONS="--scene $work/coarse.scene --hidden 3 --hidden 2,2 --iterations 10"
export STUDY_SCENE="$work/coarse.scene" SIXTEEN_SCENE="$work/patches.scene"
MPIRUN='mpirun -q --oversubscribe'
[ "$(id -u)" != 0 ] || MPIRUN="$MPIRUN --allow-run-as-root"
export MPIRUN="$MPIRUN -n 2"
coarse() { # coarse SCENE
    sed 's/\[2.0, 0.2\]/[2.0, 0.25]/; s/\[0.3, 0.1\]/[0.3, 0.15]/' "tests/scenes/$1.scene" |
        sed 's/^training.*/training = 3000;/; s/^heldout.*/heldout = 300;/'
}
coarse similarity > "$work/coarse.scene"
coarse gregory-inputs > "$work/patches.scene"

# What is not of the study itself, or a time, is made once.
mkdir -p "$work/a/runs" "$work/b/runs"
"$BIN/footpoint-bench" --rounds 1 --scene paper-quad4 --csv > "$work/a/runs/bench.csv"
echo 1..0 > "$work/a/runs/calibration.tap"
sh tests/paper/paper.sh "$work/a" > "$work/a.out" 2>&1
report $((! $?)) 'a study'
cp "$work/a/runs/"time-*.csv "$work/a/runs/bench.csv" "$work/a/runs/calibration.tap" "$work/b/runs/"

# The other is killed, with all its processes, whenever it has made one more file, at most 12 times.
files() { find "$work/b/runs" -name '*.gen' | wc -l; }
kills=0 done=0
while [ $done = 0 ] && [ $kills -lt 12 ]; do
    before=$(files)
    setsid sh tests/paper/paper.sh "$work/b" > "$work/b.out" 2>&1 &
    study=$!
    while kill -0 $study 2> /dev/null && [ "$(files)" -le "$before" ]; do sleep 0.2; done
    if kill -9 -$study 2> /dev/null; then kills=$((kills + 1)); else done=1; fi
    wait $study 2> /dev/null
done
[ $kills -ge 5 ]; report $((! $?)) "killed $kills times"
sh tests/paper/paper.sh "$work/b" > "$work/b.out" 2>&1
report $((! $?)) 'and it goes on'

ls "$work/a" | grep -v '^runs$' > "$work/a.list"
ls "$work/b" | grep -v '^runs$' | cmp -s - "$work/a.list"; report $((! $?)) 'the same files'
different=
for file in $(grep -E 'csv$|svg$|html$' "$work/a.list"); do
    cmp -s "$work/a/$file" "$work/b/$file" || different="$different $file"
done
[ -z "$different" ] || echo "# different:$different"
report $([ -z "$different" ] && echo 1 || echo 0) 'and they are equal'

# Nothing is empty: each table has rows, each cell that should hold a number one, each picture points.
empty=
for file in $(grep 'csv$' "$work/a.list"); do
    [ "$(wc -l < "$work/a/$file")" -ge 2 ] && ! grep -qi -e '-nan' -e inf "$work/a/$file" || empty="$empty $file"
done
for file in $(grep 'svg$' "$work/a.list"); do
    grep -q '<use xlink:href=.*translate' "$work/a/$file" || empty="$empty $file"
done
[ -z "$empty" ] || echo "# empty:$empty"
report $([ -z "$empty" ] && echo 1 || echo 0) 'no table and no picture is empty'
for what in table1 table2 table3 counts compare contact perceptron front condition figure7 figure8 figure9 figure10 \
    figure11 figure12 figure13 figure14 figure18 figure19 within figure20; do
    grep -q "href=\"$what.csv\"" "$work/a/index.html" || echo "$what"
done > "$work/missing"
sed 's/^/# missing: /' "$work/missing"
report $([ -s "$work/missing" ] && echo 0 || echo 1) 'the page has all of them'

export GP_GENERATIONS=7
expect 'another size' 1 '*' '*' sh tests/paper/paper.sh "$work/a"
grep -q 'holds runs of another size' "$work/stderr"; report $((! $?)) 'is refused'
