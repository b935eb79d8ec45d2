# Prints the table of `make rivals` from the output of libraries_main: for each kind of face and family, searches
# ordered by time. -v absent=NAMES -v machine=TEXT
BEGIN {
    FS = ","
    what["foot"] = "foot point, on the face or beside it"
    what["inside"] = "foot point on the face; not judged where the closest point lies on an edge"
    what["closest"] = "closest point of the closed face"
    what["point"] = "local coordinates of a point of the face; judged where the slave node is one"
    print "Searches of other libraries beside footpoint's, on the same faces and slave nodes."
    print machine
}
$1 == "version" { library[++libraries] = $2; version[$2] = $3 }
$1 == "search" {
    question[$2, $3, $4] = $5
    note[$2, $3] = $6
    if (!seen[$2, $3]++) search[++searches] = $2 SUBSEP $3
}
$1 == "family" {
    if (!(($3, $2) in block)) { block[$3, $2]; order[++blocks] = $3 SUBSEP $2 }
    line[$3, $2, ++count[$3, $2]] = $0
}
$1 == "derivative" { derivative[++derivatives] = $0 }

function percent(n, of) { return of == 0 ? "" : n == 0 ? "0" : sprintf("%.1f", 100 * n / of) }
function ns(v) { return v == "inf" ? "" : sprintf("%.0f", v) }
function head() {
    printf "  %-14s %-29s %-8s %9s %9s %7s %7s %7s %8s %6s\n", "library", "search", "question", "ns", "again", \
        "wrong", "silent", "endless", "error", "judged"
}
function print_block(b,    part, n, i, j, k, at, f, v) {
    split(order[b], part, SUBSEP)
    printf "\n%s, %s\n", part[1], part[2]
    head()
    n = count[part[1], part[2]]
    for (i = 1; i <= n; i++) {
        split(line[part[1], part[2], i], f, ",")
        time[i] = f[7] == "inf" ? 1e30 : f[7] + 0
        for (j = i; j > 1 && time[at[j - 1]] > time[i]; j--) at[j] = at[j - 1]
        at[j] = i
    }
    for (k = 1; k <= n; k++) {
        split(line[part[1], part[2], at[k]], f, ",")
        v = f[9] + f[10] + f[11] + f[12] + f[13]
        printf "%s %-14s %-29s %-8s %9s %9s %7s %7s %7s %8s %6d%s\n", f[4] == "footpoint" ? "*" : " ", f[4], f[5], \
            question[f[4], f[5], part[1]], ns(f[7]), ns(f[8]), percent(v - f[9], v), percent(f[10], v), \
            percent(f[12], v), f[14] == "nan" ? "" : f[14], v, f[13] ? "  " f[13] " crashed" : ""
    }
}
END {
    printf "\nPresent:"
    for (i = 1; i <= libraries; i++) printf "%s %s %s", (i > 1 ? "," : ""), library[i], version[library[i]]
    print "\nAbsent: " (absent ~ /[^ ]/ ? absent : "none of those that there are adapters for")
    print "\nWhat is asked for:"
    for (q in what) names = names " " q
    n = split("foot inside closest point", name, " ")
    for (i = 1; i <= n; i++) printf "  %-8s %s\n", name[i], what[name[i]]
    print "\nColumns: ns a search with a new face, and of one more on the same face, least of the rounds, processor"
    print "time; no right answer, wrong without saying so, not done in 0.2 s, in % of the cases judged; median"
    print "error of the answers in longest edges.  Wrong: farther off than 1e-4 of the longest edge.  *: ours."
    for (b = 1; b <= blocks; b++) print_block(b)
    print "\nFirst derivatives of xi, eta and gap by the 15 coordinates of a four-node face and its slave node"
    printf "  %-14s %-29s %9s %8s  %s\n", "library", "", "ns", "error", ""
    for (i = 1; i <= derivatives; i++) {
        split(derivative[i], f, ",")
        printf "%s %-14s %-29s %9.0f %8s  %s\n", f[2] == "footpoint" ? "*" : " ", f[2], f[3], f[5], f[7], f[8]
    }
    print "\nRoutines"
    for (i = 1; i <= searches; i++) {
        split(search[i], f, SUBSEP)
        printf "  %-14s %-29s %s\n", f[1], f[2], note[f[1], f[2]]
    }
}
