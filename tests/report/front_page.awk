# Prints parts of README.md about quad4, with recorded.awk: -v part=quad4, the table "Which function", or part=last, its
# searches from the last answer. Ratios are how many times faster than the faster of two Newton iterations (closest points: than
# four triangles), with the range over machines.
BEGIN {
    scene = "quad4"
    names = split("balanced fine precise accurate full", name, " ")
    use["balanced"] = "explicit codes, penalty forces"
    use["accurate"] = "implicit codes"
    use["full"] = "Newton's own accuracy"
}
function faster(f, mode) { return ratio("checked newton_checked/newton_fair_checked " mode, "checked " f "_checked " mode) }
function closest(f) { return ratio("closest four_triangles scalar", "closest " f " scalar") }
function table(    i, f) {
    print "| quad4 | OK proves xi, eta to | mean error of `_at` | dependent | calls | arrays | `_closest` | for |"
    print "|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= names; i++) {
        f = "footpoint_quad4_" name[i]
        print "| `_" name[i] "` | " short(promise[f], "%.0e") " | " short(mean[name[i]], "%.0e") " | " faster(f, "chain") " | " \
            faster(f, "scalar") " | " faster(f, "batch") " | " closest(f "_closest") " | " use[name[i]] " |"
    }
    print "| `footpoint_robust` | 1e-10 of an edge | | | | | " closest("footpoint_robust") " | any four corners |"
    print "\nMeasured on " machines "."
    print "Four triangles, the rival of `_closest`, are off by up to " short(worst_gap[scene, "closest", "four_triangles"], "%.0e") " of the face's size."
}
function last(move,    i, m, mode) {
    split("chain scalar batch", mode, " ")
    for (i = 1; i <= names; i++)
        for (m = 1; m <= 3; m++)
            take("from_" move " newton_from_" move "/newton_fair_from_" move " " mode[m], \
                "from_" move " footpoint_quad4_" name[i] "_from_" move " " mode[m])
    return told()
}
END {
    if (part == "quad4") table()
    else
        print "- The same ratios of `NAME_from` of four functions, from answers 0.001, 0.01 and 0.1 of a face away, are " last("1e-3") ", " last("1e-2") " and " last("1e-1") "."
}
