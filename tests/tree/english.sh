# Comments read like English.  Words that translations overuse are counted per 1,000 words of C comments, as h3, p4est, FFTW and
# libCEED have few of them.  They are a symptom: rewrite the sentence, do not swap the word.  Rewritten rooms, but for the files
# of `old`, must keep the limits; the rates of other rooms are printed.
. tests/cli/expect.inc
rewritten='evolve codegen runtime/batch runtime/calculix runtime/geometry runtime/replace'
old='evolve/evolve_main.c evolve/samples evolve/common/stream.* evolve/eval/errors.* evolve/eval/frame.h evolve/write/archive_*
    evolve/run/run.c evolve/run/run_verdict.* evolve/run/run_options.* evolve/region/sampled_region.*
    evolve/region/shape_requires.* evolve/surface/sample.* evolve/archive/archive_members.c evolve/input/scene.h
    evolve/input/scene_table.c evolve/input/scene_tiers.c codegen/print codegen/codegen_*.[ch]
    codegen/program/float_errors.*'
others='evolve codegen runtime tests'

# rates PATH...: a line "word rate limit" for each word, the least rate of "must" as a negative limit
rates() {
    git ls-files "$@" | grep '\.[ch]$' | xargs awk '
        FNR == 1 { inside = 0 }
        {
            line = tolower($0); text = ""
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

set -f # git expands the patterns
wrong=$(rates $rewritten $(printf ':!%s ' $old) | over)
set +f
[ -z "$wrong" ]; good=$?
[ $good = 0 ] || echo "$wrong" | sed 's/^/# /'
report $((! good)) 'comments of the rewritten rooms'
for room in $others; do
    echo "# $room: $(rates "$room" | awk '{ printf "%s %s  ", $1, $2 }')"
done
mkdir "$work/planted" && git -C "$work/planted" init -q
printf '/* What none says, where those of which one is alone. */\nint x;\n' > "$work/planted/a.c"
git -C "$work/planted" add a.c
[ "$(cd "$work/planted" && rates . | over | wc -l)" = 8 ]; report $((! $?)) 'a planted comment is found'
