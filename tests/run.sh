#!/bin/sh
# Runs test programs and scripts that print TAP ("ok ...", "not ok ..."); a program that prints no plan, or dies, fails.
# Closes with "N passed, N failed"; exits 1 if anything failed.
export CMOCKA_MESSAGE_OUTPUT=TAP
passed=0 failed=0
out=$(mktemp) || exit 3
trap 'rm -f "$out"' EXIT
for test; do
    start=$(date +%s)
    case $test in *.sh) sh "$test" ;; *) "$test" ;; esac > "$out" 2>&1
    status=$?
    good=$(grep -c '^ok ' "$out") bad=$(grep -c '^not ok ' "$out")
    if [ "$bad" -eq 0 ] && { [ "$status" -ne 0 ] || [ "$good" -eq 0 ]; }; then
        bad=1
    fi
    [ "$bad" -eq 0 ] || { echo "--- $test (exit status $status)"; cat "$out"; }
    printf '%-32s %4d passed %4d failed %5d s\n' "$(basename "$test")" "$good" "$bad" $(($(date +%s) - start))
    passed=$((passed + good)) failed=$((failed + bad))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
