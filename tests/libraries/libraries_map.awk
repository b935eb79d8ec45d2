# Draws the shares of wrong answers as SVG, from the output of libraries_main: a row for each search on one kind of
# face, ordered by time on ordinary faces; a column for each family. A cell contains the percentage of cases without a
# right answer; its shade shows how many of them are wrong without a status.
#     awk -f libraries_map.awk -v kind=quad4 rivals.csv > FILE.svg
BEGIN { FS = ","; left = 300; wide = 74; high = 22; top = 64 }
$1 == "family" && $3 == kind {
    row = $4 " " $5
    if (!(row in rows)) { rows[row] = ++n; name[n] = row; ours[n] = $4 == "footpoint" }
    if (!($2 in columns)) { columns[$2] = ++m; family[m] = $2 }
    v = $9 + $10 + $11 + $12 + $13
    r = rows[row]; c = columns[$2]
    if (v > 0) {
        cell[r, c] = 100 * (v - $9) / v
        silent[r, c] = $10 / v
        endless[r, c] = 100 * $12 / v
    }
    if ($2 == "ordinary" || !(r in time)) time[r] = $7 == "inf" ? 1e30 : $7 + 0
}
function text(x, y, s, anchor, more) {
    gsub(/&/, "\\&amp;", s)
    printf "<text x=\"%g\" y=\"%g\" text-anchor=\"%s\"%s>%s</text>\n", x, y, anchor, more, s
}
function shade(part,    g) { g = 255 - 170 * part; return sprintf("rgb(255,%d,%d)", g, g) }
END {
    width = left + 70 + m * wide + 10; height = top + n * high + 34
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\"", width, height
    printf " viewBox=\"0 0 %d %d\"", width, height
    print " font-family=\"sans-serif\" font-size=\"12\"><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
    text(10, 22, kind ": no right answer, % of the cases", "start", " font-size=\"15\"")
    text(left + 58, top - 8, "ns", "end", "")
    for (c = 1; c <= m; c++) text(left + 70 + (c - 0.5) * wide, top - 8, family[c], "middle", "")
    for (i = 1; i <= n; i++) {
        for (j = i; j > 1 && time[at[j - 1]] > time[i]; j--) at[j] = at[j - 1]
        at[j] = i
    }
    for (k = 1; k <= n; k++) {
        r = at[k]; y = top + (k - 1) * high
        weight = ours[r] ? " font-weight=\"bold\"" : ""
        text(left - 6, y + 15, name[r], "end", weight)
        text(left + 58, y + 15, time[r] < 1e30 ? sprintf("%.0f", time[r]) : "", "end", weight)
        for (c = 1; c <= m; c++) {
            if (!((r, c) in cell)) continue
            printf "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\"", left + 70 + (c - 1) * wide, y, wide, high
            printf " fill=\"%s\" stroke=\"#ccc\" stroke-width=\"0.5\"/>\n", shade(silent[r, c])
            text(left + 70 + (c - 0.5) * wide, y + 15, (cell[r, c] == 0 ? "0" : sprintf("%.1f", cell[r, c])) \
                (endless[r, c] ? sprintf(" (%.1f)", endless[r, c]) : ""), "middle", "")
        }
    }
    text(10, height - 12, "red: wrong without saying so; in brackets: never done", "start", " fill=\"#606060\"")
    print "</svg>"
}
