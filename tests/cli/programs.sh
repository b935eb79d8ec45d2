# Checks tiers of programs: the same bytes on any number of ranks, from a checkpoint and from their own genomes; the front as a
# table; the header; names that are not functions of the frame.
. tests/cli/expect.inc
evolve=$BIN/footpoint-evolve
export OMPI_MCA_btl_base_warn_component_unused=0
mpirun="mpirun -q --oversubscribe"
[ "$(id -u)" != 0 ] || mpirun="$mpirun --allow-run-as-root"
same() { cmp -s "$1" "$2"; report $((! $?)) "$3"; }

scene() { sed "$1" tests/scenes/steps.scene > "$work/s.scene"; }
refused() { expect "$1" 1 '' "$work/s.scene:$2" "$evolve" --scene "$work/s.scene" -o "$work/o.gen" --generations 1; }
scene 's/"newton_kept"/"newton_lost"/'; refused 'no function of the frame' "14: error: tier 'both': 'newton_lost' is not a function of frame 'steps'"
scene 's/"newton_kept"/"+"/';  refused 'a function twice' "12: error: function '+' stands twice"
scene 's/"newton_kept"/"4"/';  refused 'no name' "12: error: 'functions' holds something that is neither an operator nor a name"
scene 's/^functions = .*/functions = ["inside"];/'; refused 'no sums' "12: error: 'functions' must hold \"+\" and \"*\", which terms are added with"
scene 's/^functions = .*/functions = "all";/'; refused 'no word' "12: error: 'functions' must be \"polynomial\" or \"rational\""
scene 's/"place"/"plice"/'; refused 'programs end in no function' "14: error: tier 'both': 'plice' is not a function of frame 'steps'"
scene 's/"ut", "vt"/"ut", "vw0"/'; refused 'starts from no value' "14: error: tier 'both': 'vw0' is not a value of frame 'steps'"
scene 's/starts = (\["p", "q"\]/starts = (["p"]/'; refused 'starts with one value' "15: error: 'starts' must be pairs of names, ([\"p\", \"q\"], ...)"
scene 's/max_length = 15;/max_length = 1; last = "place";/'; refused 'a value ends in nothing' "16: error: tier 'clamped': 'last' is for programs, of more operations than 1"

cp tests/scenes/steps.scene "$work/"
[ -n "$FOOTPOINT_LONG" ] && population=30 whole=6 || population=20 whole=2
later 'programs: populations of 30, six generations'
options="--scene $work/steps.scene --seed 3 --islands 3 --population $population --quiet"
"$evolve" $options --from-scratch --generations $whole -o "$work/one.gen" --front "$work/one.csv" > "$work/table"
grep -q '^both  *both  *- -> ' "$work/table" && grep -q '^clamped  *both ' "$work/table"; report $((! $?)) 'one line for both outputs'
for ranks in 3; do
    $mpirun -n $ranks "$evolve" $options --from-scratch --generations $whole -o "$work/more.gen" ${FOOTPOINT_LONG:+--front "$work/more.csv"} > /dev/null 2>&1
    same "$work/one.gen" "$work/more.gen" "$ranks ranks: the same genomes"
    [ -z "$FOOTPOINT_LONG" ] || same "$work/one.csv" "$work/more.csv" 'and the same front'
done
$mpirun -n 2 "$evolve" $options --from-scratch --generations $((whole / 2)) -o "$work/parts.gen" --checkpoint "$work/ck" > /dev/null 2>&1
"$evolve" --resume "$work/ck" --generations $whole --quiet > /dev/null
same "$work/one.gen" "$work/parts.gen" 'resumed: the same genomes'
"$evolve" --scene "$work/steps.scene" --seed 3 --quiet --start "$work/one.gen" --generations 0 -o "$work/again.gen" > /dev/null
same "$work/one.gen" "$work/again.gen" 'no generations: the same file again'

# The front: errors fall with rising cost, hand-written methods are on it, and the champion is a member.
awk -F, 'NR > 1 && $1 == "both" { if (n++ && !($3 > cost && $9 <= error)) bad = 1; cost = $3; error = $9 }
    NR > 1 && NF != 18 { bad = 1 } END { exit bad || n < 30 }' "$work/one.csv"; report $((! $?)) 'the front as a table'
best=$(awk '/^genome both/ { own = 1 } own && /^note training_both/ { print $NF; exit }' "$work/one.gen")
awk -F, -v own="$best" '$1 == "both" && $3 <= 400 { n++; found += $9 == own } END { exit !(n > 10 && found == 1) }' "$work/one.csv"
report $((! $?)) 'the champion is one within the budget'

# Written programs are lets and a call of their last function, with the counted cost.
"$BIN/footpoint-codegen" --effort 0 --allow-poles --count "$work/one.gen" > "$work/a" 2> /dev/null
[ "$(grep '^function' "$work/one.gen")" = 'function place u v -> xi eta' ] && [ -s "$work/a" ]
report $((! $?)) 'no function is needed but the last'
awk -F, -v error="$best" 'NR == FNR { if ($1 == "both" && $9 == error) { mul = $4; div = $6 } next }
    $1 == "both" { exit !($2 <= 1.05 * mul && $3 <= div) }' "$work/one.csv" "$work/a"; report $((! $?)) 'and costs no more than was counted'

expect 'a header' 0 '*' '*' "$BIN/footpoint-codegen" --effort 0 --allow-poles "$work/one.gen" -o "$work/one.h"
grep -q '^ \*   poles: ' "$work/one.h"; report $((! $?)) 'that says of every denominator what is known'
