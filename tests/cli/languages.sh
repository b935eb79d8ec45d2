# What codegen writes beside C in double: float, Fortran, infix, LaTeX.  Fortran gives the bits of C, infix its values.
# Headers as HIP and CUDA, for AMD and NVIDIA GPUs; tests/long/cuda.sh compiles them by nvcc.
# With FOOTPOINT_LONG all functions of three scenes with four compilers, else two of quad4 and that of tri3 with two; device
# code of all headers, else of the first of each kind.
. tests/cli/expect.inc
CC=${CC:-gcc} CXX=${CXX:-g++}
codegen() { "$BIN/footpoint-codegen" --quiet --effort 0 "$@"; } # how the search ends is no matter here
g=$work/g.gen
strict='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror'
bits='-O2 -ffp-contract=off'
genome() { printf '%s\n' "footpoint-genome 1" "$@" > "$g"; }
written() { # written LANGUAGE NAME EXPECTED
    codegen "$g" --allow-poles --prefix g --language "$1" -o "$work/text" && grep -v '^%' "$work/text" > "$work/formulas"
    expect "$1: $2" 0 "$3" '' cat "$work/formulas"
}

# ---- formulas ----
genome 'input x y' 'genome g' 'r = + / x y 0.05' 'end' 'genome h' 'r = min x max y -3' 's = sqrt abs x' 'end'
written infix 'a line each, genomes apart' 'r = x/y + 1/20

t1 = abs(x)
u1 = -3
t2 = max(u1, y)
t3 = min(x, t2)
r = t3
s = sqrt(t1)'
written latex 'an environment each' '\begin{align}
r &= \frac{x}{y} + 0.05
\end{align}
\begin{align}
t_{1} &= \left|x\right| \\
u_{1} &= -3 \\
t_{2} &= \max\left(u_{1}, y\right) \\
t_{3} &= \min\left(x, t_{2}\right) \\
r &= t_{3} \\
s &= \sqrt{t_{1}}
\end{align}'
genome 'input speed x1 c_d xi' 'genome g' 'r = / speed x1' 's = * / 7 3 c_d' 'q = * xi xi' 'p = % x1 xi' 'end'
written latex 'names, fractions, cases' '\begin{align}
r &= \frac{\mathrm{speed}}{x_{1}} \\
s &= \frac{7}{3} \cdot \mathrm{c\_d} \\
q &= \xi^{2} \\
p &= \begin{cases} 1 & \xi = 0 \\ \frac{x_{1}}{\xi} & \text{otherwise} \end{cases}
\end{align}'
genome 'input t1 u2_' 'genome g' 'r = / sqrt + t1 u2_ sqrt + t1 * 2 u2_' 'end'
codegen "$g" --allow-poles --language infix -o "$work/text" && ! grep -qE '^(t1|u2_) ' "$work/text"
report $((! $?)) 'no temporary takes the name of an input'
genome 'input x' 'genome g' 'x = * x x' 'end'
expect 'an output named as an input' 1 '' "$g:4:1: error: output 'x' has the name of an input, which a formula cannot tell" \
    codegen "$g" --language infix -o "$work/none"
[ ! -e "$work/none" ]; report $((! $?)) 'and nothing is written'

# ---- the same values everywhere ----
genome 'input x y z' 'genome g' \
    'r = + - * x y / 7 + 3 * z z % - x y - z 0.5' \
    's = - min x max y -0.75 * * 0.35 sqrt + abs x 0.1 neg - x - y - z / 1 3' 'end'
cat > "$work/points.c" <<'END'
#include "c.h"
#include <stdio.h>
#include <string.h>
#ifdef FORTRAN
void FORTRAN(const real *x, const real *y, const real *z, real *r, real *s LAST(int *));
#endif
static real draw(unsigned long *seed)
{
    *seed = *seed * 6364136223846793005UL + 1442695040888963407UL;
    const real x = (real)(long)((*seed >> 34) - (1UL << 29)) / (real)(1UL << 27);
    return *seed % 8 ? x : (real)((int)(x * 2)) / 2; /* now and then a multiple of 1/2: protected quotients of 0 */
}
int main(void)
{
    unsigned long seed = 1;
    for (int n = 0; n < 10000; n++) {
        const real x = draw(&seed), y = draw(&seed), z = draw(&seed);
        real c[2];
        CALL(x, y, z, c, c + 1);
#ifdef FORTRAN
        real f[2];
        int status;
        FORTRAN(&x, &y, &z, f, f + 1 LAST(&status));
        if (memcmp(c, f, sizeof c) != 0)
            return printf("%.17g %.17g %.17g: %.17g %.17g, in Fortran %.17g %.17g\n", x, y, z, c[0], c[1], f[0], f[1]), 1;
#else
        if (n % 10 == 0)
            printf("%.17g %.17g %.17g %.17g %.17g\n", x, y, z, c[0], c[1]);
#endif
    }
    return 0;
}
END
for type in double float; do
    codegen "$g" --allow-poles --precision $type --prefix g -o "$work/c.h"
    codegen "$g" --allow-poles --precision $type --prefix m --language fortran -o "$work/m.f90"
    last='-DLAST(a)='
    ! grep -q 'FOOTPOINT_FN int g_g' "$work/c.h" || last='-DLAST(a)=,a'
    $CC -std=c99 $bits "-DCALL=(void)g_g" -Dreal=$type "$work/points.c" -o "$work/points" -lm && "$work/points" > "$work/$type"
    report $((! $?)) "C in $type runs"
    if ! command -v gfortran > /dev/null; then
        report 1 "skipped: Fortran in $type (no gfortran)"
        continue
    fi
    (cd "$work" && gfortran -std=f2008 -Wall -Werror $bits -c m.f90 -o m.o &&
        $CC -std=c99 $bits "-DCALL=(void)g_g" -Dreal=$type -DFORTRAN=__m_MOD_m_g "$last" points.c m.o -o points -lm -lgfortran &&
        ./points) > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) "Fortran gives the bits of C in $type"
done
awk 'NR == FNR { r[FNR] = $4; s[FNR] = $5; next }
     { d = r[FNR] - $4; e = s[FNR] - $5; if (d * d + e * e > 1e-6 * (1 + r[FNR]^2 + s[FNR]^2)) off++ }
     END { exit off > 10 }' "$work/double" "$work/float" # a few lie near a pole or a jump
report $((! $?)) 'float is double rounded'
if command -v python3 > /dev/null; then
    codegen "$g" --allow-poles --language infix -o "$work/g.txt"
    cat > "$work/check.py" <<'END'
import math, sys
def pdiv(a, b):
    return 1.0 if b == 0 else a / b
code = compile(open(sys.argv[1]).read(), "formulas", "exec")
for line in open(sys.argv[2]):
    x, y, z, r, s = map(float, line.split())
    v = {"x": x, "y": y, "z": z, "sqrt": math.sqrt, "abs": abs, "min": min, "max": max, "pdiv": pdiv}
    exec(code, v)
    assert (v["r"], v["s"]) == (r, s), (line, v["r"], v["s"])
END
    [ -n "$FOOTPOINT_LONG" ] && checked=1000 || checked=200
    head -n $checked "$work/double" > "$work/some"
    python3 "$work/check.py" "$work/g.txt" "$work/some" > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) 'Python reads infix and gives the bits of C'
else
    report 1 'skipped: infix in Python'
fi
if command -v form > /dev/null; then
    genome 'input x y' 'genome g' 'r = - * + x * 0.35 y - x / y 3 * 2 * x x' 'end'
    codegen "$g" --language infix -o "$work/g.txt"
    { echo 'Symbols x,y;'; sed 's/^/Local /; s/$/;/' "$work/g.txt"
      echo 'Local rest = r - ((x + 35/100*y)*(x - y/3) - 2*x^2);'; echo 'Print rest;'; echo '.end'; } > "$work/g.frm"
    form "$work/g.frm" > "$work/log"
    grep -q 'rest = 0;' "$work/log" || grep -A1 'rest =' "$work/log" | tr -d '\n ' | grep -q 'rest=0;'
    report $((! $?)) 'FORM reads infix'
else
    report 1 'skipped: infix in FORM'
fi

# ---- Fortran's limits ----
genome 'input x X' 'genome g' 'r = + x X' 'end'
expect 'names that differ in case' 1 '' "$g: error: Fortran takes 'in_x' and 'in_X' for one name" \
    codegen "$g" --language fortran -o "$work/m.f90"
long=a23456789012345678901234567890123456789012345678901234567890
genome 'input x' "genome $long" 'r = x' 'end'
expect 'a long name' 1 '' "$g: error: 'footpoint_m_$long' is longer than a name in Fortran" \
    codegen "$g" --language fortran -o "$work/m.f90"
{
    echo 'footpoint-genome 1'
    for i in $(seq 1500); do echo "input x$i"; done
    echo 'genome g'
    printf 'r = * 0.1234567890123456789012345678901234567890123456789012345678901'
    for i in $(seq 1499); do printf ' + * 0.3%04d x%d' "$i" "$i"; done
    printf ' x1500\nend\n'
} > "$g"
codegen "$g" --language fortran --prefix m -o "$work/m.f90"
[ "$(awk 'length > n { n = length } END { print n }' "$work/m.f90")" -le 132 ]; report $((! $?)) 'no line is longer than 132'
awk '/&$/ { if (++n > 255) exit 1; next } { n = 0 }' "$work/m.f90"; report $((! $?)) 'no statement has more than 255 continuation lines'
if command -v gfortran > /dev/null; then
    (cd "$work" && gfortran -std=f2008 -Wall -Werror -c m.f90 -o m.o) > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log" | head -20
    report $((!good)) 'a sum of 1500 terms compiles'
fi

# ---- segments ----
later 'languages: paper-quad4, quad4 in float, most functions of quad4, two compilers, 800 points in Python, functions that nobody calls of several headers in one file, second headers of a kind, edge3, quad8, quad9 and bezier on GPUs, curved faces and patches in CUDA, machine code of GPUs'
for scene in tri3 ${FOOTPOINT_LONG:+paper-quad4} quad4; do
    file=$work/$scene.gen
    some evolve/genomes/$scene.gen > "$file"
    case $scene in tri3) vectors=4 ;; *) vectors=5 ;; esac
    pointers= arguments=
    for k in $(seq 0 $((vectors - 1))); do
        pointers="$pointers@ *, " arguments="${arguments}x + $((3 * k)), "
    done
    for type in double float; do
        codegen "$file" --allow-poles --precision $type --prefix $type -o "$work/$type.h"
        [ -n "$FOOTPOINT_LONG" ] || [ $scene$type != quad4float ] || continue
        codegen "$file" --allow-poles --precision $type --prefix m --language fortran -o "$work/m.f90"
        {
            echo "#include \"$type.h\""
            echo '#include <stdio.h>'
            echo '#include <string.h>'
            for f in $(sed -n 's/^genome //p' "$file"); do
                echo "void __m_MOD_m_${f}_at($(echo "$pointers" | sed "s/@/const $type/g")$type *, $type *);"
            done
            cat <<END
int main(void)
{
    const $type corner[15] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 0, 0};
    unsigned long seed = 3;
    for (int n = 0; n < 5000; n++) {
        $type x[15], c[2], f[2];
        for (int k = 0; k < 15; k++) {
            seed = seed * 6364136223846793005UL + 1442695040888963407UL;
            x[k] = corner[k] + ($type)(seed >> 40) / ($type)(1UL << 24) - ($type)0.5;
        }
END
            for f in $(sed -n 's/^genome //p' "$file"); do
                echo "        ${type}_${f}_at(${arguments}c, c + 1);"
                echo "        __m_MOD_m_${f}_at(${arguments}f, f + 1);"
                echo '        if (memcmp(c, f, sizeof c) != 0)'
                echo "            return printf(\"$f, point %d, \", n), 1;"
            done
            echo '    }'
            echo '    return 0;'
            echo '}'
        } > "$work/both.c"
        echo "#include \"$type.h\"" > "$work/include.c"
        for compiler in "clang -std=c11" "$CXX -std=c++11 -x c++" ${FOOTPOINT_LONG:+"$CC -std=c99" "clang++ -std=c++17 -x c++"}; do
            $compiler $strict -fsyntax-only "$work/include.c" > "$work/log" 2>&1
            good=$?
            [ $good = 0 ] || sed 's/^/# /' "$work/log" | head -20
            report $((!good)) "$scene in $type, $compiler"
        done
        command -v gfortran > /dev/null || { report 1 "skipped: $scene in Fortran"; continue; }
        (cd "$work" && gfortran -std=f2008 -Wall -Werror $bits -c m.f90 -o m.o &&
            $CC -std=c99 $bits both.c m.o -o both -lm -lgfortran && ./both) > "$work/log" 2>&1
        good=$?
        [ $good = 0 ] || sed 's/^/# /' "$work/log" | head -20
        report $((!good)) "$scene in Fortran gives the bits of C in $type"
    done
done

# ---- float beside double, of quad4 ----
cat > "$work/beside.c" <<'END'
#include "double.h"
#include "float.h"
int main(void)
{
    const double a[3] = {0, 0, 0}, b[3] = {2, 0, 0.125}, c[3] = {2.25, 1.5, 0}, d[3] = {0, 1.25, 0.125}, s[3] = {0.75, 1, 0.25};
    const float fa[3] = {0, 0, 0}, fb[3] = {2, 0, 0.125F}, fc[3] = {2.25F, 1.5F, 0}, fd[3] = {0, 1.25F, 0.125F};
    const float fs[3] = {0.75F, 1, 0.25F};
    double loc[2], gap;
    float floc[2], fgap;
    if (double_coarse(a, b, c, d, s, loc, &gap) != FOOTPOINT_OK || float_coarse(fa, fb, fc, fd, fs, floc, &fgap) != FOOTPOINT_OK)
        return 1;
    if (float_coarse(fa, fa, fc, fc, fs, floc, &fgap) != FOOTPOINT_ERR_DEGENERATE)
        return 2;
    double_coarse_at(a, b, c, d, s, &loc[0], &loc[1]); /* the expression alone, in both */
    float_coarse_at(fa, fb, fc, fd, fs, &floc[0], &floc[1]);
    return !(fabs(loc[0] - (double)floc[0]) < 1e-5 && fabs(loc[1] - (double)floc[1]) < 1e-5 && fabs(gap - (double)fgap) < 1e-5);
}
END
[ -z "$FOOTPOINT_LONG" ] || called=
for compiler in "$CC -std=c99" "$CXX -std=c++11 -x c++" ${FOOTPOINT_LONG:+"clang -std=c11"}; do
    # shellcheck disable=SC2086
    $compiler $strict $called "$work/beside.c" -o "$work/beside" -lm > "$work/log" 2>&1 && "$work/beside"
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log" | head -20
    report $((!good)) "double and float in one file, $compiler"
done
# ---- two prefixes: the same functions twice in one file ----
printf '%s\n' 'footpoint-genome 2' 'face tri3' 'genome g' 'r = xi' 'require xi' end > "$g"
for prefix in one two; do
    codegen evolve/genomes/tri3.gen --allow-poles --prefix $prefix -o "$work/${prefix}_search.h"
    codegen "$g" --prefix $prefix -o "$work/${prefix}_place.h"
    capitals=$(echo $prefix | tr a-z A-Z)
    cat >> "$work/prefixes.c" <<END
#include "${prefix}_search.h"
#include "${prefix}_place.h"
${capitals}_G_OF(${prefix}_exact)
static int $prefix(const double *a, const double *b, const double *c, const double *s)
{
    const double p[3] = {0, 0, 1}, *const face[3] = {a, b, c}, *x[12], *q[3];
    double loc[2], gap, dist, r[1], xi, eta, n[1];
    int region, status, i;
    size_t which;
    for (i = 0; i < 12; i++)
        x[i] = (i < 3 ? a : i < 6 ? b : i < 9 ? c : s) + i % 3;
    for (i = 0; i < 3; i++)
        q[i] = p + i;
    status = ${prefix}_exact(a, b, c, s, loc, &gap) | ${prefix}_exact_closest(a, b, c, s, loc, &dist, &region) |
             ${prefix}_exact_closest_of(1, face, s, loc, &dist, &region, &which) | ${prefix}_along(a, b, c, s, p, loc, &dist) |
             ${prefix}_g(a, b, c, s, loc, r) | ${prefix}_exact_g(a, b, c, s, loc, n);
    ${prefix}_along_n(1, x, q, &xi, &eta, &dist, &region);
    ${prefix}_g_n(1, x, loc, loc + 1, n, &i);
    return status | region | i | (r[0] != n[0]);
}
END
done
echo 'int main(void) { const double x[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 1}};
    return one(x[0], x[1], x[2], x[3]) | two(x[0], x[1], x[2], x[3]); }' >> "$work/prefixes.c"
for compiler in "$CC -std=c99" "$CXX -std=c++11 -x c++" ${FOOTPOINT_LONG:+"clang -std=c11"}; do
    # shellcheck disable=SC2086
    $compiler $strict $called "$work/prefixes.c" -o "$work/prefixes" -lm > "$work/log" 2>&1 && "$work/prefixes"
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log" | head -20
    report $((!good)) "searches and places with two prefixes in one file, $compiler"
done

genome 'input x' 'genome g' 'r = * 1e60 x' 'end'
expect 'a constant beyond float' 1 '' "$g:3:1: error: genome 'g' has a constant outside the range of float" \
    codegen "$g" --precision float -o "$work/none"
expect 'which double has' 0 '' '' codegen "$g" -o "$work/c.h"

# ---- device code, by clang: a kernel calls every function of every header ----
# Mathematics and the words for kernels are the test's own, so that no runtime need be installed.  HEADERS: the folder.
command -v clang++ > /dev/null || { report 1 'skipped: device code (no clang++)'; exit 0; }
mkdir -p "$work/device/include"
cat > "$work/device/include/math.h" <<'END'
#pragma once
#define FOR_BOTH __attribute__((host, device))
FOR_BOTH static inline double fabs(double x) { return __builtin_fabs(x); }
FOR_BOTH static inline float fabsf(float x) { return __builtin_fabsf(x); }
FOR_BOTH static inline double sqrt(double x) { return __builtin_sqrt(x); }
FOR_BOTH static inline float sqrtf(float x) { return __builtin_sqrtf(x); }
FOR_BOTH static inline double copysign(double x, double y) { return __builtin_copysign(x, y); }
FOR_BOTH static inline float copysignf(float x, float y) { return __builtin_copysignf(x, y); }
FOR_BOTH double atan2(double y, double x);
FOR_BOTH float atan2f(float y, float x);
FOR_BOTH double frexp(double x, int *exponent);
FOR_BOTH float frexpf(float x, int *exponent);
FOR_BOTH double ldexp(double x, int exponent);
FOR_BOTH float ldexpf(float x, int exponent);
END
cat > "$work/device/words.h" <<'END'
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
#define __forceinline__ inline __attribute__((always_inline))
END

for header in "${HEADERS:-$PWD/generated}"/*.h; do
    case $header in
    */footpoint_quad4.h) ;;
    *_quad4.h | *paper* | *_bezier* | *_gregory_d* | *_quad8* | *_quad9* | *_tri6_d* | *_edge3.h) [ -n "$FOOTPOINT_LONG$HEADERS" ] || continue ;;
    esac
    device_kernel "$header" > "$work/device/$(basename "$header" .h).cu"
done
# Templates of C++, called with double and float.
printf '#include "math.h"\nnamespace std {\nusing ::fabs;\nusing ::sqrt;\n}\n' > "$work/device/include/cmath"
for ending in h hpp; do
    [ $ending = h ] && language=c || language=c++
    codegen evolve/genomes/tri3.gen --allow-poles --language $language -o "$work/device/include/footpoint_tri3.$ending"
done
cat > "$work/device/templates.cu" <<'END'
#include "footpoint_tri3.hpp"
template <class T> static __device__ void search(const T *x, T *loc, T *gap)
{
    footpoint_tri3_exact_at(x, x + 3, x + 6, x + 9, loc, loc + 1);
    (void)footpoint_tri3_exact(x, x + 3, x + 6, x + 9, loc, gap);
    (void)footpoint_tri3_exact<T>(x, x + 3, x + 6, x + 9, loc, gap);
}
__global__ void kernel(const double *x, double *a, const float *y, float *b)
{
    search(x, a, a + 2);
    search(y, b, b + 2);
}
END
# -fsyntax-only reports host functions that a kernel calls; with FOOTPOINT_LONG machine code of two kinds of faces, too.
cat > "$work/device/compile" << 'END'
for file; do :; done
case $file in footpoint_quad4.cu | footpoint_tri3.cu | templates.cu) code=${FOOTPOINT_LONG:+-S} ;; esac
clang++ ${code:--fsyntax-only} -o /dev/null "$@"
END
for target in 'hip gfx90a -nogpuinc -nogpulib' 'cuda sm_70 -nocudainc -nocudalib -D__CUDACC__'; do
    # shellcheck disable=SC2086
    set -- $target
    language=$1 gpu=$2
    shift 2
    set -- -std=c++11 -O0 -w -x "$language" --cuda-device-only "--cuda-gpu-arch=$gpu" "$@"
    clang++ "$@" -fsyntax-only /dev/null 2> /dev/null || { report 1 "skipped: $language for $gpu (not in this clang)"; continue; }
    files='*.cu'
    [ "$language" != cuda ] || [ -n "$FOOTPOINT_LONG$HEADERS" ] || files='footpoint_quad4*.cu footpoint_tri3*.cu templates.cu'
    # shellcheck disable=SC2086
    (cd "$work/device" && ls $files | xargs -P "$(nproc)" -I{} sh compile "$@" -Iinclude -include words.h {}) \
        > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || head -20 "$work/log" | sed 's/^/# /'
    report $((!good)) "$(cd "$work/device" && ls $files | wc -l) headers, every function, $language for $gpu"
done
