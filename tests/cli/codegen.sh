# Checks footpoint-codegen: usage, diagnostics, exit statuses; no file is half-written.
. tests/cli/expect.inc
# None of these expressions is hard.
codegen=$work/codegen
printf '#!/bin/sh\nexec "%s" --effort 10 "$@"\n' "$(realpath "$BIN/footpoint-codegen")" > "$codegen" && chmod +x "$codegen"
g=$work/g.gen

genome() { printf '%s\n' "footpoint-genome 1" "$@" > "$g"; }
refused() { # refused NAME LINE:COLUMN MESSAGE  (the genome is in $g)
    expect "$1" 1 '' "$g:$2: error: $3" "$codegen" --count "$g"
}

expect 'help' 0 '*' '' "$codegen" --help
expect 'version' 0 'footpoint-codegen 0.3.0' '' "$codegen" --version
expect 'no file' 2 '' 'footpoint-codegen: one genome file, please (try --help)' "$codegen" --count
expect 'neither output nor count' 2 '' 'footpoint-codegen: either -o FILE or --count, please (try --help)' "$codegen" "$g"
expect 'unknown option' 2 '' 'footpoint-codegen: unknown option or missing value: --fast (try --help)' "$codegen" --fast "$g"
expect 'bad prefix' 2 '' 'footpoint-codegen: not a C identifier: 3x (try --help)' "$codegen" --prefix 3x "$g"
misused() { # misused MESSAGE OPTIONS...
    message=$1
    shift
    expect "usage: $*" 2 '' "footpoint-codegen: $message (try --help)" "$codegen" "$@" "$g"
}
misused 'unknown language: cobol' --language cobol --count
misused 'unknown precision: half' --precision half --count
misused 'effort is a number from 0 to 1000000000, not -1' --effort -1 --count
misused 'effort is a number from 0 to 1000000000, not 1e3' --effort 1e3 --count
misused 'effort is a number from 0 to 1000000000, not 1000000001' --effort 1000000001 --count
misused 'the seed is a number from 0 to 18446744073709551615, not x' --seed x --count
misused '--points goes with -o FILE' --points "$work/points.h" --count
misused 'the seed is a number from 0 to 18446744073709551615, not 18446744073709551616' --seed 18446744073709551616 --count
expect 'an option without its value' 2 '' 'footpoint-codegen: unknown option or missing value: --cost (try --help)' \
    "$codegen" --count "$g" --cost
for option in output prefix language precision samples points allow-poles edge count cost effort seed explain help version; do
    "$codegen" --help | grep -q -e "--$option"; report $((! $?)) "help tells of --$option"
done

expect 'missing file' 3 '' "$work/none.gen: error: cannot open: No such file or directory" "$codegen" --count "$work/none.gen"

: > "$g";                                           refused 'empty file' 1:1 "not a genome file: the first word must be 'footpoint-genome'"
echo 'footpoint-genome 4' > "$g";                   refused 'wrong version' 1:18 "format version '4' is not supported; this program reads versions 1 to 3"
genome 'input x' 'genome g' 'r = sqr x' 'end';      refused 'unknown gene' 4:5 "unknown gene 'sqr'"
genome 'input x' 'genome g' 'r = + x' 'end';        refused 'stack underflow' 5:1 "expression of 'r' is incomplete: 1 operand is missing"
genome 'input x' 'genome g' 'r = + x x x' 'end';    refused 'stack overflow' 4:11 "unexpected gene 'x' after a complete expression"
genome 'input x' 'genome g' 'r = * x';              refused 'truncated in an expression' 5:1 "expression of 'r' is incomplete: 1 operand is missing"
genome 'input x' 'genome g' 'r = x';                refused 'truncated before end' 5:1 "genome 'g' has no 'end'"
genome 'input x' 'genome g' 'end';                  refused 'no output' 4:1 "genome 'g' needs an output"
genome 'input x x' 'genome g' 'r = x' 'end';        refused 'input twice' 2:9 "name 'x' is defined already"
genome 'input x' 'let y = / x - x x' 'genome g' 'r = y' 'end'; refused 'division by nothing' 3:1 "'y' divides by a value that is always 0"
genome 'input x' 'genome g' 'r = + x sqrt - x + x 2' 'end'; refused 'root of a negative constant' 4:1 \
    "'r' takes the sqrt of a value that is always negative"
genome 'input x' 'genome g' 'r = 1.2.3' 'end';      refused 'bad number' 4:5 "'1.2.3' must be a decimal number"
genome 'input x' 'genome g' 'r = 1e400' 'end';      refused 'huge number' 4:5 "number '1e400' is out of range"
genome 'speed 3';                                   refused 'unknown keyword' 2:1 "unknown keyword 'speed'"
genome 'segment quad5 any';                         refused 'unknown segment' 2:9 "unknown segment kind 'quad5'"
genome 'input x';                                   expect 'no genome' 1 '' "$g: error: the file contains no genome" "$codegen" --count "$g"

genome 'input x y' 'genome g' 'r = + * x y * x 2' 's = - x x' 'end'
expect 'count' 0 'genome,mul,div,add,sqrt,compare
g,1,0,1,0,0' '' "$codegen" --count "$g"
genome 'input x y' 'genome g' 'r = / * x y x' 's = % x x' 'end'
expect 'a removed singularity is told' 0 'genome,mul,div,add,sqrt,compare
g,0,0,0,0,0' "$g:3: warning: genome 'g': 1 division cancelled (a removed singularity)" "$codegen" --count "$g"

for r in '/ x / 1 y' '/ 1 / 1 x' '- min y / y x min y / y x' '* - y y min y / y x' '% / 1 x / 1 x'; do
    genome 'input x y' 'genome g' "r = $r" 'end'
    expect "a division lost: $r" 0 '*' "$g:3: warning: genome 'g': 1 division cancelled (a removed singularity)" "$codegen" --count "$g"
done
for r in '- sqrt x sqrt x' '* 0 sqrt - x 5' '- max y sqrt x max y sqrt x'; do
    genome 'input x y' 'genome g' "r = $r" 'end'
    expect "a root lost: $r" 0 '*' "$g:3: warning: genome 'g': 1 root cancelled (a removed singularity)" "$codegen" --count "$g"
done
for r in '% 2 - x v' 'abs - x v' 'min x * y - v x' '/ y - v x'; do
    genome 'input x y' 'let v = + 2 x' 'genome g' "r = $r" 'end'
    expect "a number behind a let: $r" 0 '*' '' "$codegen" --quiet "$g" -o "$work/h.h"
done
genome 'input x y' 'let v = + 2 x' 'genome g' 'r = sqrt - x v' 'end'
refused 'a root of a number behind a let' 5:1 "'r' takes the sqrt of a value that is always negative"
genome 'input x y' 'let v = + 2 x' 'genome g' 'r = / y + -2 abs - x v' 'end'
refused 'a divisor that is 0 behind a let' 5:1 "'r' divides by a value that is always 0"

genome 'input x y' 'genome g' 'r = + * x y * x 2' 'end'
genome 'note evil */ int x; /* \\' 'input x' 'genome g' 'note more */ int y;' 'r = x' 'end'
"$codegen" "$g" -o "$work/e.h" && echo '#include "e.h"' > "$work/e.c" && ${CC:-gcc} -Wall -Werror -c "$work/e.c" -o "$work/e.o"
report $((! $?)) 'a note cannot end the banner'
genome 'input x y' 'genome g' 'r = + * x y * x 2' 'end'

# Errors that evolution measured: the worst of so many; another distribution where mean or 99 % differ by more than 1.5.
error_table() { # error_table MEAN P99: of the even part of eta
    genome 'input x' 'genome g' \
        'note heldout_both n 7 mean 1.000e-03 1.000e-03 p99 2.000e-02 2.000e-02 max 3.000e-01 3.000e-01' \
        "note heldout_even_both n 9 mean 1.000e-03 $1 p99 2.000e-02 $2 max 3.000e-01 9.000e-01" 'xi = x' 'eta = x' 'end'
    "$codegen" --quiet "$g" -o "$work/e.h" && sed -n 's/^ \*   heldout//p' "$work/e.h"
}
first=':        xi 1.000e-03 2.000e-02 3.000e-01, eta 1.000e-03 2.000e-02 3.000e-01, of 7 samples'
even='_even:   xi 1.000e-03 2.000e-02 3.000e-01, eta'
expect 'a table of errors' 0 "$first" '' error_table 1.490e-03 1.350e-02
expect 'another mean' 0 "$first
$even 1.510e-03 2.000e-02 9.000e-01, of 9 samples" '' error_table 1.510e-03 2.000e-02
expect 'another 99 %' 0 "$first
$even 1.000e-03 1.300e-02 9.000e-01, of 9 samples" '' error_table 1.000e-03 1.300e-02
genome 'input x' 'genome g' 'r = * * x 1e300 1e300' 'end'; refused 'constant beyond double' 3:1 "genome 'g' has a constant outside the range of double"
genome 'input xA yA zA xB yB zB xC yC zC xD yD zD xS yS zS' 'segment quad4 any' 'genome a' 'xi = xS' 'eta = yS' 'end' \
    'genome a_at' 'xi = xS' 'eta = yS' 'end'
refused 'names that collide' 8:1 "genome 'a_at' conflicts with a function of 'a'"
genome 'input x y' 'let unused = / 1 - abs x abs * -1 x' 'genome g' 'r = * 2 sqrt x' 'end'
expect 'unused values do not count, nor does doubling a root' 0 'genome,mul,div,add,sqrt,compare
g,1,0,0,1,0' '' "$codegen" --count "$g"
genome 'input x y' 'genome g' 'r = + * x y * x 2' 'end'
genome 'input a b c d' 'let s = + a b' 'genome g' \
    'r = + + + * * a a a * * b b b + * 3 * * a a b * 3 * * a b b - + * s * c c * s * d d * * 2 s * c d' 'end'
expect 'squares in a sum are found' 0 'genome,mul,div,add,sqrt,compare
g,3,0,3,0,0' '' "$codegen" --count "$g"
genome 'input x y' 'genome g' 'r = + * x y * x 2' 'end'
expect 'output folder missing' 3 '' "$work/none/h.h: error: cannot write: No such file or directory" \
    "$codegen" --quiet "$g" -o "$work/none/h.h"
"$codegen" "$g" -o "$work/h.h"
cp "$work/h.h" "$work/before.h"
"$codegen" "$g" -o "$work/h.h"
cmp -s "$work/h.h" "$work/before.h"; report $((! $?)) 'same input, same bytes'
genome 'input x y' 'genome g' 'r = + * x y * x'
"$codegen" "$g" -o "$work/h.h" 2> /dev/null
cmp -s "$work/h.h" "$work/before.h" && [ "$(ls "$work" | grep -c 'h\.h')" = 1 ]; report $((! $?)) 'a refused genome leaves the old header alone'

# ---- cost, seed, effort ----
genome 'input x y' 'genome g' 'r = + * x y * x 2' 'end'
counted='genome,mul,div,add,sqrt,compare
g,1,0,1,0,0'
for model in throughput operations paper; do
    expect "cost model $model" 0 "$counted" '' "$codegen" --cost $model --count "$g"
    "$codegen" --cost $model --seed 7 --effort 10 "$g" -o "$work/h.h" && grep -q "^ \* cost model: $model (.*); seed 7, effort 10$" "$work/h.h"
    report $((! $?)) "the banner names cost model $model, seed and effort"
done
"$codegen" --cost "$work/none" --count "$g" > "$work/stdout" 2> "$work/stderr"
[ $? = 3 ] && [ ! -s "$work/stdout" ]; report $((! $?)) 'an unknown cost model'
[ "$(wc -l < "$work/stderr")" = 1 ]; report $((! $?)) 'is refused in one line'
expect 'explained' 0 "$counted" '*' "$codegen" --explain --count "$g"
expect 'an unknown pass' 2 '' '*' "$codegen" --explain=none --count "$g"
cp "$g" "$work/before.gen"
genome 'input x y' 'genome g' 'r = + * x x * 0.5 * x y' 's = / y * + x y + x y' 'end'
"$codegen" --quiet --effort 0 --explain=simplified --count "$g" 2>&1 > "$work/data" | sed -n 's/^    \([a-z]* = \)/\1/p' > "$work/lines"
[ "$(wc -l < "$work/lines")" = 2 ] && awk 'BEGIN { x = 3; y = 7 } { sub(/^. = /, ""); print }' "$work/lines" |
    sed 's/x/3/g; s/y/7/g' | while read -r sum; do awk "BEGIN { print $sum }"; done > "$work/values"
[ "$(tr '\n' ' ' < "$work/values")" = '19.5 0.07 ' ]; report $((! $?)) 'a graph in infix'
cp "$work/before.gen" "$g"

# ---- poles ----
genome 'input x y' 'genome g' 'r = / x + y 3' 'end'
rm -f "$work/h.h"
expect 'a quotient without ranges' 1 '' \
    "$g:3:1: error: genome 'g' may divide by 0 (in_y + 3.0: undecided); give the inputs' ranges, or --allow-poles" \
    "$codegen" "$g" -o "$work/h.h"
[ ! -e "$work/h.h" ]; report $((! $?)) 'nothing is written'
expect 'is counted' 0 'genome,mul,div,add,sqrt,compare
g,0,1,1,0,0' '' "$codegen" --count "$g"
expect 'is allowed' 0 '' '' "$codegen" --quiet "$g" --allow-poles --prefix p -o "$work/h.h"
grep -q '^FOOTPOINT_FN int p_g(double in_x, double in_y, double \*out_r)$' "$work/h.h"
report $((! $?)) 'and its function returns a status'
genome 'input x y' 'range y -1 1' 'genome g' 'r = / x + y 3' 'end'
expect 'ranges show that there is no pole' 0 '' '' "$codegen" --quiet "$g" --prefix p -o "$work/h.h"
grep -q '^FOOTPOINT_FN void p_g(double in_x, double in_y, double \*out_r)$' "$work/h.h"
report $((! $?)) 'and no status is needed'
genome 'input x y' 'range x 1 2' 'range y -4 1' 'genome g' 'r = / x + y 3' 'end'
expect 'ranges show a pole' 1 '' \
    "$g:5:1: error: genome 'g' may divide by 0 (in_y + 3.0: has a zero); give the inputs' ranges, or --allow-poles" \
    "$codegen" "$g" -o "$work/none.h"
genome 'input x y' 'range x 1 2' 'range y 1 2' 'require - 1.5 * x y' 'require - + x y 2.6' 'genome g' 'r = / 1 - x y' 'end'
expect 'requires that contradict each other' 1 '' "$g:5:1: error: no inputs in the ranges satisfy all requires" \
    "$codegen" "$g" --allow-poles -o "$work/none.h"
genome 'input x y' 'genome g' 'r = % x y' 'end'
expect 'a protected quotient has no pole' 0 '' '' "$codegen" --quiet "$g" -o "$work/h.h"
expect 'but is named' 0 'in_y: protected the quotient is 1 where it is 0' '' told "$work/h.h" footpoint_h_g poles
expect 'a header of expressions names its command' 0 \
    '/* GENERATED by footpoint-codegen 0.3.0. DO NOT EDIT; run `footpoint-codegen --effort 10 -o footpoint_h.h g.gen`.' '' head -1 "$work/h.h"

# ---- names and hashes ----
for tail in n points; do
    genome 'input x' 'genome a' 'r = x' 'end' "genome a_$tail" 'r = x' 'end'
    refused "a name that collides with a_$tail" 6:1 "genome 'a_$tail' conflicts with a function of 'a'"
done
genome 'input x' 'genome a' 'r = x' 'end' 'genome a_at' 'r = x' 'end'
expect 'a_at is free without a segment' 0 '*' '' "$codegen" --count "$g"
hash_of() { "$codegen" "$g" -o "$work/h.h" && told "$work/h.h" "footpoint_h_$1" genome_sha256; }
genome 'input x' 'genome a' 'r = x' 'end' 'genome b' 'r = * x x' 'end'
first=$(hash_of a)
genome 'input x' 'genome a' 'r = x' 'end' '# a comment' 'genome b' 'r = * x 2' 'end'
[ -n "$first" ] && [ "$first" = "$(hash_of a)" ]; report $((! $?)) "a genome's hash is its own"
[ "$first" = "$(printf '%s\n' 'footpoint-genome 1' 'input x' '' 'genome a' 'r = x' 'end' | sha256sum | cut -d ' ' -f 1)" ]
report $((! $?)) 'and that of its printed text'

# A banner tells of a row its worst element, and nothing of what a function tests.
printf '%s\n' 'footpoint-genome 2' 'face tri3' 'range A 0 1 0 1 0 7' 'range xi 1 2' 'genome a' 'require xi' 'r = * / 1 xi A' \
    'q = * xi * xA xi' 'end' > "$g"
expect 'a face' 0 '' '' "$codegen" --quiet "$g" -o "$work/h.h"
told "$work/h.h" footpoint_tri3_a rounding | sed 's/[0-9.]*e-1[0-9]/N/g; s/ ([0-9]* points)//' > "$work/lines"
[ "$(cat "$work/lines")" = 'r <= N proved N sampled; q <= N proved N sampled' ]; report $((! $?)) 'rounding errors, a row each'
! grep -l ': undecided' generated/*_derivatives.h; report $((! $?)) 'denominators of derivatives are proved free of zeros'

# While it works: in a log a line for each function, on a terminal one line with the time left; stdout is data alone.
genome 'input x y' 'range y 1 2' 'genome a' 'r = * x y' 'end' 'genome b' 'r = / x y' 'end'
expect 'a line for each function' 0 '' '*' "$codegen" "$g" -o "$work/h.h"
sed 's/[0-9]* s$/N s/' "$work/stderr" > "$work/lines"
[ "$(cat "$work/lines")" = 'g.gen: a, 1 of 2, N s
g.gen: b, 2 of 2, N s' ]; report $((! $?)) 'says which'
expect 'none if quiet' 0 '' '' "$codegen" --quiet "$g" -o "$work/h.h"
expect 'none for counts' 0 '*' '' "$codegen" --count "$g"
if [ -n "$(command -v script)" ]; then
    script -qec "stty cols 60; $codegen --count $g > $work/data" /dev/null > "$work/tty"
    tr '\r' '\n' < "$work/tty" | sed 's/\x1b\[K//' | grep -v '^$' > "$work/lines"
    [ "$(sed 's/[0-9]* s left/N s left/' "$work/lines")" = 'a, 1 of 2, search for the cheapest form ...
b, 2 of 2, search for the cheapest form ...  N s left' ] && [ "$(wc -l < "$work/data")" = 3 ]
    report $((! $?)) 'a line on a terminal'
fi

# A long chain of protected quotients: work that grows as its square would take minutes (tests/long/hostile.sh has longer ones).
awk 'BEGIN { print "footpoint-genome 1\ninput x y\ngenome g"; printf "r ="
    for (i = 0; i < 50000; i++) printf " %% x"; print " y\nend" }' > "$g"
(ulimit -t 20; exec "$codegen" --quiet --allow-poles "$g" -o "$work/h.h") > /dev/null 2>&1
report $((! $?)) 'a chain of protected quotients'

# ---- regions that hold nothing, or give an input by one of their own ----
header() { expect "$1" 1 '' "$g:$2: error: $3" "$codegen" --quiet --allow-poles $4 -o "$work/h.h" "$g"; }
two() { printf '%s\n' "footpoint-genome 2" "$@" > "$g"; }
two 'input x y' region 'input x y' 'range x 0 1, y 1 2' 'require - x 2' end 'genome g' 'r = / x + y 3' end
header 'no inputs with all requires of a block' 6:1 'no inputs in the ranges satisfy all requires'
two 'input x' 'range x -1 0' 'require x' 'genome g' 'r = x' end
header 'a require that is 0 at most' 4:1 'no inputs in the ranges satisfy all requires'
two 'input x' region 'input u' 'range u 0 1000' 'let x = u' end 'genome g' 'r = + * * x x x + x 0.1' end
"$codegen" --quiet -o "$work/h.h" "$g"
awk '/rounding: .* proved/ { good = $5 > 1e-8 } END { exit !good }' "$work/h.h"
report $((! $?)) 'bounds where an input is one of the block'

# ---- names that a header has ----
# ---- headers of edges, which have no genomes ----
expect 'an edge and genomes' 2 '' 'footpoint-codegen: --edge goes with -o FILE, and no genome file (try --help)' \
    "$BIN/footpoint-codegen" --edge edge2 "$g"
misused '--edge goes with -o FILE, --prefix, --precision and --quiet only' --edge edge2 --seed 1 -o "$work/h.h"
expect 'an edge that there is not' 2 '' 'footpoint-codegen: unknown edge: edge4; there are edge2 and edge3' \
    "$BIN/footpoint-codegen" --edge edge4 -o "$work/h.h"
for edge in edge2 edge3; do
    "$BIN/footpoint-codegen" --edge $edge -o "$work/footpoint_$edge.h" && cmp "$work/footpoint_$edge.h" generated/footpoint_$edge.h
    report $((! $?)) "the header of $edge is what is written now"
done

genome 'input g' 'genome g' 'r = g' end; header 'a function called as its input' 3:1 "genome 'g' conflicts with a name of the header itself, with prefix in" '--prefix in'
genome 'input x' 'genome detail_bits' 'r = x' end
header 'a function called as a helper' 3:1 "genome 'detail_bits' conflicts with a name of the header itself, with prefix footpoint" '--prefix footpoint'
two 'segment quad4 any' 'genome g' 'xi = / 1 - xA xB, eta = 0' end 'genome g_over_n' 'xi = 0, eta = 0' end
header 'a function called as a loop' 6:1 "genome 'g_over_n' conflicts with a function of 'g'"
two 'segment quad4 any' 'genome g_detail' 'xi = 0, eta = 0' end
header 'a function called as a part of another' 3:1 "genome 'g_detail' conflicts with a name of the header itself, with prefix footpoint_h"

# ---- test points ----
genome 'input x y' 'range x 0.5 2' 'genome g' 'r = + * x y 0.3' end
"$codegen" --quiet "$g" -o "$work/h.h" && cp "$work/h.h" "$work/alone.h" &&
    "$codegen" --quiet --points "$work/h_points.h" "$g" -o "$work/h.h" && cmp -s "$work/h.h" "$work/alone.h" &&
    [ "$(grep -c '^    {.*},$' "$work/h_points.h")" = 8 ] && grep -q '^static const double footpoint_h_g_points\[\]\[4\] = {$' "$work/h_points.h"
report $((! $?)) 'test points are a file of their own, and the header is the same without them'
for option in '--precision float' '--language fortran'; do
    # shellcheck disable=SC2086
    expect "test points, $option" 1 '' "$g: error: --points are for C code in double, but not at places of faces" \
        "$codegen" --quiet $option --points "$work/none.h" "$g" -o "$work/h.h"
done
[ ! -e "$work/none.h" ]; report $((! $?)) 'refused test points are not written'

# ---- rows at a place of a face ----
face() { printf '%s\n' "footpoint-genome 2" "face tri3" "genome g" "$@" 'require xi' end > "$g"; }
face 'status = xi'; header 'a row called as a variable' 4:1 "row 'status' takes a name of the header's own or a word of C"
face 'r = + 1 xS'; header 'a row that has a size' 4:1 "row 'r' is not of one power of a length: faces have any size"
face 'r1 = xi' 'r2 = xi' 'r3 = xi' 'r4 = xi' 'r5 = xi' 'r6 = xi' 'r7 = xi' 'r8 = xi' 'r9 = xi' \
    'r10 = xi' 'r11 = xi' 'r12 = xi' 'r13 = xi' 'r14 = xi' 'r15 = xi' 'r16 = xi' 'r17 = xi'
header 'too many rows' 20:1 "genome 'g' has more than 16 rows"
face 'r = xi'
expect 'a face in float' 1 '' "$g: error: functions at places of faces are in double alone" \
    "$codegen" --quiet --precision float -o "$work/h.h" "$g"
face 'r = * xi xA'
"$codegen" --quiet -o "$work/h.h" "$g"
cat > "$work/use.c" <<'C'
#include "h.h"
int main(void)
{
    const double a[3] = {NAN, 0, 0}, b[3] = {1, 0, 0}, c[3] = {0, 1, 0}, s[3] = {0, 0, 1}, loc[2] = {0.3, 0.3};
    double r[1];
    return footpoint_tri3_g(a, b, c, s, loc, r) == FOOTPOINT_ERR_NOT_FINITE ? 0 : 1;
}
C
${CC:-gcc} -std=c99 -Wall -Wextra -Werror "$work/use.c" -o "$work/use" -lm && "$work/use"
report $((! $?)) 'a node that is no number, and one that no row reads'
