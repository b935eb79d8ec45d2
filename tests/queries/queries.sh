# Checks the public set of queries: a program of 30 lines that includes nothing of footpoint's reads it; the judge
# distinguishes right, wrong and refused answers; with FOOTPOINT_LONG the set is made again, to the same bytes.
. tests/cli/expect.inc
CC=${CC:-gcc} queries=tests/queries
gzip -dc $queries/queries.txt.gz > "$work/queries.txt"; report $((! $?)) 'unpacks'
[ "$(wc -c < $queries/queries.txt.gz)" -le 1000000 ]; report $((! $?)) 'in at most a megabyte'

[ "$(wc -l < $queries/read_queries_main.c)" -le 30 ] && ! grep -q '#include "' $queries/read_queries_main.c
report $((! $?)) 'the reader has 30 lines and includes nothing of ours'
several=$(awk '$3 > 1' "$work/queries.txt" | wc -l)
$CC -std=c99 -Wall -Wextra -Wpedantic -Werror $queries/read_queries_main.c -o "$work/read"
expect 'and reads it all' 0 "4000 queries, $several with several closest points" '' sh -c "'$work/read' < '$work/queries.txt'"
awk '{ n[$1 " " $2]++ } END { for (k in n) { kinds++; bad += n[k] != 50 } exit bad || kinds != 80 }' "$work/queries.txt"
report $((! $?)) 'fifty of each kind of face and family'
[ "$several" -ge 200 ]; report $((! $?)) 'ties among them'

# The judge, on four queries of each family and kind.
awk 'n[$1 " " $2]++ < 4' "$work/queries.txt" > "$work/few.txt"
$CC -std=c11 -D_DEFAULT_SOURCE $queries/judge_queries_main.c $queries/query_text.c -o "$work/judge" -lm
judged() { # judged ANSWERS: asked, right, placed, wrong, none
    "$work/judge" "$work/few.txt" "$1" x | awk -F, '{ for (i = 3; i <= 7; i++) n[i] += $i } END { print n[3], n[4], n[5], n[6], n[7] }'
}
nodes='function nodes(kind) { return kind == "tri3" ? 3 : kind == "quad4" ? 4 : substr(kind, length(kind)) }'
awk "$nodes"' { at = 8 + 3 * nodes($1); print $(at + 1), $(at + 2), $at }' "$work/few.txt" > "$work/answers"
expect 'the truth is right' 0 '320 320 320 0 0' '' judged "$work/answers"
awk '{ print -$1 + 0.3, $2, $3 }' "$work/answers" > "$work/other"
judged "$work/other" | awk '{ exit !($4 > 300 && $2 < 20) }'; report $((! $?)) 'other points are wrong'
awk '{ print $1, $2, 1.001 * $3 + 1e-3 }' "$work/answers" > "$work/other"
judged "$work/other" | awk '{ exit !($4 > 280) }'; report $((! $?)) 'and so are other distances'
awk '{ print NR % 2 ? "none" : "skip" }' "$work/answers" > "$work/other"
expect 'refused and skipped' 0 '160 0 0 0 160' '' judged "$work/other"
echo 'nonsense' > "$work/other"
expect 'no answer' 1 '' "$work/other:1: error: not 'XI ETA [DISTANCE]', 'point X Y Z', 'none' or 'skip'" \
    "$work/judge" "$work/few.txt" "$work/other" x
{ cat "$work/answers"; echo none; } > "$work/other"
expect 'too many' 1 '' "$work/other: error: more than 320 answers" "$work/judge" "$work/few.txt" "$work/other" x
expect 'too few' 1 '' "/dev/null: error: 0 answers are not enough" "$work/judge" "$work/few.txt" /dev/null x

later 'queries: all of them made and scored again'
if [ -n "$FOOTPOINT_LONG" ]; then
    sh $queries/set.sh score "$work/queries.txt" > "$work/scores"
    [ -z "$(sed -n '/^<!-- scores -->/,/^<!-- end/p' $queries/README.md | grep '^| `[^ ]*`' | grep -vxFf "$work/scores")" ]
    report $((! $?)) 'the scores are right (make queries)'
    sh $queries/set.sh make 1 50 2> /dev/null | cmp -s - "$work/queries.txt"; report $((! $?)) 'made again, the same bytes'
fi
