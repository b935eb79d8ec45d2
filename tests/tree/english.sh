# Checks that comments and READMEs read like English. Words that translations overuse are counted per 1,000 words of C
# comments and of prose; h3, p4est, FFTW and libCEED use few of them. They are a symptom: rewrite the sentence, do not
# swap the word. READMEs and comments of all rooms, except emitted files, must keep the limits.
. tests/cli/expect.inc
emitted='tests/bench/footpoint_perceptron.h tests/generated/points'
rooms='evolve codegen runtime tests'
pages='README.md */README.md'
git ls-files --error-unmatch Makefile > "$work/log" 2>&1 || { echo 'ok 1 - comments and READMEs # SKIP no clone'; exit 0; }

# rates PATTERN PATH...: a line "word rate limit" for each word in files whose names match, the least rate of "must" as a
# negative limit.  Of pages, code counts nowhere.
rates() {
    pattern=$1
    shift
    git ls-files "$@" | grep "$pattern" | xargs awk '
        FNR == 1 { inside = span = 0 }
        FILENAME ~ /\.md$/ && /^```/ { inside = !inside; next }
        {
            line = tolower($0); text = ""
            if (FILENAME ~ /\.md$/) { # a span of code may go on in the next line
                if (!inside) { k = split(line, part, "`"); for (i = 1; i <= k; i++) { if (!span) text = text " " part[i]; if (i < k) span = !span } }
                line = ""
            }
            while (line != "") {
                if (inside) {
                    if (!(at = index(line, "*/"))) { text = text " " line; break }
                    text = text " " substr(line, 1, at - 1); line = substr(line, at + 2); inside = 0
                } else if (match(line, /"([^"\\]|\\.)*"|\/\*|\/\//)) {
                    found = substr(line, RSTART, RLENGTH); line = substr(line, RSTART + RLENGTH)
                    if (found == "/*") inside = 1
                    else if (found == "//") { text = text " " line; break }
                } else break
            }
            gsub(/[^a-z]+/, " ", text)
            n = split(text, word, " ")
            for (i = 1; i <= n; i++) { count[word[i]]++; of += word[i] == "of" && (last == "that" || last == "those"); last = word[i] }
            words += n
        }
        function show(name, number, limit) { printf "%s %.2f %s\n", name, 1000 * number / (words ? words : 1), limit }
        END {
            show("what", count["what"], 0.8); show("none", count["none"], 0.4); show("where", count["where"], 3)
            show("one(s)", count["one"] + count["ones"], 4); show("that/those-of", of, 0.4); show("alone", count["alone"], 0.3)
            show("say(s)", count["say"] + count["says"], 0.3); show("must", count["must"], -0.6)
        }'
}
over() { awk '$3 < 0 ? $2 < -$3 : $2 > $3 { print $1 ": " $2 " in 1,000 words, limit " ($3 < 0 ? "at least " -$3 : $3) }'; }

check() { # check NAME PATTERN PATH...
    name=$1
    shift
    wrong=$(rates "$@" | over)
    [ -z "$wrong" ]; good=$?
    [ $good = 0 ] || echo "$wrong" | sed 's/^/# /'
    report $((! good)) "$name"
}
set -f # git expands the patterns
check 'comments' '\.[ch]$' $rooms $(printf ':!%s ' $emitted)
check 'READMEs' '\.md$' $pages
for room in $rooms; do
    echo "# $room: $(rates '\.[ch]$' "$room" $(printf ':!%s ' $emitted) | awk '{ printf "%s %s  ", $1, $2 }')"
done
set +f
mkdir "$work/planted" && git -C "$work/planted" init -q
printf '/* What none says, where those of which one is alone. */\nint x;\n' > "$work/planted/a.c"
git -C "$work/planted" add a.c
[ "$(cd "$work/planted" && rates '\.c$' . | over | wc -l)" = 8 ]; report $((! $?)) 'a planted comment is found'
printf 'What none `what\nwhat` says.\n```\nwhat\n```\n' > "$work/planted/a.md"
git -C "$work/planted" add a.md
[ "$(cd "$work/planted" && rates '\.md$' . | head -n 1)" = 'what 333.33 0.8' ]; report $((! $?)) 'and a planted page'
