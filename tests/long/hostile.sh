# Enormous genomes end in a header or one line, in bounded time.
. tests/cli/expect.inc
n=100000
make_genome() { # NAME PREFIX-REPEATED LEAVES
    { echo 'footpoint-genome 1'; echo 'input x y z'; echo 'genome g'; printf 'r ='
      awk -v n=$n -v p="$2" -v l="$3" 'BEGIN { for (i = 0; i < n / 2; i++) printf " %s", p; printf " %s\n", l; }'; echo end; } > "$work/$1.gen"
}
make_genome sum '+ x' y
make_genome difference '- y' x
make_genome product '* 1.5' x
make_genome power '* x' y
make_genome quotient '/ x' y
make_genome protected '% x' y
make_genome alternate '+ 1 * x' y
make_genome minimum 'min x + 1' y
make_genome root 'sqrt + 0.1' y
{ echo 'footpoint-genome 1'
  awk 'BEGIN { printf "input a b"; for (i = 0; i < 40000; i++) printf " x%d", i; print ""; print "genome g"; printf "r = +"
       for (k = 0; k < 2; k++) { printf " * %s", k ? "b" : "a"; for (i = 0; i < 39999; i++) printf " * x%d", i; printf " x39999" }
       print ""; print "end" }'; } > "$work/degree.gen"
for name in degree sum difference product power quotient protected alternate minimum root; do
    timeout 60 "$BIN/footpoint-codegen" --allow-poles "$work/$name.gen" -o "$work/$name.h" > "$work/log" 2>&1
    status=$?
    [ $status -eq 0 ] || { [ $status -eq 1 ] && [ "$(wc -l < "$work/log")" = 1 ]; }
    report $((! $?)) "$name of $n genes"
done
