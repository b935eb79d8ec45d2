# Prints tables in HTML from the output of the hard cases (tests/hard/hard_main.c): a row for each method, those first that
# must not be wrong; then the wrong answers and statuses of each family.
#     awk -f hard.awk hard.csv
BEGIN {
    FS = ","
    methods = split("header locate robust stationary float float_all expression newton trust_region", method, " ")
    for (k = 1; k <= 6; k++) certified[method[k]]
}
/^#/ { next }
NF && $1 == "family" {
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
function get(what) { return $column[what] }
{
    m = get("method")
    if (!(get("family") in seen)) { seen[get("family")]; family[++families] = get("family") }
    n[m] += get("n")
    answers[m] += get("ok") + get("outside")
    statuses[m] += get("not_unique") + get("unproved") + get("refused")
    wrong[m] += wrong_in[get("family"), m] = get("wrong") + get("wrong_status")
}
function marked(number) { return number ? "<b>" number "</b>" : number + 0 }
END {
    print "<div class=wide><table><tr><th>search</th><th>cases</th><th>answers</th><th>other statuses</th><th>wrong</th></tr>"
    for (k = 1; k <= methods; k++) {
        m = method[k]
        if (m in n) print "<tr" (m in certified ? " class=ours" : "") "><td>" m "</td><td>" n[m] "</td><td>" answers[m] "</td><td>" statuses[m] \
            "</td><td>" marked(wrong[m]) "</td></tr>"
    }
    print "</table></div>"
    print "<details><summary>Wrong answers and statuses by family</summary><div class=wide><table><tr><th>family</th>"
    for (k = 1; k <= methods; k++) print "<th>" method[k] "</th>"
    print "</tr>"
    for (i = 1; i <= families; i++) {
        printf "<tr><td>%s</td>", family[i]
        for (k = 1; k <= methods; k++)
            printf "<td>%s</td>", (family[i], method[k]) in wrong_in ? marked(wrong_in[family[i], method[k]]) : ""
        print "</tr>"
    }
    print "</table></div></details>"
}
