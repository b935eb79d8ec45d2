# The configurations. Under the sanitizers: tests of all rooms and of the library, which compiles the generated headers, too.
# With fused multiply-add: the library, what computes bounds and fits, and promises of headers, which a contraction must not
# break; test_batch compares bits of programs that are contracted differently. Other tests of headers take minutes to compile
# and would repeat these; FOOTPOINT_CONFIGURATIONS=all runs all tests in both. Without optimisation the programs are built;
# what they assert the sanitizers' build asserts, too. At last, tests of headers that are compiled without optimisation, with it.
. tests/cli/expect.inc
long=$FOOTPOINT_LONG
unset FOOTPOINT_LONG
sources() { # sources CONFIG: of the tests to run
    case $FOOTPOINT_CONFIGURATIONS$1 in
    *debug) ;;
    allfma) ls tests/*/test_*.c tests/*/*/test_*.c | grep -v test_batch ;;
    all*) ls tests/*/test_*.c tests/*/*/test_*.c ;;
    asan) ls tests/codegen/test_*.c tests/evolve/test_*.c tests/paper/rivals/test_*.c tests/queries/test_*.c tests/rivals/test_*.c \
        tests/generated/test_promise_curved.c tests/generated/test_promise_patches.c tests/runtime/test_*.c \
        tests/support/test_*.c | grep -v test_header_bounds ;;
    fma) ls tests/codegen/test_bound.c tests/codegen/test_program.c tests/evolve/test_kernel.c tests/evolve/test_lines.c \
        tests/generated/test_along.c tests/generated/test_*promise*.c tests/plane/test_edge.c tests/runtime/test_*.c |
        grep -v test_batch ;;
    esac
}
for config in asan fma debug; do
    programs=$(sources $config | sed "s|.*/\(.*\)\.c|build/$config/bin/tests/\1|")
    make -s CONFIG=$config $([ $config = fma ] || echo all) $programs > "$work/log" 2>&1
    good=$?
    [ $good -eq 0 ] || tail -20 "$work/log" | sed 's/^/# /'
    report $((!good)) "$config builds"
    for test in $programs; do
        "$test" > "$work/log" 2>&1
        good=$?
        [ $good -eq 0 ] || tail -20 "$work/log" | sed 's/^/# /'
        report $((!good)) "$config $(basename "$test")"
    done
done

for name in along_gradients along_hessian batch face_sides float place_arrays promise_float promise_tri3 single_closest single_curved; do
    source=$(ls tests/*/test_$name.c)
    object=build/release/${source%.c}.o
    # The commands of make, with other output.
    make -n V=1 -W "$source" HEADERS_OPT=-O1 "$BIN/tests/test_$name" |
        sed -n "s|$object|$work/$name.o|; s|-o $BIN/tests/test_$name |-o $work/$name |; / -o /p" > "$work/commands"
    sh -e "$work/commands" > "$work/log" 2>&1 && FOOTPOINT_LONG=$long "$work/$name" > "$work/log" 2>&1
    good=$?
    [ $good -eq 0 ] || tail -20 "$work/log" | sed 's/^/# /'
    report $((!good)) "optimised, $name"
done
