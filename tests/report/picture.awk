# Draws time against error of bare searches by a gnuplot script, from `footpoint-bench --csv`:
#     awk -f picture.awk -v scene=quad4 -v sample=random -v mode=scalar -v norm=mean -v out=FILE bench.csv | gnuplot
# writes FILE.svg and FILE.png, with -v narrow=1 FILE.svg for a telephone. Filled squares and the staircase: ours. Open circles: rivals. Rivals are named if no
# other rival beats them in both time and error, or if they are not truncated iterations.
#
# An error is the larger of xi's and eta's, unless set by -v error=; -v others= names the rivals, -v processor= what was measured on. Names are placed near
# their points without covering anything; a name without room is omitted.
BEGIN {
    FS = ","
    width = 1000; height = 680; left = 92; right = 20; top = 62; bottom = 58 # pixels
    if (narrow) { width = 364; height = 480; left = 64; right = 10; top = 70 }
    character = 7.3; line = 15; marker = 5.5
    least_error = 1e-16
}
NR == 1 {
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
"question" in column && $column["question"] != "bare" { next }
$column["scene"] == scene && $column["sample"] == sample && $column["mode"] == mode {
    e = $column[norm "_xi"] > $column[norm "_eta"] + 0 ? $column[norm "_xi"] + 0 : $column[norm "_eta"] + 0
    noises[++all] = $column["noise"] + 0
    machine = (processor ? processor : $column["compiler"]) ", " $column["isa"]
    if (!(e < 1)) next
    n++
    name[n] = $column["method"]; ours[n] = $column["ours"]; x[n] = $column["ns"] + 0
    y[n] = e < least_error ? least_error : e
    if (!ours[n]) sub(/^(tri|quad)[0-9]+_/, "", name[n])
}
END {
    if (n == 0) exit 1
    ranges()
    for (i = 1; i <= n; i++) front[i] = best(i)
    for (i = 1; i <= n; i++) {
        px[i] = pixel_x(x[i]); py[i] = pixel_y(y[i])
        block(px[i] - marker, py[i] - marker, px[i] + marker, py[i] + marker)
    }
    steps()
    script()
}

function log10(v) { return log(v) / log(10) }

# Axes: whole steps of 1, 1.5, 2, 3, 5, 7 around the times, whole decades around the errors.
function ranges(    i) {
    x0 = y0 = 1e300
    for (i = 1; i <= n; i++) {
        if (x[i] < x0) x0 = x[i]
        if (x[i] > x1) x1 = x[i]
        if (y[i] < y0) y0 = y[i]
    }
    x0 *= 0.85; x1 *= 1.2; y1 = 1
    y0 = 10 ^ (log10(y0) - 0.35)
}
function pixel_x(v) { return left + (width - left - right) * log(v / x0) / log(x1 / x0) }
function pixel_y(v) { return bottom + (height - top - bottom) * log(v / y0) / log(y1 / y0) }
function time_at(p) { return x0 * exp((p - left) / (width - left - right) * log(x1 / x0)) }
function error_at(p) { return y0 * exp((p - bottom) / (height - top - bottom) * log(y1 / y0)) }

# Keeps our functions that no other function of ours beats, and one of each group of close rivals.
function best(i,    j, near) {
    near = ours[i] ? 1 : 1.04
    for (j = 1; j <= n; j++)
        if (j != i && ours[j] == ours[i] && x[j] <= near * x[i] && y[j] <= near ^ 3 * y[i] && x[j] * y[j] < x[i] * y[i])
            return 0
    return 1
}

function block(a, b, c, d) { boxes++; bx0[boxes] = a; by0[boxes] = b; bx1[boxes] = c; by1[boxes] = d }
function covered(a, b, c, d,    k) {
    if (a < left + 2 || c > width - right || b < bottom + 2 || d > height - top) return 1
    for (k = 1; k <= boxes; k++)
        if (a < bx1[k] && c > bx0[k] && b < by1[k] && d > by0[k]) return 1
    return 0
}

# The staircase of our front, from the top of the picture to its right edge.
function steps(    i, j, k, last) {
    for (i = 1; i <= n; i++)
        if (ours[i] && front[i]) {
            for (k = ++count; k > 1 && x[at[k - 1]] > x[i]; k--) at[k] = at[k - 1]
            at[k] = i
        }
    stairs = ""
    for (k = 1; k <= count; k++) {
        i = at[k]
        if (k == 1) stairs = sprintf("%g %g\n", x[i], y1)
        stairs = stairs sprintf("%g %g\n", x[i], y[i])
        block(px[i] - 1, py[i], px[i] + 1, k == 1 ? height - top : py[at[k - 1]])
        block(px[i], py[i] - 1, k == count ? width - right : px[at[k + 1]], py[i] + 1)
    }
    if (count) stairs = stairs sprintf("%g %g\n", x1, y[at[count]])
}

# The name of point i at its nearest free place: a gnuplot command, with a thin line if it is far away.
function label(i,    text, w, r, k, dx, dy, a, b, c, d, place, far) {
    text = name[i]
    sub("^footpoint_" under "_", "", text)
    gsub(/_/, " ", text)
    w = length(text) * character * (ours[i] ? 1.12 : 1)
    for (r = 0; r <= (ours[i] ? 5 : 3); r++)
        for (k = 0; k < 8; k++) {
            far = marker + 3 + 11 * r
            dx = k > 5 ? 0 : k % 2 ? -far : far
            dy = k < 2 ? 0 : k > 5 ? far + 4 : 0.8 * far + 2
            if (k == 4 || k == 5 || k == 7) dy = -dy
            a = px[i] + dx - (dx < 0 ? w : dx == 0 ? w / 2 : 0)
            b = py[i] + dy - line / 2; c = a + w; d = b + line
            if (covered(a, b, c, d)) continue
            block(a, b, c, d)
            place = dx < 0 ? "right" : dx == 0 ? "center" : "left"
            if (r > 0)
                printf "set arrow from %g,%g to %g,%g nohead lw 0.6 lc rgb '#b0b0b0' back\n", x[i], y[i],
                    time_at(px[i] + dx), error_at(py[i] + dy - (dx == 0 ? (dy > 0 ? line / 2 : -line / 2) : 0))
            printf "set label '%s' at %g,%g %s noenhanced font 'sans,%s' tc rgb '%s'\n", text, time_at(px[i] + dx),
                error_at(py[i] + dy), place, ours[i] ? "12" : "10.5", ours[i] ? "#000000" : "#555555"
            return
        }
}
function truncated(i) { return name[i] ~ /^(gn?[0-9]|n[0-9])/ }

function median(    i, j, v) {
    for (i = 2; i <= all; i++) {
        v = noises[i]
        for (j = i - 1; j > 0 && noises[j] > v; j--) noises[j + 1] = noises[j]
        noises[j + 1] = v
    }
    return noises[int((all + 1) / 2)]
}

function heading(tag, size, colour, down, text) {
    printf "set label %d '%s' at screen %g,%g left noenhanced font 'sans,%d' tc rgb '%s'\n", tag, text, (narrow ? 8 : left) / width,
        1 - down / height, size, colour
}

function script(    i, k) {
    under = scene
    gsub(/-/, "_", under)
    print "set logscale xy\nset border 3 lc rgb '#606060'\nset tics nomirror out tc rgb '#303030'\nunset key"
    print "set format y '10^{%L}'\nset mytics 1\nset grid xtics ytics lt 1 lw 0.5 lc rgb '#e8e8e8'"
    print "set xtics (" (narrow ? "1, 3, 10, 30, 100, 300, 1000" : "0.5, 1, 1.5, 2, 3, 4, 5, 7, 10, 15, 20, 30, 40, 50, 70, 100, 150, " \
        "200, 300, 500, 1000, 2000, 5000") ", 1e4, 2e4, 5e4, 1e5, 2e5, 5e5, 1e6)"
    print "set ytics 1e-18, " (y0 < 1e-8 ? "100" : "10") ", 1"
    printf "set lmargin at screen %g\nset rmargin at screen %g\nset bmargin at screen %g\nset tmargin at screen %g\n",
        left / width, 1 - right / width, bottom / height, 1 - top / height
    printf "set xrange [%g:%g]\nset yrange [%g:%g]\n", x0, x1, y0, y1
    clock["chain"] = "dependent calls"; clock["scalar"] = "independent calls"; clock["batch"] = "over arrays"
    printf "set xlabel 'nanoseconds a search, %s' offset 0,0.3\n", clock[mode]
    printf "set ylabel '%s' offset 0.5,0\n", error != "" ? error : \
        (norm == "p99" ? "99 %" : norm) " error, the larger of xi and eta"
    heading(1000, narrow ? 12 : 15, "#000000", 20, scene ", " mode ": " (norm == "p99" ? "99 %" : norm) " error against time")
    told = sample " samples; " machine (median() > 0 ? sprintf("; noise %.1f %%", 100 * median()) : "")
    signs = "filled: footpoint,  open: " (others != "" ? others : "by hand or fitted")
    heading(1001, 11, "#606060", narrow ? 38 : 42, told (narrow ? "" : ";  " signs))
    if (narrow) heading(1002, 11, "#606060", 54, signs)
    for (i = 1; i <= n; i++) if (ours[i]) label(i)
    for (i = 1; i <= n; i++) if (!ours[i] && front[i]) label(i)
    for (i = 1; i <= n; i++) if (!ours[i] && !front[i] && !truncated(i)) label(i)
    print "$stairs << END\n" stairs "END\n$rivals << END"
    for (i = 1; i <= n; i++) if (!ours[i]) print x[i], y[i]
    print "END\n$ours << END"
    for (i = 1; i <= n; i++) if (ours[i]) print x[i], y[i]
    print "END"
    for (k = 0; k < (narrow ? 1 : 2); k++) {
        printf "set terminal %s size %d,%d font 'sans,12' background '#ffffff'\n", k ? "pngcairo" : "svg", width, height
        printf "set output '%s.%s'\n", out, k ? "png" : "svg"
        print "plot $rivals with points pt 6 ps 0.9 lw 1 lc rgb '#808080'" \
            (count ? ", $stairs with steps lw 1 lc rgb '#000000'" : "") \
            (count ? ", $ours with points pt 5 ps 1.1 lc rgb '#000000'" : "")
    }
}
