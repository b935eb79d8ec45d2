# Reads what commands wrote, for the tables of READMEs: promises and operations from headers, held-out errors from genomes,
# times from tests/report/machines/. Use it with a program that prints:
#     awk -f recorded.awk -f PROGRAM.awk generated/footpoint_quad4.h evolve/genomes/quad4.gen MACHINE.csv...
FILENAME ~ /\.h$/ {
    if (/^#define FOOTPOINT_[A-Z0-9_]+_PROMISE /) promise[tolower(substr($2, 1, length($2) - 8))] = $3
    if (/^\/\* footpoint_[a-z0-9_]+$/) banner = $2
    if (/^ \*   operations: /) operations[banner] = $3 + 0 " | " $5 + 0 " | " $7 + 0
    next
}
FILENAME ~ /\.gen$/ {
    if (/^genome /) genome = $2
    if (/^note heldout_both /) {
        mean[genome] = $6
        p99[genome] = $9
        worst[genome] = $12
        climbed[genome] = $14 == "climbing" ? $15 : $12
    }
    if (/^note at_heldout /) {
        at_mean[genome] = $4
        at_worst[genome] = $6 + 0
    }
    next
}
/^# / { machine++; machines = machines (machines == "" ? "" : "; ") substr($0, 3); next }
/^scene,/ { split("", c); n = split($0, head, ","); for (i = 1; i <= n; i++) c[head[i]] = i; next }
{
    split($0, v, ",")
    method = v[c["scene"]] SUBSEP v[c["question"]] SUBSEP v[c["method"]]
    ns[machine, method, v[c["mode"]]] = v[c["ns"]]
    counts[method] = v[c["mul"]] " | " v[c["div"]] " | " v[c["add"]]
    errors[method] = v[c["mean_xi"]] " " v[c["p99_xi"]] " " v[c["max_xi"]]
    worst_gap[method] = v[c["max_gap"]]
}
# The least time on a machine: "QUESTION METHOD/METHOD... MODE" of the scene.
function least_time(machine, what,    part, name, i, n, t, least) {
    split(what, part, " ")
    n = split(part[2], name, "/")
    for (i = 1; i <= n; i++)
        if ((t = ns[machine, scene, part[1], name[i], part[3]] + 0) > 0 && (least == "" || t < least)) least = t
    return least
}
# Takes the ratio of two times on each machine into the range that `told` prints.
function take(above, below,    m, a, b) {
    for (m = 1; m <= machine; m++) {
        a = least_time(m, above)
        b = least_time(m, below)
        if (a == "" || b == "") continue
        if (low == "" || a / b < low) low = a / b
        if (high == "" || a / b > high) high = a / b
    }
}
# The range so far, which begins anew: two digits.
function told(    a, b) {
    a = digits(low)
    b = digits(high)
    low = high = ""
    return a == b ? a : a " to " b
}
function digits(x) { return x == "" ? "" : sprintf(x < 9.95 ? "%.1f" : "%.0f", x) }
function ratio(above, below) { take(above, below); return told() }
function short(x, format) { x = sprintf(format == "" ? "%.1e" : format, x); sub(/e-0/, "e-", x); return x }
