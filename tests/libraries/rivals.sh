#!/bin/sh
# rivals.sh FOLDER: compares searches of other libraries with ours on the same faces and slave nodes. Prints a table,
# and writes FOLDER/index.html with pictures and FOLDER/rivals.csv. Missing libraries are named as absent. CASES=: cases
# for each family and kind of face.
#
# Adapters and headers are compiled alike for this machine; what a library has compiled is as its package compiled it,
# and so is ours in libfootpoint.
folder=$1 BIN=${BIN:-build} CC=${CC:-gcc} CXX=${CXX:-g++} CASES=${CASES:-200}
say() { echo "rivals: $*" >&2; }
rm -rf "$folder" && mkdir -p "$folder/objects" || exit 3

judge='-std=c11 -D_DEFAULT_SOURCE -O2 -ffp-contract=off'
for source in tests/libraries/face.c tests/libraries/cases.c tests/libraries/library_judge.c tests/libraries/libraries_main.c \
    tests/hard/truth.c tests/hard/subdivision.c tests/hard/draw.c tests/hard/hard.c tests/hard/wild.c; do
    # shellcheck disable=SC2086
    $CC $judge -c $source -o "$folder/objects/$(basename $source .c).o" || exit 3
done
$CC "$folder"/objects/*.o -o "$folder/libraries_main" -ldl -lm || exit 3

flags='-O3 -march=native -DNDEBUG -fPIC -shared -fvisibility=hidden -Wl,--no-undefined'
objects=
# library NAME HEADER LANGUAGE FLAGS...: built where HEADER is found; FLAGS are for the compiler and the linker
library() {
    name=$1 header=$2 language=$3
    shift 3
    case $language in
    c) compile="$CC -std=c11 -D_DEFAULT_SOURCE" source=tests/libraries/library_$name.c ;;
    *) compile="$CXX -std=c++17" source=tests/libraries/library_$name.cpp ;;
    esac
    if ! echo "#include <$header>" | $compile -E "$@" -x "$language" - > /dev/null 2>&1; then
        echo "$name" >> "$folder/absent"
        say "$name is absent"
    elif $compile $flags -w $source -o "$folder/$name.so" "$@" 2> "$folder/log"; then
        objects="$objects $folder/$name.so"
    else
        cat "$folder/log" >&2
        exit 3
    fi
}
package() { pkg-config "$@" 2> /dev/null; }
# Where headers do not tell it, that of the package.
version() { echo "-DLIBRARY_VERSION=\"$(dpkg-query -W -f '${Version}' "$1" 2> /dev/null | sed 's/[+-].*//')\""; }
trilinos='-isystem /usr/include/trilinos -DOMPI_SKIP_MPICXX'

: > "$folder/absent"
# shellcheck disable=SC2046,SC2086
{
    library footpoint math.h c \
        "-DLIBRARY_VERSION=\"$(sed -n 's/^.define FOOTPOINT_VERSION "\(.*\)"/\1/p' codegen/base/base.h)\"" "$BIN/libfootpoint_ccx.a" "$BIN/libfootpoint.a" -lm
    library dune dune/geometry/multilineargeometry.hh c++ "$(version libdune-geometry-dev)" $(package --cflags --libs dune-geometry)
    library vtk vtkQuad.h c++ $(find /usr/include -maxdepth 1 -name 'vtk-*' | sed 's/^/-isystem /') \
        $(find /usr/lib -name 'libvtkCommon[DC]*-[0-9.]*.so' | sed -n 's/.*lib\(vtkCommon\(DataModel\|Core\)-.*\)\.so$/-l\1/p')
    library getfem getfem/bgeot_geotrans_inv.h c++ -lgetfem
    library gmsh gmsh.h c++ "$(version libgmsh-dev)" -lgmsh
    library intrepid2 Intrepid2_CellTools.hpp c++ $trilinos $(package --cflags ompi-cxx) -ltrilinos_intrepid2 \
        -ltrilinos_shards -ltrilinos_kokkoscore -ltrilinos_teuchoscore
    library sisl sisl.h c "$(version libsisl-dev)" -Wl,-Bsymbolic -lsisl -lm
    library opencascade BRepExtrema_DistShapeShape.hxx c++ -isystem /usr/include/opencascade -lTKGeomAlgo -lTKTopAlgo \
        -lTKBRep -lTKGeomBase -lTKG3d -lTKMath -lTKernel
    library cgal CGAL/AABB_tree.h c++
    library embree embree3/rtcore.h c -lembree3 -lm
    library sacado Sacado_No_Kokkos.hpp c++ $trilinos $(package --cflags ompi-cxx) -ltrilinos_sacado \
        -ltrilinos_teuchoscomm -ltrilinos_teuchosparameterlist -ltrilinos_teuchoscore
    library adolc adolc/adolc.h c++ "$(version libadolc-dev)" -ladolc
}
say "$CASES cases of each family and kind of face, some minutes"
export OMP_NUM_THREADS=1
# shellcheck disable=SC2086
"$folder/libraries_main" "$CASES" $objects > "$folder/rivals.csv" || exit 3
machine="$($CC --version | head -n 1), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
awk -f tests/libraries/libraries_table.awk -v absent="$(tr '\n' ' ' < "$folder/absent")" -v machine="$machine" \
    "$folder/rivals.csv" > "$folder/rivals.txt" || exit 3
cat "$folder/rivals.txt"

picture() { # picture FAMILY KIND: time against error
    awk -F, -v f="$1" -v k="$2" -v machine="$machine" 'BEGIN {
            print "scene,sample,method,ours,mode,ns,median_xi,median_eta,noise,compiler,isa"
        }
        $1 == "family" && $2 == f && $3 == k && $14 != "nan" && $7 != "inf" {
            name = $4 == "footpoint" ? "footpoint_" $5 : $4 " " $5
            print f " " k ",random," name "," ($4 == "footpoint") ",scalar," $7 "," $14 "," $14 ",0," machine ","
        }' "$folder/rivals.csv" |
        awk -f tests/report/picture.awk -v scene="$1 $2" -v sample=random -v mode=scalar -v norm=median \
            -v out="$folder/$1-$2" -v error='median error, in longest edges' -v others='other libraries' | gnuplot || exit 3
    echo "<a href=\"$1-$2.svg\"><img src=\"$1-$2.svg\" alt=\"$1 $2: time against error\"></a>"
}
map() { # map KIND
    awk -f tests/libraries/libraries_map.awk -v kind="$1" "$folder/rivals.csv" > "$folder/map-$1.svg" || exit 3
    echo "<a href=\"map-$1.svg\"><img src=\"map-$1.svg\" alt=\"$1: wrong answers by family\"></a>"
}
{
    cat << END
<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>footpoint: beside other libraries</title>
<style>
body { font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 1400px; padding: 0 1em; color: #222 }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(560px, 100%), 1fr)); gap: 8px }
img { max-width: 100% } pre { font-size: 12px; overflow-x: auto }
</style>
<h1>Beside other libraries</h1>
<div class=pictures>
END
    map quad4
    picture ordinary quad4
    for kind in tri6 quad8 quad9; do
        map $kind
        picture ordinary $kind
    done
    echo '</div><pre>'
    sed 's/&/\&amp;/g; s/</\&lt;/g' "$folder/rivals.txt"
    echo '</pre><p><a href="rivals.csv">rivals.csv</a></p>'
} > "$folder/index.html" || exit 3
rm -r "$folder/objects" "$folder/log"
echo "$folder/index.html"
