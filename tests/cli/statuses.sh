# Checks statuses of the functions of generated headers, as C and C++, also if -ffast-math lets a compiler ignore NaN:
# see tests/generated/statuses.h. Two functions of quad4, tri3 and quad8 with a C compiler, and those of quad4 with
# a C++ compiler under -ffast-math; with FOOTPOINT_LONG two of every header with five compilers, with STATUSES=all,
# too, all functions with eight, hours.
. tests/cli/expect.inc
CC=${CC:-gcc} CXX=${CXX:-g++}
HEADERS=${HEADERS:-$(ls "$PWD"/generated/*.h | grep -v -e _derivatives -e _edge)}

# places KIND: numbers of the places in tests/generated/statuses.h
places() {
    case $1 in
    quad4) echo 0 1 2 3 9 ;;
    tri3) echo 0 1 3 9 ;;
    tri6) echo 0 1 3 4 10 7 9 ;;
    quad8) echo 0 1 2 3 4 5 6 7 9 ;;
    quad9) echo 0 1 2 3 4 5 6 7 8 9 ;;
    gregory | bezier) echo 0 1 2 3 11 11 11 11 9 ;;
    esac
}
later 'statuses: second headers of a kind, more compilers and levels, for the library and four-node arrays, too, and seven sizes of eight'
for header in $HEADERS; do
    name=$(basename "$header" .h)
    case ${name#footpoint_} in
    quad4 | quad4_float | tri3 | quad8) ;;
    *) [ -n "$FOOTPOINT_LONG" ] || continue ;;
    esac
    kind=$(sed -n 's/^#define FOOTPOINT_\([A-Z0-9]*\)_SEARCH\(_F\)*$/\1/p' "$header" | tr A-Z a-z)
    type=$(sed -n 's/^ \* precision: //p' "$header")
    functions=$(sed -n 's/^FOOTPOINT_FN int \(footpoint_[a-z0-9_]*\)(const [a-z]* xA.*/\1/p' "$header" | grep -v -e _detail_ -e '_sure$' -e '_closest$' -e '_along$' -e '_from$')
    [ "$STATUSES" = all ] || functions=$(echo "$functions" | sed '1b; $!d')
    set -- $(places "$kind")
    vectors=$#
    arguments=x[0]
    for i in $(seq $((vectors - 1))); do arguments="$arguments, x[$i]"; done
    case $kind in gregory | bezier) nodes=4 ;; *) nodes=$((vectors - 1)) ;; esac
    wide=
    ! grep -q '^ \* corners: any' "$header" || grep -q '_PROMISE ' "$header" || wide=1 # whose answers are not the expression's
    {
        echo "#include \"$header\""
        [ "$type" = float ] && echo '#define EXTREME 96' || echo '#define EXTREME 992'
        [ -z "$wide" ] || echo '#define WIDE'
        case $kind in gregory | bezier) echo '#define PATCH' ;; esac
        ! grep -q _side_run "$header" && [ "$nodes" = $((vectors - 1)) ] || echo '#define SIDE_BY_SIDE'
        echo "#define R $type"
        echo "#define VECTORS $vectors"
        echo "#define NODES $nodes"
        echo "#define ORDER $(echo "$@" | sed 's/ /, /g')"
        echo "#define ARGUMENTS $arguments"
        echo "#define FUNCTIONS(F) $(for f in $functions; do printf 'F(%s) ' "$f"; done)"
        ! grep -q '^FOOTPOINT_LOOP void .*_over_n(' "$header" || echo '#define OVER'
        ! grep -q _closest "$header" || echo "#define CLOSEST(F) $(for f in $functions; do printf 'F(%s_closest) ' "$f"; done)"
        echo '#ifdef __cplusplus'
        echo 'extern "C" {'
        echo '#endif'
        for f in $functions; do echo "void wide_$f(const __float128 (*x)[3], __float128 loc[2]);"; done
        echo '#ifdef __cplusplus'
        echo '}'
        echo '#endif'
        echo "#include \"$PWD/tests/generated/statuses.h\""
    } > "$work/use.c"
    cp "$work/use.c" "$work/use.cpp"
    {
        echo "#define NARROW $type"
        echo "#include \"$PWD/tests/generated/wide_number.h\""
        case $kind in gregory | bezier) echo '#undef __GNUC__' ;; esac # there are no vectors of such numbers
        echo "#include \"$header\""
        for f in $functions; do
            echo "extern \"C\" void wide_$f(const __float128 (*at)[3], __float128 loc[2]);"
            echo "extern \"C\" void wide_$f(const __float128 (*at)[3], __float128 loc[2])"
            echo '{'
            echo "    double x[$vectors][3], xi, eta;"
            echo "    for (int i = 0; i < 3 * $vectors; i++)"
            echo "        x[i / 3][i % 3] = at[i / 3][i % 3];"
            echo "    ${f}_at($arguments, &xi, &eta);"
            echo '    loc[0] = xi.value;'
            echo '    loc[1] = eta.value;'
            echo '}'
        done
    } > "$work/wide.cpp"
    # shellcheck disable=SC2086
    $CXX -std=gnu++17 $called ${FOOTPOINT_LONG:+-O1} -c "$work/wide.cpp" -o "$work/wide.o" || exit 1
    for compiler in "$CC -std=gnu99 -Ofast" "clang++ -std=c++11 -Ofast" "$CC -std=c99 -O1" "$CC -std=c99 -O2" "clang -std=gnu99 -O2" \
                    "clang -std=c99 -Ofast" "$CXX -std=c++17 -Ofast" "$CC -std=gnu99 -O0 -ffast-math"; do
        case $name$compiler in # second headers of a kind differ in their expressions alone
        footpoint_*_quad4"$CC -std=gnu99 -Ofast" | footpoint_*_quad4"clang -std=c99 -Ofast") ;;
        footpoint_*_quad4*) continue ;;
        esac
        case $kind$compiler in # calls of patches that prove nothing take longest
        *c99\ -O2 | *c99\ -Ofast | *c++17\ -Ofast) [ "$STATUSES" = all ] || continue ;;
        gregory"$CC -std=gnu99 -Ofast" | bezier"$CC -std=gnu99 -Ofast" | *c99\ -O1) ;;
        gregory* | bezier*) [ "$STATUSES" = all ] || continue ;;
        esac
        case $compiler in
        *c++11\ -Ofast) case $name in *_quad8 | *_float | *_tri3) [ -n "$FOOTPOINT_LONG" ] || continue ;; esac ;;
        *c99\ -O1) [ -n "$FOOTPOINT_LONG" ] || compiler="$CC -std=c99 -O0" ;;
        *) [ -n "$FOOTPOINT_LONG" ] || continue ;;
        esac
        case $compiler in *fast*) exact= ;; *) exact=-DEXACT ;; esac
        case $compiler in *-O0) exact="$exact $called" ;; esac
        case $compiler in *++*) source=use.cpp ;; *) source=use.c ;; esac
        # shellcheck disable=SC2086
        $compiler $exact -ffp-contract=off "$work/$source" "$work/wide.o" -o "$work/use" -lm > "$work/log" 2>&1 && "$work/use" >> "$work/log" 2>&1
        good=$?
        [ $good -eq 0 ] || head -${LOG:-12} "$work/log" | sed 's/^/# /'
        report $((!good)) "$name, $compiler"
    done
done

# The library's quick search and what goes with it, under the same flags.
[ -n "$FOOTPOINT_LONG" ] && step= || step=-DPOWER_STEP=8
quick="geometry/quad4 geometry/node_normals batch/batch batch/batch_lanes search/locate search/newton search/contact search/differentiate"
for compiler in "$CC -std=gnu11 -O0 -ffast-math" "$CC -std=gnu11 -O1 -ffast-math" "$CC -std=gnu11 -Ofast" "clang -std=gnu11 -Ofast" \
                "$CC -std=gnu11 -Ofast -march=native" "$CC -std=gnu11 -O2"; do
    apart=$called # not with optimisation, which inlines no function that is called by its address
    case $compiler in *O0*) ;; *) [ -n "$FOOTPOINT_LONG" ] || continue; apart= ;; esac
    sources=$(for f in $quick; do echo "$PWD/runtime/$f.c"; done)
    # shellcheck disable=SC2086
    $compiler $step $apart -I"$PWD" "$PWD/tests/runtime/library_statuses_main.c" $sources -o "$work/use" -lm > "$work/log" 2>&1 && "$work/use" >> "$work/log" 2>&1
    good=$?
    [ $good -eq 0 ] || head -12 "$work/log" | sed 's/^/# /'
    report $((!good)) "the library, $compiler"
done

# The same bits, statuses and exceptions however gcc orders stores: of four-node arrays gcc 12 with -O1 took a function apart
# for one without effects, and proofs used what was left on the stack.
cat > "$work/levels.c" <<'END'
#include "generated/footpoint_quad4.h"
#include <fenv.h>
#include <stdio.h>
enum { PAIRS = 4096 };
static double x[15][PAIRS], answer[3][PAIRS];
static int status[PAIRS];
static double uniform(void) /* in [-1, 1) */
{
    static unsigned state = 1;
    state = 1664525 * state + 1013904223;
    return (double)(state >> 8) / (1 << 23) - 1;
}
int main(void)
{
    const double *column[15];
    static const double square[15] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    for (int i = 0; i < 15; i++) {
        column[i] = x[i];
        for (int k = 0; k < PAIRS; k++)
            x[i][k] = square[i] + (i < 12 ? 0.15 : 0.9) * uniform();
    }
    feclearexcept(FE_ALL_EXCEPT);
    footpoint_quad4_full_checked_n(PAIRS, column, answer[0], answer[1], answer[2], status);
    const int raised = fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    fwrite(answer, sizeof answer, 1, stdout);
    fwrite(status, sizeof status, 1, stdout);
    return raised != 0;
}
END
for level in -O1 ${FOOTPOINT_LONG:+-O1:-fno-tree-fre -O1:-fno-tree-dse} -O3; do
    flags=$(echo "$level" | tr : ' ')
    # shellcheck disable=SC2086
    $CC -std=gnu11 $flags -ffp-contract=off -I"$PWD" "$work/levels.c" -o "$work/use" -lm > "$work/log" 2>&1 &&
        "$work/use" > "$work/out" && { [ -s "$work/first" ] || cp "$work/out" "$work/first"; } && cmp "$work/out" "$work/first" > "$work/log"
    good=$?
    [ $good -eq 0 ] || head -12 "$work/log" | sed 's/^/# /'
    report $((!good)) "four-node arrays, $CC $flags"
done
