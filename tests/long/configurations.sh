# Everything under the sanitizers, and with fused multiply-add; at its usual length.  Without optimisation the programs
# are built; what they assert the sanitizers' build asserts, too.
. tests/cli/expect.inc
unset FOOTPOINT_LONG
export ISAS=quick # of the bench: how fast it is is no matter here
for config in asan fma debug; do
    make -s CONFIG=$config all bench-program paper-programs > "$work/log" 2>&1 && if [ $config != debug ]; then
        make -s CONFIG=$config $(ls tests/*/test_*.c tests/*/*/test_*.c | sed "s|.*/\(.*\)\.c|build/$config/bin/tests/\1|") >> "$work/log" 2>&1
    fi
    report $((! $?)) "$config builds"
    [ $config != debug ] || continue
    for test in build/$config/bin/tests/test_*; do
        "$test" > "$work/log" 2>&1
        good=$?
        [ $good -eq 0 ] || tail -20 "$work/log" | sed 's/^/# /'
        report $((!good)) "$config $(basename "$test")"
    done
done
