# Prints the methods of `footpoint-bench --csv` on a scene's samples as a table in HTML, ordered by time in independent calls.
#     awk -f table.awk -v scene=quad4 -v sample=random -v question=bare bench.csv
BEGIN { FS = "," }
NR == 1 {
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
function get(what) { return $column[what] }
get("scene") == scene && get("sample") == sample && get("question") == question {
    m = get("method")
    if (!(m in seen)) {
        seen[m] = ++n
        method[n] = m
        ours[n] = get("ours")
        count[n] = cell(get("mul")) cell(get("div")) cell(get("add")) cell(get("sqrt"))
        for (i = split("xi eta gap", output, " "); i > 0; i--)
            errors[n] = cell(get("mean_" output[i])) cell(get("p99_" output[i])) cell(get("max_" output[i])) errors[n]
        errors[n] = errors[n] cell(get("failures"))
    }
    if (get("mode") == "scalar") time[seen[m]] = get("ns") + 0
    speed[seen[m], get("mode")] = cell(get("ns")) cell(get("ratio")) cell(sprintf("%.1f", 100 * get("noise")))
}
function cell(v) { return "<td>" (v ~ /e[-+]/ ? sprintf("%.1e", v) : v) "</td>" }
function heads(list,    i, k, h, text) {
    k = split(list, h, " ")
    for (i = 1; i <= k; i++) text = text "<th>" h[i] "</th>"
    return text
}
END {
    print "<table><tr><th></th><th colspan=4>operations</th><th colspan=3>dependent calls</th><th colspan=3>independent calls</th><th colspan=3>arrays</th>"
    print "<th colspan=3>xi</th><th colspan=3>eta</th><th colspan=3>gap</th><th></th></tr>"
    print "<tr><th>method</th>" heads("mul div add sqrt ns ratio &plusmn;% ns ratio &plusmn;% ns ratio &plusmn;% " \
        "mean 99&nbsp;% worst mean 99&nbsp;% worst mean 99&nbsp;% worst failures") "</tr>"
    for (i = 1; i <= n; i++) at[i] = i
    for (i = 2; i <= n; i++)
        for (j = i; j > 1 && time[at[j]] < time[at[j - 1]]; j--) {
            k = at[j]; at[j] = at[j - 1]; at[j - 1] = k
        }
    none = cell("") cell("") cell("")
    for (j = 1; j <= n; j++) {
        i = at[j]
        printf "<tr%s><td>%s</td>%s%s%s%s</tr>\n", ours[i] ? " class=ours" : "", method[i], count[i],
            speed[i, "chain"] speed[i, "scalar"], (i, "batch") in speed ? speed[i, "batch"] : none, errors[i]
    }
    print "</table>"
}
