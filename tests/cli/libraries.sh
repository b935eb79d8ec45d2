# Checks the judge of other libraries' searches (make rivals): it separates right, wrong, refused, crashed and endless answers.  Our
# own answers must be right if they promise it.
. tests/cli/expect.inc
. tests/hard/build.inc
FOOTPOINT_BUILT=
[ -n "$FOOTPOINT_LONG" ] || [ "$BIN" != build ] || FOOTPOINT_BUILT=1
CC=${CC:-gcc}
mkdir -p "$work/objects"
for source in tests/libraries/face.c tests/libraries/cases.c tests/libraries/library_judge.c tests/libraries/libraries_main.c \
    tests/hard/truth.c tests/hard/subdivision.c tests/hard/draw.c tests/hard/hard.c tests/hard/wild.c; do
    object=${source##*/}
    object=$work/objects/${object%.c}.o
    hard_built $source "$object" || $CC -std=c11 -D_DEFAULT_SOURCE -O1 -ffp-contract=off -c $source -o "$object" &
done
share='-std=c11 -D_DEFAULT_SOURCE -O0 -fPIC -shared -fvisibility=hidden'
$CC $share $called '-DLIBRARY_VERSION="0"' tests/libraries/library_footpoint.c "$BIN/libfootpoint_ccx.a" "$BIN/libfootpoint.a" -lm \
    -o "$work/footpoint.so"
$CC $share tests/libraries/library_planted.c -lm -o "$work/planted.so"
wait
$CC "$work"/objects/*.o -o "$work/main" -ldl -lm; report $((! $?)) 'builds'
expect 'no arguments' 2 '' 'usage: libraries_main CASES LIBRARY.so...' "$work/main"
expect 'no such library' 3 '' '*' "$work/main" 1 "$work/none.so"
expect 'planted searches' 0 '*' '' "$work/main" 1 "$work/planted.so"
cp "$work/stdout" "$work/table"
judged() { awk -F, -v s="$1" '$1 == "family" && $5 == s && $8 != "" { right += $9; wrong += $10; refused += $11; endless += $12; crashed += $13 } END { print right + 0, wrong + 0, refused + 0, endless + 0, crashed + 0 }' "$work/table"; }
families=$(awk -F, '$1 == "family" && $5 == "refuse"' "$work/table" | wc -l)
expect 'refusals' 0 "0 0 $families 0 0" '' judged refuse
expect 'crashes' 0 "0 0 0 0 $families" '' judged crash
expect 'what never ends' 0 "0 0 0 $families 0" '' judged endless
expect 'points off the face' 0 "0 $families 0 0 0" '' judged far
judged corner | awk '{ exit !($1 + $2 == '$families' && $2 > 0.7 * ($1 + $2)) }'; report $((! $?)) 'a corner is rarely right'
expect 'ours, and two references that agree' 0 '*' '' "$work/main" 2 "$work/footpoint.so"
cp "$work/stdout" "$work/table"
expect 'footpoint_robust is right' 0 "$((2 * families)) 0 0 0 0" '' judged robust
judged locate | awk '{ exit $2 + $4 + $5 > 0 }'; report $((! $?)) 'footpoint_locate says so where it has no answer'
awk -F, '$1 == "family" && $2 ~ /^(on|ordinary)$/ && $4 == "footpoint" { n++; bad += $9 != 2 || !($7 > 0 && $7 < 1e6) } END { exit bad || n < 20 }' \
    "$work/table"; report $((! $?)) 'ours on ordinary faces of all kinds'
awk -F, '$1 == "derivative" { n++; bad += $6 > 0 || !($7 < 1e-13) } END { exit bad || n != 1 }' "$work/table"; report $((! $?)) 'derivatives'
awk -f tests/libraries/libraries_table.awk -v absent=nothing "$work/table" | grep -q '^\* footpoint  *robust '; report $((! $?)) 'the table'
awk -f tests/libraries/libraries_map.awk -v kind=quad4 "$work/table" | tail -n 1 | grep -q '^</svg>$'; report $((! $?)) 'the picture'
