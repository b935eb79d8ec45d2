# Prints a table in HTML from the output of the hard cases (tests/hard/hard_main.c): a row for each family; for each
# method the number of cases with an answer, with another status, and with a wrong answer or status, and the worst
# error.
#     awk -f hard.awk hard.csv
BEGIN { FS = "," }
/^#/ { next }
NF && $1 == "family" {
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
function get(what) { return $column[what] }
{
    if (!(get("family") in seen_family)) { seen_family[get("family")]; family[++families] = get("family") }
    if (!(get("method") in seen_method)) { seen_method[get("method")]; method[++methods] = get("method") }
    wrong = get("wrong") + get("wrong_status")
    cells[get("family"), get("method")] = "<td>" get("ok") + get("outside") "</td><td>" \
        get("not_unique") + get("unproved") + get("refused") "</td><td>" (wrong ? "<b>" wrong "</b>" : 0) "</td><td>" get("worst") "</td>"
    total[get("method")] += wrong
    n = get("n")
}
END {
    printf "<table><tr><th>%d cases each</th>", n
    for (k = 1; k <= methods; k++) printf "<th colspan=4>%s</th>", method[k]
    printf "</tr>\n<tr><th>family</th>"
    for (k = 1; k <= methods; k++) printf "<th>answers</th><th>status</th><th>wrong</th><th>worst</th>"
    print "</tr>"
    for (i = 1; i <= families; i++) {
        printf "<tr><td>%s</td>", family[i]
        for (k = 1; k <= methods; k++) printf "%s", cells[family[i], method[k]]
        print "</tr>"
    }
    printf "<tr class=ours><td>wrong in all</td>"
    for (k = 1; k <= methods; k++) printf "<td></td><td></td><td>%d</td><td></td>", total[method[k]]
    print "</tr></table>"
}
