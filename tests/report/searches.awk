# The times of README.md's table "Which function", from what `footpoint-bench --scene quad4 --csv` prints for one or several
# instruction sets:
#     awk -f searches.awk FILE...
# For each search how many times quicker it is than converged Newton asked the same, closest points than four triangles:
# bare, checked, closest point; the same over arrays; and what checking takes of the bare search, one at a time and over
# arrays.  Then the functions that are not one of each search.  Figures of several files stand in one cell.
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
# rival's time over ours, of all files
function cell(ours, rival, mode,    f, text) {
    for (f = 1; f <= files; f++)
        if ((f, ours, mode) in ns)
            text = text (text == "" ? "" : " / ") figure(ns[f, rival, mode] / ns[f, ours, mode])
    return text
}
END {
    print "| search | bare | checked | closest | arrays | checked arrays | closest arrays | checking | over arrays |"
    for (i = 1; i <= n; i++) {
        m = order[i]
        if (question[m] == "bare")
            print "| `" m "` | " cell(m, "newton", "scalar") " | " cell(m "_checked", "newton_checked", "scalar") " | " \
                cell(m "_closest", "four_triangles", "scalar") " | " cell(m, "newton", "batch") " | " \
                cell(m "_checked", "newton_checked", "batch") " | " cell(m "_closest", "four_triangles", "batch") " | " \
                cell(m, m "_checked", "scalar") " | " cell(m, m "_checked", "batch") " |"
    }
    print "\n| besides | of | one at a time | over arrays |"
    split("checked newton_checked over newton_over closest four_triangles along newton_along derivatives newton_implicit", pair, " ")
    for (i = 1; i <= 9; i += 2) rival[pair[i]] = pair[i + 1]
    for (i = 1; i <= n; i++) {
        m = order[i]
        if (question[m] != "bare" && m !~ /_(checked|closest)$/)
            print "| `" m "` | `" rival[question[m]] "` | " cell(m, rival[question[m]], "scalar") " | " \
                cell(m, rival[question[m]], "batch") " |"
    }
}
