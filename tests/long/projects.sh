# Builds outside projects against an installed copy that was staged and moved, also to a name with a blank: CMake in C,
# C++17 and Fortran, pkg-config in C++, a header alone, the Fortran module from source.
. tests/cli/expect.inc
CC=${CC:-gcc} CXX=${CXX:-g++}
logged() { # logged NAME COMMAND...: as `report`, with what the command says where it fails
    name=$1
    shift
    "$@" > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) "$name"
}
logged 'make install' make -s install CC="$CC" PREFIX=/usr/local DESTDIR="$work/stage"
mv "$work/stage/usr/local" "$work/local"
logged 'make install in folders of other names' make -s install CC="$CC" PREFIX=/usr \
    LIBDIR=/usr/lib/some-where INCLUDEDIR=/usr/include/own DESTDIR="$work/stage"
mv "$work/stage/usr" "$work/moved folder"
installed="$work/moved folder" lib="$work/moved folder/lib/some-where"
export LD_LIBRARY_PATH="$lib"
mkdir "$work/project"

cat > "$work/project/use.c" <<'C'
#include "footpoint.h"
#include "footpoint/footpoint_quad4.h"
#include "footpoint/footpoint-quad4-geometry.h"
#include <stdio.h>

int main(void)
{
    const double xyz[5][3] = {{0, 0, 0}, {2, 0, 0.1}, {2.2, 1.5, 0}, {0, 1.2, 0.1}, {0.7, 0.9, 0.25}};
    const int seg[4] = {0, 1, 2, 3}, slave = 4;
    double loc[2], gap, r[3];
    if (footpoint_locate_pairs(1, xyz[0], 5, seg, &slave, loc, &gap, NULL) != 0)
        return 1;
    footpoint_quad4_position(xyz[0], xyz[1], xyz[2], xyz[3], loc[0], loc[1], r);
    printf("%.6f %.6f %.6f %.6f\n", loc[0], loc[1], gap, r[2]);
    return 0;
}
C
answer='-0.349489 0.395534 0.193207 0.056912'
cat > "$work/project/use.cpp" <<'C'
#include <array>
#include <footpoint.h>
#include <footpoint/footpoint_quad4.h>
#include <iostream>
#include <stdexcept>

struct Foot {
    double xi, eta, gap;
};

template <typename Search> Foot find(const std::array<std::array<double, 3>, 5> &x, Search search)
{
    double loc[2], gap;
    if (const int status = search(x[0].data(), x[1].data(), x[2].data(), x[3].data(), x[4].data(), loc, &gap);
        status != FOOTPOINT_OK)
        throw std::runtime_error(footpoint_strerror(status));
    return {loc[0], loc[1], gap};
}

int main()
{
    std::array<std::array<double, 3>, 5> x = {{{0, 0, 0}, {2, 0, 0.1}, {2.2, 1.5, 0}, {0, 1.2, 0.1}, {0.7, 0.9, 0.25}}};
    const auto [xi, eta, gap] = find(x, footpoint_locate);
    const Foot own = find(x, footpoint_quad4_accurate);
    std::cout << xi << ' ' << eta << ' ' << gap << ' ' << (own.xi == xi && own.eta == eta) << '\n';
    x[1] = x[2] = x[3] = x[0];
    try {
        find(x, footpoint_locate);
    } catch (const std::runtime_error &e) {
        std::cout << e.what() << '\n';
    }
}
C
answer_cpp='-0.349489 0.395534 0.193207 1
the segment is degenerate'
cat > "$work/project/use.f90" <<'F'
program use_footpoint
  use footpoint
  implicit none
  double precision :: x(3, 5), loc(2), gap
  x = reshape([0d0, 0d0, 0d0, 2d0, 0d0, 0.1d0, 2.2d0, 1.5d0, 0d0, 0d0, 1.2d0, 0.1d0, 0.7d0, 0.9d0, 0.25d0], [3, 5])
  if (footpoint_locate(x(:, 1), x(:, 2), x(:, 3), x(:, 4), x(:, 5), loc, gap) /= FOOTPOINT_OK) stop 1
  print '(f9.6, 2f9.6)', loc, gap
end program
F
answer_f='-0.349489 0.395534 0.193207'
cat > "$work/project/ccx.c" <<'C'
#include <stdio.h>
void attach_2d_(const double (*pneigh)[3], double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                double *etl);
int main(void)
{
    const double x[9][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    double at[3] = {0.25, 0.5, 2}, ratio[9], dist, xi, eta;
    const int nodes = 3;
    attach_2d_(x, at, &nodes, ratio, &dist, &xi, &eta);
    printf("%g %g %g\n", xi, eta, dist);
    return 0;
}
C
answer_ccx='0.25 0.5 2'

# ---- CMake ----
version=$(sed -n 's/^.define FOOTPOINT_VERSION "\([0-9]*\.[0-9]*\).*/\1/p' codegen/base/base.h)
later=${version%.*}.$((${version#*.} + 1))
if command -v cmake > /dev/null; then
    fortran=
    command -v gfortran > /dev/null && fortran=Fortran
    cat > "$work/project/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.13)
project(use C CXX $fortran)
find_package(footpoint $version REQUIRED)
set(CMAKE_CXX_STANDARD 17)
add_executable(use_shared use.c)
target_link_libraries(use_shared PRIVATE footpoint::footpoint)
add_executable(use_static use.c)
target_link_libraries(use_static PRIVATE footpoint::static)
add_executable(use_cpp use.cpp)
target_link_libraries(use_cpp PRIVATE footpoint::footpoint)
add_executable(use_ccx ccx.c)
target_link_libraries(use_ccx PRIVATE footpoint::ccx)
if(CMAKE_Fortran_COMPILER)
  add_executable(use_fortran use.f90)
  target_link_libraries(use_fortran PRIVATE footpoint::footpoint)
endif()
# What a later or another version would need is not found.
find_package(footpoint $later QUIET)
if(footpoint_FOUND)
  message(FATAL_ERROR "$version passes for $later")
endif()
CMAKE
    logged 'CMake finds it' env CC="$CC" CXX="$CXX" \
        cmake -S "$work/project" -B "$work/built" -DCMAKE_PREFIX_PATH="$work/local"
    logged 'and builds' cmake --build "$work/built"
    logged 'CMake finds it in other folders' \
        cmake -S "$work/project" -B "$work/built_own" -Dfootpoint_DIR="$lib/cmake/footpoint"
    logged 'and builds there' cmake --build "$work/built_own"
    expect 'C, shared, there' 0 "$answer" '' "$work/built_own/use_shared"
    expect 'C, shared' 0 "$answer" '' "$work/built/use_shared"
    expect 'C, static' 0 "$answer" '' env -u LD_LIBRARY_PATH "$work/built/use_static"
    expect 'C++17' 0 "$answer_cpp" '' "$work/built/use_cpp"
    expect 'the search for CalculiX' 0 "$answer_ccx" '' env -u LD_LIBRARY_PATH "$work/built/use_ccx"
    [ -z "$fortran" ] || expect 'Fortran' 0 "$answer_f" '' "$work/built/use_fortran"

    # ---- the sources taken in, without a language but C: a folder, or the archive of `make dist` ----
    version=$(sed -n 's/^.define FOOTPOINT_VERSION "\(.*\)"/\1/p' codegen/base/base.h)
    mkdir "$work/inside" "$work/footpoint-$version"
    cp -r runtime generated "$work/footpoint-$version"
    tar -C "$work" -czf "$work/inside/footpoint.tar.gz" "footpoint-$version"
    if git rev-parse -q --verify HEAD > /dev/null 2>&1; then
        git clone -q . "$work/clone"
        logged 'make dist' make -s -C "$work/clone" dist
        mv "$work/clone/build/footpoint-$version.tar.gz" "$work/inside/footpoint.tar.gz"
    fi
    mv "$work/footpoint-$version" "$work/inside/footpoint"
    cp "$work/project/use.c" "$work/project/ccx.c" "$work/inside"
    cat > "$work/inside/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.14)
project(inside C)
include(FetchContent)
if(FETCH)
  FetchContent_Declare(footpoint URL "${CMAKE_CURRENT_SOURCE_DIR}/footpoint.tar.gz" SOURCE_SUBDIR runtime)
  FetchContent_MakeAvailable(footpoint)
else()
  add_subdirectory(footpoint/runtime)
endif()
add_executable(use use.c)
target_link_libraries(use PRIVATE footpoint::footpoint)
add_executable(use_ccx ccx.c)
target_link_libraries(use_ccx PRIVATE footpoint::ccx)
add_library(alone OBJECT alone.c)
target_link_libraries(alone PRIVATE footpoint::headers)
CMAKE
    echo '#include "footpoint_quad4.h"' > "$work/inside/alone.c"
    # Optimised once: that takes minutes.
    for options in -DCMAKE_BUILD_TYPE=Debug '-DCMAKE_BUILD_TYPE=Debug -DBUILD_SHARED_LIBS=ON' -DFETCH=ON; do
        rm -rf "$work/inside/built"
        logged "add_subdirectory $options" env CC="$CC" cmake -S "$work/inside" -B "$work/inside/built" $options
        logged 'builds' cmake --build "$work/inside/built" -j2
        expect 'and answers' 0 "$answer" '' env -u LD_LIBRARY_PATH "$work/inside/built/use"
        expect 'and so does the search for CalculiX' 0 "$answer_ccx" '' \
            env -u LD_LIBRARY_PATH "$work/inside/built/use_ccx"
        ! nm "$work/inside/built/use" | grep -q attach_2d_; report $((! $?)) 'which nobody else gets'
    done
else
    report 1 'skipped: no cmake'
fi

# ---- pkg-config and folders with a blank in their names ----
export PKG_CONFIG_PATH="$lib/pkgconfig"
for compiler in "$CXX -std=c++17" 'clang++ -std=c++17' "$CXX -std=c++11 -DOLD"; do
    command -v "${compiler%% *}" > /dev/null || continue
    case $compiler in *OLD) source=use.c language='-x c++' ;; *) source=use.cpp language= ;; esac
    eval "$compiler -Wall -Wextra -Wpedantic -Werror -I. $language '$work/project/$source' -x none -o '$work/use'" \
        "$(pkg-config --cflags --libs footpoint) -lm" > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) "$compiler"
    case $compiler in
    *OLD) expect 'which answers' 0 "$answer" '' "$work/use" ;;
    *) expect 'which answers' 0 "$answer_cpp" '' "$work/use" ;;
    esac
done

# ---- a header alone ----
mkdir "$work/alone"
cp generated/footpoint_quad4.h "$work/alone/"
cat > "$work/alone/use.c" <<'C'
#include "footpoint_quad4.h"
#include <stdio.h>

int main(void)
{
    const double a[3] = {0, 0, 0}, b[3] = {2, 0, 0.1}, c[3] = {2.2, 1.5, 0}, d[3] = {0, 1.2, 0.1};
    const double s[3] = {0.7, 0.9, 0.25};
    double loc[2], gap;
    if (footpoint_quad4_accurate(a, b, c, d, s, loc, &gap) != FOOTPOINT_OK)
        return 1;
    printf("%.6f %.6f %.6f\n", loc[0], loc[1], gap);
    return 0;
}
C
logged 'a header copied, nothing else' \
    $CC -std=c99 -Wall -Wextra -Wpedantic -Werror "$work/alone/use.c" -o "$work/alone/use" -lm
expect 'which answers' 0 "${answer% *}" '' "$work/alone/use"

# ---- Fortran from the module's source, which needs no interface file of another compiler ----
if command -v gfortran > /dev/null; then
    cp "$installed/include/own/footpoint/footpoint.f90" "$work/project/use.f90" "$work/alone/"
    (cd "$work/alone" && gfortran -std=f2003 footpoint.f90 use.f90 -o use_f "$lib/libfootpoint.a" -lm) \
        > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((!good)) 'Fortran 2003, from source'
    expect 'which answers' 0 "$answer_f" '' "$work/alone/use_f"
else
    report 1 'skipped: no gfortran'
fi
