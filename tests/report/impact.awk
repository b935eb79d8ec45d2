# Prints figures of tests/example/impact.c from what it printed on each machine: -v part=share, that of local search by
# Newton's iteration in the whole run, or part=impact, the sentence of tests/README.md.
#     awk -v part=share -f impact.awk MACHINE-impact.txt...
FNR == 1 { run++ }
{ words = $0; sub(/  [ ]*[0-9].*/, "", words); rest = substr($0, length(words) + 1); split(rest, x, " ") }
words == "local search, ns a pair" { keep("pair", x[1] / x[2]) }
words == "... over arrays, least ns" { keep("arrays", x[1] / x[2]) }
words == "local search, ms" && !((run, "local") in of) { of[run, "local"] = x[1] }
words == "everything, ms" && !((run, "whole") in of) { of[run, "whole"]; keep("share", 100 * of[run, "local"] / x[1]); keep("whole", x[2] / x[1]) }
words == "momentum error, relative" { keep("momentum", x[2]) }
words == "nodes apart at the end, mm, worst" { keep("apart", x[1]) }
function keep(what, value) {
    if (!(what in low) || value < low[what]) low[what] = value
    if (!(what in high) || value > high[what]) high[what] = value
}
function span(what, format,    a, b) {
    a = sprintf(format, low[what])
    b = sprintf(format, high[what])
    return a == b ? a : a " to " b
}
function at_most(what,    x) { x = sprintf("%.1e", high[what]); sub(/e-0/, "e-", x); return x }
END {
    if (part == "share") print span("share", "%.0f")
    else {
        print "Both give the same motion, to " at_most("apart") " mm, and keep momentum to " at_most("momentum") ". Local search by `_balanced` over"
        print "arrays is " span("pair", "%.1f") " times as fast as Newton pair by pair, and " span("arrays", "%.1f") " times as fast as Newton over arrays. The whole run takes"
        print span("whole", "%.2f") " of the time."
    }
}
