# Checks batches of pairs from arrays far larger than the caches: the fast search costs at most 1.5 times a loop that
# only gathers the same coordinates and stores two doubles, in one run, in the order of the mesh and in random order,
# from nodes x 3 and from columns. A slower run is repeated, TRIES in all, and the best ratio of each line counts; if
# that is more, too, there is a warning. Asserts that every pair has an answer.
. tests/cli/expect.inc
CC=${CC:-gcc} TRIES=3
free=$(awk '$1 == "MemAvailable:" { print int($2 / 1024) }' /proc/meminfo 2> /dev/null)
[ "${free:-8000}" -gt 2500 ] || { report 1 'skipped: less than 2.5 GB free'; exit 0; }
$CC -std=c11 -D_DEFAULT_SOURCE -O3 -o "$work/pairs" tests/bench/bench_pairs_main.c "$BIN/libfootpoint.a" -lm > "$work/log" 2>&1
good=$((! $?))
[ "$good" = 1 ] || sed 's/^/# /' "$work/log"
report "$good" 'builds'
for try in $(seq $TRIES); do
    "$work/pairs" > "$work/run.$try"; report $((! $?)) 'every pair has an answer'
    awk -F, '
        $1 == "order" { next }
        { k = $1 FS $2 FS $3 FS $4 }
        !(k in ratio) { order[++n] = k; ns[k] = $5; ratio[k] = $6 }
        { if ($5 < ns[k]) ns[k] = $5; if ($6 < ratio[k]) ratio[k] = $6 }
        END { for (i = 1; i <= n; i++) print order[i] FS ns[order[i]] FS ratio[order[i]] }
    ' "$work"/run.* > "$work/best"
    awk -F, '$4 == "fast" && $6 > 1.5 { slow = 1 } END { exit slow }' "$work/best" && break
done
echo '# order, arrays, bits of an index, what: ns a pair, and how many times the loop'
awk -F, '{ printf "# %-7s %-10s %s %-36s %8.2f %6.2f\n", $1, $2, $3, $4, $5, $6 }' "$work/best"
awk -F, '$4 == "fast" && $6 > 1.5 { print "# WARNING: " $2 ", " $3 " bits, in " $1 " order: " $6 " times the loop" }' "$work/best"
