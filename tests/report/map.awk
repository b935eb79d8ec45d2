# Draws maps of the mean error of xi over the segment by a gnuplot script, from the VTK files of `footpoint-bench --map`:
#     awk -f map.awk -v title=quad4 -v out=FILE SCENE-*.vtk | gnuplot
# writes FILE.svg and FILE.png: a panel for each function, all with the same colours.
FNR == 1 { panel++; reading = "" }
FNR == 2 { function_name[panel] = $1; sub(",", "", function_name[panel]) }
$1 == "DIMENSIONS" { side[1] = $2 - 1; side[2] = $3 - 1 }
$1 == "ORIGIN" { low[1] = $2; low[2] = $3 }
$1 == "SPACING" { step[1] = $2; step[2] = $3 }
$1 == "SCALARS" { reading = $2; k = 0; next }
reading == "" || $1 == "LOOKUP_TABLE" { next }
reading == "mean_error_xi" { error[panel, k++] = $1 + 0 }
reading == "samples" { samples[panel, k++] = $1 }
END {
    least = 1e300
    squares = side[1] * side[2]
    for (p = 1; p <= panel; p++)
        for (k = 0; k < squares; k++)
            if (samples[p, k]) {
                if (error[p, k] < 1e-17) error[p, k] = 1e-17
                if (error[p, k] < least) least = error[p, k]
                if (error[p, k] > most) most = error[p, k]
            }
    across = 300; high = 330
    for (p = 1; p <= panel; p++) {
        printf "$panel%d << END\n", p
        for (k = 0; k < squares; k++)
            printf "%g %g %s\n", low[1] + step[1] * (k % side[1] + 0.5), low[2] + step[2] * (int(k / side[1]) + 0.5),
                samples[p, k] ? error[p, k] : "NaN"
        print "END"
    }
    print "set logscale cb\nset format cb '10^{%L}'"
    print "set palette defined (0 '#f7fbff', 1 '#9ecae1', 2 '#4292c6', 3 '#08306b')"
    printf "set cbrange [%g:%g]\nset size ratio -1\nunset key\nset tics out nomirror\nset border lw 0.5\n", least, most
    printf "set xrange [%g:%g]\nset yrange [%g:%g]\nset xtics 0.5\nset ytics 0.5\n", low[1], low[1] + side[1] * step[1],
        low[2], low[2] + side[2] * step[2]
    print "set xlabel 'xi' offset 0,0.5"
    wide = across * panel + 130
    for (t = 0; t < 2; t++) {
        printf "set terminal %s size %d,%d font 'sans,11' background '#ffffff'\nset output '%s.%s'\n",
            t ? "pngcairo" : "svg", wide, high + 40, out, t ? "png" : "svg"
        print "set multiplot"
        printf "set label 1 '%s: mean error of xi over the segment' at screen 0.02,0.95 left noenhanced " \
            "font 'sans,14'\n", title
        for (p = 1; p <= panel; p++) {
            print "set bmargin at screen 0.14\nset tmargin at screen 0.82"
            printf "set lmargin at screen %g\nset rmargin at screen %g\n",
                (70 + across * (p - 1)) / wide, (70 + across * p - 46) / wide
            name = function_name[p]
            prefix = "footpoint_" title "_"
            gsub(/-/, "_", prefix)
            sub("^" prefix, "", name)
            printf "set title '%s' noenhanced offset 0,-0.5\n%s\n%s\n", name,
                p == panel ? "set colorbox" : "unset colorbox", p == 1 ? "set ylabel 'eta' offset 1,0" : "unset ylabel"
            printf "plot $panel%d using 1:2:3 with image\nunset label 1\n", p
        }
        print "unset multiplot"
    }
}
