# Spelling, by codespell, of all text that is typed.  spelling.words lists the names that it takes for errors.
. tests/cli/expect.inc
command -v codespell > /dev/null || { echo 'ok 1 - spelling # SKIP no codespell'; exit 0; }
git ls-files --error-unmatch Makefile > "$work/log" 2>&1 || { echo 'ok 1 - spelling # SKIP no clone'; exit 0; }

wrong=$(git ls-files | grep -E '(\.(md|c|h|hpp|cpp|cu|f90|sh|awk|inc|gen|scene|1|3|py)|Makefile)$' |
    grep -vE '^(generated/|tests/generated/points/|tests/fuzz/|tests/bench/footpoint_perceptron\.h|evolve/genomes/)' |
    xargs codespell -I tests/tree/spelling.words)
[ -z "$wrong" ]; good=$?
[ $good = 0 ] || echo "$wrong" | sed 's/^/# /'
report $((! good)) 'spelling'
printf 'A rec%sved answer.\n' ie > "$work/planted.md"
[ "$(codespell -I tests/tree/spelling.words "$work/planted.md" | wc -l)" = 1 ]; report $((! $?)) 'a planted error is found'
