# Checks that commits since the rule have an imperative subject of at most 72 characters, without a full stop. Authors'
# dates decide, which a rebase keeps. Archives have no history.
. tests/cli/expect.inc
since=2026-11-28

# wrong FOLDER: the subjects that break the rule
wrong() {
    git -C "$1" log --no-merges --format='%as %s' | awk -v since=$since '
        $1 < since { next }
        { sub(/^[^ ]* /, "") }
        length > 72 || /\.$/ || tolower($0) ~ /^([^ ]*: )?(add|fix|change|make|move|remove|rename|update)(s|es|d|ed) /'
}

git ls-files --error-unmatch Makefile > "$work/log" 2>&1 || { echo 'ok 1 - subjects of commits # SKIP no clone'; exit 0; }
subjects=$(wrong .)
[ -z "$subjects" ]; good=$?
[ $good = 0 ] || echo "$subjects" | sed 's/^/# /'
report $((! good)) 'subjects of commits'

git init -q "$work/planted"
for subject in 'Add a test' 'Added a test' "tests: $(printf '%070d' 0)" 'Add a test.'; do
    git -C "$work/planted" -c user.name=x -c user.email=x -c commit.gpgsign=false commit -q --allow-empty -m "$subject"
done
[ "$(wrong "$work/planted" | wc -l)" = 3 ]; report $((! $?)) 'planted subjects are found'
