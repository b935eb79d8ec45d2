#!/bin/sh
# figures.sh: fills the parts of READMEs between "<!-- figures NAME -->" and "<!-- end -->" from what commands wrote: headers,
# genomes, tests/report/machines/*.csv, tests/hard/hard.csv.
# figures.sh --check: changes nothing; names the parts that differ, and fails if there are any.
# figures.sh --record: writes tests/hard/hard.csv first, a hundred hard cases of each family (a minute).
. tests/hard/build.inc
documents='README.md tests/README.md'
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT

# The table of the front page.
figures_quad4() {
    awk -f tests/report/front_page.awk generated/footpoint_quad4.h evolve/genomes/quad4.gen tests/report/machines/*.csv
}

figures_hard() {
    echo '| search | cases | wrong answers and statuses |'
    echo '|---|---|---|'
    awk -F, '/^#/ { next } $1 == "family" { for (i = 1; i <= NF; i++) c[$i] = i; next }
        { m = $c["method"]; if (!(m in n)) order[++methods] = m; n[m] += $c["n"]; bad[m] += $c["wrong"] + $c["wrong_status"] }
        END { for (i = 1; i <= methods; i++) print "| `" order[i] "` | " n[order[i]] " | " bad[order[i]] " |" }' tests/hard/hard.csv
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
exit $status
