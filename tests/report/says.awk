# Describes the pictures of a scene in HTML, from `footpoint-bench --csv`:
#     awk -f says.awk -v scene=quad4 -v sample=random bench.csv
BEGIN { FS = "," }
NR == 1 {
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
$column["scene"] == scene && $column["sample"] == sample && $column["question"] == "bare" {
    m = $column["method"]; mode = $column["mode"]
    mean[m] = $column["mean_xi"] > $column["mean_eta"] + 0 ? $column["mean_xi"] + 0 : $column["mean_eta"] + 0
    ns[m, mode] = $column["ns"] + 0
    if ($column["ours"]) ours[m]
    else if (m ~ /^gn?[0-9n_]*centre$/ || m ~ /^gn[0-9]_centre$/) truncated[m]
    if (m ~ /^((tri|quad)[0-9]+_)?newton$/) newton = m
    if (m ~ /newton_fair$/) fair = m
}
# Newton's time in a mode: converged or fair, whichever is faster.
function quicker(mode) { return fair && ns[fair, mode] < ns[newton, mode] ? ns[fair, mode] : ns[newton, mode] }
function short(m) { sub(/^footpoint_/, "", m); return "<code>" m "</code>" }
END {
    for (m in ours) {
        if (!fast || ns[m, "scalar"] < ns[fast, "scalar"]) fast = m
        if (!exact || mean[m] < mean[exact]) exact = m
    }
    # The truncated iteration nearest to three decimal digits, and our fastest function that is as accurate.
    for (m in truncated)
        if (mean[m] > 0 && mean[m] < 1 && (!rival || (log(mean[m]) + 6.9) ^ 2 < (log(mean[rival]) + 6.9) ^ 2)) rival = m
    for (m in ours)
        if (rival && mean[m] <= 1.1 * mean[rival] && (!match_ || ns[m, "scalar"] < ns[match_, "scalar"])) match_ = m
    printf "<p>Each point is a way to find xi and eta on the scene %s: to the right it takes longer, upwards it errs more; what is left of and below everything else is best.\n", scene
    if (fast)
        printf "Filled points and the line are footpoint's functions, from %s (%.1f ns in independent calls, mean error %.0e) to %s (%.1f ns, %.0e); open points are iterations and closed forms written by hand.\n", short(fast), ns[fast, "scalar"], mean[fast], short(exact), ns[exact, "scalar"], mean[exact]
    else
        print "Open points are iterations and closed forms written by hand; of footpoint there is no function for this scene."
    printf "Newton's iteration%s takes %.1f ns in calls that wait for one another, %.1f ns in independent calls and %.1f ns over arrays", fair ? ", from the centre or from the taper, the quicker," : "", quicker("chain"), quicker("scalar"), quicker("batch")
    if (exact) printf "; %s takes %.1f, %.1f and %.1f", short(exact), ns[exact, "chain"], ns[exact, "scalar"], ns[exact, "batch"]
    print "."
    if (match_ && rival)
        printf "At an error of %.0e, the truncated iteration <code>%s</code> takes %.1f ns in independent calls and %.2f ns over arrays, %s %.1f and %.2f.\n", mean[rival], rival, ns[rival, "scalar"], ns[rival, "batch"], short(match_), ns[match_, "scalar"], ns[match_, "batch"]
    print "These are times of bare searches; what callers get besides stands in tables below the pictures.</p>"
}
