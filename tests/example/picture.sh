#!/bin/sh
# picture.sh FOLDER [slide]: draws the examples' results, with their data. FOLDER/impact.svg: energies of both worlds
# over time, and the time of local search per pair for each function of the header. FOLDER/slide.svg, or only this one:
# contact forces over the distance slid.
here=$(dirname "$0") folder=$1 CC=${CC:-gcc}
[ -d "$folder" ] || { echo 'usage: picture.sh FOLDER [slide]' >&2; exit 2; }
$CC -O3 -march=native "$here/slide.c" "$here/../../runtime/geometry/gregory.c" "$here/../../runtime/geometry/bezier.c" \
    "$here/../../runtime/geometry/node_normals.c" -o "$folder/slide" -lm &&
    "$folder/slide" 1 "$folder" > "$folder/slide.txt" || exit 3
gnuplot << PLOT || exit 3
set terminal svg size 1000,430 font 'sans,13' background rgb 'white'
set output '$folder/slide.svg'
set datafile separator ','
set multiplot layout 1,2
set grid lc rgb '#dddddd' lt 1
set xlabel 'distance slid, mm'
set xrange [4:16]
file = '$folder/slide.csv'
set title 'a block slides over a coarse drum: normal force, N'
set yrange [0:200]
set key at graph 0.98, 0.30
plot file every 6 using 1:2 with lines lw 1.5 lc rgb '#d1495b' title 'facets', \
     file every 6 using 1:4 with lines lw 2 lc rgb '#1f6fb4' title 'Gregory patches, normals (44)', \
     file every 6 using 1:6 with lines lw 2 lc rgb '#2a9d4a' title 'Gregory patches, even normals', \
     file every 6 using 1:8 with lines lw 1 lc rgb '#000000' title 'the round body itself'
set title 'tangential force, N'
set yrange [*:*]
unset key
plot file every 6 using 1:3 with lines lw 1.5 lc rgb '#d1495b', \
     file every 6 using 1:5 with lines lw 2 lc rgb '#1f6fb4', \
     file every 6 using 1:7 with lines lw 2 lc rgb '#2a9d4a', \
     file every 6 using 1:9 with lines lw 1 lc rgb '#000000'
PLOT
[ "$2" = slide ] && exit
: > "$folder/times.txt"
for function in fast coarse medium balanced precise accurate; do
    $CC -O3 -march=native -DHEADER='"../../generated/footpoint_quad4.h"' -DLOCATE=footpoint_quad4_$function \
        "$here/impact.c" -o "$folder/impact" -lm &&
        "$folder/impact" 0.5 "$folder" > "$folder/$function.txt" || exit 3
    awk -v f=$function '/one at a time/ { one[1] = $(NF - 3); one[2] = $(NF - 2) }
        /over arrays/ { all[1] = $(NF - 3); all[2] = $(NF - 2) } /^xi, eta .*mean/ { mean = $NF }
        END { print one[1], all[1] > "/dev/stderr"; print f, one[2], all[2], mean }' "$folder/$function.txt" \
        >> "$folder/times.txt" 2>> "$folder/newton.txt"
done
{
    awk '{ if (NR == 1 || $1 < one) one = $1; if (NR == 1 || $2 < all) all = $2 } END { print "Newton", one, all, 0 }' \
        "$folder/newton.txt"
    cat "$folder/times.txt"
} > "$folder/all.txt"
rm "$folder/newton.txt"
gnuplot << PLOT
set terminal svg size 1000,430 font 'sans,13' background rgb 'white'
set output '$folder/impact.svg'
set datafile separator ','
set multiplot layout 1,2
set grid lc rgb '#dddddd' lt 1
set title 'two plates collide: energies, N mm'
set xlabel 'time, µs'
set xrange [0:30]
set yrange [0:1400]
set key at graph 0.98, 0.62
file = '$folder/energy.csv'
every_10 = 10
plot file using (1e3 * \$1):(\$2 + \$3 + \$4) with lines lw 2 lc rgb '#000000' title 'sum', \
     file using (1e3 * \$1):2 with lines lw 2 lc rgb '#1f6fb4' title 'kinetic', \
     file using (1e3 * \$1):3 with lines lw 2 lc rgb '#2a9d4a' title 'strain', \
     file using (1e3 * \$1):4 with lines lw 2 lc rgb '#d1495b' title 'contact', \
     file every every_10 using (1e3 * \$1):(\$6 + \$7 + \$8) with points pt 6 ps 0.7 lc rgb '#000000' notitle, \
     file every every_10 using (1e3 * \$1):6 with points pt 6 ps 0.7 lc rgb '#1f6fb4' notitle, \
     file every every_10 using (1e3 * \$1):7 with points pt 6 ps 0.7 lc rgb '#2a9d4a' notitle, \
     file every every_10 using (1e3 * \$1):8 with points pt 6 ps 0.7 lc rgb '#d1495b' title 'circles: by footpoint'
set datafile separator whitespace
set title 'local search of a pair, ns, and mean error of xi and eta'
unset xlabel
set xrange [*:*]
set yrange [1:500]
set logscale y
set style fill solid 0.8
set boxwidth 0.38
set key at graph 0.98, 0.98
set xtics rotate by -25
label(e) = e > 0 ? sprintf('%.0e', e) : 'reference'
plot '$folder/all.txt' using (\$0 - 0.2):2 with boxes lc rgb 0x1f6fb4 title 'one at a time', \
     '$folder/all.txt' using (\$0 + 0.2):3 with boxes lc rgb 0x2a9d4a title 'over arrays (Newton: a block steps together)', \
     '$folder/all.txt' using 0:(1):xtic(1) with points pt 0 notitle, \
     '$folder/all.txt' using (\$0 - 0.2):2:(sprintf('%.0f', \$2)) with labels offset 0,0.6 font ',10' notitle, \
     '$folder/all.txt' using (\$0 + 0.2):3:(sprintf('%.1f', \$3)) with labels offset 0,0.6 font ',10' notitle, \
     '$folder/all.txt' using 0:2:(label(\$4)) with labels offset 0,1.7 tc rgb '#666666' font ',10' notitle
PLOT
