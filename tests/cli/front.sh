# Checks the members of a front that footpoint-evolve writes for `make front`, and the choice of which_ship.awk for invented times.
. tests/cli/expect.inc
evolve=$BIN/footpoint-evolve
cp tests/scenes/steps.scene "$work/"
expect 'members without a front' 2 '' 'footpoint-evolve: error: --members needs --front' "$evolve" --scene quad4 --members 3
"$evolve" --scene "$work/steps.scene" --from-scratch --generations 1 --islands 2 --population 20 --quiet -o "$work/a.gen" --front "$work/front.gen" \
    --members 3 > /dev/null 2>&1
"$evolve" --scene "$work/steps.scene" --from-scratch --generations 1 --islands 2 --population 20 --quiet -o "$work/b.gen" > /dev/null 2>&1
cmp -s "$work/a.gen" "$work/b.gen"; report $((! $?)) 'the genomes are those of any run'
costs=$(sed -n 's/^genome both_both_c//p' "$work/front.gen" | tr '\n' ' ')
echo "$costs" | awk '{ bad = NF < 1 || NF > 3; for (i = 1; i <= NF; i++) bad = bad || $i > 1.06 * 400 || (i > 1 && $i <= $(i - 1)); exit bad }'
report $((! $?)) "three members at most, within the budget, by cost: $costs"
grep -q '^range .*C ' "$work/front.gen"; report $((! $?)) 'with the region that they are proved in'
# Two frames that begin alike: if the first lets of a line exist already, the others get a line of their own.
expect 'a front of two frames' 0 '*' '*' "$evolve" --scene tests/scenes/small.scene --from-scratch --generations 1 --population 20 \
    --quiet -o "$work/a.gen" --front "$work/two.gen"
expect 'which is read again' 0 '*' '*' "$evolve" --scene tests/scenes/small.scene --from-scratch --generations 0 --quiet \
    --seeds "$work/two.gen" -o "$work/b.gen"

# scene,sample,method,ours,mode,mul,div,add,sqrt,ns,ratio,mean_xi,p99_xi,max_xi,mean_eta,p99_eta,max_eta,failures
method() { # method NAME OURS NS ARRAYS MEAN WORST
    for mode in scalar batch; do
        [ $mode = scalar ] && ns=$3 || ns=$4
        echo "s,validation,$1,$2,$mode,0,0,0,0,$ns,1,$5,$6,$6,$5,$6,$6,0"
    done
}
front=footpoint_s_front
{
    method newton 0 1 1 0 0
    method footpoint_s_fine 1 10 1 1e-3 1e-2
    method footpoint_s_full 1 20 2 1e-6 1e-5
    method ${front}_fine_both_c90 1 10 1 5e-4 1e-2
    method ${front}_fine_both_c91 1 9 1.1 1e-4 1e-2   # slower over arrays
    method ${front}_fine_both_c92 1 9 0.9 8e-4 2e-2   # a larger worst error
    method ${front}_full_both_c150 1 21 2 2e-6 1e-5
} > "$work/times.csv"
awk -v id=s -f evolve/which_ship.awk "$work/times.csv" > "$work/table"
verdict() { # verdict FUNCTION WORDS
    grep -q "^$1 .*  $2\$" "$work/table"; report $((! $?)) "$1: $2"
}
verdict s_fine 'gives way to s_front_fine_both_c90'
verdict s_full stays
verdict s_front_fine_both_c90 ship
verdict s_front_fine_both_c91 new
verdict s_front_fine_both_c92 new
verdict s_front_full_both_c150 'behind s_full'
grep -q '^    { name = "fine"; budget = 90; }, // s_front_fine_both_c90: error 0.50, time 1.00 and, over arrays, 1.00 of what ships$' "$work/table"
report $((! $?)) 'a line for the scene file'
