# Checks footpoint-calibrate: its cost files are read back, and costs are plausible.  Times are not asserted.
. tests/cli/expect.inc
calibrate=$BIN/footpoint-calibrate
nothing='footpoint-calibrate:'

expect 'help' 0 '*' '' "$calibrate" --help
expect 'version' 0 'footpoint-calibrate 0.3.0' '' "$calibrate" --version
expect 'unknown option' 2 '' "$nothing unknown option or missing value: --fast (try --help)" "$calibrate" --fast
expect 'no file name' 2 '' "$nothing unknown option or missing value: -o (try --help)" "$calibrate" -o
expect 'unexpected argument' 2 '' "$nothing unexpected argument: costs (try --help)" "$calibrate" costs
expect 'output folder missing' 3 '' "$work/none/c: error: cannot write: No such file or directory" \
    "$calibrate" -o "$work/none/c"

# sane FILE: every key once, in order, finite; a division costs at least an addition
sane() {
    grep -v '^#' "$1" | awk '
        NR == 1 { good = $0 == "footpoint-costs 1"; split("mul add div sqrt compare", key); next }
        { good = good && NF == 2 && $1 == key[NR - 1] && $2 ~ /^[0-9]+(\.[0-9]+)?$/; value[$1] = $2 }
        END {
            good = good && NR == 6
            exit !(good && value["add"] == 1 && value["mul"] > 0 && value["div"] >= 1)
        }'
}

expect 'writes a file' 0 '' '' "$calibrate" -o "$work/costs"
sane "$work/costs"; report $((! $?)) 'throughput is sane'
[ "$(ls "$work" | grep -c costs)" = 1 ]; report $((! $?)) 'no file is left aside'
later 'calibrate: to standard output'
if [ -n "$FOOTPOINT_LONG" ]; then
    expect 'to standard output' 0 '*' '' "$calibrate"
    sane "$work/stdout"; report $((! $?)) 'and is sane there, too'
fi
expect 'latency, which is none of its costs' 2 '' \
    "$nothing unknown option or missing value: --latency (try --help)" "$calibrate" --latency

if "$BIN/footpoint-codegen" --help | grep -q -e ' --cost '; then
    printf '%s\n' 'footpoint-genome 1' 'input x y' 'genome g' 'r = + * x y * x 2' 'end' > "$work/g.gen"
    expect 'footpoint-codegen reads it' 0 'genome,mul,div,add,sqrt,compare
g,1,0,1,0,0' '' "$BIN/footpoint-codegen" --cost "$work/costs" --count "$work/g.gen"
fi
