# Chooses the members of a front to ship as tiers, from `footpoint-bench --validation --csv` of them and of the shipped
# functions. Prints a table and lines for the scene file. A member replaces a tier's function if it is slower neither in
# independent calls nor over arrays, has no larger error (mean, 99 %, worst), and is better by a tenth in error or in
# both times. A member is new if no function is more accurate and no slower in either mode. id: the scene in names of
# functions.
BEGIN { FS = ","; noise = 1.01; worth = 0.9 }
function larger(a, b) { return a + 0 > b + 0 ? a + 0 : b + 0 }
$4 == 1 {
    if (!($3 in mean)) { order[++n] = $3; at[$3] = n }
    ns[$3, $5] = $10
    mean[$3] = larger($12, $15); p99[$3] = larger($13, $16); worst[$3] = larger($14, $17)
    failures[$3] += $18
}
function is_member(m) { return m ~ /_both_c[0-9]+$/ }
function slower(m, s) { return ns[m, "scalar"] > noise * ns[s, "scalar"] || ns[m, "batch"] > noise * ns[s, "batch"] }
function faster(m, s) { return ns[m, "scalar"] < worth * ns[s, "scalar"] && ns[m, "batch"] < worth * ns[s, "batch"] }
function replaces(m, s) {
    return failures[m] == 0 && !slower(m, s) && mean[m] <= mean[s] && p99[m] <= p99[s] && worst[m] <= worst[s] && \
        (mean[m] < worth * mean[s] || faster(m, s))
}
function left_behind(m,    i, s) {
    for (i = 1; i <= n; i++) {
        s = order[i]
        if (s != m && failures[s] == 0 && mean[s] <= mean[m] && !slower(s, m) && (mean[s] < mean[m] || i < at[m]))
            return s
    }
    return ""
}
function short(m) { sub(/^footpoint_/, "", m); return m }
function verdict(m,    s) {
    if (!is_member(m))
        return m in heir ? "gives way to " short(heir[m]) : "stays"
    if (m in place) return "ship"
    if (failures[m] > 0) return "fails"
    s = left_behind(m)
    return s == "" ? "new" : "behind " short(s)
}
function tier(m) { sub(/^.*_front_/, "", m); sub(/_both_c[0-9]+$/, "", m); return m }
function cost(m) { sub(/^.*_c/, "", m); return m }
END {
    for (i = 1; i <= n; i++) { # the most accurate among possible replacements
        s = order[i]
        for (k = 1; k <= n && !is_member(s); k++)
            if (is_member(order[k]) && replaces(order[k], s) && (!(s in heir) || mean[order[k]] < mean[heir[s]])) heir[s] = order[k]
        if (s in heir) place[heir[s]] = place[heir[s]] " " s
    }
    printf "%-44s %8s %8s %8s %8s %8s\n", "on validation samples", "ns", "arrays", "mean", "99 %", "worst"
    for (i = 1; i <= n; i++) {
        m = order[i]
        what = verdict(m)
        printf "%-44s %8.2f %8.2f %8.1e %8.1e %8.1e  %s\n", short(m), ns[m, "scalar"], ns[m, "batch"], mean[m], p99[m], worst[m], what
        if (what == "new") fresh[++news] = m
    }
    printf "\nlines for the scene file:\n"
    for (i = 1; i <= n; i++) {
        s = order[i]
        if (!(s in heir)) continue
        lines++
        m = heir[s]
        name = s
        sub("^footpoint_" id "_", "", name)
        printf "    { name = \"%s\"; budget = %d; }, // %s: error %.2f, time %.2f and, over arrays, %.2f of what ships\n", name, cost(m),
            short(m), mean[m] / mean[s], ns[m, "scalar"] / ns[s, "scalar"], ns[m, "batch"] / ns[s, "batch"]
    }
    for (i = 1; i <= news; i++) {
        lines++
        printf "    { name = \"%s_%d\"; budget = %d; }, // new: mean %.1e in %.2f ns, over arrays %.2f\n", tier(fresh[i]), cost(fresh[i]),
            cost(fresh[i]), mean[fresh[i]], ns[fresh[i], "scalar"], ns[fresh[i], "batch"]
    }
    if (lines == 0) print "    nothing is better than what ships"
}
