# Prints the times of README.md's table "Which function", from `footpoint-bench --scene quad4 --csv` for one or several
# instruction sets:
#     awk -f searches.awk FILE...
# For each search: how many times faster it is than Newton for the same question, converged or fair, whichever is faster
# in that mode, and closest points than four triangles: bare, checked, closest point, each in dependent calls, in
# independent calls and over arrays. Then the time of checked over bare searches, and the functions that not every
# search has. Figures of several files share a cell.
BEGIN { FS = "," }
FNR == 1 {
    for (i = 1; i <= NF; i++) c[$i] = i
    files++
    next
}
{
    m = $c["method"]
    ns[files, m, $c["mode"]] = $c["ns"]
    if (!$c["ours"] || m in question) next
    question[m] = $c["question"]
    order[++n] = m
}
function figure(v) { return sprintf(v < 9.95 ? "%.1f" : "%.0f", v) }
function quickest(f, rivals, mode,    i, k, name, least) {
    k = split(rivals, name, " ")
    for (i = 1; i <= k; i++)
        if ((f, name[i], mode) in ns && (least == "" || ns[f, name[i], mode] < least)) least = ns[f, name[i], mode]
    return least
}
# the time of the fastest rival over ours, for all files
function cell(ours, rivals, mode,    f, text) {
    for (f = 1; f <= files; f++)
        if ((f, ours, mode) in ns)
            text = text (text == "" ? "" : " / ") figure(quickest(f, rivals, mode) / ns[f, ours, mode])
    return text
}
function three(ours, rivals) {
    return " " cell(ours, rivals, "chain") " | " cell(ours, rivals, "scalar") " | " cell(ours, rivals, "batch") " |"
}
END {
    print "| search | bare: dependent | calls | arrays | checked: dependent | calls | arrays | closest: dependent | calls | " \
        "arrays | checking: dependent | calls | arrays |"
    for (i = 1; i <= n; i++) {
        m = order[i]
        if (question[m] == "bare")
            print "| `" m "` |" three(m, "newton newton_fair") three(m "_checked", "newton_checked newton_fair_checked") \
                three(m "_closest", "four_triangles") three(m, m "_checked")
    }
    print "\n| besides | of | dependent | calls | arrays |"
    rival["checked"] = "newton_checked newton_fair_checked"
    rival["over"] = "newton_over newton_fair_over"
    rival["closest"] = "four_triangles"
    rival["along"] = "newton_along"
    rival["derivatives"] = "newton_implicit"
    for (k = 1; k <= 3; k++) rival["from_1e-" k] = "newton_from_1e-" k " newton_fair_from_1e-" k
    for (i = 1; i <= n; i++) {
        m = order[i]
        if (question[m] != "bare" && m !~ /_(checked|closest)$/)
            print "| `" m "` | `" rival[question[m]] "` |" three(m, rival[question[m]])
    }
}
