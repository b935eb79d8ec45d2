# Checks segments of any size: functions of patches answer as for |AB| = 1, status included, in any unit of length.
. tests/cli/expect.inc
CC=${CC:-gcc} CODEGEN=${BIN:-build}/footpoint-codegen
strict='-std=c99 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -ffp-contract=off'
[ -n "$FOOTPOINT_LONG" ] && strict="$strict -O1" called= || strict="$strict -O0" # gcc with -O1 inlines no function called by its address

# A genome that divides by powers 2 and 3 of lengths, which are 0 if |AD| = |AB|/2, within limits of xi and eta.
{
    echo 'footpoint-genome 1'
    echo 'input xA yA zA xB yB zB xC yC zC xD yD zD xnA ynA znA xnB ynB znB xnC ynC znC xnD ynD znD xS yS zS'
    echo 'segment gregory any'
    for range in 'xA 0 0' 'yA 0 0' 'zA 0 0' 'xB 1 1' 'yB 0 0' 'zB 0 0' 'xC 0.5 1.5' 'yC 0.5 1.5' 'zC -0.1 0.1' 'xD -0.2 0.2' 'yD 0.25 1' \
                 'zD -0.1 0.1' 'xS 0 1' 'yS 0 1' 'zS -0.1 0.1'; do
        echo "range $range"
    done
    for n in A B C D; do
        printf 'range xn%s -0.1 0.1\nrange yn%s -0.1 0.1\nrange zn%s 0.9 1\n' $n $n $n
    done
    echo 'let ab = + + * - xB xA - xB xA * - yB yA - yB yA * - zB zA - zB zA'
    echo 'let ad = + + * - xD xA - xD xA * - yD yA - yD yA * - zD zA - zD zA'
    echo 'let as = + + * - xS xA - xB xA * - yS yA - yB yA * - zS zA - zB zA'
    echo 'genome sized'
    echo 'xi = max -1 min 1 * 0.25 / as - ad * 0.25 ab'
    echo 'eta = max -1 min 1 / * as - xS xB * ad - - yD yA * 0.5 - xB xA'
    echo 'end'
} > "$work/sized.gen"
"$CODEGEN" --effort 0 --allow-poles "$work/sized.gen" -o "$work/sized.h" > "$work/log" 2>&1
report $((!$?)) 'a genome with poles behind limits'
[ "$(tr -s ' \n' ' ' < "$work/sized.h" | grep -oE 'power\(xA, xB, [23]\)' | sort -u | wc -l)" = 2 ] # lines break anywhere
report $((!$?)) 'its limits go with the square and the cube of |AB|'

cat > "$work/sizes.c" << 'END'
#include <stdio.h>
#include <string.h>
#include HEADER

typedef int function(const double *, const double *, const double *, const double *, const double *, const double *,
                     const double *, const double *, const double *, double *, double *);
static function *const functions[] = {FUNCTIONS};

/* Corners, normals and slave node; the second one's |AD| is half of |AB|. */
static const double patch[3][9][3] = {
    {{0, 0, 0}, {1, 0, 0}, {1.125, 1, 0.0625}, {0.125, 0.875, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0.25, 0.375, 0.03125}},
    {{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {0, 0.5, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0.25, 0.125, 0.0625}},
    {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0.5, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0.25, 0.125, 0.0625}}};

static int call(function *f, const double (*p)[3], double size, double answer[3])
{
    double x[9][3];
    for (int v = 0; v < 9; v++)
        for (int i = 0; i < 3; i++)
            x[v][i] = v < 4 || v == 8 ? size * p[v][i] : p[v][i];
    answer[0] = answer[1] = answer[2] = 7 * size;
    const int status = f(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], answer, answer + 2);
    answer[2] /= size;
    return status;
}

static int differ(double a, double b)
{
    return !(a - b <= 1e-12 && b - a <= 1e-12);
}

int main(void)
{
    static const double sizes[] = {1e-12, 1e-6, 1.0 / 1048576, 1e6, 1e12};
    int wrong = 0;
    for (size_t k = 0; k < sizeof functions / sizeof *functions; k++)
        for (int i = 0; i < 3; i++) {
            double usual[3], here[3];
            const int status = call(functions[k], patch[i], 1, usual);
            wrong += status != EXPECTED[i];
            for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
                const int bad = call(functions[k], patch[i], sizes[s], here) != status ||
                                (status == 0 && (differ(here[0], usual[0]) || differ(here[1], usual[1]) || differ(here[2], usual[2])));
                if (bad)
                    printf("function %d, patch %d, size %g: %.17g %.17g %.17g\n", (int)k, i, sizes[s], here[0], here[1], here[2]);
                wrong += bad;
            }
        }
    return wrong != 0;
}
END

# sizes HEADER STATUSES WHAT
sizes() {
    functions=$(sed -n 's/^FOOTPOINT_FN int \([a-z0-9_]*\)(const double xA.*/\1/p' "$1" | grep -v -e '^footpoint_detail_' -e '_closest$' -e '_along$' -e '_from$' | paste -sd, -)
    # shellcheck disable=SC2086
    ${CC:-gcc} $strict $called -DHEADER="\"$1\"" -DFUNCTIONS="$functions" -DEXPECTED="((const int[3]){$2})" "$work/sizes.c" -o "$work/sizes" -lm \
        > "$work/log" 2>&1 && "$work/sizes" >> "$work/log" 2>&1
    good=$?
    [ $good -eq 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) "$3"
}
sizes "$work/sized.h" 0,0,-2 'a pole of the search keeps no answer from its proof, at any size'
# A Gregory patch divides by the lengths of its edges, a Bezier patch does not.
sizes "$PWD/generated/footpoint_bezier.h" 0,0,0 'footpoint_bezier.h at any size'
later 'sizes: paper_gregory, optimised code'
for kind in gregory ${FOOTPOINT_LONG:+paper_gregory}; do
    sizes "$PWD/generated/footpoint_$kind.h" 0,0,-2 "footpoint_$kind.h at any size"
done
