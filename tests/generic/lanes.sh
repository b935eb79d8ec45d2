# Checks that loops over arrays of patches vectorise without flags or pragmas, for static and allocated arrays and for
# parameters: their functions must have packed instructions, and almost no scalar arithmetic.
. tests/cli/expect.inc
headers='bezier'
[ -z "$FOOTPOINT_LONG" ] || headers='bezier gregory paper_gregory'
command -v objdump > /dev/null && [ "$(uname -m)" = x86_64 ] || { echo '# SKIP no objdump, or another machine'; exit 0; }
later 'lanes: gregory, paper_gregory, and clang'
for compiler in "${CC:-gcc} -O2" "${CC:-gcc} -O3" 'clang -O3'; do
    case $compiler in
    *-O2) ;;
    *) [ -n "$FOOTPOINT_LONG" ] || continue ;;
    esac
    for name in $headers; do
        {
            echo "#include \"$PWD/generated/footpoint_$name.h\""
            echo '#include <stdlib.h>'
            echo "#define CHECKED footpoint_${name}_smooth_checked_n"
            echo 'enum { N = 1000 };'
            echo 'static double column[27][N], xi[N], eta[N], gap[N];'
            echo 'static int status[N];'
            echo 'int fixed(void) { const double *x[27]; int k; for (k = 0; k < 27; k++) x[k] = column[k];'
            echo '    CHECKED(N, x, xi, eta, gap, status); return status[7]; }'
            echo 'double allocated(size_t n) { double *x[27], *a = malloc(30 * n * sizeof *a), sum; int *s = malloc(n * sizeof *s), k;'
            echo '    if (!a || !s) abort();'
            echo '    for (k = 0; k < 27; k++) x[k] = a + (size_t)k * n;'
            echo '    for (k = 0; k < 27; k++) x[k][0] = column[k][0];'
            echo '    CHECKED(1, (const double *const *)x, a + 27 * n, a + 28 * n, a + 29 * n, s);'
            echo '    sum = a[27 * n] + s[0]; free(a); free(s); return sum; }'
            echo 'void passed(size_t n, const double *const *x, double *p, double *q, double *g, int *s) { CHECKED(n, x, p, q, g, s); }'
        } > "$work/lanes.c"
        # shellcheck disable=SC2086
        $compiler -std=c99 -mavx2 -mfma -c "$work/lanes.c" -o "$work/lanes.o" || exit 1
        objdump -d --no-show-raw-insn "$work/lanes.o" | awk '
            /^[0-9a-f]+ </ { name = $2 }
            name ~ /_lanes_(shapes|bares|proofs)|_begin/ && /ymm/ { packed[name]++ }
            name ~ /_lanes_(shapes|bares|proofs)|_begin/ && /v(mul|add|sub|fn?m[a-z0-9]*)ss / { scalar[name]++ }
            END { for (name in packed) { n++; bad += packed[name] < 100 || scalar[name] > 10 } exit n < 3 || bad }'
        report $((!$?)) "$name, $compiler"
    done
done
