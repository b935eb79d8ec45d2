# Checks templates of C++ (--language c++): tests/generic/generic_main.cpp compares them, for four types of numbers,
# with the C header. With FOOTPOINT_LONG all kinds of faces, against the headers of generated/. Device code:
# languages.sh.
. tests/cli/expect.inc
CXX=${CXX:-g++}
codegen() { "$BIN/footpoint-codegen" --quiet --allow-poles "$@"; }
strict='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror'
g=$work/g.gen

# compare KIND SEARCH NODES NEAR COUNT FOLDER: with the C header of that folder, to NEAR
compare() {
    # shellcheck disable=SC2086
    $CXX -std=c++17 $strict -O0 -ffp-contract=off "-DNAME=footpoint_$1_$2" "-DAT=footpoint_$1_$2_at" "-DGRADIENTS=footpoint_$1_gradients" \
        "-DNODES=$3" "-DNEAR=$4" "-DCOUNT=$5" -I"$work" -I"$6" -Igenerated -include "footpoint_$1.hpp" -include "footpoint_$1_derivatives.h" \
        tests/generic/generic_main.cpp -o "$work/compare" > "$work/log" 2>&1 && "$work/compare" >> "$work/log"
    good=$?
    [ $good = 0 ] || head -20 "$work/log" | sed 's/^/# /'
    report $((!good)) "$1: double has the bits of C, float its answer, dual numbers the derivatives"
}

later 'generic: all kinds of faces, by the headers of generated/'
if [ -n "$FOOTPOINT_LONG" ]; then
    while read -r kind search nodes near; do
        codegen --language c++ "evolve/genomes/$kind.gen" -o "$work/footpoint_$kind.hpp"
        compare "$kind" "$search" "$nodes" "$near" 20000 generated
    done << 'END'
tri3 exact 3 1e-12
tri6 accurate 6 1e-10
quad4 full 4 1e-12
quad8 full 8 1e-12
quad9 full 9 1e-12
END
else
    awk '/^genome / { inside = 1; on = $2 == "full" } !inside || on; /^end/ { inside = 0 }' evolve/genomes/quad4.gen > "$g"
    for language in c c++; do
        [ $language = c ] && ending=h || ending=hpp
        codegen --effort 0 --language $language "$g" -o "$work/footpoint_quad4.$ending"
    done
    compare quad4 full 4 1e-12 300 "$work"
fi

# ---- functions of scalars, and refusals ----
printf '%s\n' 'footpoint-genome 3' 'input x y' 'genome g' 'r = sqrt(abs(x) + 0.1)*(1/3) - min(x, max(y, -0.75)) + x % y' 'q = 2.5' 'end' > "$g"
codegen --effort 0 --prefix g "$g" -o "$work/g.h" && codegen --effort 0 --prefix g --language c++ "$g" -o "$work/g.hpp"
cat > "$work/scalars.cpp" <<'END'
#include "g.h"
#include "g.hpp"
#include <cstring>
int main()
{
    for (int n = 0; n < 1000; n++) {
        const double x = (n % 37 - 18) / 8.0, y = (n % 23 - 11) / 4.0;
        double a[2], b[2];
        long double wide[2];
        (void)g_g(x, y, a, a + 1);
        g_g<double>(x, y, b, b + 1);
        g_g((long double)x, (long double)y, wide, wide + 1);
        if (std::memcmp(a, b, sizeof a) != 0 || !(std::fabs(wide[0] - (long double)a[0]) <= 1e-15 * (1 + std::fabs(wide[0]))))
            return 1;
    }
    return 0;
}
END
# shellcheck disable=SC2086
$CXX -std=c++11 $strict -ffp-contract=off "$work/scalars.cpp" -o "$work/scalars" > "$work/log" 2>&1 && "$work/scalars"
good=$?
[ $good = 0 ] || head -20 "$work/log" | sed 's/^/# /'
report $((!good)) 'functions of scalars have the bits of C'
printf '%s\n' 'footpoint-genome 2' 'face tri3' 'genome g' 'r = xi' 'require xi' end > "$g"
expect 'a place of a face' 1 '' "$g: error: functions at a place of a face are printed in C alone" \
    codegen --language c++ "$g" -o "$work/none"
