# Compares the proved rounding bounds with Gappa's for the same statements, each operation rounded. Ours, which hold
# with fused operations as well, must be at most twice as wide.
. tests/cli/expect.inc
command -v gappa > /dev/null || { report 1 'skipped: no gappa'; exit 0; }

# genome NAME "INPUT LO HI ..." EXPRESSION
genome() {
    {
        echo 'footpoint-genome 1'
        echo "input $(echo "$2" | awk '{ for (i = 1; i <= NF; i += 3) printf "%s ", $i }')"
        echo "$2" | awk '{ for (i = 1; i <= NF; i += 3) print "range", $i, $(i + 1), $(i + 2) }'
        echo 'genome g'
        echo "v = $3"
        echo end
    } > "$work/$1.gen"
}

genome bilinear 'x -1 1 y -1 1' '+ + 0.7 * 0.3 x * y + 0.2 * 1.1 x'
genome quintic 'x -1 1' '- x * * x * x x - 0.1666666 * 0.0083333 * x x'
genome cubic 'x -2 2 y -2 2 z -0.3 0.3' '+ - * 0.37 * x * x y * 1.3 * y z + * 0.11 * z * z z - * 2.5 * x z 0.77'
genome rational 'x -1 1 y 0 2 z 0.5 1.5' '+ * x * y y - * 0.3 x / * z + y x + 2 * x x'
genome taper 'p -1 1 q -1 1 a -0.3 0.3 b -0.3 0.3' '/ - p * a * p q + 1 + * a q * b p'
genome norm 'x 1 2 y -1 1 z -1 1' 'sqrt + + * x x * y y * z z'
genome resistances 'x 1 10 y 1 10' '/ 1 + / 1 x / 1 y'

# statements PREFIX EQUALS ROUND: the body of the function in $work/g.h, in Gappa's words
statements() {
    sed -n '/^FOOTPOINT_FN void [a-z_]*_g(/,/^}/p' "$work/g.h" |
        awk '/;$/ { sub(/^ +/, "    " text, $0); print; text = ""; next } / = |^ +[^ ]/ { sub(/^ +/, ""); text = text $0 " " }' |
        sed 's/, \(t[0-9]*\) = /;\n    const double \1 = /g' | sed -n '
        s/^    const double \([a-z0-9]*\) = \(.*\);$/\1 @ \2;/p
        s/^    \*out_\([a-z]*\) = \(.*\);$/\1 @ \2;/p' |
        sed -E "s/([^a-z0-9_.])([0-9]+\.[0-9]+)/\1$3(\2)/g; s/\b(t[0-9]+|v)\b/$1\1/g; s/@/$2/"
}

for file in "$work"/*.gen; do
    name=$(basename "$file" .gen)
    "$BIN/footpoint-codegen" "$file" -o "$work/g.h" || { report 0 "$name"; continue; }
    {
        echo '@rnd = float<ieee_64, ne>;'
        statements '' 'rnd=' rnd
        statements E '=' ''
        echo "{ $(awk '$1 == "range" { printf "%sin_%s in [%s,%s]", and, $2, $3, $4; and = " /\\ " }' "$file") -> v - Ev in ? }"
    } > "$work/g.gappa"
    theirs=$(gappa "$work/g.gappa" 2>&1 | sed -n 's/.*v - Ev in \[.*{\(-*[0-9.e+-]*\),.*{\([0-9.e+-]*\),.*/\1 \2/p')
    ours=$(sed -n 's/.*rounding: *v <= \([0-9.e+-]*\) proved.*/\1/p' "$work/g.h")
    verdict=$(echo "$ours $theirs" | awk 'NF == 3 { lo = $2 < 0 ? -$2 : $2; most = lo > $3 ? lo : $3
                                                    printf "%d %.2g times", $1 <= 2 * most, $1 / most }')
    [ -n "$verdict" ] || { verdict='0 no answer'; gappa "$work/g.gappa" 2>&1 | sed 's/^/# /' | head; }
    report "${verdict%% *}" "$name: ours $ours is ${verdict#* } Gappa's"
done
