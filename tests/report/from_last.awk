# The searches from the last answer as a table in HTML, won and lost, from what `footpoint-bench --csv` prints:
#     awk -f from_last.awk bench.csv
# Each cell is the time of Newton's iteration from the same answer, converged or fair, the quicker in that mode, over ours; below 1
# the iteration, which proves nothing, is faster.  Prints nothing if no search of ours begins with the last answer.
BEGIN {
    FS = ","
    modes = split("chain scalar batch", mode, " ")
    moves = split("1e-3 1e-2 1e-1", move, " ")
}
NR == 1 {
    for (i = 1; i <= NF; i++) c[$i] = i
    next
}
$c["question"] ~ /^from_/ && $c["ours"] {
    m = $c["method"]
    sub(/_from_.*/, "", m)
    key = $c["scene"] ", " $c["sample"] ", " m
    if (!(key in seen)) order[seen[key] = ++n] = key
    ratio[key, substr($c["question"], 6), $c["mode"]] = $c["ratio"]
    cells++
    lost += $c["ratio"] < 1
}
function row(key,    i, j, v, text) {
    for (i = 1; i <= moves; i++)
        for (j = 1; j <= modes; j++) {
            v = ratio[key, move[i], mode[j]]
            text = text "<td>" (v != "" && v < 1 ? "<b>" v "</b>" : v) "</td>"
        }
    return "<tr><td>" key "</td>" text "</tr>"
}
END {
    if (!n) exit
    print "<h2 id=\"last\">From the last answer</h2>"
    print "<p>The time of Newton's iteration from the same answer, the quicker of converged and fair, over ours. Ours proves its answers,"
    print "Newton's iteration proves nothing. It is faster in " lost " of " cells " cells, which are bold.</p>"
    print "<div class=wide><table><tr><th>the last answer is away by</th>"
    for (i = 1; i <= moves; i++) print "<th colspan=3>" move[i] " of the face</th>"
    print "</tr><tr><th></th>"
    for (i = 1; i <= moves; i++) print "<th>dependent</th><th>calls</th><th>arrays</th>"
    print "</tr>"
    for (i = 1; i <= n; i++) print row(order[i])
    print "</table></div>"
}
