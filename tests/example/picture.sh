#!/bin/sh
# picture.sh FOLDER: what the example does as a picture, FOLDER/impact.svg, with the data that it is made of: energies
# of both worlds over time, and what local search of a pair takes with each function of the header.
here=$(dirname "$0") folder=$1 CC=${CC:-gcc}
[ -d "$folder" ] || { echo 'usage: picture.sh FOLDER' >&2; exit 2; }
: > "$folder/times.txt"
for function in fast coarse medium balanced precise accurate; do
    $CC -O3 -march=native -DHEADER='"../../generated/footpoint_quad4.h"' -DLOCATE=footpoint_quad4_${function}_n \
        "$here/impact.c" -o "$folder/impact" -lm && "$folder/impact" 0.5 "$folder" > "$folder/$function.txt" || exit 3
    awk -v f=$function '/^local search, ns/ { newton = $(NF - 3); ns = $(NF - 2) } /^xi, eta .*mean/ { mean = $NF }
        END { print newton > "/dev/stderr"; print f, ns, mean }' "$folder/$function.txt" >> "$folder/times.txt" \
        2>> "$folder/newton.txt"
done
sort -n "$folder/newton.txt" |
    awk '{ ns[NR] = $1 } END { print "Newton", ns[int((NR + 1) / 2)], 0 }' > "$folder/all.txt"
cat "$folder/times.txt" >> "$folder/all.txt"
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
set yrange [0:105]
set style fill solid 0.8
set boxwidth 0.6
unset key
set xtics rotate by -25
label(e) = e > 0 ? sprintf('%.0e', e) : 'reference'
plot '$folder/all.txt' using 0:2:(\$0 == 0 ? 0x999999 : 0x1f6fb4):xtic(1) with boxes lc rgb variable notitle, \
     '$folder/all.txt' using 0:2:(sprintf('%.1f', \$2)) with labels offset 0,0.6 notitle, \
     '$folder/all.txt' using 0:2:(label(\$3)) with labels offset 0,1.7 tc rgb '#666666' font ',11' notitle
PLOT
