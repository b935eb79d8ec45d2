#!/bin/sh
# report.sh FOLDER: one bench run as CSV, and of each scene, sample and mode a picture of time against mean error.
folder=$1 BIN=${BIN:-build}
mkdir -p "$folder" && "$BIN/footpoint-bench" --csv > "$folder/bench.csv" || exit 3
{
    echo '<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>footpoint: time against error</title>'
    echo '<h1>Time against error</h1><p>One run, all methods in turn on the same held-out samples:'
    echo '<a href="bench.csv">bench.csv</a>. Filled: ours. Open: methods written by hand.</p>'
} > "$folder/index.html"
for picture in $(awk -F, 'NR > 1 { print $1 "," $2 "," $5 }' "$folder/bench.csv" | uniq | sort -u); do
    scene=${picture%%,*} rest=${picture#*,}
    sample=${rest%,*} mode=${rest#*,}
    awk -F, -v s="$scene" -v p="$sample" -v m="$mode" '$1 == s && $2 == p && $5 == m && $12 > 1e-17 && $12 < 1 {
        print $3, $4, $10, ($12 + $15) / 2 }' "$folder/bench.csv" > "$folder/points"
    gnuplot << END || exit 3
set terminal svg size 900,600 font "sans,12" background "white"
set output "$folder/$scene-$sample-$mode.svg"
set logscale xy
set format y "10^{%L}"
set title "$scene, $sample samples, $mode" noenhanced
set xlabel "ns a search"
set ylabel "mean error of xi and eta"
set grid
set xrange [3:100]
set key bottom left
plot "$folder/points" using (\$2 == 0 ? \$3 : 1/0):4 with points pt 6 ps 1 title "by hand", \
     "" using (\$2 == 1 ? \$3 : 1/0):4 with points pt 5 ps 1.2 title "footpoint", \
     "" using 3:4:1 with labels offset 1,0.6 left font ",9" noenhanced notitle
END
    echo "<img src=\"$scene-$sample-$mode.svg\" alt=\"$scene, $sample, $mode\">" >> "$folder/index.html"
done
rm -f "$folder/points"
echo "$folder/index.html"
