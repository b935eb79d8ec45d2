#!/bin/sh
# figures.sh: fills the parts of READMEs between "<!-- figures NAME -->" and "<!-- end -->" from what commands wrote: headers,
# genomes, tests/report/machines/, tests/hard/hard.csv, tests/calculix/models.csv (the table that tests/long/calculix.sh writes).
# Draws the picture of README.md from the record measured last.
# figures.sh --check: changes nothing; names the parts that differ, and fails if there are any.
# figures.sh --record: writes tests/hard/hard.csv first, a hundred hard cases of each family (a minute).
. tests/hard/build.inc
documents='README.md generated/README.md runtime/README.md tests/README.md'
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT

# recorded PROGRAM PART SCENE: a table of recorded times
recorded() {
    awk -v part="$2" -f tests/report/recorded.awk -f "tests/report/$1.awk" "generated/footpoint_$3.h" "evolve/genomes/$3.gen" \
        tests/report/machines/*.csv
}
impact() { awk -v part="$1" -f tests/report/impact.awk tests/report/machines/*-impact.txt; }
# calculix: models; how many times faster our search is; the share of CalculiX's search in all models and the largest, in per
# cent; the largest relative difference of results
calculix() {
    awk -F, 'NR == 1 { next }
        { theirs += $3; ours += $4; whole += $5; if (100 * $3 / $5 > most) most = 100 * $3 / $5
          for (i = 7; i <= 10; i++) if ($i != "-" && $i + 0 > apart + 0) apart = $i }
        END { sub(/e-0/, "e-", apart); printf "%d %.0f %.0f %.0f %s\n", NR - 1, theirs / ours, 100 * theirs / whole, most, apart }' tests/calculix/models.csv
}

figures_quad4() { recorded front_page quad4 quad4; }
figures_loses() {
    recorded front_page last quad4
    echo "- Local search is rarely the bottleneck. Newton's iteration takes $(impact share) % of the time of our explicit impact"
    calculix | while read -r models factor share rest; do
        echo "  example, CalculiX's search $share % of that of $models of its models ([runtime](runtime/README.md#in-other-codes))."
    done
}
figures_speed() { recorded header_speeds speed quad4; }
figures_robust() { recorded header_speeds robust quad4; }
figures_calls() { recorded header_speeds calls quad4; }
figures_derivatives() { recorded header_speeds derivatives quad4; }
figures_gregory() { recorded header_speeds gregory gregory; }
figures_bezier() { recorded header_speeds bezier bezier; }
figures_sizes() {
    wc -c generated/*.h | awk '$2 == "total" { next } { k = $2 ~ /_derivatives/; size = int($1 / 1e4 + 0.5) * 10
            if (!(k in low) || size < low[k]) low[k] = size
            if (size > high[k]) high[k] = size }
        END { print "A header has " low[0] " to " high[0] " kB, one of derivatives " low[1] " to " high[1] " kB (`sh tests/report/header_sizes.sh`)." }'
}
figures_impact() { impact impact; }
figures_calculix() {
    calculix | while read -r models factor share most apart; do
        echo "In $models models (\`tests/long/calculix.sh\`), a search takes 1/$factor of the time of CalculiX's, and displacements, gaps"
        echo "and contact stresses agree to $apart of the largest. Searching took $share % of CalculiX's time, at most $most % of a model's."
    done
}

figures_hard() {
    echo '| search | cases | wrong answers and statuses |'
    echo '|---|---|---|'
    awk -F, '/^#/ { next } $1 == "family" { for (i = 1; i <= NF; i++) c[$i] = i; next }
        { m = $c["method"]; if (!(m in n)) order[++methods] = m; n[m] += $c["n"]; bad[m] += $c["wrong"] + $c["wrong_status"] }
        END { for (i = 1; i <= methods; i++) print "| `" order[i] "` | " n[order[i]] " | " bad[order[i]] " |" }' tests/hard/hard.csv
}

# draw FILE: writes FILE.svg
draw() {
    latest=$(awk 'FNR == 1 { print $NF, FILENAME }' tests/report/machines/*.csv | sort | tail -n 1)
    table=${latest#* }
    sed 1d "$table" | awk -f tests/report/picture.awk -v scene=quad4 -v sample=random -v mode=scalar -v norm=mean -v out="$1" \
        -v processor="$(sed -n '1s/^# \(.*\), x86-64.*/\1/p' "$table")" | gnuplot
}

# parts DOCUMENT: the names of its parts
parts() { sed -n 's/^<!-- figures \([a-z0-9]*\) -->$/\1/p' "$1"; }
# part DOCUMENT NAME: what it has now
part() { awk -v begin="<!-- figures $2 -->" '$0 == "<!-- end -->" { on = 0 } on; $0 == begin { on = 1 }' "$1"; }

if [ "$1" = --record ]; then
    LIBRARY="${BIN:-build}/libfootpoint_ccx.a ${BIN:-build}/libfootpoint.a"
    hard_build "$work/hard" "${CC:-gcc}" -O1 -ffp-contract=off || exit 3
    "$work/hard" 100 > "$work/hard.csv"
    [ $? -le 1 ] && mv "$work/hard.csv" tests/hard/hard.csv || exit 3
fi
status=0
for document in $documents; do
    for name in $(parts "$document"); do
        part "$document" "$name" > "$work/old"
        "figures_$name" < "$work/old" > "$work/new" || exit 3
        cmp -s "$work/old" "$work/new" && continue
        if [ "$1" = --check ]; then
            echo "$document: $name: make figures"
            diff "$work/old" "$work/new"
            status=1
            continue
        fi
        awk -v begin="<!-- figures $name -->" -v new="$work/new" '$0 == "<!-- end -->" { skip = 0 } !skip
            $0 == begin { skip = 1; while ((getline line < new) > 0) print line }' "$document" > "$work/page" &&
            cat "$work/page" > "$document"
    done
done
if [ "$1" != --check ]; then
    draw "$work/picture" || exit 3
    cat "$work/picture.svg" > tests/report/quad4-scalar.svg
fi
exit $status
