# A generated header alone in a folder: compiles everywhere with warnings as errors, and answers as the library does.
. tests/cli/expect.inc
CC=${CC:-gcc} CXX=${CXX:-g++}
strict='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -O2'

for header in generated/*.h; do
    name=$(basename "$header")
    mkdir -p "$work/alone"
    cp "$header" "$work/alone/"
    functions=$(sed -n 's/^FOOTPOINT_FN int \(footpoint_[a-z0-9_]*\)(const double xA.*/\1/p' "$header" | grep -v '^footpoint_detail_')
    {
        echo "#include \"$name\""
        echo "#include \"$name\""
        echo 'int main(void)'
        echo '{'
        echo '    const double a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {1.1, 1, 0}, d[3] = {0, 0.9, 0.05}, s[3] = {0.2, 0.25, 0.01};'
        echo '    double loc[2] = {7, 7}, gap = 7;'
        for f in $functions; do
            echo "    if ($f(a, b, c, d, s, loc, &gap) != FOOTPOINT_OK || !(loc[0] > -1 && loc[0] < 0 && loc[1] > -1 && loc[1] < 0))"
            echo '        return 1;'
        done
        echo '    return 0;'
        echo '}'
    } > "$work/alone/use.c"
    cp "$work/alone/use.c" "$work/alone/use.cpp"
    for compiler in "$CC -std=c99" "$CC -std=c11" "clang -std=c99" "clang -std=c11" \
                    "$CXX -std=c++11" "$CXX -std=c++17" "clang++ -std=c++11" "clang++ -std=c++17"; do
        case $compiler in *++*) source=use.cpp ;; *) source=use.c ;; esac
        (cd "$work/alone" && $compiler $strict $source -o use -lm && ./use) > "$work/log" 2>&1
        good=$?
        [ $good -eq 0 ] || sed 's/^/# /' "$work/log"
        report $((!good)) "$name alone, $compiler"
    done
    if command -v nvcc > /dev/null; then
        (cd "$work/alone" && cp use.c use.cu && nvcc -c use.cu -o use.o) > "$work/log" 2>&1
        good=$?
        [ $good -eq 0 ] || sed 's/^/# /' "$work/log"
        report $((!good)) "$name alone, nvcc"
    fi
    rm -rf "$work/alone"
done

mkdir "$work/same"
cp generated/footpoint_quad4.h runtime/footpoint.h "$work/same/"
cat > "$work/same/same.c" <<'END'
#include "footpoint.h"
#include "footpoint_quad4.h"
#include <stdio.h>
#include <string.h>
static double draw(unsigned long *s)
{
    *s = *s * 6364136223846793005UL + 1442695040888963407UL;
    return (double)(*s >> 11) / 9007199254740992.0 - 0.5;
}
int main(void)
{
    unsigned long seed = 3;
    for (int n = 0; n < 20000; n++) {
        double x[5][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}}, p[3] = {0}, q[3] = {0};
        for (int i = 0; i < 15; i++)
            x[i / 3][i % 3] += draw(&seed);
        if (n % 100 == 0)
            memcpy(x[n / 100 % 4], x[(n / 100 + 1) % 4], sizeof x[0]);
        const int a = footpoint_locate(x[0], x[1], x[2], x[3], x[4], p, p + 2);
        const int b = footpoint_quad4_accurate(x[0], x[1], x[2], x[3], x[4], q, q + 2);
        if (a != b || memcmp(p, q, sizeof p) != 0)
            return printf("sample %d differs\n", n), 1;
    }
    return 0;
}
END
$CC -std=c11 -O3 -ffp-contract=off "$work/same/same.c" "$BIN/libfootpoint.a" -o "$work/same/same" -lm && "$work/same/same"
report $((! $?)) 'the header alone answers as the library does, bit for bit'
$CC -std=c11 -O3 -ffp-contract=off "$work/same/same.c" -o "$work/same/shared" -L"$BIN" -lfootpoint -lm &&
    LD_LIBRARY_PATH=$BIN "$work/same/shared"
report $((! $?)) 'the same with the shared library'
