# Counts lines of .c and .h files that are neither blank nor comment, by room, without a limit.
. tests/cli/expect.inc
for room in evolve codegen runtime; do
    find "$room" -name "*.[ch]" -exec cat {} + | "$CC" -fpreprocessed -dD -E -P -w -x c - > "$work/code" || touch "$work/unread"
    awk -v room="$room" 'NF { n++ } END { print room, n + 0 }' "$work/code"
done > "$work/lines"
awk '{ print "# " $1 ": " $2 " lines of code"; all += $2 } END { print "# together: " all }' "$work/lines"
[ ! -e "$work/unread" ]
report $((! $?)) 'lines of code are counted'
