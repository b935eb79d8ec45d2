# Checks that loops over arrays vectorise, by their packed operations in the machine code: for gcc and clang with AVX2
# in double; for gcc, which vectorises less, with SSE2, including two functions of a scene in float. Their results must
# equal the function for one point, bit for bit. Of scenes other than quad4 only the first and last function, or all of
# them with FOOTPOINT_VECTOR=all.
. tests/cli/expect.inc
codegen() { "$BIN/footpoint-codegen" --effort 10 "$@"; } # how the search ends is no matter here
command -v objdump > /dev/null || { report 1 'skipped: no objdump'; exit 0; }
case $(uname -m) in x86_64) ;; *) report 1 'skipped: not x86-64'; exit 0 ;; esac
warnings='-Wall -Wextra -Wpedantic -Wshadow -Werror'

# packed NAME LEAST REGISTER FLAGS: $work/use.c has at least LEAST packed operations on REGISTER, of which a compiler may
# spare one in a hundred (equal ones)
packed() {
    case_name=$1 least=$2 register=$3
    shift 3
    $compiler -std=c99 -O3 -ffp-contract=off $warnings "$@" -I"$work" -c "$work/use.c" -o "$work/use.o" > "$work/log" 2>&1
    found=$(objdump -d "$work/use.o" | grep -cE "v?(mul|div|add|sub|min|max|sqrt)p[ds] .*%$register")
    [ $((100 * found)) -ge $((99 * least)) ]
    good=$?
    [ $good = 0 ] || { sed 's/^/# /' "$work/log"; echo "# $found packed operations, not $least"; }
    report $((!good)) "$case_name, $compiler $*"
}

# operations HEADER FUNCTION: products, quotients and sums, as its banner counts them
operations() { told "$1" "$2" operations | awk '{ print $1 + $3 + $5 }'; }

# loop_flags HEADER FUNCTION: what the header says that its loop needs, beyond -O3
loop_flags() {
    told "$1" "${2%_n}" vectorises | sed 's/^-O3//'
}

for file in evolve/genomes/*.gen; do
    scene=$(basename "$file" .gen | tr - _)
    header=$PWD/generated/footpoint_$scene.h
    if ! grep -q '^ \* precision: double' "$header"; then
        header=$work/$scene.h
        codegen "$file" --allow-poles --precision double --prefix "footpoint_$scene" -o "$header"
    fi
    (FOOTPOINT_LONG='' && some "$file") > "$work/two.gen"
    codegen "$work/two.gen" --allow-poles --precision float --prefix "${scene}_f" -o "$work/${scene}_f.h"
    genomes=$(sed -n 's/^genome //p' "$file")
    [ "$scene" = quad4 ] || [ "$FOOTPOINT_VECTOR" = all ] || genomes=$(echo "$genomes" | sed '1b; $!d')
    for genome in $genomes; do
        for type in double float; do
            if [ $type = double ]; then
                in=$header function=footpoint_${scene}_$genome
            else
                grep -q "^genome $genome\$" "$work/two.gen" || continue
                in=$work/${scene}_f.h function=${scene}_f_$genome
            fi
            {
                echo "#include \"$in\""
                echo "void use(size_t n, const $type *const *x, $type *xi, $type *eta);"
                echo "void use(size_t n, const $type *const *x, $type *xi, $type *eta)"
                echo "{ ${function}_n(n, x, xi, eta); }"
            } > "$work/use.c"
            flags=$(loop_flags "$in" "${function}_n")
            least=$(operations "$in" "$function")
            for compiler in gcc clang; do
                # shellcheck disable=SC2086
                [ $compiler = clang ] || packed "$scene $genome $type" "$least" xmm $flags
                # shellcheck disable=SC2086
                [ $type = float ] || packed "$scene $genome $type" "$least" ymm $flags -mavx2 -mprefer-vector-width=256
            done
        done
    done
done

# Checked ones, as they are committed: the least and the most accurate of each kind of segment.
compiler=gcc
for kind in tri3 quad4 tri6 quad8 quad9 bezier gregory; do
    header=$PWD/generated/footpoint_$kind.h
    for function in $(grep -o "footpoint_${kind}_[a-z0-9]*_checked_n" "$header" | sort -u | sed 's/_checked_n$//' |
        while read -r name; do grep -n "int $name(" "$header" | sed "s/:.*/ $name/"; done | sort -n | sed 's/.* //; 1p; $!d'); do
        {
            echo "#include \"$header\""
            echo 'void use(size_t n, const double *const *x, double *xi, double *eta, double *gap, int *status);'
            echo 'void use(size_t n, const double *const *x, double *xi, double *eta, double *gap, int *status)'
            echo "{ ${function}_checked_n(n, x, xi, eta, gap, status); }"
        } > "$work/use.c"
        packed "${function}_checked_n" 100 ymm -fno-math-errno -fno-trapping-math -mavx2 -mprefer-vector-width=256
    done
done

# Closest points on four-node faces, whatever the flags.
{
    echo "#include \"$PWD/generated/footpoint_quad4.h\""
    echo 'void use(size_t n, const double *const *x, double *xi, double *eta, double *dist, int *region, int *status);'
    echo 'void use(size_t n, const double *const *x, double *xi, double *eta, double *dist, int *region, int *status)'
    echo '{ footpoint_quad4_accurate_closest_n(n, x, xi, eta, dist, region, status); }'
} > "$work/use.c"
packed 'footpoint_quad4_accurate_closest_n' 400 ymm -O2 -mavx2

# Along a direction, with fewer operations than they have.
for row in tri3:120 quad4:250 tri6:600 quad8:800 quad9:900; do
    name=footpoint_${row%:*}_along_n
    {
        echo "#include \"$PWD/generated/footpoint_${row%:*}.h\""
        echo 'void use(size_t n, const double *const *x, const double *const *p, double *xi, double *eta, double *dist, int *status);'
        echo 'void use(size_t n, const double *const *x, const double *const *p, double *xi, double *eta, double *dist, int *status)'
        echo "{ $name(n, x, p, xi, eta, dist, status); }"
    } > "$work/use.c"
    packed "$name" "${row#*:}" ymm -fno-math-errno -mavx2 -mprefer-vector-width=256
done

compilers='gcc clang'
# scalar NAME LEAST FLAGS: genome g of $work/g.gen, with inputs x y z and output r, vectorises as double and float
scalar() {
    name=$1 least=$2
    shift 2
    for type in double float; do
        codegen "$work/g.gen" --allow-poles --precision $type --prefix g -o "$work/g.h"
        status= argument=
        ! grep -q 'int \*FOOTPOINT_RESTRICT status' "$work/g.h" || { status=', int *s' argument=', s'; }
        {
            echo '#include "g.h"'
            echo "void use(size_t n, const $type *x, const $type *y, const $type *z, $type *r$status);"
            echo "void use(size_t n, const $type *x, const $type *y, const $type *z, $type *r$status)"
            echo "{ g_g_n(n, x, y, z, r$argument); }"
        } > "$work/use.c"
        for compiler in $compilers; do
            packed "$name $type" "$least" xmm "$@"
        done
    done
}
genome() { printf '%s\n' 'footpoint-genome 1' 'input x y z' 'genome g' "r = $*" end > "$work/g.gen"; }
genome '+ * x y * 0.35 - z * x x';                   scalar 'a polynomial' 4
genome 'min * x y max + z 0.5 abs - x y';            scalar 'min, max, abs' 3
genome '* z min 1.5 max -0.5 + x * y z';             scalar 'a clamp' 3
genome '* z min 1 max -1 + x * y z';                 scalar 'a clamp whose ends gcc multiplies' 3 -fno-trapping-math
genome '+ / x + y 3 / y - * z z 2';                  scalar 'quotients with a status' 5
genome '* x sqrt + * y y * z z';                     scalar 'a root' 5 -fno-math-errno
compilers=gcc # clang keeps the branch of a protected quotient in double
genome '+ x % * x y - z x';                          scalar 'a protected quotient' 3 -fno-trapping-math
genome 'max x min y % * y sqrt z - z x';             scalar 'all of them' 3 -fno-math-errno -fno-trapping-math

# many arrays: more than a compiler would test for overlap
{
    echo 'footpoint-genome 1'
    for i in $(seq 60); do echo "input x$i"; done
    echo 'genome g'
    for k in $(seq 12); do
        echo "r$k ="
        for i in $(seq $k 12 60); do echo " + * x$i x$(((i * 7 + k) % 60 + 1))"; done
        echo ' 1'
    done
    echo end
} > "$work/g.gen"
codegen "$work/g.gen" --prefix g -o "$work/g.h"
{
    echo '#include "g.h"'
    echo 'void use(size_t n, const double *const x[60], double *const r[12]);'
    echo 'void use(size_t n, const double *const x[60], double *const r[12])'
    printf '{ g_g_n(n'
    for i in $(seq 0 59); do printf ', x[%d]' "$i"; done
    for k in $(seq 0 11); do printf ', r[%d]' "$k"; done
    echo '); }'
} > "$work/use.c"
for compiler in gcc clang; do
    packed '60 arrays in, 12 out' 100 xmm
done

cat > "$work/same.c" <<'END'
#include "footpoint_quad4.h"
#include <stdio.h>
#include <string.h>
enum { N = 1003 };
int main(void)
{
    static double column[15][N], xi[N], eta[N];
    const double corner[15] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 0, 0};
    const double *x[15];
    unsigned long seed = 3;
    for (int k = 0; k < 15; k++) {
        for (int i = 0; i < N; i++) {
            seed = seed * 6364136223846793005UL + 1442695040888963407UL;
            column[k][i] = corner[k] + (double)(seed >> 11) / 9007199254740992.0 - 0.5;
        }
        x[k] = column[k];
    }
    footpoint_quad4_accurate_n(N, x, xi, eta);
    for (int i = 0; i < N; i++) {
        double p[15], one[2];
        for (int k = 0; k < 15; k++)
            p[k] = x[k][i];
        footpoint_quad4_accurate_at(p, p + 3, p + 6, p + 9, p + 12, one, one + 1);
        if (memcmp(one, xi + i, sizeof *xi) != 0 || memcmp(one + 1, eta + i, sizeof *eta) != 0)
            return printf("pair %d differs\n", i), 1;
    }
    return 0;
}
END
for compiler in gcc clang; do
    $compiler -std=c99 -O3 -ffp-contract=off $warnings -Igenerated "$work/same.c" -o "$work/same" -lm && "$work/same"
    report $((! $?)) "the loop gives what the function gives, $compiler"
done
