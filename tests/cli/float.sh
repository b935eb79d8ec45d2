# Checks the way from a scene in float to its header: `precision = "float"`, samples whose coordinates are floats, a
# banner with the errors of the float code, and code that computes nothing in double.
. tests/cli/expect.inc
CC=${CC:-gcc}
export OMPI_MCA_btl_base_warn_component_unused=0
evolve=$BIN/footpoint-evolve codegen=$BIN/footpoint-codegen
sed 's/^precision .*/precision = "float";/' tests/scenes/small.scene > "$work/f.scene"
expect 'evolution for float' 0 '*' '' "$evolve" --scene "$work/f.scene" -o "$work/f.gen" --generations 2 --quiet
expect 'the genomes say so' 0 'note precision float' '' grep '^note precision' "$work/f.gen"
expect 'samples' 0 '' '' "$evolve" --scene "$work/f.scene" --samples "$work/f.samples"
expect 'of all parts' 0 'heldout
heldout_even' '' sh -c "sed 1d '$work/f.samples' | cut -d, -f1 | uniq"
expect 'with climbing' 0 '' '' "$evolve" --scene "$work/f.scene" --start "$work/f.gen" --samples "$work/f.samples"
expect 'of the scene alone' 0 'heldout
heldout_climbing
heldout_even' '' sh -c "sed 1d '$work/f.samples' | cut -d, -f1 | uniq"
expect 'coordinates are floats' 0 0 '' sh -c \
    "sed 1d '$work/f.samples' | cut -d, -f2-16 | tr , '\n' | grep -cvE '^-?0x[01](\.[0-9a-f]{1,6})?p[-+][0-9]+$'; :"
expect 'header' 0 '' '' "$codegen" --quiet --effort 0 --allow-poles --samples "$work/f.samples" "$work/f.gen" -o "$work/f.h"
expect 'in float' 0 ' * precision: float' '' grep '^ . precision' "$work/f.h"
expect 'whose banner has errors of the float code alone' 0 2 '' grep -c '^ .   heldout' "$work/f.h"
expect 'of climbing, too' 0 '*' '' grep '^ .   heldout: .* samples and' "$work/f.h"
functions=$(sed -n 's/^FOOTPOINT_FN int \(footpoint_[a-z0-9_]*\)(const float xA.*/\1/p' "$work/f.h" | grep -v -e _detail_ -e '_closest$' -e '_along$')
{
    echo '#include "f.h"'
    echo 'int use(const float *const x[5], float loc[2], float *gap);'
    echo 'int use(const float *const x[5], float loc[2], float *gap)'
    echo '{'
    echo '    int sum = 0;'
    for f in $functions; do echo "    sum += $f(x[0], x[1], x[2], x[3], x[4], loc, gap);"; done
    echo '    return sum;'
    echo '}'
} > "$work/use.c"
later 'float: clang'
for compiler in "$CC -O2" "$CC -O0" ${FOOTPOINT_LONG:+"clang -O2"}; do
    $compiler -std=c99 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion -Werror -c "$work/use.c" -o "$work/use.o" \
        > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) "compiles, $compiler"
    case $(uname -m) in x86_64) ;; *) continue ;; esac
    ! objdump -d "$work/use.o" | grep -E '(cvtss2sd|cvtps2pd|cvtsd2ss|(add|sub|mul|div|sqrt)[sp]d) '
    report $((! $?)) "computes nothing in double, $compiler"
done

# Coordinates are those less A's: where A lies elsewhere, a bound for the coordinates as they are would say nothing of them.
bound() { # range of A, of B and C: how many bounds the banner claims
    printf '%s\n' 'footpoint-genome 2' 'segment quad4 any' \
        "range A $1 $1 0 0 0 0, B $2 0 0 0 0, C $2 1 1 0 0, D $1 $1 1 1 0 0, S 0.5 0.6 0.5 0.6 0 0.1" \
        'genome example' 'xi = / - xC xB - xB xA' 'eta = / - yS yA - yC yA' 'end' > "$work/a.gen"
    "$codegen" --quiet --effort 0 --samples "$work/f.samples" --precision float "$work/a.gen" -o "$work/a.h" &&
        grep '^ .   rounding' "$work/a.h" | grep -c proved
}
expect 'a bound where A is the origin' 0 1 '' bound 0 '1 1.001'
expect 'none where it is not' 1 0 '' bound 1 '0 0.001'

# What is refused.
expect 'samples of double code' 1 '' "$work/f.gen: error: --samples are for C code of a segment in float" \
    "$codegen" --effort 0 --precision double --allow-poles --samples "$work/f.samples" "$work/f.gen" -o "$work/d.h"
echo 'part,xA' > "$work/g.samples"
expect 'samples of something else' 1 '' \
    "$work/g.samples:1: error: no samples of the genomes' inputs, see footpoint-evolve --samples" \
    "$codegen" --effort 0 --allow-poles --samples "$work/g.samples" "$work/f.gen" -o "$work/d.h"
{ head -2 "$work/f.samples"; echo 'heldout,1,2'; } > "$work/g.samples"
expect 'a short line' 1 '' "$work/g.samples:3: error: no sample" \
    "$codegen" --effort 0 --allow-poles --samples "$work/g.samples" "$work/f.gen" -o "$work/d.h"
sed 's/^precision .*/precision = "float";/' evolve/scenes/gregory.scene > "$work/n.scene"
expect 'normals in float' 1 '' "$work/n.scene:13: error: 'precision' must be \"double\" for segment 'gregory'" \
    "$evolve" --scene "$work/n.scene" --samples "$work/n.samples"
[ ! -e "$work/n.samples" ] && [ ! -e "$work/d.h" ]; report $((! $?)) 'nothing is written'

# Triangles are proved in float, too, by any search.
printf '%s\n' 'footpoint-genome 3' 'segment tri3 any' 'genome g' 'xi = (dot(S - A, B - A)) / dot(B - A, B - A)' 'eta = dot(S - A, C - A) / dot(C - A, C - A)' 'end' > "$work/t.gen"
expect 'a triangle' 0 '' '' "$codegen" --quiet --effort 0 --allow-poles --precision float --prefix t "$work/t.gen" -o "$work/t.h"
cat > "$work/t.c" <<'END'
#include "t.h"
int main(void)
{
    static const float x[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25f, 0.25f, 0.5f}};
    const float *row[12], *const rest[3] = {&x[3][0], &x[3][1], &x[3][2]}, *const face[3] = {x[0], x[1], x[2]};
    float loc[2], gap, xi, eta;
    int region, status, wrong;
    size_t which;
    for (int k = 0; k < 12; k++)
        row[k] = &x[k / 3][k % 3];
    wrong = t_g(x[0], x[1], x[2], x[3], loc, &gap) != FOOTPOINT_OK || loc[0] != 0.25f;
    t_g_checked_n(1, row, &xi, &eta, &gap, &status);
    wrong |= status != FOOTPOINT_OK || xi != 0.25f;
    t_g_over_n(face, 1, rest, &xi, &eta, &gap, &status);
    wrong |= status != FOOTPOINT_OK || xi != 0.25f;
    wrong |= t_g_closest(x[0], x[1], x[2], x[3], loc, &gap, &region) != FOOTPOINT_OK;
    t_g_closest_n(1, row, &xi, &eta, &gap, &region, &status);
    wrong |= status != FOOTPOINT_OK;
    return wrong | (t_g_closest_of(1, face, x[3], loc, &gap, &region, &which) != FOOTPOINT_OK);
}
END
$CC -std=c99 -O1 "$work/t.c" -o "$work/t" -lm && "$work/t"
report $((! $?)) 'its answers are proved'

# A point almost as near to AC as to AB. Parts of -ffast-math, of which clang announces none, would prove AC.
cat > "$work/t.c" <<'END'
#include "t.h"
int main(void)
{
    static const volatile float at[12] = {-0x1.3cc996p-1f, -0x1.78df46p-1f, -0x1.d57424p-1f, -0x1.2dfab4p-2f,
                                          -0x1.78d05ap-1f, -0x1.d294p-3f,   -0x1.2de046p-2f, -0x1.78c212p-1f,
                                          -0x1.d26422p-3f, -0x1.1684f6p+0f, -0x1.df2f24p-2f, -0x1.35ea58p-1f};
    float x[4][3], loc[2] = {0, 0}, dist;
    int region;
    for (int k = 0; k < 12; k++)
        x[k / 3][k % 3] = at[k];
    return t_g_closest(x[0], x[1], x[2], x[3], loc, &dist, &region) == FOOTPOINT_OK && loc[0] == 0;
}
END
clang -std=c99 -O1 -ffast-math -fno-finite-math-only "$work/t.c" -o "$work/t" -lm && "$work/t"
report $((! $?)) 'headers ignore -ffast-math if clang does not announce it'
loose='-fassociative-math -fno-signed-zeros -fno-trapping-math'
# shellcheck disable=SC2086
clang -std=c99 -O1 -c "$work/t.c" -o "$work/t.o" && clang -std=c99 -O1 $loose -freciprocal-math -c "$work/t.c" -o "$work/loose.o" &&
    cmp "$work/t.o" "$work/loose.o"
report $((! $?)) 'parts of -ffast-math do not change object code of clang'
printf '%s\n' '#include "t.h"' '#if !FOOTPOINT_LOOSE' '#error proofs' '#endif' > "$work/t.c"
# shellcheck disable=SC2086
gcc -fsyntax-only $loose "$work/t.c" && gcc -fsyntax-only -freciprocal-math "$work/t.c"
report $((! $?)) 'nothing is proved under parts of -ffast-math that gcc announces'
