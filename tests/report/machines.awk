# Prints the recorded machines as HTML, with recorded.awk: how many times faster than Newton's iteration (closest points: than four
# triangles) the functions of quad4 are, on each.
#     awk -f recorded.awk -f machines.awk MACHINE.csv
BEGIN {
    scene = "quad4"
    names = split("balanced fine precise accurate full", name, " ")
    modes = split("chain scalar batch", mode, " ")
}
function cell(x) { return "<td>" (x != "" && x < 1 ? "<b>" x "</b>" : x) "</td>" }
END {
    print "<h3>" machines "</h3>"
    print "<div class=wide><table><tr><th>quad4</th><th>dependent</th><th>calls</th><th>arrays</th><th>closest</th></tr>"
    for (i = 1; i <= names; i++) {
        f = "footpoint_quad4_" name[i]
        printf "<tr><td>%s</td>", name[i]
        for (m = 1; m <= modes; m++)
            printf "%s", cell(ratio("checked newton_checked/newton_fair_checked " mode[m], "checked " f "_checked " mode[m]))
        print cell(ratio("closest four_triangles scalar", "closest " f "_closest scalar")) "</tr>"
    }
    print "</table></div>"
}
