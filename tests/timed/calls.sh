# What callers get, by footpoint-bench, for AVX2 and, where the machine has it, AVX-512: the table of README.md and those of
# generated/README.md.  Prints whether, as it was on the machines measured so far: a bare search without iteration is never slower than converged Newton; checked over arrays it is at
# least twice as quick as Newton with the same checks; closest points over arrays are twice as quick as four triangles;
# along a direction is 1.5 times as quick as Newton in three unknowns, 4 times over arrays; derivatives are the quickest,
# and fifteen times as quick as forward differentiation.
. tests/cli/expect.inc
isas=x86-64-v3
grep -q avx512f /proc/cpuinfo && isas="$isas x86-64-v4"

# quicker FILE METHOD RIVAL TIMES: of all methods that match, in independent calls and over arrays (TIMES: "1.5 4", 0:
# either), the rival's time over theirs
quicker() {
    awk -F, -v method="$2" -v rival="$3" -v times="$4" '
        NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; split(times, least, " "); next }
        { ns[$c["method"], $c["mode"]] = $c["ns"]; if ($c["method"] ~ method && $c["mode"] != "chain") name[++n] = $c["method"] " " $c["mode"] }
        END {
            for (i = 1; i <= n; i++) {
                split(name[i], row, " ")
                ratio = ns[rival, row[2]] / ns[row[1], row[2]]
                if (ratio < least[row[2] == "batch" ? 2 : 1]) { print "# " name[i] ": " ratio; bad++ }
            }
            exit bad > 0 || n == 0
        }' "$work/$1-$isa.csv"
}
measure() { "$BIN/footpoint-bench" --isa $isa --csv --quiet --rounds 15 --scene "$1" > "$work/$1-$isa.csv"; }
quicker_or_again() { quicker "$@" > "$work/slower" || { cat "$work/slower"; measure "$1"; false; }; }
holds() { steady "$isa, $2: $1" quicker_or_again "$2" "$3" "$4" "$5"; }

for isa in $isas; do
    for scene in quad4 tri6 quad8 quad9; do
        measure $scene
        report $((! $?)) "$isa, $scene: runs"
        awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next } $c["question"] != "bare" || $4 || $3 == "newton" {
            print "# " $1, $c["method"], $c["mode"], $c["ns"], $c["ratio"], $c["max_xi"], $c["max_gap"], $c["failures"] }' "$work/$scene-$isa.csv"
    done
    holds 'bare searches' quad4 '^footpoint_quad4_(fast|coarse|gauss2|medium|balanced|fine|precise|accurate)$' newton '1 1'
    holds 'checked' quad4 '^footpoint_quad4_.*_checked$' newton_checked '0.9 2'
    holds 'closest points' quad4 '^footpoint_quad4_.*_closest$' four_triangles '0 2'
    holds 'along a direction' quad4 '^footpoint_quad4_along$' newton_along '1.5 4'
    for rival in newton_implicit newton_differences; do
        holds 'derivatives' quad4 '^footpoint_quad4_accurate_gradients$' $rival '1 1'
    done
    holds 'derivatives, beside forward differentiation' quad4 '^footpoint_quad4_accurate_gradients$' newton_forward '15 15'
    for kind in tri6 quad8 quad9; do
        holds 'checked over arrays' $kind "^footpoint_${kind}_(accurate|sharp)_checked\$" ${kind}_newton_checked '0 2'
    done
done
awk -f tests/report/searches.awk "$work"/quad4-*.csv | sed "s/^/# /"
