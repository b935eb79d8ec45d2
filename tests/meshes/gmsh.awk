# Reads gmsh's own .inp: nodes into x, y, z, elements into conn; number[set, n] is the n-th element of a physical group.
/^\*/ {
    part = toupper($0)
    gsub(/[ \t]/, "", part)
    set = part
    sub(/.*ELSET=/, "", set)
    next
}
part == "*NODE" {
    split($0, f, ",")
    x[f[1] + 0] = f[2] + 0
    y[f[1] + 0] = f[3] + 0
    z[f[1] + 0] = f[4] + 0
}
part ~ /^\*ELEMENT,TYPE=(CPS4|C3D8),/ {
    n = index($0, ",")
    conn[substr($0, 1, n - 1) + 0] = substr($0, n + 1)
}
part ~ /^\*ELSET/ {
    n = split($0, f, ",")
    for (i = 1; i <= n; i++)
        if (f[i] + 0 > 0)
            number[set, ++count[set]] = f[i] + 0
}

# Renumbers nodes and elements of a group from first + 1 on: node[] and nodes, element[] and elements.
function collect(group, first,    i, k, n, c) {
    nodes = elements = 0
    for (i = 1; i <= count[group]; i++) {
        n = split(conn[number[group, i]], c, ",")
        element[++elements] = number[group, i]
        for (k = 1; k <= n; k++)
            if (!((c[k] + 0) in new)) {
                node[++nodes] = c[k] + 0
                new[c[k] + 0] = first + nodes
            }
    }
}
function element_line(first, i,    k, n, c, line) {
    n = split(conn[element[i]], c, ",")
    line = (first + i)
    for (k = 1; k <= n; k++)
        line = line ", " new[c[k] + 0]
    return line
}
# Uniform in -1..1, the same in every awk (Park and Miller).
function noise() {
    seed = (seed * 16807) % 2147483647
    return 2 * seed / 2147483647 - 1
}
