# The runtime library's tests under valgrind: no invalid access, nothing read before it is set.
. tests/cli/expect.inc
command -v valgrind > /dev/null || { report 1 'skipped: no valgrind'; exit 0; }
for test in runtime contact batch select; do
    valgrind -q --error-exitcode=9 "$BIN/tests/test_$test" > "$work/log" 2>&1
    good=$((! $?))
    [ "$good" = 1 ] || tail -40 "$work/log" | sed 's/^/# /'
    report "$good" "test_$test under valgrind"
done
