# Counts the instructions of searches (gcc 12 -O3). On ordinary segments, inside and all around, footpoint_robust must
# cost no more than when its last resort was a list that nothing proved complete.
. tests/cli/expect.inc
CC=${CC:-gcc} CXX=${CXX:-g++}
if ! command -v valgrind > /dev/null; then
    report 1 'skipped: no valgrind'
    exit
fi
$CC -std=c11 -D_DEFAULT_SOURCE -O3 -DNDEBUG -ffp-contract=off \
    tests/hard/count_main.c tests/hard/hard.c tests/hard/draw.c tests/hard/wild.c runtime/geometry/*.c runtime/search/*.c runtime/certain/*.c -o "$work/count" -lm
for limit in '0 1226450 inside' '1 1456817 around'; do # of commit d5a6fb2
    set -- $limit
    count=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=footpoint_robust \
        "$work/count" "$1" 2>&1 | sed -n 's/.*Collected : //p')
    echo "# $3: $count instructions a thousand calls, $2 then"
    [ -n "$count" ] && [ "$count" -le "$2" ]; report $((! $?)) "no more instructions than before: $3"
done

# A proved foot point on an edge of three nodes: no more than two steps of Newton's, which prove nothing.
$CC -std=c11 -D_DEFAULT_SOURCE -O3 -DNDEBUG -ffp-contract=off tests/plane/cost_main.c tests/plane/edge_judge.c tests/hard/draw.c \
    -o "$work/edge" -lm
cost() { # cost SEARCH: instructions a thousand calls
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="counted_$1" "$work/edge" "$1" 2>&1 |
        sed -n 's/.*Collected : \(.*\).$/\1/p'
}
accurate=$(cost accurate) closest=$(cost closest) newton=$(cost newton)
echo "# edge3: $accurate instructions a thousand calls, closest point $closest, two steps of Newton's $newton"
[ -n "$newton" ] && [ "$accurate" -le "$newton" ]; report $((! $?)) "a proved foot point costs no more than two steps of Newton's"

# Projection along a direction with first derivatives of four nodes, slave node and direction: at most twice the projection, and a
# tenth of Newton's iteration with dual numbers of 18 directions.
$CXX -std=c++17 -O3 -DNDEBUG -ffp-contract=off tests/along/along_cost_main.cpp -o "$work/edge" -lm
along=$(cost along) gradients=$(cost gradients) duals=$(cost duals)
echo "# along: $along instructions a thousand calls, with derivatives $gradients, dual numbers $duals"
[ -n "$along" ] && [ "$gradients" -le $((2 * along)) ]; report $((! $?)) 'first derivatives cost no more than a projection'
[ -n "$duals" ] && [ $((10 * gradients)) -le "$duals" ]; report $((! $?)) 'and cost a tenth of dual numbers'
