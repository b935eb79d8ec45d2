# The test programs of what allocates and reads, under valgrind: no invalid access, nothing read before it is set, no block
# lost.  Tests of headers, which allocate nothing, are left to compilers' sanitizers (configurations.sh), and so are those that
# compute on end (the first below) and where long double has to have 64 digits, of which valgrind keeps 53 (test_attach,
# test_bound, test_reference).
. tests/cli/expect.inc
unset FOOTPOINT_LONG # as check has them: a program takes thirty times as long
command -v valgrind > /dev/null || { report 1 'skipped: no valgrind'; exit 0; }
for source in tests/codegen/test_*.c tests/evolve/test_*.c tests/runtime/test_*.c tests/support/test_*.c tests/paper/rivals/test_*.c; do
    test=$(basename "$source" .c) program=$BIN/tests/$(basename "$source" .c)
    case $test in test_additions | test_calibration | test_float | test_header_bounds | test_island | test_lines | test_poles | \
        test_program | test_prove | test_robust | test_samples | \
        test_attach | test_bound | test_reference) continue ;; esac
    [ "$test" = test_random_programs ] && count=300 || count=
    valgrind -q --leak-check=full --errors-for-leak-kinds=definite --error-exitcode=99 "$program" $count > "$work/log" 2>&1
    good=$((! $?))
    [ "$good" = 1 ] || tail -40 "$work/log" | sed 's/^/# /'
    report "$good" "$test under valgrind"
done
