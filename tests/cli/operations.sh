# Checks that --count counts the operations of the emitted text: an awk script that reads only the text counts the same.
. tests/cli/expect.inc
codegen=$BIN/footpoint-codegen

# Shared terms that divide, shared inverses, quotients of constants, doublings, signs, functions.
cat > "$work/terms.gen" << 'END'
footpoint-genome 1
input x y
genome shared
p = + y / 3 x
q = - * y y / 3 x
genome inverses
p = + / y x / 2 x
q = - / y + x y / x + x y
r = / 1 x
genome constants
p = + * / 1 3 x / y 7
q = - 0 * 2 * x + y / 4 9
genome functions
p = min * -2 x sqrt + y abs x
q = % x max y - 0 x
end
END
later 'operations: longer expressions, the paper'"'"'s measure'
if [ -n "$FOOTPOINT_LONG" ]; then effort=20 bytes=100000; else effort=3 bytes=150; fi
# Rows of faces are not read by the script.
files=$(find "$work/terms.gen" tests/expressions/*.gen tests/fuzz/corpus/*.gen \( -size -${bytes}c -o -name search-quad4.gen \) -exec grep -L '^face ' {} +)
for cost in throughput ${FOOTPOINT_LONG:+paper}; do
    for gen in $files; do
        "$codegen" --count --cost $cost --effort $effort "$gen" 2> /dev/null > "$work/counts" || continue
        "$codegen" --allow-poles --cost $cost --effort $effort --prefix g "$gen" -o "$work/g.h" 2> /dev/null || continue
        sed '1d; s/^[^,]*,//' "$work/counts" > "$work/said"
        awk -f tests/bench/operations.awk "$work/g.h" > "$work/seen"
        cmp -s "$work/said" "$work/seen" || echo "# $gen, $cost: $(diff "$work/said" "$work/seen" | tr '\n' ' ')"
    done
done > "$work/log"
cat "$work/log"
report $((! $(wc -l < "$work/log"))) 'counts are those of the text'
