# Checks that files of `make install` work in a scratch folder and after it was moved: library, Fortran module,
# programs, pages; and that `make uninstall` removes only these.  Projects with CMake and C++, and folders of other names, are in tests/long/projects.sh.
. tests/cli/expect.inc
CC=${CC:-gcc}
strict='-Wall -Wextra -Wpedantic -Werror'
[ -z "$FOOTPOINT_LONG" ] || called=
logged() { # logged NAME COMMAND...: as `report`, with what the command says where it fails
    name=$1
    shift
    "$@" > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) "$name"
}
functions_of() { grep -ohE '^[a-z].*\bfootpoint_[a-z0-9_]+\(' "$@" | grep -oE 'footpoint_[a-z0-9_]+' | sort -u; }

# Templates of C++ are installed if they have been made: here a quick one, elsewhere than `make c++` puts them.
"$BIN/footpoint-codegen" --quiet --allow-poles --effort 0 --language c++ evolve/genomes/tri3.gen -o "$work/footpoint_tri3.hpp"
generic=GENERIC=$work/footpoint_tri3.hpp
logged 'make install' make -s install "$generic" CC="$CC" PREFIX=/opt/footpoint DESTDIR="$work/stage"
mv "$work/stage/opt/footpoint" "$work/moved"
installed=$work/moved include=$work/moved/include lib=$work/moved/lib
find "$work/stage" ! -type d > "$work/log"; [ ! -s "$work/log" ]; report $((! $?)) 'nothing outside PREFIX'
find "$include" -name '*.h' | sed 's|.*/||' | grep -v '^footpoint[-_.]' > "$work/log"
[ ! -s "$work/log" ]; report $((! $?)) 'headers have our name'
find "$include" -name '*.h' | grep -vxF -e "$include/footpoint_batch.h" -e "$include/footpoint_face.h" -e "$include/footpoint_patch.h" | sed 's|.*/||' | grep '_' | grep -vxF "$(ls generated)" \
    > "$work/log" # they stand beside footpoint.h, generated ones have a folder of their own
[ ! -s "$work/log" ]; report $((! $?)) 'and those of the library none that a generated one could have'
! grep -rlIF -e "$work" -e "$PWD" "$installed" > "$work/log"; report $((! $?)) 'no file knows where it was made'

# ---- the library ----
functions_of "$include"/*.h "$include"/footpoint/footpoint-*.h > "$work/declared"
nm -D --defined-only "$lib/libfootpoint.so" | sed -n 's/.* T \(.*\)@@FOOTPOINT_2$/\1/p' | sort > "$work/exported"
logged 'the library exports what its headers declare' diff "$work/declared" "$work/exported"
nm -D --defined-only "$lib/libfootpoint.so" | grep -vE '(@@| A )FOOTPOINT_2$' > "$work/log"
[ ! -s "$work/log" ]; report $((! $?)) 'and nothing else'
nm -g --defined-only "$lib/libfootpoint.a" | awk 'NF == 3 && $3 !~ /^_*footpoint_/' > "$work/log"
[ ! -s "$work/log" ]; report $((! $?)) 'the archive has no other names'
nm -g --defined-only "$lib/libfootpoint_ccx.a" | awk 'NF == 3 && $3 !~ /^_*footpoint_attach_/ { print $3 }' > "$work/log"
expect 'the library for CalculiX has one' 0 attach_2d_ '' cat "$work/log"

cat > "$work/use.c" <<'C'
#include <footpoint.h>
#include <footpoint/footpoint_quad4.h>
#include <stdio.h>

int main(void)
{
    const double x[5][3] = {{0, 0, 0}, {2, 0, 0.1}, {2.2, 1.5, 0}, {0, 1.2, 0.1}, {0.7, 0.9, 0.25}};
    double loc[2], gap, own[2], own_gap;
    const int status = footpoint_locate(x[0], x[1], x[2], x[3], x[4], loc, &gap);
    if (footpoint_quad4_accurate(x[0], x[1], x[2], x[3], x[4], own, &own_gap) != FOOTPOINT_OK)
        return 1;
    printf("%s %.6f %.6f %.6f %.6f\n", footpoint_strerror(status), loc[0], loc[1], gap, own_gap);
    return 0;
}
C
answer='success -0.349489 0.395534 0.193207 0.193207'
export PKG_CONFIG_PATH="$installed/lib/pkgconfig"
if command -v pkg-config > /dev/null; then
    expect 'pkg-config knows the version' 0 "$("$BIN/footpoint-codegen" --version | grep -oE '[0-9.]+$')" '' \
        pkg-config --modversion footpoint
    logged 'C, shared' $CC -std=c99 $strict $called "$work/use.c" -o "$work/use" $(pkg-config --cflags --libs footpoint) -lm
    readelf -d "$work/use" | grep -q 'NEEDED.*libfootpoint\.so\.2'; report $((! $?)) 'which asks for the ABI by number'
    expect 'and answers' 0 "$answer" '' env LD_LIBRARY_PATH="$installed/lib" "$work/use"
    logged 'C, static' $CC -std=c11 $strict $called "$work/use.c" -o "$work/use" $(pkg-config --cflags footpoint) \
        "$installed/lib/libfootpoint.a" -lm
    expect 'which answers' 0 "$answer" '' "$work/use"
    cat > "$work/use.cpp" <<'C'
#include <footpoint/footpoint_tri3.hpp>
#include <footpoint/footpoint_tri3_derivatives.h>
#include <cstdio>

int main()
{
    const long double x[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.5, 2}};
    long double loc[2], gap;
    std::printf("%d", footpoint_tri3_exact(x[0], x[1], x[2], x[3], loc, &gap));
    std::printf(" %g %g %g\n", (double)loc[0], (double)loc[1], (double)gap);
    return 0;
}
C
    logged 'C++, any type of numbers' ${CXX:-g++} -std=c++11 $strict $called "$work/use.cpp" -o "$work/use" $(pkg-config --cflags footpoint)
    expect 'which answers' 0 '4 0.25 0.5 2' '' "$work/use"
    # A program with a search of its own, from an archive: ours is used only on request.
    cat > "$work/search.c" <<'C'
#include <footpoint.h>
#include <stdio.h>
void attach_2d_(const double (*pneigh)[3], double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                double *etl);
int main(void)
{
    const double x[9][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    double at[3] = {0.25, 0.5, 2}, ratio[9], dist = -1, xi, eta;
    const int nodes = 3;
    attach_2d_(x, at, &nodes, ratio, &dist, &xi, &eta);
    printf("%s %g\n", footpoint_strerror(FOOTPOINT_OK), dist);
    return 0;
}
C
    printf 'void attach_2d_(const void *x, double *p, const int *n, double *r, double *dist) { *dist = 77; }\n' > "$work/own.c"
    (cd "$work" && $CC -c search.c own.c $(pkg-config --cflags footpoint) && ar rc own.a own.o); report $((! $?)) 'compiles'
    for kind in shared static; do
        [ $kind = shared ] && general=$(pkg-config --libs footpoint) || general=$lib/libfootpoint.a
        expect "a program with a search of its own links, $kind" 0 '' '' \
            $CC "$work/search.o" $general "$work/own.a" -lm -o "$work/search"
        expect 'and keeps it' 0 'success 77' '' env LD_LIBRARY_PATH="$lib" "$work/search"
    done
    expect 'one that asks for ours links' 0 '' '' \
        $CC "$work/search.o" $(pkg-config --libs footpoint_ccx) "$work/own.a" -lm -o "$work/search"
    expect 'and has it' 0 'success 2' '' env LD_LIBRARY_PATH="$lib" "$work/search"
else
    report 1 'skipped: no pkg-config'
fi

# Programs linked with a static library whose batches have threads require OpenMP.
for threads in 0 1; do
    make -n install-runtime OPENMP=$threads PREFIX=/opt/footpoint | grep -o 's|@THREADS@|[^|]*|' | sort -u
done > "$work/log"
expect 'OPENMP=1 is in the files for pkg-config and CMake' 0 's|@THREADS@||
s|@THREADS@|-fopenmp|' '' cat "$work/log"
grep -l '@THREADS@' runtime/package/footpoint.pc.in runtime/package/footpoint-config.cmake.in > "$work/log"
expect 'both' 0 'runtime/package/footpoint.pc.in
runtime/package/footpoint-config.cmake.in' '' cat "$work/log"

# ---- Fortran ----
functions_of "$installed"/include/footpoint.h "$installed"/include/footpoint_face.h "$installed"/include/footpoint_patch.h > "$work/declared"
module=$include/footpoint/footpoint.f90
sed -n 's/^ *function \(footpoint_[a-z0-9_]*\)(.*/\1/p' "$module" | sort > "$work/module"
logged 'the Fortran module has every function' diff "$work/declared" "$work/module"
sed -n 's/^#define \(FOOTPOINT_[A-Z_]*\) (*\(-*[0-9][0-9]*\).*/\1 \2/p' \
    "$include/footpoint.h" > "$work/declared"
sed -n '/Kinds of faces/q; s/.*parameter :: \(FOOTPOINT_[A-Z_]*\) = \(-*[0-9]*\)$/\1 \2/p' "$module" > "$work/module"
logged 'and every status' diff "$work/declared" "$work/module"
if command -v gfortran > /dev/null; then
    cat > "$work/use.f90" <<'F'
program use_footpoint
  use footpoint
  use, intrinsic :: iso_c_binding, only: c_double, c_int, c_size_t
  implicit none
  real(c_double) :: xyz(3, 5), loc(2), gap, pairs(2, 2), gaps(2), m(3), fs(3), fm(3, 4)
  real(c_double) :: points(2, FOOTPOINT_STATIONARY_MOST)
  integer(c_int) :: status, statuses(2), iterations, chosen, count
  xyz = reshape([0d0, 0d0, 0d0, 2d0, 0d0, 0.1d0, 2.2d0, 1.5d0, 0d0, 0d0, 1.2d0, 0.1d0, 0.7d0, 0.9d0, 0.25d0], [3, 5])
  status = footpoint_locate(xyz(:, 1), xyz(:, 2), xyz(:, 3), xyz(:, 4), xyz(:, 5), loc, gap)
  print '(i0, 3f10.6)', status, loc, gap
  print '(i0, 2i2, 6f10.6)', &
    footpoint_locate_pairs(2_c_size_t, xyz, 5_c_size_t, reshape([0, 1, 2, 3, 0, 1, 2, 9], [4, 2]), [4, 4], pairs, &
    gaps, statuses), statuses, pairs(:, 1), gaps(1)
  status = footpoint_newton(xyz(:, 1), xyz(:, 2), xyz(:, 3), xyz(:, 4), xyz(:, 5), 20, 1d-12, loc, gap, iterations)
  print '(i0, 3f10.6)', status, loc, gap
  status = footpoint_select_segment(xyz, 3, 1, reshape([0, 1, 2, 3], [4, 1]), xyz(:, 5), chosen)
  print '(i0, i2)', status, chosen
  status = footpoint_normal(xyz(:, 1), xyz(:, 2), xyz(:, 4), m)
  status = status + footpoint_gap(xyz(:, 1), xyz(:, 2), xyz(:, 3), xyz(:, 4), xyz(:, 5), loc, m, gap)
  status = status + footpoint_force(-gap, 10d0, m, loc, fs, fm)
  status = status + footpoint_stationary(xyz(:, 1), xyz(:, 2), xyz(:, 3), xyz(:, 4), xyz(:, 5), points, count)
  print '(i0, l2)', status, all(abs(fs + sum(fm, 2)) < 1d-15) .and. abs(dot_product(fs, m) - 10 * gap) < 1d-14
end program
F
    if [ -e "$installed/include/footpoint.mod" ]; then
        (cd "$work" && gfortran -std=f2008 $strict use.f90 -o use_f $(pkg-config --cflags --libs footpoint) -lm) \
            > "$work/log" 2>&1
        good=$?
        [ $good = 0 ] || sed 's/^/# /' "$work/log"
        report $((!good)) 'Fortran, with the module installed'
        expect 'which answers' 0 '0 -0.349489  0.395534  0.193207
1 0-5 -0.349489  0.395534  0.193207
0 -0.349489  0.395534  0.193207
0 0
0 T' '' env LD_LIBRARY_PATH="$installed/lib" "$work/use_f"
    fi
else
    report 1 'skipped: no gfortran'
fi

# ---- programs and pages ----
mkdir "$work/elsewhere" && cd "$work/elsewhere" || exit 3
expect 'evolve finds its scenes' 0 '*' '*' \
    "$installed/bin/footpoint-evolve" --scene bricks-quad4 --generations 0 --quiet
cd - > /dev/null || exit 3
expect 'and writes genomes here' 0 '' '' cmp "$work/elsewhere/bricks-quad4.gen" evolve/genomes/bricks-quad4.gen
expect 'of which codegen makes the header' 0 '*' '*' "$installed/bin/footpoint-codegen" --allow-poles \
    "$work/elsewhere/bricks-quad4.gen" -o "$work/elsewhere/footpoint_bricks_quad4.h"
expect 'that is installed' 0 '' '' cmp "$work/elsewhere/footpoint_bricks_quad4.h" \
    "$installed/include/footpoint/footpoint_bricks_quad4.h"
for program in evolve codegen calibrate; do
    documented "$installed/bin/footpoint-$program" "$installed/share/man/man1/footpoint-$program.1"
done
documented "$BIN/footpoint-bench" tests/bench/footpoint-bench.1
functions_of "$installed"/include/footpoint.h "$installed"/include/footpoint_face.h "$installed"/include/footpoint_patch.h | while read -r function; do
    grep -qx "\.F[no] $function" "$installed/share/man/man3/footpoint.3" || echo "$function"
done > "$work/log"
[ ! -s "$work/log" ]; good=$?
[ $good = 0 ] || sed 's/^/# not in footpoint.3: /' "$work/log"
report $((!good)) 'the page of the library has every function'
grep -hv '^ *[/*#]' "$installed"/include/footpoint.h "$installed"/include/footpoint_face.h "$installed"/include/footpoint_patch.h |
    tr -s '\n ' ' ' | tr ';{}' '\n\n\n' | sed -n 's/^.*\(footpoint_[a-z0-9_]*\)(\(.*\)) *$/\1, \2/p' | sort > "$work/declared"
sed -n 's/^\.Fo //p; s/^\.Fa "\(.*\)"$/, \1/p; s/^\.Fc$/;/p' "$installed/share/man/man3/footpoint.3" |
    tr -d '\n' | tr ';' '\n' | sort > "$work/page"
logged 'with its arguments' diff "$work/declared" "$work/page"
if command -v mandoc > /dev/null; then
    expect 'mandoc has no objections' 0 '' '' mandoc -Tlint -Wwarning "$installed"/share/man/man?/footpoint*
else
    report 1 'skipped: no mandoc'
fi

# ---- uninstalled ----
mkdir -p "$work/stage/opt" && mv "$work/moved" "$work/stage/opt/footpoint"
own='include/footpoint/footpoint_mine.h share/footpoint/evolve/scenes/mine.scene lib/cmake/footpoint/mine.cmake'
for file in $own; do : > "$work/stage/opt/footpoint/$file"; done
logged 'make uninstall' make -s uninstall "$generic" PREFIX=/opt/footpoint DESTDIR="$work/stage"
find "$work/stage" ! -type d | sed "s|.*/opt/footpoint/||" | sort > "$work/log"
printf '%s\n' $own | sort | cmp -s - "$work/log"; report $((! $?)) 'leaves what is not ours, and nothing else'
for file in $own; do rm -f "$work/stage/opt/footpoint/$file"; done
logged 'make uninstall, again' make -s uninstall PREFIX=/opt/footpoint DESTDIR="$work/stage"
find "$work/stage" -name '*footpoint*' ! -path "$work/stage/opt/footpoint" > "$work/log"
[ ! -s "$work/log" ]; report $((! $?)) 'closes its folders where nothing is left in them'

# ---- folders with blanks in their names ----
mkdir -p "$work/x/my/own" && : > "$work/x/my/own/file"
ls -A > "$work/tree"
spaced="$work/x/my tools"
logged 'make install-runtime' make -s install-runtime CC="$CC" PREFIX="$spaced" LIBDIR="$spaced/the lib"
ls -A | cmp -s - "$work/tree"; report $((! $?)) 'the source tree is as it was'
if command -v pkg-config > /dev/null; then
    export PKG_CONFIG_PATH="$spaced/the lib/pkgconfig"
    eval "$CC -std=c99 $called '$work/use.c' -o '$work/use' $(pkg-config --cflags --libs footpoint) -lm" > "$work/log" 2>&1
    report $((! $?)) 'pkg-config finds it'
    expect 'it answers' 0 "$answer" '' env LD_LIBRARY_PATH="$spaced/the lib" "$work/use"
fi
logged 'make uninstall there' make -s uninstall PREFIX="$spaced" LIBDIR="$spaced/the lib"
find "$work/x" ! -type d > "$work/log"
expect 'takes away its files, and no other folder' 0 "$work/x/my/own/file" '' cat "$work/log"
