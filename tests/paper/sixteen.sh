# sixteen.sh: the paper's second study, section 7.2, expressions in sixteen inputs on Gregory patches: tables and
# pictures of Figures 18 to 20, and their comparisons. tests/paper/page.sh reads it with its variables and functions.
sixteen='xc yc zc xd yd xs ys zs nxA nyA nxB nyB nxC nyC nxD nyD'
held='mean,99 %,worst,off the lattice: mean,99 %,worst'

# from_inputs FILE [OUTPUT]: the operations of each genome, or of its output, from the sixteen inputs: codegen's table
from_inputs() {
    awk -v only="$2" -v inputs="$sixteen" -f $here/bare.awk "$1" > "$runs/bare.gen"
    from_nodes "$runs/bare.gen"
}
# from_nodes FILE: of the whole genomes, both outputs together
from_nodes() {
    "$BIN/footpoint-codegen" --count --cost paper --allow-poles --effort 50 "$1"
}

# measured PREFIX FILE [OUTPUT] < OPERATIONS: operations and errors of each genome, or of its output, as
# PREFIX,genome,output,mul,div,sqrt,training,mean,p99,worst and the last three off the lattice
measured() {
    cat > "$runs/operations"
    errors_of "$1" "$2" | awk -F, -v only="$3" '
        FNR == NR { operations[$1] = $2 "," $3 "," $5; next }
        only == "" || $3 == only {
            print $1 "," $2 "," $3 "," operations[$2] "," $5 "," $6 "," $8 "," $9 "," $7 "," $10 "," $11
        }' "$runs/operations" -
}

# kind,length: of a tier named poly50, rati50, ...
split_tier() {
    awk -F, -v OFS=, '{ $2 = (substr($2, 1, 4) == "poly" ? "polynomial" : "rational") "," substr($2, 5); print }'
}

for seed in $seeds; do
    for output in xi eta; do
        from_inputs "$runs/sixteen-$seed.gen" $output | measured "$seed" "$runs/sixteen-$seed.gen" $output
    done
done | split_tier > "$folder/sixteen.rows"
{
    echo "seed,functions,MaxGeneLength,output,mul,div,sqrt,training,$held"
    cat "$folder/sixteen.rows"
} > "$folder/sixteen.csv"
# most_of FUNCTIONS: the most operations that any of its runs came to
most_of() {
    awk -F, -v f="$1" '$2 == f && $5 + $6 > most { most = $5 + $6 } END { print most + 0 }' "$folder/sixteen.rows"
}
most_polynomial=$(most_of polynomial) most_rational=$(most_of rational)

# column FUNCTIONS COLUMNS: their sum in the rows of a kind, spread over the seeds
column() {
    awk -F, -v f="$1" -v columns="$2" '
        BEGIN { count = split(columns, c, ",") }
        $2 == f { s = 0; for (i = 1; i <= count; i++) s += $c[i]; print $4 "," $3 "," s }' "$folder/sixteen.rows" |
        sort -s -t, -k1,1r -k2,2n | awk -v head="output,MaxGeneLength" -f $here/spread.awk
}
for figure in 18,polynomial 19,rational; do
    number=${figure%,*} functions=${figure#*,}
    column "$functions" 5,6 | cut -d, -f3-5 | sed '1s/.*/operations: mean,deviation,least/' > "$runs/b.csv"
    column "$functions" 9 | paste -d, - "$runs/b.csv" > "$folder/figure$number.csv"
    plot "figure$number" MaxGeneLength "mean error, held out" "set y2label 'multiplications and divisions'
set ytics nomirror; set y2tics; set yrange [0:1e-6<*]; set y2range [0:]; set xrange [30:270]
$(lines "figure$number" 1 2 3 4), $(lines "figure$number" 1 2 7 8 |
    sed 's/^plot //; s/ with/ axes x1y2 with/; s/title "/&operations, /')"
done
rm "$folder/sixteen.rows"

cp "$runs/time-sixteen.csv" "$folder/figure20.csv"
plot figure20 MaxGeneLength "seconds a generation" "set yrange [0:1e-6<*]; set xrange [0:]
$(lines figure20 1 2 3 '(0)')"

# best_within LIMIT FUNCTIONS OUTPUT < ROWS: of rows functions,output,mul,div,sqrt,training,... that of least error on
# the training samples with so many multiplications and divisions at most
best_within() {
    awk -F, -v limit="$1" -v f="$2" -v o="$3" '
        $1 == f && $2 == o && $3 + $4 <= limit && (!n++ || $6 + 0 < least) { least = $6 + 0; row = $0 }
        END { print row }'
}

cut -d, -f2,4- "$folder/sixteen.csv" > "$runs/gp.rows"
from_inputs "$runs/sixteen-front.members" | awk -F, -v OFS=, '
    FNR == NR { operations[$1] = $2 "," $3 "," $5; next }
    { name = sprintf("%s_%s_c%.0f", $1, $2, $3) }
    name in operations {
        print substr($1, 1, 4) == "poly" ? "polynomial" : "rational", $2, operations[name], $9, $11, $12, $13, $15, $16, $17
    }' - "$runs/sixteen-front.judged.csv" > "$runs/front.rows"
{
    sed 's/^segment \(.*\) any/face \1/' evolve/frames/similarity_gregory.gen
    echo genome inputs
    for input in $sixteen; do echo "of_$input = $input"; done
    echo end
} > "$runs/frame.gen"
{
    echo "method,functions,output,mul,div,sqrt,training,$held"
    echo "(paper),polynomial,xi,within 50,0,0,,,,,,,"
    echo "(paper),rational,xi,within 100,,0,,,,,,,"
    for kind in polynomial,50 rational,100; do
        functions=${kind%,*} limit=${kind#*,}
        for output in xi eta; do
            echo "pd-LinearGP,$(best_within "$limit" "$functions" $output < "$runs/gp.rows")"
        done
        echo "programs,$(best_within $((2 * limit)) "$functions" both < "$runs/front.rows")"
    done
    from_nodes "$runs/sixteen-known.gen" | measured 'known; from the nodes' "$runs/sixteen-known.gen" |
        sed 's/,area,/,area coordinates,/; s/,facet,/,foot point on the facet,/'
    echo "preprocessing; from the nodes,the sixteen inputs,,$(from_nodes "$runs/frame.gen" |
        awk -F, 'NR == 2 { print $2 "," $3 "," $5 }'),,,,,,,"
} > "$folder/within.csv"
