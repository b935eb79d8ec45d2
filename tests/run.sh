#!/bin/sh
# Runs test programs and scripts that print TAP ("ok ...", "not ok ..."), JOBS= at a time, by default one more than
# there are processors, because some wait; those after the word --alone one by one. A program that prints no plan, or
# dies, fails. Prints skipped checks and warnings, and a line "n of m" for each test with its time and processor time.
# The last lines are the totals and "N passed, N failed". Exits 1 if anything failed.
if [ "$1" = --one ]; then # prints the result of one test of so many, and adds "passed failed seconds" to a file of counts
    tests=$2 counts=$3 test=$4
    out=$(mktemp) || exit 3
    trap 'rm -f "$out"' EXIT
    start=$(date +%s)
    case $test in *.sh) sh "$test" ;; *) "$test" ;; esac > "$out" 2>&1
    status=$?
    times > "$out.times" # of the children, in the second line: "0m1.50s 0m0.25s", user and system
    seconds=$(awk 'NR == 2 { split($0, t, /[ms ]+/); printf "%.1f", 60 * t[1] + t[2] + 60 * t[3] + t[4] }' "$out.times")
    good=$(grep -c '^ok ' "$out") bad=$(grep -c '^not ok ' "$out")
    if [ "$bad" -eq 0 ] && { [ "$status" -ne 0 ] || [ "$good" -eq 0 ]; }; then
        bad=1
    fi
    { # one at a time, so that each has a number of its own and no two are mixed
        flock 9
        echo "$good $bad $seconds" >&9
        [ "$bad" -eq 0 ] || { echo "--- $test (exit status $status)"; cat "$out"; }
        grep -hE '^# SKIP|^# WARNING|skipped:' "$out"
        printf '%3d of %d  %-32s %4d passed %4d failed %5d s %7.1f s processor\n' "$(wc -l < "$counts")" "$tests" \
            "$(basename "$test")" "$good" "$bad" $(($(date +%s) - start)) "$seconds"
    } 9>> "$counts"
    rm -f "$out.times"
    exit 0
fi
export CMOCKA_MESSAGE_OUTPUT=TAP OMPI_MCA_mpi_yield_when_idle=1 # ranks that wait give way to other tests
# Without plugins for graphics cards and buses processes find the processors sooner.
export HWLOC_PLUGINS_PATH=/dev/null
# Each mpirun binds its ranks to the first processors, those of tests side by side to the same ones.
export OMPI_MCA_hwloc_base_binding_policy=none
# Programs start soonest where they are not told to look for networks, and one rank needs no daemon.
export OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader OMPI_MCA_ess_singleton_isolated=1
counts=$(mktemp) || exit 3
trap 'rm -f "$counts"' EXIT
begin=$(date +%s)
at_a_time=${JOBS:-$(($(nproc) + 1))} tests=0
for test; do
    [ "$test" != --alone ] || continue
    tests=$((tests + 1))
done
printf '%s\n' "$@" | sed '/^--alone$/,$d' | xargs -r -n 1 -P "$at_a_time" sh "$0" --one $tests "$counts"
printf '%s\n' "$@" | sed '1,/^--alone$/d' | xargs -r -n 1 sh "$0" --one $tests "$counts"
awk -v tests=$tests -v wall=$(($(date +%s) - begin)) '{ passed += $1; failed += $2; seconds += $3 }
    END {
        failed += tests - NR
        printf "%.0f s of processor time in %d s\n%d passed, %d failed\n", seconds, wall, passed, failed
        exit failed > 0
    }' "$counts"
