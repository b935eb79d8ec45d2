# awk -v what=sphere -f own.awk: a contact mesh as users have them, smooth bodies cut into shells of four nodes, graded.
# sphere: the cap of a ball on a block's few nodes; thread: a flank of a bolt's thread; wavy: a sheet; saddle.
function pi() { return atan2(0, -1) }
function graded(t) { return t * (0.4 + 0.6 * t) } # from 0 to 1, steps growing 1 : 4
function place(u, v,    a, r) {
    if (what == "sphere") { # about the lowest point, a square's sides bent to parallels
        u = 2 * u - 1; v = 2 * v - 1
        u *= 0.3 + 0.7 * u * u; v *= 0.3 + 0.7 * v * v
        r = sqrt(u * u * (1 - v * v / 2) + v * v * (1 - u * u / 2)); a = 0.6 * r
        x = 10 * sin(a) * (r > 0 ? u * sqrt(1 - v * v / 2) / r : 0)
        y = 10 * sin(a) * (r > 0 ? v * sqrt(1 - u * u / 2) / r : 0)
        z = -10 * cos(a)
        y = -y # so that normals point outwards
    } else if (what == "thread") {
        a = 2.5 * pi() * u; r = 4 + 0.9 * graded(v)
        x = r * cos(a); y = r * sin(a); z = 1.5 * a / (2 * pi()) + 0.5 * (r - 4)
    } else if (what == "wavy") {
        x = 12 * graded(u); y = 8 * v; z = 0.4 * sin(1.1 * x) * cos(0.9 * y)
    } else { # saddle
        x = 10 * u - 5; y = 10 * graded(v) - 5; z = 0.05 * (x * x - y * y) + 0.02 * x * y
    }
}
BEGIN {
    n = what == "thread" ? 60 : 16; m = what == "thread" ? 6 : 16
    print "** made by awk -v what=" what " -f tests/meshes/own.awk"
    print "*NODE"
    for (j = 0; j <= m; j++)
        for (i = 0; i <= n; i++) {
            place(i / n, j / m)
            printf "%d, %.9g, %.9g, %.9g\n", 1 + i + j * (n + 1), x, y, z
        }
    for (k = 1; k <= 36; k++) { # nodes of the other body
        place((0.5 + (k - 1) % 6) / 6 * 0.98, (0.5 + int((k - 1) / 6)) / 6 * 0.98)
        printf "%d, %.9g, %.9g, %.9g\n", 10000 + k, x, y, z + (what == "sphere" ? -0.02 : 0.02)
    }
    print "*ELEMENT, TYPE=S4, ELSET=SHELL"
    for (j = 0; j < m; j++)
        for (i = 0; i < n; i++) {
            a = 1 + i + j * (n + 1)
            printf "%d, %d, %d, %d, %d\n", 1 + i + j * n, a, a + 1, a + n + 2, a + n + 1
        }
    print "*NSET, NSET=OTHER, GENERATE\n10001, 10036\n*SURFACE, NAME=M\nSHELL, SPOS\n*SURFACE, NAME=S, TYPE=NODE\nOTHER\n*CONTACT PAIR\nS, M"
}
