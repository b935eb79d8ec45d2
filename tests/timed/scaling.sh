# Checks that two ranks on two free cores take little more than half the time of one rank with the same islands;
# otherwise warns. They must write the same bytes.
# Runs only while the machine is otherwise idle, and is skipped if it never is.
#
# More ranks: on an Intel Xeon with 16 cores, `mpirun -n P footpoint-evolve --scene quad4 --islands 4 --generations 10` (28
# islands, for the seven tiers of the time) took 60.6 s with one rank, 36.2 with 2, 23.2 with 4, 21.1 with 8 and 18.6 with 16.
# About 14 s of this are start and end, which do not depend on the number of ranks (`--generations 0` shows most of it).
# Without them, 16 ranks are about ten times as fast as one; 28 islands of unequal cost cannot be shared evenly.
#
# For P ranks of n islands, with N programs of at most L operations, in brackets for N = 200, L = 100 and 28,546 samples:
#   a generation                          n t (t = 370 ms)
#   migrants, each 10 generations         4 m (3 + 3 L) bytes, m = N/10 (24,240 bytes: 2.4 kB a generation)
#   a poll, each generation               56 + 8 rings bytes, ceil(log2 P) steps (80 bytes for 3 tiers)
#   generations from a signal to the end  2 + 2 ceil(log2 P) (2 at P = 1, 10 at 10, 22 at 1,000, 36 at 100,000)
#   an island's state in a checkpoint     89 + (N + 513) (48 + 12 L) + 131,072 bytes (1.0 MB: 1.0 GB for 1,000 islands)
# On 1,000 ranks, 21 polls of 10 steps may be in flight, so no rank waits unless another is 21 generations behind.  A program needs
# 1,670 generations around a ring of 168 islands, 260 with --topology torus (12 x 14), about 110 with random.  On 100,000 ranks,
# rank 0 limits first: 100,000 log lines each 370 ms, 7 GB of fronts at the end.  The next limit is the start, when all processes
# open the same scene and compute the same table (12 MB).
#
# t: processor time of `footpoint-evolve --scene tests/scenes/similarity.scene
# --from-scratch --generations 40 -o FILE` minus that with `--generations 10`, over 30 generations and 4 islands, on an AMD EPYC
# with AVX-512.  The run prints the size f of each front, 48 to 61; its report to rank 0 has 4 + f (20 + 12 L) bytes, 73 kB for
# f = 60.  A log line to rank 0 has 40 bytes, 40 kB a generation for 1,000 islands.
. tests/cli/expect.inc
evolve=$BIN/footpoint-evolve
mpirun="mpirun -q --bind-to none"
[ "$(id -u)" != 0 ] || mpirun="$mpirun --allow-run-as-root"
[ "$(nproc)" -ge 2 ] || { echo 'ok 1 - # skip one core'; exit 0; }
sed 's/^training .*/training = 20000;/' tests/scenes/small.scene > "$work/small.scene"

seconds() { # seconds RANKS: of one and the same run, which writes the same bytes
    begun=$(date +%s.%N)
    $mpirun -n "$1" "$evolve" --scene "$work/small.scene" --from-scratch --islands 4 --generations 30 \
        -o "$work/$1.gen" > /dev/null 2>&1 || echo "# $1 ranks failed" >&2
    echo "$(date +%s.%N) $begun" | awk '{ print $1 - $2 }'
}
twice() {
    ratio=$(echo "$(seconds 1) $(seconds 2)" | awk '{ print $1 / $2 }')
    echo "# two ranks: $ratio times one"
    awk "BEGIN { exit !($ratio >= 1.9) }"
}
steady 'two ranks are nearly twice as fast as one' twice
cmp "$work/1.gen" "$work/2.gen"; report $((! $?)) 'one and two ranks write the same genomes'
