# Compares operation counts with the best of FORM, Maxima and SymPy (tests/expressions/rivals.csv, written by
# tests/expressions/compare.py --record, so that these need not be installed) and with known bounds: for short
# expressions and, in the paper's measure, its own pair; with FOOTPOINT_LONG for all expressions in both measures.
. tests/cli/expect.inc
codegen=$BIN/footpoint-codegen

# expression,model,bound: the paper's pair, dense cubics, a Newton step
cat > "$work/bounds.csv" << 'END'
paper-pair,paper,24
cubic-full-generic,paper,164
cubic-full-grid,paper,143
newton-quad,paper,28
END

find tests/expressions -name '*.gen' -size -128c > "$work/short"
# files MODEL
files() {
    for file in tests/expressions/*.gen; do
        name=${file##*/} name=${name%.gen}
        if [ -n "$FOOTPOINT_LONG" ]; then echo "$file"; continue; fi
        case $1 in
        throughput) ! grep -qxF "$file" "$work/short" || echo "$file" ;;
        paper) [ "$name" != paper-pair ] || echo "$file" ;;
        esac
    done
}
later 'counts: expressions of 128 bytes and more, and most of them in the paper'"'"'s measure'

for model in throughput paper; do
    for file in $(files $model); do
        echo "$file" >> "$work/files"
        name=${file##*/}
        "$codegen" --count --cost $model "$file" 2> /dev/null |
            awk -F, -v name="${name%.gen}" -v model="$model" 'NR > 1 {
                label = $1 == "g" ? name : name "/" $1
                print label "," model "," $2 "," $4 "," $3 "," (model == "paper" ? $2 + $3 : $2 + $4 + 8 * $3) }'
    done
done > "$work/ours.csv"

# misses.csv: if another tool is better, our own figure is the bound
grep -v -e '^#' -e '^expression' tests/expressions/rivals.csv | cut -d, -f1,2,6 | cat - "$work/bounds.csv" |
    awk -F, 'FILENAME == MISSES { miss[$1 "," $2] = $3; next }
             FILENAME == OURS { ours[$1 "," $2] = $3 "/" $4 "/" $5 " = " $6; cost[$1 "," $2] = $6; next }
             { key = $1 "," $2
               if (key in cost && key in miss) print cost[key] <= miss[key], $1, $2 ":", ours[key], "against", $3, "(a known miss)"
               else if (key in cost) print cost[key] <= $3, $1, $2 ":", ours[key], "against", $3 }' \
        MISSES=tests/expressions/misses.csv OURS="$work/ours.csv" tests/expressions/misses.csv "$work/ours.csv" - > "$work/judged"
while read -r good text; do
    report "$good" "$text"
done < "$work/judged"
grep -v -e '^#' -e '^expression' tests/expressions/rivals.csv |
    awk -F, 'FILENAME == "-" { if (($1, $2) in cost) { n++; d = cost[$1, $2] - $6; won += d < 0; lost += d > 0 } next }
             { cost[$1, $2] = $6 }
             END { print "# of " n " comparisons " won " won, " n - won - lost " equal, " lost " lost" }' "$work/ours.csv" -

# missing CSV FILE...: prints the files without a line in the table
missing() {
    table=$1; shift
    printf '%s\n' "$@" | awk -F '[,/]' 'NR == FNR { there[$1]; next } { name = $NF; sub(/\.gen$/, "", name) } !(name in there) { print "# " $0 }' "$table" -
}
missing tests/expressions/rivals.csv tests/expressions/*.gen > "$work/missing"
cat "$work/missing"; report $((! $(wc -l < "$work/missing"))) 'every expression is recorded'
missing "$work/ours.csv" $(cat "$work/files") > "$work/missing"
cat "$work/missing"; report $((! $(wc -l < "$work/missing"))) 'every expression compiles'

if python3 -c '' 2> /dev/null; then
    python3 -B -m doctest tests/expressions/count.py; report $((! $?)) 'the counter of the rivals counts as it says'
    mkdir "$work/made" && python3 tests/expressions/make.py "$work/made" && good=1 || good=0
    for file in "$work"/made/*.gen; do
        cmp -s "$file" "tests/expressions/${file##*/}" || { good=0; echo "# ${file##*/} differs"; }
    done
    report $good 'the expressions are those that make.py writes'
fi
