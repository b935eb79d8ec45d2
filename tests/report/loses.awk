# Where hand-written methods beat ours, as HTML: a row a scene, from what front.awk prints.
#     awk -f loses.awk front.txt
BEGIN {
    FS = ", "
    modes = split("chain scalar batch", mode, " ")
}
$2 ~ /^mean: / {
    split($1, key, " ")
    sub(/^mean: /, "", $2)
    if (!seen[key[1]]++) scene[++scenes] = key[1]
    if (!count[key[1], key[3]]++ || $3 + 0 < least[key[1], key[3]]) {
        least[key[1], key[3]] = $3 + 0
        quickest[key[1], key[3]] = $2
    }
}
END {
    print "<h2 id=\"loses\">Where footpoint loses</h2>"
    if (!scenes) print "<p>No hand-written method lies below our front in this run.</p>"
    if (!scenes) exit
    print "<p>Hand-written methods below our front: no function of ours is as accurate (mean error) and, but for the noise, as fast."
    print "Each cell has their number, over all questions, and the quickest.</p>"
    print "<div class=wide><table class=words><tr><th>scene</th><th>dependent calls</th><th>independent calls</th><th>arrays</th></tr>"
    for (s = 1; s <= scenes; s++) {
        printf "<tr><td><a href=\"#%s\">%s</a></td>", scene[s], scene[s]
        for (m = 1; m <= modes; m++) {
            k = scene[s] SUBSEP mode[m]
            if (count[k]) printf "<td>%d: <code>%s</code></td>", count[k], quickest[k]
            else printf "<td>none</td>"
        }
        print "</tr>"
    }
    print "</table></div>"
}
