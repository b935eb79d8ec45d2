# blocks.inp and blocks-nodes.inp (its name in the variable `include`, its path in `nodes_file`) from the two boxes: the
# upper one turned by 7 degrees, both with distorted elements, and wavy where they meet.
function move(k, upper, edge,    u, v, w, a) {
    w = z[k]
    u = x[k] - 20 + 0.12 * edge * noise()
    v = y[k] - 20 + 0.12 * edge * noise()
    if (upper) {
        a = 7 * atan2(0, -1) / 180
        x[k] = 20 + u * cos(a) - v * sin(a)
        y[k] = 20 + u * sin(a) + v * cos(a)
    } else {
        x[k] = 20 + u + 0.5 * sin(v / 6)
        y[k] = 20 + v + 0.5 * sin(u / 5)
    }
    if (w == 12)
        z[k] += upper ? 0.25 * sin(x[k] / 5) * sin(y[k] / 6) : 0.15 * cos(x[k] / 7 + y[k] / 9)
    else if (w > 0 && w < 20)
        z[k] += 0.1 * edge * noise()
}
function block(set, upper, first, edge,    i, k, height) {
    print "*NODE, NSET=N_" set > nodes_file
    for (i = 1; i <= nodes; i++) {
        k = node[i]
        height = z[k]
        move(k, upper, edge)
        meets[new[k]] = height == 12
        printf "%d, %.4f, %.4f, %.4f\n", new[k], x[k], y[k], z[k] > nodes_file
    }
    print "*ELEMENT, TYPE=C3D8R, ELSET=" set
    for (i = 1; i <= elements; i++)
        print element_line(first, i)
}
# The elements whose face begins with corner `corner` (1: bottom, 5: top) at the meeting plane.
function layer(set, first, corner,    i, c, n, line) {
    print "*ELSET, ELSET=" set
    line = ""
    for (i = 1; i <= elements; i++) {
        split(conn[element[i]], c, ",")
        if (!meets[new[c[corner] + 0]])
            continue
        line = line (n % 16 ? ", " : "") (first + i)
        if (++n % 16 == 0) {
            print line
            line = ""
        }
    }
    if (line)
        print line
}
BEGIN {
    seed = 20080401
}
END {
    print "*HEADING"
    print "Two blocks of hexahedra whose meshes do not match, mm, N, MPa"
    print "** Mesh: gmsh, from blocks.geo, by make-meshes.sh."
    print "*INCLUDE, INPUT=" include
    collect("LOWER", 0)
    block("LOWER", 0, 0, 40 / 14)
    layer("LOWER_TOP", 0, 5)
    collect("UPPER", 5000)
    block("UPPER", 1, 5000, 32 / 20)
    layer("UPPER_BOTTOM", 5000, 1)
    print "**"
    print "*SURFACE, NAME=Master, TYPE=ELEMENT"
    print "LOWER_TOP, S2"
    print "*SURFACE, NAME=Slave, TYPE=ELEMENT"
    print "UPPER_BOTTOM, S1"
    print "*SURFACE INTERACTION, NAME=DRY"
    print "*CONTACT PAIR, INTERACTION=DRY,"
    print "    TYPE=SURFACE TO SURFACE"
    print "Slave, Master"
    print "**"
    print "*MATERIAL, NAME=STEEL"
    print "*ELASTIC"
    print "210000., 0.3"
    print "*SOLID SECTION, ELSET=LOWER, MATERIAL=STEEL"
    print "*SOLID SECTION, ELSET=UPPER, MATERIAL=STEEL"
}
