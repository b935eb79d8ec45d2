# Prints the table "Which function" of README.md:
#     awk -f front_page.awk generated/footpoint_quad4.h evolve/genomes/quad4.gen MACHINE.csv...
# Promises come from the header, errors from the genome, times from `make bench-record`: how many times faster than the
# faster of two Newton iterations (closest points: than four triangles), with the range over machines.
BEGIN {
    names = split("balanced fine precise accurate full", name, " ")
    use["balanced"] = "explicit codes, penalty forces"
    use["fine"] = ""
    use["precise"] = ""
    use["accurate"] = "implicit codes"
    use["full"] = "Newton's own accuracy"
}
FNR == 1 { file++ }
FILENAME ~ /\.h$/ {
    if (/^#define FOOTPOINT_QUAD4_[A-Z0-9]+_PROMISE /) promise[tolower(substr($2, 17, length($2) - 24))] = $3
    next
}
FILENAME ~ /\.gen$/ {
    if (/^genome /) genome = $2
    if (/^note heldout_both /) { mean[genome] = $6; samples = $4 }
    next
}
/^#/ { machines = machines (machines == "" ? "" : "; ") substr($0, 3); next }
/^scene,/ { split("", c); n = split($0, head, ","); for (i = 1; i <= n; i++) c[head[i]] = i; next }
{ split($0, v, ","); ns[file, v[c["method"]], v[c["mode"]]] = v[c["ns"]] }
function short(x) { x = sprintf("%.0e", x); sub(/e-0/, "e-", x); return x }
function ratio(ours, rival, other, mode,    f, r, least, most) {
    for (f = 3; f <= file; f++) {
        if (!((f, ours, mode) in ns)) continue
        r = ns[f, rival, mode]
        if (other != "" && ns[f, other, mode] < r) r = ns[f, other, mode]
        r /= ns[f, ours, mode]
        if (least == "" || r < least) least = r
        if (r > most) most = r
    }
    least = sprintf("%.1f", least)
    most = sprintf("%.1f", most)
    return least == most ? least : least " to " most
}
END {
    print "| quad4 | OK proves xi, eta to | mean error of `_at` | dependent | calls | arrays | `_closest` | for |"
    print "|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= names; i++) {
        f = "footpoint_quad4_" name[i]
        fair = "newton_fair_checked"
        print "| `_" name[i] "` | " short(promise[name[i]]) " | " short(mean[name[i]]) " | " ratio(f "_checked", "newton_checked", fair, "chain") \
            " | " ratio(f "_checked", "newton_checked", fair, "scalar") " | " ratio(f "_checked", "newton_checked", fair, "batch") \
            " | " ratio(f "_closest", "four_triangles", "", "scalar") " | " use[name[i]] " |"
    }
    print "| `footpoint_robust` | 1e-10 of an edge | | | | | " ratio("footpoint_robust", "four_triangles", "", "scalar") " | any four corners |"
    print "\nMeasured on " machines "."
}
