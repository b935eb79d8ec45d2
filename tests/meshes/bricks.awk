# bricks.inp: two blocks of bricks, a fine one on a coarse one, edges along the axes.
function block(set, first, nx, ny, x0, y0, z0, dx, dy, dz,    i, j, k) {
    print "*NODE, NSET=N_" set
    for (k = 0; k < 2; k++)
        for (j = 0; j <= ny; j++)
            for (i = 0; i <= nx; i++)
                printf "%d, %g, %g, %g\n", label(first, nx, ny, i, j, k), x0 + i * dx, y0 + j * dy, z0 + k * dz
    print "*ELEMENT, TYPE=C3D8R, ELSET=" set
    for (j = 0; j < ny; j++)
        for (i = 0; i < nx; i++)
            print first + 1 + i + nx * j ", " layer(first, nx, ny, i, j, 0) ", " layer(first, nx, ny, i, j, 1)
}
function label(first, nx, ny, i, j, k) {
    return first + 1 + i + (nx + 1) * (j + (ny + 1) * k)
}
function layer(first, nx, ny, i, j, k,    a) {
    a = label(first, nx, ny, i, j, k)
    return a ", " a + 1 ", " a + nx + 2 ", " a + nx + 1
}
BEGIN {
    print "*HEADING"
    print "Two blocks of bricks, mm, N, MPa"
    print "** Mesh: bricks.awk, by make-meshes.sh."
    block("LOWER", 0, 4, 3, 12.3, 4.1, 0.7, 2.3, 1.9, 1.1)
    block("UPPER", 1000, 7, 5, 12.9, 4.4, 1.85, 1.1, 0.9, 1.3)
    print "**"
    print "*SURFACE, NAME=Master, TYPE=ELEMENT"
    print "LOWER, S2"
    print "*SURFACE, NAME=Slave, TYPE=ELEMENT"
    print "UPPER, S1"
    print "*SURFACE INTERACTION, NAME=DRY"
    print "*CONTACT PAIR, INTERACTION=DRY, TYPE=SURFACE TO SURFACE"
    print "Slave, Master"
}
