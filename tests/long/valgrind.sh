# The test programs under valgrind: no invalid access, nothing read before it is set, no block lost.  Not those that
# compute on end (test_calibration, test_digits, test_float, test_island, test_poles, test_samples; test_headers, whose
# headers tests/cli/header.sh tries alone), which configurations.sh runs under the address sanitizer, and not where long
# double has to have 64 digits, of which valgrind keeps 53 (test_along, test_attach, test_bound,
# test_reference).
. tests/cli/expect.inc
unset FOOTPOINT_LONG # as check has them: a program takes thirty times as long
command -v valgrind > /dev/null || { report 1 'skipped: no valgrind'; exit 0; }
for program in "$BIN"/tests/test_*; do
    test=$(basename "$program")
    case $test in test_calibration | test_digits | test_float | test_headers | test_island | test_poles | test_samples | \
        test_along | test_attach | test_bound | test_reference) continue ;; esac
    [ "$test" = test_random_programs ] && count=300 || count=
    valgrind -q --leak-check=full --errors-for-leak-kinds=definite --error-exitcode=99 "$program" $count > "$work/log" 2>&1
    good=$((! $?))
    [ "$good" = 1 ] || tail -40 "$work/log" | sed 's/^/# /'
    report "$good" "$test under valgrind"
done
