#!/bin/sh
# report.sh FOLDER: makes a page from one run of the bench. First where footpoint loses, an index and the hard cases; then
# the scene quad4 and a description of its pictures; then recorded machines, the searches from the last answer and a key
# to the methods' names; then each scene with pictures of time against error, tables, error maps and the rivals below our
# front. BENCH_OPTIONS, for example "--scene quad4", go to the bench.
folder=$1 BIN=${BIN:-build}
say() { echo "report: $*" >&2; }
rm -rf "$folder" && mkdir -p "$folder/maps" || exit 3
"$BIN/footpoint-bench" --csv --map "$folder/maps" $BENCH_OPTIONS > "$folder/bench.csv" || exit 3
awk -f tests/report/front.awk "$folder/bench.csv" > "$folder/front.txt" || exit 3
say 'hard cases'
work=$folder/work
LIBRARY="$BIN/libfootpoint_ccx.a $BIN/libfootpoint.a"
mkdir "$work" && . tests/hard/build.inc && hard_build "$work/hard" "${CC:-gcc}" -O3 -ffp-contract=off || exit 3
"$work/hard" 100 > "$folder/hard.csv"
hard=$?
[ "$hard" -le 1 ] || exit 3
rm -r "$work"
scenes=$(awk -F, 'NR > 1 && !seen[$1]++ { print $1 }' "$folder/bench.csv")

# image NAME TEXT: a picture, NAME-narrow.svg on a narrow screen if there is one; it scrolls where its smallest letters (10.5 of
# its pixels) would have less than 9
image() {
    least=$(awk 'match($0, /width="[0-9]+/) { print int(substr($0, RSTART + 7) * 9 / 10.5) + 1; exit }' "$folder/$1.svg")
    narrow=
    if [ -e "$folder/$1-narrow.svg" ]; then
        narrow="<source media=\"(max-width: ${least}px)\" srcset=\"$1-narrow.svg\">" least=0
    fi
    echo "<a class=wide href=\"$1.svg\"><picture>$narrow<img style=\"--least: ${least}px\" src=\"$1.svg\" alt=\"$2\"></picture></a>"
}

picture() { # picture SCENE SAMPLE MODE NORM
    name=$1-$2-$3-$4
    for narrow in '' -narrow; do
        awk -f tests/report/picture.awk -v scene="$1" -v sample="$2" -v mode="$3" -v norm="$4" -v out="$folder/$name$narrow" \
            -v narrow="${narrow:+1}" "$folder/bench.csv" | gnuplot || exit 3
    done
    image "$name" "$1, $2, $3: time against error, $4"
}

methods() { # methods SCENE SAMPLE QUESTION TITLE: the table, if there is something in it
    awk -F, -v s="$1" -v sample="$2" -v q="$3" '$1 == s && $2 == sample { for (i = 20; i <= NF; i++) if ($i == q) exit found = 1 }
        END { exit !found }' "$folder/bench.csv" || return 0
    echo "<details><summary>$4</summary><div class=wide>"
    awk -f tests/report/table.awk -v scene="$1" -v sample="$2" -v question="$3" "$folder/bench.csv"
    echo '</div></details>'
}

part() { # part SCENE SAMPLE
    echo "<h3>$2 samples</h3>"
    for norm in mean p99; do
        for mode in chain scalar batch; do
            picture "$1" "$2" $mode $norm
        done
    done
    methods "$1" "$2" bare 'All methods'
    methods "$1" "$2" checked 'Checked, with gap and status'
    methods "$1" "$2" over 'Checked, eight slave nodes over each segment'
    methods "$1" "$2" closest 'The closest point of the closed face, every other slave node beside it'
    methods "$1" "$2" along 'Along a direction'
    methods "$1" "$2" derivatives 'With derivatives by all coordinates; errors are of these'
    for move in 1e-3 1e-2 1e-1; do
        methods "$1" "$2" from_$move "Checked, from an answer $move of the face away"
    done
    echo '<details><summary>'
    grep "^$1 $2 " "$folder/front.txt" | awk 'END { print NR " rivals below the front" }'
    echo '</summary><div class=wide><pre>'
    grep "^$1 $2 " "$folder/front.txt"
    echo '</pre></div></details>'
}

map() { # map SCENE: its searches in the order of the bench
    files=$(awk -F, -v s="$1" -v f="$folder/maps/" '
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
        $1 == s && $at["ours"] == 1 && $at["question"] == "bare" && !seen[$3]++ { print f s "-" $3 ".vtk" }' "$folder/bench.csv")
    [ -n "$files" ] || return 0
    awk -f tests/report/map.awk -v title="$1" -v out="$folder/$1-map" $files > "$folder/map.gp" &&
        gnuplot "$folder/map.gp" && rm "$folder/map.gp" || exit 3
    echo '<h3>Error over the segment</h3>'
    image "$1-map" "$1: map of the error"
    echo '<p>For ParaView, cells with the mean errors and the number of samples:'
    for vtk in $files; do
        echo "<a href=\"maps/${vtk##*/}\">${vtk##*/}</a>"
    done
    echo '</p>'
}

samples_of() { awk -F, -v s="$1" '$1 == s && !seen[$2]++ { print $2 }' "$folder/bench.csv"; }

scene_part() { # scene_part SCENE
    say "pictures of $1"
    echo "<h2 id=\"$1\">$1</h2>"
    for sample in $(samples_of "$1"); do
        part "$1" "$sample"
    done
    map "$1"
}

# The names of the methods, from the table in methods.md.
names() {
    echo '<div class=wide><table class=words>'
    awk -F ' *[|] *' '/^\| method \|/ { on = 1 } on && !/^\|/ { exit }
        on && !/^\|--/ { gsub(/`[^`]*`/, "<code>&</code>"); gsub(/`/, ""); print "<tr><td>" $2 "</td><td>" $3 "</td></tr>" }' \
        tests/report/methods.md
    echo '</table></div>'
}

first=$(echo "$scenes" | grep -x quad4 || echo "$scenes" | head -n 1)
sample=$(samples_of "$first" | tail -n 1)
{
    cat << END
<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>footpoint: time against error</title>
<style>
body { font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 1400px; padding: 0 1em; color: #222; overflow-wrap: anywhere }
img { min-width: var(--least); max-width: 100% } a.wide { display: block } pre { font-size: 12px } summary { cursor: pointer; margin: .4em 0 } .wide { overflow-x: auto; overflow-wrap: normal }
table { border-collapse: collapse; font-size: 12px }
td, th { padding: 1px 7px; text-align: right; border-bottom: 1px solid #eee }
td:first-child, th:first-child, .words td, .words th { text-align: left } .ours td { font-weight: bold; background: #f3f3f3 }
</style>
<h1>Time against error</h1>
END
    awk -f tests/report/loses.awk "$folder/front.txt"
    echo '<p>Contents: <a href="#hard">hard cases</a>, <a href="#times">times</a>, <a href="#machines">machines</a>,'
    echo '<a href="#last">from the last answer</a>, <a href="#names">names</a>; the scenes'
    for scene in $scenes; do
        echo "<a href=\"#$scene\">$scene</a>"
    done
    cat << END
</p>
<h2 id="hard">Hard cases</h2>
<p>Families of segments and slave nodes on which searches fail, against the truth in extended precision. Wrong: an answer
too far off without a status, or a status that is not true. Certified functions, in bold, must never be wrong, and
$([ "$hard" = 0 ] && echo 'none was' || echo '<b>one was</b>') (<a href="hard.csv">hard.csv</a>): <code>header</code> is
footpoint_quad4_accurate, <code>float</code> its like in single precision; locate, robust and stationary are the library's. The
bare expression (footpoint_quad4_accurate_at), Newton's iteration and the trust region promise nothing.</p>
END
    awk -f tests/report/hard.awk "$folder/hard.csv"
    echo "<h2 id=\"times\">Time against error: $first</h2>"
    picture "$first" "$sample" chain mean
    picture "$first" "$sample" scalar mean
    picture "$first" "$sample" batch mean
    awk -f tests/report/says.awk -v scene="$first" -v sample="$sample" "$folder/bench.csv"
    cat << END
<p>One run, all methods in turn on the same held-out samples, all compiled alike:
$(awk -F, 'NR == 2 { print $(NF) ", " $(NF - 1) }' "$folder/bench.csv"). <a href="bench.csv">bench.csv</a> holds all.
Times are medians of the turns, in processor time, by three clocks: in dependent calls (mode chain) each search waits for
the one before; independent calls (scalar) overlap in the processor; arrays (batch) are loops over columns. The noise of a method is half of the interquartile range of its ratio
to Newton, converged or fair, the quicker, asked the same, over the rounds, relative to the median; a picture states the median of its methods' noises. Errors
are the larger of those of xi and eta, against the certain foot point; gaps and distances are over the square root of the
segment's area. <b>$(tail -n 1 "$folder/front.txt")</b>, over all scenes, samples, modes and both norms: faster than any function of
ours that is as accurate, by more than the noise of the two (<a href="front.txt">front.txt</a>).</p>
<h2 id="machines">Machines</h2>
<p>Functions with gap, status and proof, recorded by <code>make bench-record</code>: the time of the faster of two Newton iterations,
which prove nothing, over ours; for closest points, of four triangles around the centroid. Below 1, in bold, footpoint loses.</p>
END
    for machine in tests/report/machines/*.csv; do
        awk -f tests/report/recorded.awk -f tests/report/machines.awk "$machine"
    done
    awk -f tests/report/from_last.awk "$folder/bench.csv"
    echo '<h2 id="names">Names of the methods</h2>'
    names
    scene_part "$first"
    for scene in $scenes; do
        [ "$scene" = "$first" ] || scene_part "$scene"
    done
} > "$folder/index.html" || exit 3
tail -n 1 "$folder/front.txt"
echo "$folder/index.html"
