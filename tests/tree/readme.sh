# Checks the READMEs.  Programs compile, run and print the output shown; the genome compiles; commands, options,
# files, functions and links exist; figures agree with headers and genomes.
. tests/cli/expect.inc
CC=${CC:-gcc}
documents='README.md codegen/README.md evolve/README.md generated/README.md runtime/README.md tests/README.md'

check() { # check NAME WRONG: what is wrong, a line each
    [ -z "$2" ]
    good=$?
    [ $good = 0 ] || echo "$2" | sed 's/^/# /'
    report $((! good)) "$1"
}
# blocks FILE LANGUAGE: the fenced blocks of a language
blocks() { awk -v fence="^\`\`\`$2\$" '$0 ~ fence { on = 1; next } /^```$/ { on = 0 } on' "$1"; }
# quoted FILES: the text in backticks outside of blocks, a line each
quoted() { cat "$@" | awk '/^```/ { on = !on; next } !on' | tr '\n' ' ' | grep -o '`[^`]*`' | tr -d '`'; }

lines=$(wc -l < README.md)
check 'the front page has 150 lines at most' "$([ "$lines" -le 150 ] || echo "$lines lines")"

# ---- programs and genomes ---------------------------------------------------------------------------------------------

for document in README.md generated/README.md; do
    blocks $document c > "$work/use.c"
    shown=$(awk '/^```/ { if (on) exit; if (inside = !inside) { on = after && $0 == "```"; after = after || $0 == "```c" } next } on' \
        $document)
    [ -n "$shown" ]; report $((! $?)) "$document shows what its program prints"
    $CC -std=c99 -Wall -Wextra -Wpedantic -Werror -Igenerated "$work/use.c" -o "$work/use" -lm
    expect "the program of $document" 0 "$shown" '' "$work/use"
done
cp README.md "$work/" && (cd "$work" && blocks README.md c > use.c)
expect 'the compile line' 0 "$(blocks README.md '' | grep '^xi ')" '' \
    sh -c "cp -r generated '$work/' && cd '$work' && $(blocks README.md sh | grep 'use\.c')"

if command -v gfortran > /dev/null; then
    blocks README.md fortran > "$work/use.f90"
    gfortran "-I$BIN" "$work/use.f90" "$BIN/libfootpoint.a" -lm -o "$work/use_f90"
    expect 'the program in Fortran' 0 "$(blocks README.md '' | grep '^status [0-9]')" '' "$work/use_f90"
fi

awk '/^footpoint-genome/ { on = 1 } /^```$/ { on = 0 } on' codegen/README.md > "$work/example.gen"
expect 'the genome' 0 'genome,mul,div,add,sqrt,compare
example,2,1,2,0,1' '' "$BIN/footpoint-codegen" --count "$work/example.gen"
tools=$(cd "$BIN" && pwd)
blocks codegen/README.md sh | grep '^build/footpoint-codegen' | sed 's/#.*//' > "$work/lines"
while read -r program options; do
    (cd "$work" && "$tools/${program#build/}" --effort 0 $options) > "$work/log" 2>&1
    report $((! $?)) "footpoint-codegen $options"
done < "$work/lines"

# ---- names ---------------------------------------------------------------------------------------------------------

awk -F ':.*## ' '/^[a-z+ -]+:.*## / { gsub(" ", "\n", $1); print $1 }' Makefile | sort > "$work/targets"
for document in $documents; do
    blocks $document sh | sed 's/#.*//'
    quoted $document
done > "$work/commands"
sed -n 's/.*\<make \(.*\)/\1/p' "$work/commands" | sed "s/[&|;>].*//; s/'[^']*'//g" | tr ' ' '\n' | grep '^[a-z]' | grep -v '[=.]' |
    sort -u | comm -23 - "$work/targets" > "$work/wrong"
check 'targets of make' "$(cat "$work/wrong")"
sed -n 's/.*\<make \(.*\)/\1/p' "$work/commands" | grep -o '\<[A-Z_]*=' | sort -u | while read -r variable; do
    grep -q "${variable%=}" Makefile || echo "$variable"
done > "$work/wrong"
check 'variables of make' "$(cat "$work/wrong")"

: > "$work/help"
for program in evolve codegen bench pga perceptron calibrate; do
    "$BIN/footpoint-$program" --help > "$work/help.$program" 2> "$work/log" || echo "# no $program"
    cat "$work/help.$program" >> "$work/help"
done
# Options after a program must be its own; options by themselves may be any program's, or mpirun's.
sed -e ':a' -e '/\\$/N; s/\\\n//; ta' "$work/commands" |
    sed -n 's/.*footpoint-\(evolve\|codegen\|bench\|pga\|perceptron\|calibrate\) \(.*\)/\1 \2/p' |
    while read -r program options; do
        for option in $options; do
            case $option in
            --*) grep -q -e "$option\\>" "$work/help.$program" || echo "footpoint-$program $option" ;;
            esac
        done
    done > "$work/wrong"
check 'options behind programs' "$(cat "$work/wrong")"
grep -v '^mpirun\|^srun' "$work/commands" | grep -o '^--[a-z-]*' | sort -u | while read -r option; do
    [ "$option" = --mca ] || grep -q -e "$option\\>" "$work/help" || echo "$option"
done > "$work/wrong"
check 'options by themselves' "$(cat "$work/wrong")"

# Files that users type; rooms and recipes name folders by themselves.
quoted $documents | tr ' ' '\n' | sed 's/[,;:]$//' |
    grep -E '^(tests/(cli|tree|long|timed|example|expressions|scenes|meshes|paper|hard)|evolve/(scenes|frames|genomes)|generated)/[A-Za-z0-9_./-]+$' |
    grep -vE '(NAME|mine)' | sort -u | while read -r path; do
    [ -e "$path" ] || [ -e "$path.c" ] || echo "$path"
done > "$work/wrong"
check 'files' "$(cat "$work/wrong")"

# anchors FILE: the names under which links reach its headings
anchors() { sed -n '/^```/,/^```/d; s/^##* //p' "$1" | tr 'A-Z ' 'a-z-' | tr -dc 'a-z0-9_\n-'; }
for document in $documents tests/queries/README.md; do
    grep -o '](\([^)]*\))' $document | sed 's/^](//; s/)$//' | while read -r link; do
        page=${link%%#*} heading=${link#"${link%%#*}"}
        page=${page:+$(dirname $document)/$page}
        [ -e "${page:-$document}" ] && { [ -z "$heading" ] || anchors "${page:-$document}" | grep -qx "${heading#?}"; } ||
            echo "$document: $link"
    done
done > "$work/wrong"
check 'links and pictures' "$(cat "$work/wrong")"

cat runtime/*.h runtime/*/*.h runtime/replace/*.hpp generated/*.h | grep -oE '\<footpoint_[a-z0-9_]+\>' | sort -u > "$work/declared"
{ quoted $documents; cat $documents | awk '/^```/ { on = !on; next } on'; } | grep -oE '\<footpoint_[a-z0-9_]+\>' | sort -u |
    grep -vE '^footpoint_(example|mine|plates|ccx)' | comm -23 - "$work/declared" | while read -r name; do
    joined=$(echo "$name" | sed -E 's/_(place|gradients|hessian)(_n)?$//') # a search that FOOTPOINT_KIND_..._OF joins
    grep -qx "$joined" "$work/declared" || [ -e "generated/$name.h" ] || [ -e "runtime/$name.h" ] || echo "$name"
done > "$work/wrong"
check 'functions' "$(cat "$work/wrong")"

# ---- figures ----------------------------------------------------------------------------------------------------------

check 'what make figures fills' "$(sh tests/report/figures.sh --check)"

# operations HEADER FUNCTION: mul div add, from the banner
operations() { told "generated/footpoint_$1.h" "$2" operations | awk '{ print $1, $3, $5 }'; }
# heldout SCENE GENOME PART_OUTPUT: mean, 99 % and worst of samples, worst of climbing, too
heldout() {
    awk -v g="$2" -v note="${3%_*}_both" -v k="$([ "${3##*_}" = xi ]; echo $?)" \
        '/^genome/ { on = $2 == g } on && $2 == note { printf "%.1e %.1e %.1e %.1e\n", $(6 + k), $(9 + k), $(12 + k), $14 == "climbing" ? $(15 + k) : $(12 + k) }' \
        "evolve/genomes/$1.gen" | sed 's/e-0/e-/g'
}
for kind in tri3 quad4 tri6 quad8 quad9 bezier gregory; do # of derivatives: mul div add sqrt, both in a row if there are two
    counted=$(for f in gradients hessian; do
        told "generated/footpoint_${kind}_derivatives.h" footpoint_${kind}_$f operations
    done | awk '{ for (i = 1; i <= 7; i += 2) all[i] = all[i] (NR > 1 ? ", " : "") $i }
        END { print all[1] " | " all[3] " | " all[5] " | " all[7] }')
    row=$(sed -n "s/^| \`footpoint_${kind}_gradients\`[^|]* | \([0-9].*\) |\$/\1/p" generated/README.md)
    check "operations of the derivatives of $kind" "$([ "$row" = "$counted" ] || echo "$row, counted $counted")"
done
sed -n '/^\/\* footpoint_quad4_fast$/,/^ \*\/$/p' generated/README.md > "$work/banner"
sed -n "/^\/\* footpoint_quad4_fast\$/,/^ \*\/\$/p" generated/footpoint_quad4.h | cmp -s - "$work/banner"
report $((! $?)) "the banner shown"
for f in coarse balanced accurate; do
    row=$(awk -F' *\\| *' -v f="\`_$f\`" '/^\| `paper_quad4` / { on = 1 } on && $2 == f { print $3, $4, $5, $6; exit }' generated/README.md)
    xi=$(heldout paper-quad4 $f heldout_xi) eta=$(heldout paper-quad4 $f heldout_eta)
    set -- $xi $eta
    counted=$(operations paper_quad4 footpoint_paper_quad4_$f)
    [ "$row" = "${counted% *} $1 / $5 $2 / $6" ]; report $((! $?)) "paper_quad4_$f"
done
# Functions that were bred: trees of more than one gene, and programs with a seed; the others were derived by hand.
searches=$(ls generated/*.h | grep -v _derivatives)
functions=$(cat $searches | grep -c '^ \*   operations:') exact=$(cat $searches | grep -cE '^ \*   exact(_xi)?:')
bred=$(awk '/^genome/ { good = 0 } /^note training_(xi|eta)/ && $4 > 1 || /^note found_both seed/ { if (!good++) n++ } END { print n }' evolve/genomes/*.gen)
told=$(tr '\n' ' ' < generated/README.md | sed -n 's/.*Of the \([0-9]*\) functions in `generated.`, \([0-9]*\) are exact. Of the other \([0-9]*\), evolution bred \([0-9]*\):.* The other \([0-9]*\) were.*/\1 \2 \3 \4 \5/p')
expect 'how many functions were bred' 0 "$functions $exact $((functions - exact)) $bred $((functions - exact - bred))" '' echo "$told"
worst() { awk -v a="$1" -v b="$2" 'BEGIN { print(a + 0 > b + 0 ? a : b) }'; }
xi=$(heldout paper-quad4 program3 heldout_xi) eta=$(heldout paper-quad4 program3 heldout_eta)
random_xi=$(heldout paper-quad4 program3 heldout_random_xi) random_eta=$(heldout paper-quad4 program3 heldout_random_eta)
expect 'the bred programs on and off the lattice' 0 \
    "$(worst ${xi##* } ${eta##* }) $(worst ${random_xi##* } ${random_eta##* }) ${random_xi%% *}" '' echo "$(tr '\n' ' ' < generated/README.md |
        sed -n 's/.*`paper_quad4_program3` is off by \([^ ]*\) at worst, off the lattice by \([^ ]*\) (mean \([^,]*\),.*/\1 \2 \3/p')"
expect 'expressions counted' 0 "$(grep -h '^genome ' tests/expressions/*.gen | wc -l)" '' \
    sed -n 's/^`tests\/expressions\/` holds \([0-9]*\) expressions.*/\1/p' codegen/README.md
