# Writes contact models for CalculiX: awk -v model=NAME -f models.awk > NAME.inp
# Two bodies of bricks or wedges, nodes of the upper against faces of the lower; N, mm, t, s.

# Lattice point (i,j,k) of the block being built, i up to 2 nx and so on; even points are corners of elements.
function point(i, j, k) { return base + 1 + i + (2 * nx + 1) * (j + (2 * ny + 1) * k) }

# Displacement of an inner corner, in elements; midside nodes move by half of their neighbours'.
function moved(way, i, j) {
    if (i % 2) return (moved(way, i - 1, j) + moved(way, i + 1, j)) / 2
    if (j % 2) return (moved(way, i, j - 1) + moved(way, i, j + 1)) / 2
    if (i == 0 || i == 2 * nx || j == 0 || j == 2 * ny) return 0
    return distort * (way == "x" ? sin(3 * i + 5 * j) : cos(4 * i + 2 * j))
}

# Maps a regular block to moved nodes and curved surfaces, u, v, w in [0,1] over the block.
function shape(i, j, k,    u, v, w, x, y, z) {
    u = i / (2 * nx); v = j / (2 * ny); w = k / (2 * nz)
    x = x0 + u * lx + moved("x", i, j) * lx / nx
    y = y0 + v * ly + moved("y", i, j) * ly / ny
    z = z0 + w * lz
    z += wave * sin(1.3 * x) * cos(1.7 * y)
    z += bulge * (1 - w) * ((2 * u - 1) ^ 2 + (2 * v - 1) ^ 2)
    return sprintf("%d,%.9g,%.9g,%.9g", point(i, j, k), x, y, z)
}

# Returns the nodes of an element, from places "ijk ijk ..." relative to the lower corner (a,b,c) of its cell.
function nodes(places,    n, m, p, s, t) {
    n = split(places, p, " ")
    for (m = 1; m <= n; m++) {
        t = point(a + substr(p[m], 1, 1), b + substr(p[m], 2, 1), c + substr(p[m], 3, 1))
        used[t] = 1
        s = s (m % 10 ? "," : ",\n") t
    }
    return s
}

# Writes the block: elements NAME and their top layer NAMEtop, nodes NAMEnodes, and nodes NAMEupper and NAMElower of its
# upper and lower face.
function block(name,    i, j, k, e, split_cells, list, n, m) {
    split("", used)
    list["C3D8"] = "000 200 220 020 002 202 222 022"
    list["C3D20R"] = list["C3D8"] " 100 210 120 010 102 212 122 012 001 201 221 021"
    list["C3D6"] = "000 200 220 002 202 222"; list["C3D6b"] = "000 220 020 002 222 022"
    list["C3D15"] = list["C3D6"] " 100 210 110 102 212 112 001 201 221"
    list["C3D15b"] = list["C3D6b"] " 110 120 010 112 122 012 001 221 021"
    split_cells = (type ~ /C3D6|C3D15/) ? 2 : 1
    e = base
    print "*ELEMENT,TYPE=" type ",ELSET=" name
    for (k = 0; k < nz; k++) for (j = 0; j < ny; j++) for (i = 0; i < nx; i++) for (m = 1; m <= split_cells; m++) {
        a = 2 * i; b = 2 * j; c = 2 * k
        e++
        print e nodes(list[type (m == 2 ? "b" : "")])
        if (k == nz - 1) top[e] = 1
    }
    print "*NODE,NSET=" name "nodes"
    for (k = 0; k <= 2 * nz; k++) for (j = 0; j <= 2 * ny; j++) for (i = 0; i <= 2 * nx; i++)
        if (point(i, j, k) in used) print shape(i, j, k)
    level(name "upper", 2 * nz); level(name "lower", 0)
    print "*ELSET,ELSET=" name "top"
    for (e in top) print e
    split("", top)
    base += (2 * nx + 1) * (2 * ny + 1) * (2 * nz + 1)
}

function level(set, k,    i, j) {
    print "*NSET,NSET=" set
    for (j = 0; j <= 2 * ny; j++) for (i = 0; i <= 2 * nx; i++) if (point(i, j, k) in used) print point(i, j, k)
}

function cells(p, q, r) { nx = p; ny = q; nz = r }
function box(p, q, r, s, t, u) { x0 = p; y0 = q; z0 = r; lx = s; ly = t; lz = u }

function material(stiffness, friction) {
    print "*MATERIAL,NAME=STEEL\n*ELASTIC\n210000.,.3\n*DENSITY\n7.8e-9"
    print "*SOLID SECTION,ELSET=lower,MATERIAL=STEEL\n*SOLID SECTION,ELSET=upper,MATERIAL=STEEL"
    print "*SURFACE,NAME=master\nlowertop,S2\n*SURFACE,NAME=slave,TYPE=NODE\nupperlower"
    print "*CONTACT PAIR,INTERACTION=touch,TYPE=NODE TO SURFACE\nslave,master"
    print "*SURFACE INTERACTION,NAME=touch\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n" stiffness ",1."
    if (friction) print "*FRICTION\n" friction "," stiffness / 10
    print "*BOUNDARY\nlowerlower,1,3"
}

function output() {
    print "*NODE PRINT,NSET=uppernodes\nU\n*NODE PRINT,NSET=lowernodes\nU\n*CONTACT PRINT\nCDIS,CSTR"
    print "*NODE FILE\nU\n*EL FILE\nS\n*END STEP"
}

# Moves the upper block's upper face to (x, y, z).
function press(increment, x, y, z) {
    print "*STEP,NLGEOM,INC=1000\n*STATIC\n" increment ",1."
    print "*BOUNDARY\nupperupper,1,1," x "\nupperupper,2,2," y "\nupperupper,3,3," z
    output()
}

BEGIN {
    base = 0; distort = 0.12; wave = 0; bulge = 0; type = "C3D8"
    if (model ~ /^punch/) { # a punch with a curved face into a sheet
        if (model == "punch-tri3") type = "C3D6"
        if (model == "punch-tri6") type = "C3D15"
        if (model == "punch-quad8") type = "C3D20R"
        quadratic = type ~ /C3D20R|C3D15/
        cells(quadratic ? 7 : 14, quadratic ? 7 : 14, 2); box(-3, -3, -1, 6, 6, 1); block("lower")
        type = "C3D8"; bulge = 0.12
        cells(9, 9, 3); box(-1.57, -1.43, 0.001, 3, 3, 2); block("upper")
        material(5e6, 0)
        press(0.1, 0, 0, -0.06)
    } else if (model == "blocks") { # two blocks with warped faces that do not match, squeezed and sheared
        wave = 0.04
        cells(9, 9, 3); box(-2, -2, -2, 4, 4, 2); block("lower")
        distort = 0.08
        cells(7, 7, 3); box(-1.61, -1.52, 0, 3.2, 3.1, 1.5); block("upper")
        material(5e6, 0.2)
        press(0.2, 0, 0, -0.02)
        press(0.2, 0.01, 0.005, -0.03)
    } else if (model == "sliding") { # a block pressed on a plate, then slid over several of its faces
        wave = 0.01
        cells(16, 8, 1); box(-4, -2, -0.8, 8, 4, 0.8); block("lower")
        wave = 0
        cells(5, 5, 2); box(-3, -0.93, 0.012, 2, 2, 1); block("upper")
        material(1e6, 0.1)
        press(0.25, 0, 0, -0.02)
        press(0.02, 2.5, 0.2, -0.02)
    } else if (model == "impact") { # a block with a curved face hits a plate, explicit dynamics
        cells(12, 12, 2); box(-3, -3, -1, 6, 6, 1); block("lower")
        bulge = 0.05
        cells(7, 7, 3); box(-1.07, -0.93, 0.002, 2, 2, 1); block("upper")
        material(1e6, 0)
        print "*INITIAL CONDITIONS,TYPE=VELOCITY\nuppernodes,3,-2.e4"
        print "*STEP,NLGEOM,INC=100000\n*DYNAMIC,EXPLICIT\n5.e-9,1.5e-6"
        print "*NODE PRINT,NSET=uppernodes,FREQUENCY=100\nU\n*NODE PRINT,NSET=lowernodes,FREQUENCY=100\nU"
        print "*CONTACT PRINT,FREQUENCY=50\nCDIS,CSTR\n*NODE FILE,FREQUENCY=100\nU\n*EL FILE,FREQUENCY=100\nS"
        print "*END STEP"
    } else {
        print "models.awk: no model '" model "'" > "/dev/stderr"
        exit 2
    }
}
