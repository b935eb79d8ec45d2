# page.sh: makes the tables, figures and CSV files of $folder/index.html from the runs in $runs. tests/paper/paper.sh
# calls it with its variables. All figures are computed, except the paper's, which are marked.
page=$folder/index.html
here=tests/paper

errors_of() { # errors_of PREFIX FILE
    awk -v prefix="$1" -f $here/figures.awk "$2"
}

# table FILE.csv: as HTML.
table() {
    echo "<table>"
    awk -F, '{ c = NR == 1 ? "th" : "td"; printf "<tr>"; for (i = 1; i <= NF; i++) printf "<%s>%s</%s>", c, $i, c
               print "</tr>" }' "$folder/$1.csv"
    echo "</table><p><a href=\"$1.csv\">$1.csv</a></p>"
}

section() { # section NAME TITLE TEXT: the table NAME.csv and, if there is one, the picture NAME.svg
    echo "<h2>$2</h2><p>$3</p>"
    [ ! -e "$folder/$1.svg" ] || echo "<img src=\"$1.svg\" alt=\"$2\">"
    table "$1"
}

# plot NAME XLABEL YLABEL COMMANDS: gnuplot's commands may read $folder/NAME.csv.
plot() {
    gnuplot << END || exit 3
set terminal svg size 760,480 font "sans,12" background "white"
set output "$folder/$1.svg"
set datafile separator ","
set xlabel "$2"
set ylabel "$3"
set grid
set key outside below
$4
END
}

# lines FILE KEY-COLUMN X Y DEVIATION: a curve with error bars for each value of the key column.
lines() {
    printf 'plot '
    awk -F, -v k="$2" 'NR > 1 && !seen[$k]++ { print $k }' "$folder/$1.csv" | while read -r key; do
        echo "\"< awk -F, '\$$2 == \\\"$key\\\"' $folder/$1.csv\" using $3:$4:$5 with yerrorlines title \"$key\", \\"
    done
    echo '1/0 notitle'
}

# ---- Tables 1 to 3 --------------------------------------------------------------------------------------------------

{
    echo "expression (paper),linear GP (paper),genome text,read back by footpoint-codegen"
    "$BIN/footpoint-codegen" --language infix $here/table1.gen -o "$runs/table1.txt"
    awk -F ' = ' 'FNR == NR { if (/^f = /) { n++; genome[n] = $2 } next }
         / = / { k++; print name[k] "," form[k] "," genome[k] "," $2 }
         BEGIN { split("x+3y|y(3+x)|3xy+x", name, "|"); split("+x*3y|*y+3x|+*3*xyx", form, "|") }' \
        $here/table1.gen "$runs/table1.txt"
} > "$folder/table1.csv"

awk -f $here/perfect.awk > "$folder/table2.csv"

# All p-GA polynomials: method,seed,genome,output,terms,training,heldout,heldout_random
for seed in $seeds; do
    errors_of "p-GA,$seed" "$runs/pga-$seed.gen"
    errors_of "with exchanges and mean-error coefficients,$seed" "$runs/beyond-$seed.gen"
done > "$folder/pga.csv"
errors_of 'equations (41) and (42),-' "$runs/ten.gen" >> "$folder/pga.csv"

bench() { # bench SAMPLE COLUMNS [METHOD]
    awk -v sample="$1" -v columns="$2" -v method="$3" -f $here/pick.awk "$runs/bench.csv"
}
first_seed=${seeds%% *}
count_genome() { # count_genome RUN GENOME: a row of compare.csv, without a time
    awk -v only="$2" '/^genome / { skip = $2 != only } { if (!skip) print } /^end/ { skip = 0 }' "$runs/$1.gen" \
        > "$runs/one.gen"
    case $1 in beyond*) kind='p-GA with exchanges' ;; *) kind=p-GA ;; esac
    echo "$kind: $2,$("$BIN/footpoint-codegen" --count --allow-poles --effort 50 "$runs/one.gen" |
        awk -F, 'NR == 2 { print $2 "," $3 "," $4 "," $5 }'),,$(errors_of - "$runs/one.gen" | awk -F, '
            { held[$3] = $6; off[$3] = $7 }
            END { print held["xi"] ",," held["eta"] ",," off["xi"] "," off["eta"] }')"
}
area() { bench grid "$1" area; }
best() { # best METHOD GENOME OUTPUT COLUMN: of the run of least error on the training samples
    awk -F, -v m="$1" -v g="$2" -v o="$3" -v c="$4" '$1 == m && $3 == g && $4 == o && (!n++ || $6 + 0 < least) {
        least = $6 + 0; v = $c } END { print v }' "$folder/pga.csv"
}
error_and_terms() { # error_and_terms METHOD GENOME: of xi and eta
    echo "$(best "$1" "$2" xi 7),$(best "$1" "$2" xi 5),$(best "$1" "$2" eta 7),$(best "$1" "$2" eta 5)"
}
errors() { # errors METHOD GENOME: of xi and eta
    echo "$(best "$1" "$2" xi 7),$(best "$1" "$2" eta 7)"
}
beyond='with exchanges and mean-error coefficients'
{
    echo "method,xi,terms,eta,terms"
    echo "p-GA (paper),0.017445,124,0.022610,129"
    echo "p-GA: best of the seeds; held out,$(error_and_terms p-GA pga_0)"
    echo "$beyond,$(error_and_terms "$beyond" pga_124)"
    echo "area coordinates (paper),0.2361,,0.2174,"
    echo "area coordinates; held out,$(area mean_xi),,$(area mean_eta),"
} > "$folder/table3.csv"
within=$(awk -F, -v m="$beyond" '$1 == m {
    print $2 <= 0.0174 && $3 <= 124 && $4 <= 0.0226 && $5 <= 129 ? "are within" : "are NOT within" }' \
    "$folder/table3.csv")

for seed in $seeds; do
    awk -v seed="$seed" '
        /^genome / { n = $2; sub("pga_", "", n) }
        /^note terms_/ { print (n == 0 ? "all" : n) "," seed "," substr($2, 7) "," $3 "," $5 "," $7 }' \
        "$runs/pga-$seed.gen"
done | { echo "N,seed,output,terms,condition,dependent"; cat; } > "$folder/condition.csv"

# ---- Figure 7, the ten-term polynomials, the count of the whole process ---------------------------------------------

awk -F, '$1 != "equations (41) and (42)" { print $1 " " $4 "," $3 "," $7 }' "$folder/pga.csv" |
    sed 's/,pga_0,/,pga_165,/; s/,pga_/,/' |
    awk -v head="method and output,N" -f $here/spread.awk > "$folder/figure7.csv"
plot figure7 "N, terms at most" "mean error, held out" "set yrange [0:1e-6<*]
$(lines figure7 1 2 3 4)"

# mul and div of a genome file's first genome, by footpoint-codegen, in the paper's count: whole, or in the eight inputs
count_whole() {
    "$BIN/footpoint-codegen" --count --cost paper --allow-poles "$1" | awk -F, 'NR == 2 { print $2 "," $3 "," $5 }'
}
awk -f $here/bare.awk "$runs/ten.gen" > "$runs/ten.bare"
{
    echo "what,multiplications,divisions,roots,error of xi,error of eta"
    echo "(41) and (42) together (paper),24,,,,"
    echo "(41) and (42) together,$(count_whole "$runs/ten.bare"),$(errors 'equations (41) and (42)' ten_terms)"
    echo "whole process with preprocessing (paper),about 100,,,,"
    echo "whole process with preprocessing,$(count_whole "$runs/ten.gen"),,"
    echo "area coordinates (paper),about 50,,,0.2361,0.2174"
    echo "area coordinates,$(area mul,div,sqrt,mean_xi,mean_eta)"
    echo "p-GA's own ten terms; best of the seeds,,,,$(errors p-GA pga_10)"
    echo "... $beyond,,,,$(errors "$beyond" pga_10)"
} > "$folder/counts.csv"

# ---- the methods that the paper compares with -----------------------------------------------------------------------

# Searches of the bench in its order; of the unrolled iterations two steps and three.
{
    echo "method,mul,div,add,sqrt,ns a search,error of xi,99 %,error of eta,99 %,off the lattice: xi,eta"
    bench random mean_xi,mean_eta > "$runs/off"
    bench grid method,mul,div,add,sqrt,ns,mean_xi,p99_xi,mean_eta,p99_eta | paste -d, - "$runs/off" |
        grep -E '^(newton|gn[23]_centre|area|pinball|perceptron_[a-z0-9_]*|footpoint_[a-z0-9_]*),' |
        sed 's/^gn\([23]\)_centre/Gauss-Newton; \1 steps/; s/^newton/Newton; converged/
             s/^area/area coordinates/; s/,nan/,/g'
    for polynomial in "pga-$first_seed pga_0" "beyond-$first_seed pga_124" "beyond-$first_seed pga_10"; do
        count_genome $polynomial
    done
} > "$folder/compare.csv"

cp "$runs/contact.csv" "$folder/contact.csv"

checks=$(awk '/^ok/ { n++ } /^not ok/ { bad++ } END { print n + 0 " checks pass, " bad + 0 " fail" }' \
    "$runs/calibration.tap")
errors_of perceptron "$runs/perceptron.gen" |
    awk -F, 'BEGIN { print "network,output,weights,training,held out,off the lattice" }
             { print $2 "," $3 "," $4 "," $5 "," $6 "," $7 }' > "$folder/perceptron.csv"
cmp -s "$runs/perceptron.gen" $here/perceptron.gen && same_networks='byte for byte' || same_networks=NOT

# ---- pd-LinearGP: Figures 10 to 13, and the front of multiplications against error ----------------------------------

for count in $groups; do
    for seed in $seeds; do
        errors_of "$count,$seed" "$runs/groups-$count-$seed.gen"
    done
done | awk -F, '$4 == "xi" { sub("poly", "", $3); print $3 "," $1 "," $7 }' |
    sort -s -t, -k1,1n |
    awk -v head="MaxGeneLength,groups" -f $here/spread.awk > "$folder/figure10.csv"
plot figure10 groups "mean of the runs' errors" "set xrange [0:22]
$(lines figure10 1 2 3 4)"
cp "$folder/figure10.csv" "$folder/figure11.csv"
plot figure11 groups "least of the runs' errors" "set xrange [0:22]
$(lines figure11 1 2 5 '(0)')"

# functions,length,seed,error of xi,mul,div as bred
for seed in $seeds; do
    awk -f $here/operators.awk "$runs/lengths-$seed.gen" > "$runs/operators"
    errors_of "$seed" "$runs/lengths-$seed.gen" | awk -F, '
        FNR == NR { ops[$1] = $2 "," $3; next }
        $3 == "xi" { kind = substr($2, 1, 4) == "poly" ? "polynomial" : "rational"
                     print kind "," substr($2, 5) "," $1 "," $6 "," ops[$2] }' "$runs/operators" -
done > "$folder/lengths.csv"
for figure in 12,polynomial 13,rational; do
    number=${figure%,*} functions=${figure#*,}
    awk -F, -v f="$functions" '$1 == f { print $2 "," $4 }' "$folder/lengths.csv" |
        awk -v head="MaxGeneLength" -f $here/spread.awk > "$runs/a.csv"
    awk -F, -v f="$functions" '$1 == f { print $2 "," $5 + $6 }' "$folder/lengths.csv" |
        awk -v head="MaxGeneLength" -f $here/spread.awk | cut -d, -f2-4 > "$runs/b.csv"
    sed -i '1s/.*/operations: mean,deviation,least/' "$runs/b.csv" # after the error's mean,deviation,least,runs
    awk -F, 'FNR == NR { b[FNR] = $0; next } { print $0 "," b[FNR] }' "$runs/b.csv" "$runs/a.csv" \
        > "$folder/figure$number.csv"
    plot "figure$number" MaxGeneLength "mean error of xi, held out" "set y2label 'multiplications and divisions as bred'
set ytics nomirror; set y2tics; set yrange [0:1e-6<*]; set y2range [0:]; set xrange [30:270]
plot '$folder/figure$number.csv' every ::1 using 1:2:3 with yerrorlines title 'error, mean', \\
     '' every ::1 using 1:4 with points title 'least', \\
     '' every ::1 using 1:6:7 axes x1y2 with yerrorlines title 'operations'"
done

# method,mul+div for xi from the eight inputs,heldout error of xi
for seed in $seeds; do
    for kind in pga beyond; do
        awk -v only=xi -f $here/bare.awk "$runs/$kind-$seed.gen" > "$runs/bare.gen"
        errors_of "$seed" "$runs/$kind-$seed.gen" | awk -F, '$3 == "xi" { print $2 "," $6 }' > "$runs/errors"
        "$BIN/footpoint-codegen" --count --cost paper --effort 50 "$runs/bare.gen" |
            awk -F, -v name="$([ $kind = pga ] && echo p-GA || echo p-GA with exchanges)" '
            FNR == NR { error[$1] = $2; next }
            FNR > 1 { print name "," $2 + $3 "," error[$1] }' "$runs/errors" -
    done
    awk -f $here/bare.awk "$runs/front-$seed.members" > "$runs/bare.gen"
    "$BIN/footpoint-codegen" --count --cost paper --effort 50 "$runs/bare.gen" | awk -F, '
        FNR == NR { error[sprintf("%s_%s_c%.0f", $1, $2, $3)] = $11; next }
        FNR > 1 && $1 in error { print "programs," ($2 + $3) / 2 "," error[$1] }' "$runs/front-$seed.judged.csv" -
done | { echo "method,multiplications and divisions,heldout error of xi"; cat; } > "$folder/front.csv"
awk -v only=xi -f $here/bare.awk "$runs/perceptron.gen" > "$runs/bare.gen"
"$BIN/footpoint-codegen" --count --cost paper --allow-poles "$runs/bare.gen" |
    awk -F, 'FNR == NR { if ($2 == "xi") error[$1] = $5; next }
             FNR > 1 { print "perceptron," $2 + $3 + $5 "," error[$1] }' "$folder/perceptron.csv" - \
        >> "$folder/front.csv"
awk -F, '{ print "pd-LinearGP " $1 "," $5 + $6 "," $4 }' "$folder/lengths.csv" >> "$folder/front.csv"
plot front "multiplications and divisions for xi, from the eight inputs" "mean error of xi, held out" "set logscale xy
set xrange [2:600]; set yrange [0.004:0.4]
plot $(cut -d, -f1 "$folder/front.csv" | sed 1d | sort -u | while read -r m; do
    printf '%s' "\"< awk -F, '\$1 == \\\"$m\\\"' $folder/front.csv\" using 2:3 with points title \"$m\", "
done) 1/0 notitle"

# ---- times: Figures 8, 9, 14 ----------------------------------------------------------------------------------------

awk -F, 'NR == 1 { print $0 ",speed-up"; next } NR == 2 { one = $2 } { printf "%s,%.2f\n", $0, one / $2 }' \
    "$runs/time-pga.csv" > "$folder/figure8.csv"
plot figure8 ranks "speed-up" "set xrange [0:]; set yrange [0:1e-6<*]
plot '$folder/figure8.csv' every ::1 using 1:3 with linespoints title 'measured', x title 'ideal'"
awk -F, 'NR == 1 { print $0 ",seconds x ranks / groups"; next } { printf "%s,%.3f\n", $0, $3 * $2 / $1 }' \
    "$runs/time-groups.csv" > "$folder/figure9.csv"
plot figure9 groups seconds "set yrange [0:1e-6<*]; set xrange [0:22]
plot '$folder/figure9.csv' every ::1 using 1:3 with linespoints title 'elapsed', \\
     '' every ::1 using 1:4 with linespoints title 'elapsed, were there a core for each group'"
cp "$runs/time-lengths.csv" "$folder/figure14.csv"
plot figure14 MaxGeneLength "seconds a generation" "set yrange [0:1e-6<*]; set xrange [0:]
$(lines figure14 1 2 3 '(0)')"

# ---- sixteen inputs: Figures 18 to 20 --------------------------------------------------------------------------------

. $here/sixteen.sh

# ---- the page -------------------------------------------------------------------------------------------------------

{
    cat << END
<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>footpoint: the paper, reproduced</title>
<style>body{font:15px sans-serif;max-width:60em;margin:2em auto;padding:0 1em}table{border-collapse:collapse}
td,th{border:1px solid #bbb;padding:.2em .6em;text-align:right}
td:first-child,th:first-child{text-align:left}img{max-width:100%}</style>
<h1>The paper, reproduced</h1>
<p>Oishi and Yoshimura, "Genetic approaches to iteration-free local contact search", CMES 2008. What is marked
(paper) is the paper's; all else comes from the runs beside this page: seeds $seeds; p-GA $pga_generations
generations of 100, pd-LinearGP $gp_generations (lengths) and $group_generations (groups) generations of 200 a
group; the paper: ten runs of 3000 generations each. Errors are means of |error| on the configurations of the
lattice that no run has seen; the paper's are on the 28546 that chose the expressions. "deviation" is the standard
deviation over seeds. Times are of this machine, on up to $RANKS ranks, and do not repeat; everything else does, to
the byte.</p>
END
    section table1 "Table 1: expressions as linear genomes" "The prefix form is the same; genome text puts
blanks between genes."
    section table2 "Table 2: perfect polynomials in eight variables" "Counted by enumerating the monomials:
exactly the paper's."
    section table3 "Table 3: average error" "The data set is the reading of section 6.1 that tests/evolve/test_calibration.c
checks ($checks); the paper leaves the choice of its 28546 configurations open. The second p-GA exchanges terms by
forward and backward steps, and its coefficients minimise the mean error itself, not its square; its errors and
terms $within the paper's."
    section compare "The methods side by side" "footpoint-bench on the scene paper-quad4, held-out configurations of the
lattice, and in the last two columns random ones off it; from five nodes to xi and eta, the affine preprocessing
included, one call at a time. The paper puts the whole process at about 100 multiplications, twice those of area
coordinates, and gives no times. The pinball test finds no xi and eta; its decisions are in the next table. Networks
learn the lattice better than they learn what lies between its points. p-GA's rows are runs of this page, counted by
footpoint-codegen in its own cost model and not timed; footpoint's three are the generated header's."
    section contact "The pinball test: contact or not" "Exact: the foot point is on the segment and the gap negative.
Every element is taken as deep as the root of the segment's area, as five nodes do not say what stands behind them; two
spheres of the elements' volume stand proud of flat faces by 24 % of that length, which is why it sees contacts too
early, and what most of the error of depth is (relative to the same length). The paper says that it is fast, but has
difficulties in accuracy, and gives no numbers."
    section perceptron "The perceptrons" "Of the authors' earlier (2007) work the paper says that they need many
multiplications and sigmoids, and gives no numbers. Here: one network for xi and eta, trained by GSL's
Levenberg-Marquardt method on the 28546 training configurations; sigmoid s / sqrt(1 + s^2), which is cheaper than the
usual one. Trained again for this page: $same_networks what footpoint-bench has (tests/paper/perceptron.gen)."
    section condition "Conditioning of the least squares (22)" "Condition numbers of the normal equations of the best
polynomials, columns scaled to unit length, and how many of the polynomials that were tried had dependent terms. The
paper says nothing of this."
    section figure7 "Figure 7: error against terms" "The paper's text gives no numbers here, but says that N
&ge; 60 costs little and N &le; 40 much."
    section counts "Equations (41) and (42), and the multiplications of the whole process" "Coefficients
refitted by least squares, as the paper prints none. Counted by footpoint-codegen in the paper's model, where a
product or quotient counts one and a sum nothing."
    section front "Error against multiplications, xi" "What each method finds, in the eight inputs, before
preprocessing; programs are footpoint's own evolution with the paper's inputs and + - *: half of what xi and eta take together, and the mean error of both. Roots count one, too."
    section figure8 "Figure 8: speed-up of p-GA" "The paper has 32 processors; here as many ranks as were given,
both outputs, unrestricted size. Rank 0 breeds and evaluates as well, where the paper's server only breeds."
    section figure9 "Figure 9: elapsed time against groups" "MaxGeneLength 50, $timed_generations generations
(the paper: 500), xi and eta. The paper has a processor for each group; here groups share the ranks, so that the
elapsed time grows with them, and the last column, which the paper's curve shows, stays."
    section figure10 "Figure 10: average error against groups" "Polynomials for xi, errors held out. The paper's text
gives no numbers, but says that the average falls with more groups."
    section figure11 "Figure 11: least error against groups" "The column 'least' is drawn; by the paper it
depends on the groups much less than the average."
    section figure12 "Figure 12: polynomials against MaxGeneLength" "Five groups. The operations are those of
the tree as it was bred."
    section figure13 "Figure 13: rational expressions against MaxGeneLength" "As Figure 12; quotients are
protected. By the paper both kinds are about equally accurate."
    section figure14 "Figure 14: time of a generation against MaxGeneLength" "Processor time of a group of 200
for xi and one for eta. By the paper the time is almost proportional to the length, and rational expressions take
about 20 % more."
    cat << END
<h2>Section 7.2: Gregory patches, sixteen inputs</h2>
<p>The configurations of the first study with random node normals, tangent of their tilt below 0.2; foot points are
those on the patch. The paper makes twenty sets of normals a configuration, 835906 patches in all, and draws 83552 of
them; here two sets a configuration, $sixteen_training patches to breed on, and others, made alike, for the errors.
pd-LinearGP: $sixteen_generations generations (the paper: 3000), five groups. The paper says of its figures, which are
pictures alone, that longer genes bring more operations but little accuracy, that both kinds of expressions are about
equally accurate, and that they take within 50 multiplications and within 100 multiplications and divisions. Operations
are counted from the sixteen inputs, as codegen leaves them; the most that any run here came to are $most_polynomial and
$most_rational.</p>
END
    section figure18 "Figure 18: polynomials against MaxGeneLength, Gregory patches" "All runs: <a
href=\"sixteen.csv\">sixteen.csv</a>."
    section figure19 "Figure 19: rational expressions against MaxGeneLength, Gregory patches" "As Figure 18; quotients
are protected."
    section within "Within 50 multiplications, and within 100 multiplications and divisions" "Of all runs' expressions
that are within these limits, those of least error on the training samples. Programs are footpoint's own evolution with
the same inputs, $sixteen_length operations at most; they make xi and eta together, within twice the limit. Area coordinates and
the foot point on the facet know nothing of normals; they are counted for xi and eta together, with all preprocessing.
Some segments are so bent that the z component of a node normal is about 0; the ratios by it have no bound, and neither
have errors, off the lattice above all."
    section figure20 "Figure 20: time of a generation against MaxGeneLength, sixteen inputs" "As Figure 14, on 6000
samples. By the paper the time is almost proportional to the length."
} > "$page"
