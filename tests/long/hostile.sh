# Checks that enormous, deep and broken genomes end in code or in one line, within limits of memory and of processor
# time, which does not depend on other load; a limit by the clock stops endless waits.
. tests/cli/expect.inc
codegen=$BIN/footpoint-codegen
seconds=60 kilobytes=4000000
grep -q __asan_init "$codegen" && seconds=600 kilobytes=unlimited # the sanitizer reserves all addresses that there are

ends() { # ends NAME STATUSES [ARGUMENTS...]   the genome is $work/NAME.gen
    name=$1 statuses=$2
    shift 2
    (
        ulimit -v $kilobytes
        ulimit -t $seconds
        exec timeout $((10 * seconds)) "$codegen" --allow-poles "$@" "$work/$name.gen" -o "$work/$name.h"
    ) > "$work/log" 2>&1
    status=$?
    case " $statuses " in
    *" $status "*) [ $status -eq 0 ] || [ "$(wc -l < "$work/log")" = 1 ] ;;
    *) false ;;
    esac
    good=$((! $?))
    [ $good = 1 ] || { echo "# exit status $status, $(wc -l < "$work/log") lines"; head -3 "$work/log" | cut -c1-200 | sed 's/^/#   /'; }
    report $good "$name"
    rm -f "$work/$name.gen" "$work/$name.h"
}

genome() { # genome NAME: the lines of standard input between the inputs x y z and the end
    { printf 'footpoint-genome 1\ninput x y z\n'; cat; echo end; } > "$work/$1.gen"
}

# One expression of 100000 genes: a prefix again and again, then a leaf.
repeated() { # repeated NAME PREFIX LEAF
    awk -v p="$2" -v l="$3" 'BEGIN { n = 100000 / split(p, words, " "); printf "genome g\nr ="
        for (i = 0; i < n; i++) printf " %s", p; print " " l }' | genome "$1"
    ends "$1" '0 1'
}
repeated sum '+ x' y
repeated difference '- y' x
repeated product '* 1.5' x
repeated power '* x' y
repeated quotient '/ x' y
repeated protected '% x' y
repeated alternate '+ 1 * x' y
repeated minimum 'min x + 1' y
repeated root 'sqrt + 0.1' y
repeated continued-fraction '/ 1 + x' y
repeated negatives 'neg' x
repeated sizes 'abs' x
repeated roots 'sqrt' x
repeated functions 'min x sqrt abs max y' z

# A million operations deep.
deep() { # deep NAME OPERATIONS COUNT: a prefix of so many operations
    awk -v p="$2" -v k="$3" 'BEGIN { printf "genome g\nr ="; for (i = 0; i < 1000000 / k; i++) printf " %s", p; print " y" }' |
        genome "$1"
    ends "$1" 0
}
deep deep-sum '+ x' 1
deep deep-difference '- x' 1
deep deep-product '* x' 1
deep deep-quotient '/ x' 1
deep deep-protected '% x' 1
deep deep-minimum 'min x' 1
deep deep-maximum 'max x' 1
deep deep-root sqrt 1
deep deep-size abs 1
deep deep-alternate '+ 1 * x' 2
deep deep-continued-fraction '/ 1 + x' 2
deep deep-clamp 'min x max z' 2

# Lets in terms of the one or two before them: degrees and constants that double, or grow as Fibonacci's numbers.
lets() { # lets NAME STATUSES COUNT FIRST SECOND EXPRESSION: "a" is the last value, "b" the one before
    awk -v n="$3" -v first="$4" -v second="$5" -v e="$6" 'BEGIN { print "let v0 = " first; print "let v1 = " second
        for (i = 2; i < n; i++) { t = " " e " "; gsub(/ a /, " v" i - 1 " ", t); gsub(/ a /, " v" i - 1 " ", t)
            gsub(/ b /, " v" i - 2 " ", t); gsub(/ b /, " v" i - 2 " ", t); print "let v" i " =" t }
        print "genome g\nr = * x v" n - 1 }' | genome "$1"
    ends "$1" "$2"
}
lets square '0' 50 x y '* a a'
lets square-of-sum '0 1' 50 x '+ y 1' '* a a'
lets square-of-constant '1' 50 1.5 1.5 '* a a'
lets square-of-large '1' 50 1e300 1e300 '* a a'
lets cancelled-constant '0 1' 50 1e300 1e300 '/ * a a * b b'
lets logistic '0 1' 50 x y '+ z * a a'
lets logistic-long '0 1' 2000 x y '+ z * a a'
lets newton '0 1' 50 x y '- a / - * a a z * 2 a'
lets fibonacci-sum '0 1' 2000 x y '+ a b'
lets fibonacci-product '0 1' 2000 x y '* a b'
lets fibonacci-quotient '0 1' 2000 x y '/ 1 + a b'
lets fibonacci-minimum '0 1' 2000 x y 'min a + 1 b'
lets chain '0 1' 100000 x y '+ y * a z'
lets power-of-sum '0' 65 '+ x 1' '+ x 1' '* a a'

# A full binary tree of quotients of both kinds, and many outputs over many inputs.
awk 'function tree(d) { if (d == 0) return substr("x y z", 1 + 2 * (n++ * 7 % 3), 1)
                        return (++n * 5 % 3 ? "% " : "/ ") tree(d - 1) " " tree(d - 1) }
     BEGIN { print "genome g"; print "r = " tree(11) }' | genome tree-of-quotients
ends tree-of-quotients '0 1'
outputs() { # outputs NAME DEPTH OPERATORS: 200 trees of these operators over 200 inputs
    awk -v depth="$2" -v operators="$3" '
        function random(k) { seed = (seed * 16807) % 2147483647; return seed % k }
        function tree(d) { return d ? operator[1 + random(n)] " " tree(d - 1) " " tree(d - 1) : "x" random(200) }
        BEGIN { seed = 1; n = split(operators, operator, " "); printf "footpoint-genome 1\ninput"
                for (i = 0; i < 200; i++) printf " x%d", i; print "\ngenome g"
                for (i = 0; i < 200; i++) print "o" i " = " tree(depth); print "end" }' > "$work/$1.gen"
    ends "$1" '0 1'
}
outputs outputs-polynomial 6 '+ * -'
outputs outputs-rational 4 '+ * - /'
outputs outputs-protected 4 '+ * %'
awk 'BEGIN { printf "footpoint-genome 1\ninput"; for (i = 0; i < 200; i++) printf " x%d", i; print "\ngenome g"
    for (i = 0; i < 200; i++) { printf "o%d =", i; for (k = 0; k < 199; k++) printf " + * %d x%d", (i * k) % 97 + 2, k; print " x199" }
    print "end" }' > "$work/matrix.gen"
ends matrix '0'

# Many inputs, outputs and names.
numbered() { awk -v from="$1" -v to="$2" -v f="$3" 'BEGIN { for (i = from; i < to; i++) printf f, i, i, i }'; }
{ echo 'footpoint-genome 1'; echo "input$(numbered 0 10000 ' x%d')"; echo 'genome g'
  echo "r =$(numbered 0 9999 ' + x%d') x9999"; echo end; } > "$work/inputs.gen"
ends inputs '0'
{ echo 'footpoint-genome 1'; echo "input a b$(numbered 0 10000 ' x%d')"; echo 'genome g'
  echo "r =$(numbered 0 9999 ' + / x%d - a x%d') x9999"; echo end; } > "$work/quotients.gen"
ends quotients '0 1'
{ echo 'footpoint-genome 1'; echo "input a b$(numbered 0 40000 ' x%d')"; echo 'genome g'
  echo "r = + * a$(numbered 0 39999 ' * x%d') x39999 * b$(numbered 0 39999 ' * x%d') x39999"; echo end; } > "$work/factors.gen"
ends factors '0 1'
{ echo 'genome g'; numbered 0 1000 'o%d = + * x %d * y z\n'; } | genome outputs
ends outputs '0'
{ numbered 0 1000 'let q%d = / 1 + y * x %d\n'; echo 'genome g'
  echo "r = +$(numbered 0 999 ' * q%d') q999$(numbered 0 999 ' + * x q%d') q999"; } | genome shared-quotients
ends shared-quotients '0 1'
{ numbered 0 1000 'genome g%d\nr = + x %d\nend\n'; echo 'genome g'; echo 'r = x'; } | genome genomes
ends genomes '0' --effort 0

# Broken and odd bytes.
long=$(awk 'BEGIN { for (i = 0; i < 20000; i++) printf "abcdefghij" }')
{ echo "genome $long"; echo 'r = x'; } | genome long-name
ends long-name '1'
{ echo 'genome g'; echo "r = + x $long"; } | genome long-gene
ends long-gene '1'
{ echo 'genome g'; echo "r = 0.${long}1"; } | genome long-number
ends long-number '1'
{ echo "note who $long"; echo "# $long"; echo 'genome g'; echo 'r = x'; } | genome long-note
ends long-note '0'
printf 'genome g\r\nr = + x\r\n y\r\n' | genome carriage-returns
ends carriage-returns '0'
printf 'genome g\nr = + x\0 y\n' | genome nul
ends nul '1'
head -c 100000 /dev/zero > "$work/zeros.gen"
ends zeros '1'
awk 'BEGIN { for (i = 0; i < 50000; i++) printf "%c", (i * 7919 + int(i * i / 7)) % 255 + 1 }' > "$work/noise.gen"
ends noise '1'

# A small genome cut after each byte.
printf 'footpoint-genome 1\nnote a b\ninput x y # two\nrange x -1 1.5\nrequire y\nlet a = * x -0.25\ngenome g\nnote c d\nr = + a sqrt y\nend' \
    > "$work/whole"
size=$(wc -c < "$work/whole") bad=
for n in $(seq 0 "$size"); do
    head -c "$n" "$work/whole" > "$work/cut.gen"
    timeout 60 "$codegen" --count --effort 0 "$work/cut.gen" > "$work/stdout" 2> "$work/stderr"
    status=$?
    [ $status -eq $((n < size)) ] && [ "$(wc -l < "$work/stderr")" = $((n < size)) ] || bad="$bad $n"
done
[ -z "$bad" ] || echo "# cut after$bad"
[ -z "$bad" ]
report $((! $?)) "cut after each of $size bytes"
