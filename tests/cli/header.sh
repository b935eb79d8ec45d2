# A generated header alone in a folder: compiles everywhere with warnings as errors, and answers as the library does.
# One of each kind with the oldest C, quad4 and tri3 with the oldest C++, too; all of them with every compiler and standard
# when FOOTPOINT_LONG is set.
. tests/cli/expect.inc
CC=${CC:-gcc} CXX=${CXX:-g++}
strict='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror'
[ -n "$FOOTPOINT_LONG" ] && strict="$strict -O1" called= || strict="$strict -O0"

# nodes KIND: numbers of the nodes and normals below, S last
nodes() {
    case $1 in
    quad4) echo 0 1 2 3 9 ;;
    tri3) echo 0 1 3 9 ;;
    tri6) echo 0 1 3 4 10 7 9 ;;
    quad8) echo 0 1 2 3 4 5 6 7 9 ;;
    quad9) echo 0 1 2 3 4 5 6 7 8 9 ;;
    gregory | bezier) echo 0 1 2 3 11 11 11 11 9 ;;
    esac
}
later 'header: second headers of quad4 and gregory, answers of quad9 and bezier, functions of most headers that nobody calls, most compilers and standards'
for header in generated/*.h; do
    name=$(basename "$header")
    case $name in
    *_edge*) continue ;;
    *_quad4.h | *paper*) [ $name = footpoint_quad4.h ] || [ -n "$FOOTPOINT_LONG" ] || continue ;;
    esac
    mkdir -p "$work/alone"
    cp "$header" "$work/alone/"
    functions=$(sed -n 's/^FOOTPOINT_FN int \(footpoint_[a-z0-9_]*\)(const [a-z]* xA.*/\1/p' "$header" | grep -v -e '^footpoint_detail_' -e '_closest$' -e '_closest_from$' -e '_along$' -e '_place$' -e '_shapes$' -e '_gradients$' -e '_hessian$')
    kind=$(sed -n 's/^#define FOOTPOINT_\([A-Z0-9]*\)_SEARCH\(_F\)*$/\1/p' "$header" | tr A-Z a-z)
    arguments=$(nodes "$kind" | sed 's/[0-9]*/n[&]/g; s/ /, /g')
    type=$(sed -n 's/^ \* precision: //p' "$header")
    case $kind in tri*) least=0 most=1 ;; *) least=-1 most=0 ;; esac
    {
        echo "#include \"$name\""
        echo "#include \"$name\""
        echo 'int main(void)'
        echo '{'
        echo "#define R(x) (($type)(x))"
        echo "    const $type n[12][3] = {{0, 0, 0}, {1, 0, 0}, {R(1.1), 1, 0}, {0, R(0.9), R(0.05)}, {R(0.5), 0, 0}, {R(1.05), R(0.5), 0},"
        echo '        {R(0.55), R(0.95), R(0.025)}, {0, R(0.45), R(0.025)}, {R(0.525), R(0.475), R(0.0125)}, {R(0.2), R(0.25), R(0.01)},'
        echo '        {R(0.5), R(0.45), R(0.025)}, {0, 0, 1}};'
        echo "    $type loc[2] = {7, 7}, gap = 7;"
        echo '    int region = 7;'
        echo '    (void)n, (void)loc, (void)gap;'
        for f in $functions; do
            echo "    if ($f($arguments, loc, &gap) != FOOTPOINT_OK || !(loc[0] > $least && loc[0] < $most && loc[1] > $least && loc[1] < $most))"
            echo '        return 1;'
            grep -q "${f}_closest(" "$header" || continue
            [ "$f" = "${f%_sure}" ] || continue
            echo "    if (${f}_closest($arguments, loc, &gap, &region) != FOOTPOINT_OK || region != 0 || !(loc[0] > $least && loc[0] < $most && gap != 7))"
            echo '        return 1;'
        done
        echo '    return region == 8;'
        echo '}'
    } > "$work/alone/use.c"
    cp "$work/alone/use.c" "$work/alone/use.cpp"
    for compiler in "$CC -std=c99" "clang++ -std=c++11" "$CC -std=c11" "clang -std=c99" "clang -std=c11" \
                    "$CXX -std=c++11" "$CXX -std=c++17" "clang++ -std=c++17"; do
        case $name$compiler in
        *"$CC -std=c99" | footpoint_*_quad4.h"clang++ -std=c++17") ;;
        footpoint_*_quad4.h*) continue ;; # which differs from footpoint_quad4.h in its expressions alone
        esac
        case $name$compiler in
        *"$CC -std=c99" | footpoint_quad4.h"clang++ -std=c++11" | footpoint_tri3.h"clang++ -std=c++11") ;;
        *) [ -n "$FOOTPOINT_LONG" ] || continue ;;
        esac
        case $compiler in *++*) source=use.cpp ;; *) source=use.c ;; esac
        # Another language or a later standard may refuse something; what the compiler makes of it is the same.
        # Derivatives are not called here.
        # Answers of quad9 and bezier are computed as those of quad8 and gregory.
        case $compiler$name in *_derivatives.h | *_quad9.h | *_bezier.h | *++*) run="-fsyntax-only $source" ;; *) run="$source -o use -lm" ;; esac
        case $compiler in *=c99) level= ;; *) level=-O0 ;; esac
        case $name in *_float.h | footpoint_quad4.h) ;; *) level="$level $called" ;; esac
        [ "$type" != float ] || level="$level -Wdouble-promotion"
        [ -z "$FOOTPOINT_LONG" ] || run="$source -o use -lm"
        # shellcheck disable=SC2086
        (cd "$work/alone" && rm -f use && $compiler $strict $level $run && { [ ! -e use ] || ./use; }) > "$work/log" 2>&1
        good=$?
        [ $good -eq 0 ] || sed 's/^/# /' "$work/log"
        report $((!good)) "$name alone, $compiler"
        [ "$compiler" != "$CC -std=c99" ] || cp "$work/alone/use" "$work/alone/narrow" 2> /dev/null
    done
    if [ "$type" = float ]; then
        ! objdump -d "$work/alone/narrow" | grep -E '[a-z](ss2sd|ps2pd|sd2ss|pd2ps|(add|sub|mul|div|sqrt)[sp]d)' > "$work/log" 2>&1
        good=$?
        [ $good -eq 0 ] || sed 's/^/# /' "$work/log"
        report $((!good)) "$name computes nothing in double"
    fi
    rm -rf "$work/alone"
done

# Headers compile everywhere, loops over arrays included, and pass their test points, with and without fused
# multiply-add: fresh ones, of two functions of a scene, and with FOOTPOINT_LONG those shipped in place of fresh ones in double.
cat > "$work/scalars.gen" <<'END'
footpoint-genome 1
input x y z
range x 0.5 2
range y -1 1
range z -0.25 3
let s = + * x x * y y
genome polynomial
r = - + * x * y z * 0.3 * s z 0.7
q = * - x y + * s s * 1.1 z
end
genome quotient
r = / + y * 0.05 z + s 1
q = / x + 4 y
end
genome mixed
r = max min x y * 0.5 sqrt + s abs z
q = % * x y + y 2
end
genome unused
r = * x 2.5
end
END
cat > "$work/poles.gen" <<'END'
footpoint-genome 1
input x y
genome g
r = / x - x y
s = + / 1 + * x x y x
end
END
# use HEADER POINTS TYPE: a program that calls every function, and compares it with the test points in the file POINTS
use() {
    echo '#include <stdio.h>'
    echo "#include \"$(basename "$1")\""
    echo "#include \"$(basename "$1")\""
    [ ! -s "$2" ] || echo "#include \"$(basename "$2")\""
    echo 'int main(void)'
    echo '{'
    echo "    static $3 column[80][8];"
    echo '    static int status[8], region[8];'
    echo "    const $3 *x[30];"
    echo '    int failed = 0, k;'
    echo '    for (k = 0; k < 30; k++)'
    echo '        x[k] = column[k];'
    awk -v type="$3" '
    function flush_function(   i, call) {
        if (name ~ /_(checked|from)$/) {
            printf "    %s_n(8, x, column[70], column[71], column[72], status);\n", name
            return
        }
        if (name ~ /_over$/) {
            printf "    %s_n(x, 8, x, column[70], column[71], column[72], status);\n", name
            return
        }
        if (name ~ /_along$/) {
            printf "    %s_n(8, x, x, column[70], column[71], column[72], status);\n", name
            return
        }
        if (name ~ /_closest$/) {
            printf "    %s_n(8, x, column[70], column[71], column[72], region, status);\n", name
            return
        }
        printf "    { %s out[%d]; size_t i; (void)i;\n", type, outs
        call = name at "("
        for (i = 0; i < ins; i++)
            call = call (i ? ", " : "") (segment ? "p + " 3 * i : "p[" i "]")
        if (apart[name]) # NAME_at takes steps instead
            call = "for (k = 0; k < " 3 * ins "; k++) column[k][0] = p[k];\n          " name "_n(1, x"
        if (points[name]) {
            printf "      for (i = 0; i < sizeof %s_points / sizeof *%s_points; i++) {\n", name, name
            printf "          const double *p = %s_points[i];\n          %s", name, call
            for (i = 0; i < outs; i++) printf ", out + %d", i
            printf ");\n"
            for (i = 0; i < outs; i++)
                printf "          if (!(fabs(out[%d] - p[%d]) <= p[%d])) { failed = 1; printf(\"%s: point %%d, output %d: %%.17g\\n\", (int)i, out[%d]); }\n",
                    i, (segment ? 3 * ins : ins) + i, (segment ? 3 * ins : ins) + outs + i, name, i, i
            printf "      }\n"
        }
        printf "      (void)out;\n      %s_n(8", name
        for (i = 0; i < ins && !segment; i++) printf ", column[%d]", i
        if (segment) printf ", x"
        for (i = 0; i < outs; i++) printf ", column[%d]", 70 + i
        printf "%s); }\n", status ? ", status" : ""
    }
    FILENAME ~ /_points.h$/ { if (/_points\[\]/) { sub(/_points.*/, "", $4); points[$4] = 1 } next }
    /_n is the genome\. \*\/$/ { name = $(NF - 4); sub(/_n$/, "", name); apart[name] = 1 }
    /^FOOTPOINT_LOOP/ { text = $0; while (text !~ /\)/) { getline; text = text " " $0 }
        name = text; sub(/^FOOTPOINT_LOOP void /, "", name); sub(/_n\(.*/, "", name)
        segment = match(text, /\*const x\[[0-9]+\]/); at = segment ? "_at" : ""
        ins = segment ? substr(text, RSTART + 9) / 3 : gsub(/\*in_/, "", text); status = text ~ /\*FOOTPOINT_RESTRICT status/
        outs = gsub(/FOOTPOINT_RESTRICT (out_|xi|eta)/, "", text)
        flush_function() }' "$2" "$1"
    echo '    (void)x;'
    echo '    (void)status;'
    echo '    (void)region;'
    echo '    return failed;'
    echo '}'
}
fused=
! grep -q -w fma /proc/cpuinfo 2> /dev/null || fused='-mfma -ffp-contract=fast'
mkdir "$work/fresh"
later 'header: fresh headers of most scenes, parallelogram-quad4 and clang in float, poles by clang'
for file in evolve/genomes/*.gen "$work/scalars.gen" "$work/poles.gen"; do
    name=$(basename "$file" .gen)
    case $name in *-float) continue ;; esac # quad4's
    case $name in parallelogram-quad4 | tri3 | scalars | poles) ;; *) [ -n "$FOOTPOINT_LONG" ] || continue ;; esac
    case $name in scalars | poles) cp "$file" "$work/fresh/" ;; *) (FOOTPOINT_LONG='' && some "$file") > "$work/fresh/$name.gen" ;; esac
    poles=--allow-poles
    [ "$name" != scalars ] || poles=
    for type in double float; do
        [ -n "$FOOTPOINT_LONG" ] || [ $name$type != parallelogram-quad4float ] || continue
        header=$work/fresh/$(echo "$name" | tr - _)_$type.h
        shipped=footpoint_$(echo "$name" | tr - _)
        points=${header%.h}_points.h
        if [ $type = double ] && [ -n "$FOOTPOINT_LONG" ] && [ -e "generated/$shipped.h" ]; then
            cp "generated/$shipped.h" "$header"
            cp "tests/generated/points/${shipped}_points.h" "$points"
        elif [ $type = double ]; then
            "$BIN/footpoint-codegen" --effort 0 "$work/fresh/$name.gen" $poles --points "$points" -o "$header"
        else
            : > "$points"
            "$BIN/footpoint-codegen" --effort 0 "$work/fresh/$name.gen" $poles --precision $type -o "$header"
        fi
        use "$header" "$points" $type > "$work/fresh/use.c"
        cp "$work/fresh/use.c" "$work/fresh/use.cpp"
        for compiler in "$CC -std=c99" "clang -std=c11 -ffp-contract=off" "$CXX -std=c++11 -O3 $fused" "clang++ -std=c++17"; do
            case $name$compiler in
            scalars*clang* | poles*clang*) [ $type = double ] || [ -n "$FOOTPOINT_LONG" ] || continue ;;
            scalars* | poles* | tri3*=c99 | parallelogram*=c99 | *-O3*) ;;
            tri3* | quad8*) [ -n "$FOOTPOINT_LONG" ] || continue ;;
            *) continue ;; # compiled above by all of them
            esac
            case $compiler in *++*) source=use.cpp ;; *) source=use.c ;; esac
            case $compiler in *++*) run="-fsyntax-only $source" ;; *) run="$source -o use -lm" ;; esac
            [ -z "$FOOTPOINT_LONG" ] || run="$source -o use -lm"
            # shellcheck disable=SC2086
            (cd "$work/fresh" && rm -f use && $compiler $strict $run && { [ ! -e use ] || ./use; }) > "$work/log" 2>&1
            good=$?
            [ $good -eq 0 ] || head -20 "$work/log" | sed 's/^/# /'
            report $((!good)) "$name in $type, fresh, $compiler"
        done
        case $name in scalars | poles) ;; *) continue ;; esac # tests/long/cuda.sh compiles those of generated/
        if [ -n "$FOOTPOINT_LONG" ] && command -v nvcc > /dev/null; then
            (cd "$work/fresh" && cp use.c use.cu && nvcc -c use.cu -o use.o) > "$work/log" 2>&1
            good=$?
            [ $good -eq 0 ] || head -20 "$work/log" | sed 's/^/# /'
            report $((!good)) "$name in $type, fresh, nvcc"
        fi
    done
    grep -q '_points\[\]' "$work/fresh/$(echo "$name" | tr - _)_double_points.h"
    report $((! $?)) "$name has test points"
done

# Denominators of 0: the status says so, for one point and for many.
"$BIN/footpoint-codegen" --effort 0 "$work/poles.gen" --allow-poles --prefix p -o "$work/fresh/p.h"
cat > "$work/fresh/poles.c" <<'END'
#include "p.h"
int main(void)
{
    const double x[] = {1, 1, 0, 3, HUGE_VAL, 2}, y[] = {2, 1, 0, -9, 1, 0 * HUGE_VAL};
    const int expected[] = {0, -2, -2, -2, -2, -2};
    double r[6], s[6];
    int status[6], i;
    p_g_n(6, x, y, r, s, status);
    for (i = 0; i < 6; i++)
        if (status[i] != expected[i] || p_g(x[i], y[i], r, s) != expected[i])
            return i + 1;
    return 0;
}
END
for compiler in "$CC -std=c99 -O3" ${FOOTPOINT_LONG:+"clang -std=c99 -O3"} "$CC -std=c99 -O0"; do
    $compiler "$work/fresh/poles.c" -o "$work/fresh/poles" -lm && "$work/fresh/poles"
    report $((! $?)) "the status of a pole, $compiler"
done

# A divisor that is never 0, but that rounding makes 0 or turns round: a Gram determinant of nearly parallel vectors.  Its
# rounding error is known (g); or only its sign, where an input has no range (h).  With status 0, r has the right sign.
cat > "$work/gram.gen" <<'END'
footpoint-genome 2
input x vector u vector v
range u 1000 2000 1000 2000 1000 2000, v 1000 2000 1000 2000 1000 2000
let c = cross u v
require - dot c c 1e-4
let d = - * dot u u dot v v * dot u v dot u v
genome g
r = / 1 d
end
genome h
r = / x d
end
END
cat > "$work/fresh/gram.c" <<'END'
#include "gram.h"
static unsigned long long seed = 5;
static long draw(long n)
{
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (long)(seed >> 33) % n;
}
/* Coordinates are whole multiples of 2^-10, so that cross products are exact.  Returns the wrong answers. */
static int test(long spread, int *answers)
{
    long u[3], v[3], c[3];
    double x[6], r, s, square;
    int k, known, sign;
    for (k = 0; k < 3; k++) {
        u[k] = 1200000 + draw(700000);
        v[k] = u[k] + draw(2 * spread + 1) - spread;
        x[k] = (double)u[k] / 1024;
        x[3 + k] = (double)v[k] / 1024;
    }
    for (k = 0; k < 3; k++)
        c[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    square = ((double)c[0] * (double)c[0] + (double)c[1] * (double)c[1] + (double)c[2] * (double)c[2]) / 1099511627776.0;
    if (square <= 1e-4)
        return 0;
    known = gram_g(1, x[0], x[1], x[2], x[3], x[4], x[5], &r);
    sign = gram_h(1, x[0], x[1], x[2], x[3], x[4], x[5], &s);
    *answers += known == FOOTPOINT_OK && sign == FOOTPOINT_OK;
    return (known == FOOTPOINT_OK && !(r * square > 0.4 && r * square < 2.5)) + (sign == FOOTPOINT_OK && !(s > 0 && s < 1e300));
}
int main(void)
{
    int i, wrong = 0, near = 0, far = 0;
    for (i = 0; i < 100000; i++)
        wrong += test(1, &near) + test(100000, &far);
    return wrong ? 1 : far < 99990 ? 2 : 0;
}
END
"$BIN/footpoint-codegen" --effort 300 --quiet "$work/gram.gen" --prefix gram -o "$work/fresh/gram.h" &&
    $CC -std=c99 -O2 "$work/fresh/gram.c" -o "$work/fresh/gram" -lm && "$work/fresh/gram"
report $((! $?)) 'a divisor that rounding makes 0 or turns round'
grep -q 'proved free of zeros, |...| >= 9.9e-05; status if |...| <= ' "$work/fresh/gram.h" &&
    grep -q 'proved free of zeros, |...| >= 9.9e-05; status if computed as 0, not finite' "$work/fresh/gram.h"
report $((! $?)) 'is in the banner'

grep -q '^/\* NAME_at: ' generated/footpoint_quad4.h && grep -q 'NAME_PROMISE' generated/footpoint_quad4.h &&
    ! grep -nE '(/\*|^ \*) (:|_[a-z_]+:)|[ (]_PROMISE' generated/*.h
report $((! $?)) 'contracts name what they are of'

# A segment's denominator whose zero a minimum hides: NAME notices all the same; in double it begins there, and proves.
cat > "$work/hidden.gen" <<'END'
footpoint-genome 1
input xA yA zA xB yB zB xC yC zC xD yD zD xS yS zS
segment quad4 any
genome g
xi = min 1 max -1 / 0.125 - xS 0.5
eta = - yS 0.5
end
END
for type in double float; do
    "$BIN/footpoint-codegen" --effort 0 "$work/hidden.gen" --allow-poles --precision $type --prefix p -o "$work/fresh/p.h"
    cat > "$work/fresh/hidden.c" <<END
#include "p.h"
int main(void)
{
    const $type a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {1, 1, 0}, d[3] = {0, 1, 0};
    const $type s[2][3] = {{0.75, 0.5, 1}, {0.5, 0.5, 1}};
    $type loc[2], gap, xi, eta;
    p_g_at(a, b, c, d, s[1], &xi, &eta);
    if (!(p_g(a, b, c, d, s[0], loc, &gap) == FOOTPOINT_OK && loc[0] == ($type)0.5 && xi == 1))
        return 1;
#ifdef P_G_PROMISE
    return !(p_g(a, b, c, d, s[1], loc, &gap) == FOOTPOINT_OK && loc[0] < P_G_PROMISE && loc[0] > -P_G_PROMISE);
#else
    return !(p_g(a, b, c, d, s[1], loc, &gap) == FOOTPOINT_ERR_DEGENERATE && loc[0] == ($type)0.5);
#endif
}
END
    $CC -std=c99 $strict $called "$work/fresh/hidden.c" -o "$work/fresh/hidden" -lm && "$work/fresh/hidden"
    report $((! $?)) "a pole behind a minimum in $type"
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
    int refused = 0;
    for (int n = 0; n < 20000; n++) {
        double x[5][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}}, p[3] = {0}, q[3] = {0};
        for (int i = 0; i < 15; i++)
            x[i / 3][i % 3] += draw(&seed);
        if (n % 100 == 0)
            memcpy(x[n / 100 % 4], x[(n / 100 + 1) % 4], sizeof x[0]);
        const int a = footpoint_locate(x[0], x[1], x[2], x[3], x[4], p, p + 2);
        const int b = footpoint_quad4_accurate(x[0], x[1], x[2], x[3], x[4], q, q + 2);
        if (a == FOOTPOINT_ERR_DOMAIN && b >= FOOTPOINT_OK)
            refused++;
        else if (a != b || memcmp(p, q, sizeof p) != 0)
            return printf("sample %d differs\n", n), 1;
    }
    return refused > 5000;
}
END
$CC -std=c11 -O1 -ffp-contract=off -c "$work/same/same.c" -o "$work/same/same.o" &&
    $CC "$work/same/same.o" "$BIN/libfootpoint.a" -o "$work/same/same" -lm && "$work/same/same"
report $((! $?)) 'the header alone answers as the library does, bit for bit, where that vouches for it'
$CC "$work/same/same.o" -o "$work/same/shared" -L"$BIN" -lfootpoint -lm &&
    LD_LIBRARY_PATH=$BIN "$work/same/shared"
report $((! $?)) 'the same with the shared library'
