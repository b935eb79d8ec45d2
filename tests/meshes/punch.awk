# punch.inp from the plan view: heights of the sheet (doubly curved, with ripples) and of the punch (a sphere, pressed in
# by 0.35 mm at its pole).
function bowl(u, v) {
    return (u - 60) ^ 2 / 3200 + (v - 40) ^ 2 / 2500
}
function ripple(u, v) {
    return 0.15 * sin(u / 4.5) * cos(v / 5)
}
function node_block(set, punch,    i, k, u, v, h) {
    print "*NODE, NSET=" set
    for (i = 1; i <= nodes; i++) {
        k = node[i]
        u = x[k]
        v = y[k]
        h = punch ? bowl(63, 38) - 0.35 + 600 - sqrt(600 ^ 2 - (u - 63) ^ 2 - (v - 38) ^ 2) : bowl(u, v) + ripple(u, v)
        printf "%d, %.4f, %.4f, %.4f\n", new[k], u, v, h
    }
}
function element_block(set, first,    i) {
    print "*ELEMENT, TYPE=S4, ELSET=" set
    for (i = 1; i <= elements; i++)
        print element_line(first, i)
}
END {
    print "*HEADING"
    print "Spherical punch on a rippled sheet, mm, N, MPa"
    print "** Mesh: gmsh, from punch.geo, by make-meshes.sh."
    collect("SHEET", 0)
    node_block("N_SHEET", 0)
    element_block("SHEET", 0)
    collect("PUNCH", 20000)
    print "**"
    node_block("N_PUNCH", 1)
    element_block("PUNCH", 20000)
    print "**"
    print "*MATERIAL, NAME=STEEL"
    print "*ELASTIC"
    print "210000., 0.3"
    print "*SHELL SECTION, ELSET=SHEET, MATERIAL=STEEL"
    print "1.2"
    print "*SHELL SECTION, ELSET=PUNCH, MATERIAL=STEEL"
    print "5."
    print "**"
    print "*SURFACE, NAME=SHEET_TOP, TYPE=ELEMENT"
    print "SHEET, SPOS"
    print "*SURFACE, NAME=PUNCH_FACE, TYPE=NODE"
    print "N_PUNCH,"
    print "*SURFACE INTERACTION, NAME=DRY"
    print "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR"
    print "1.E6"
    print "*CONTACT PAIR, INTERACTION=DRY,"
    print "    TYPE=NODE TO SURFACE"
    print "punch_face, sheet_top"
}
