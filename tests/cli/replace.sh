# Checks that the adapters of runtime/replace/ compile with the signatures of their codes, and return known answers.
. tests/cli/expect.inc
CXX=${CXX:-g++} FC=${FC:-gfortran}
LIBRARY=$BIN/libfootpoint.a
later 'replace: clang, optimised code, a device'
[ -n "$FOOTPOINT_LONG" ] && level=-O1 called= || level=-O0 # with optimisation gcc inlines no function called by its address
for compiler in "$CXX" ${FOOTPOINT_LONG:+clang++}; do
    command -v "$compiler" > /dev/null || continue
    "$compiler" -std=c++11 $level -Wall -Wextra -Wpedantic -Wshadow -Werror $called -Iruntime -Igenerated tests/replace/replace_main.cpp \
        "$LIBRARY" -lm -o "$work/adapters"
    expect "Tribol, MOOSE, NimbleSM, ArborX: $compiler" 0 '' '' "$work/adapters"
done
for compiler in "${CC:-gcc}" ${FOOTPOINT_LONG:+clang}; do
    command -v "$compiler" > /dev/null || continue
    "$compiler" -std=c11 $level -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror $called -Igenerated runtime/replace/sfepy.c \
        tests/replace/replace_sfepy_main.c -lm -o "$work/sfepy"
    expect "sfepy: $compiler" 0 '' '' "$work/sfepy"
done
if command -v "$FC" > /dev/null; then
    for code in openradioss frontistr code_aster abaqus; do
        adapter=$(ls runtime/replace/$code*.f90)
        # The program's modules come before the adapter that uses them.
        "$FC" -std=gnu $level -Wall -Wextra -Wno-unused-dummy-argument -Wno-compare-reals -Werror -fno-range-check -J"$work" \
            runtime/package/footpoint.f90 runtime/replace/unclamped.f90 tests/replace/replace_points.f90 \
            tests/replace/replace_${code}_main.f90 "$adapter" "$LIBRARY" -lm -o "$work/$code"
        expect "$code" 0 '' '' "$work/$code"
    done
else
    echo "# SKIP no $FC: adapters in Fortran"
fi
if [ -n "$FOOTPOINT_LONG" ] && command -v nvcc > /dev/null; then
    nvcc -std=c++17 -Iruntime -Igenerated -x cu -c tests/replace/replace_main.cpp -o "$work/device.o"; report $((! $?)) 'on a device'
fi
