# sfepy 2021.4 with our search in place of its own: the models of its tests that search for contact, and larger ones,
# give the same displacements, contact forces and Newton iterations.  sfepy stops its local search at steps of 1e-3, so
# answers differ by what that leaves: with our equivalent of its iteration, stopped there, they agree to rounding, and so do
# ours with the same iteration converged.  Takes Debian's packages of sfepy and what it needs, from where this machine's
# packages come, into a scratch folder (SFEPY=FOLDER keeps them between runs), and installs nothing.  The search is
# exchanged where Python calls it, its own called in the same way; and, where there is sfepy's source (SFEPY_SOURCE=FOLDER
# or Debian's), in sfepy's extension, which is built with either search and must pass sfepy's tests of contact.  A table
# goes to $BIN/sfepy.csv; MODELS='plane space' runs just these.
. tests/cli/expect.inc
. tests/calculix/sources.inc
here=$PWD
folder=${SFEPY:-$work/sfepy}
skip() { echo "ok 1 - # skip $1"; exit 0; }
for tool in apt-get dpkg; do
    command -v $tool > /dev/null || skip "no $tool"
done
python=/usr/bin/python3 # Debian's, for which its modules are built
[ -x $python ] || skip "no $python"
mkdir -p "$folder" && folder=$(cd "$folder" && pwd) || exit 3
table=$BIN/sfepy.csv
TOLERANCE=1e-3
ROUNDING=1e-9

fetch() { # into $folder/root
    mkdir -p lists/partial cache/archives/partial root
    copy_sources /etc/apt "$PWD"
    apt="apt-get -qq -o Dir::Etc::sourcelist=$PWD/sources.list -o Dir::Etc::sourceparts=$PWD/sources.list.d
        -o Dir::State::lists=$PWD/lists -o Dir::Cache=$PWD/cache -o APT::Sandbox::User=root"
    $apt update && $apt download python3-sfepy python3-numpy python3-scipy python3-meshio python3-rich python3-markdown-it \
        python3-mdurl python3-pyparsing python3-tables python3-tables-lib python3-numexpr python3-sympy python3-mpmath \
        python3-decorator python3-pooch python3-appdirs python3-packaging python3-matplotlib python3-dateutil python3-six \
        python3-kiwisolver python3-contourpy python3-cycler python3-fonttools python3-pil libblas3 liblapack3 \
        libgfortran5 libumfpack5 libamd2 liblbfgsb0 libsuperlu5 libblosc1 cython3 libpython3.11-dev || return 1
    $apt source --download-only sfepy && tar xf sfepy_2021.4.orig.tar.* && mv sfepy-*2021.4 source
    for package in *.deb; do dpkg -x "$package" root || return 1; done
}

[ -z "$SFEPY_SOURCE" ] || SFEPY_SOURCE=$(cd "$SFEPY_SOURCE" && pwd) || exit 3
[ -e "$folder/fetched" ] || (cd "$folder" && fetch && touch fetched) > "$work/fetch" 2>&1 ||
    skip "no packages: $(tail -n 1 "$work/fetch")"
modules=$folder/root/usr/lib/python3/dist-packages libs=$(echo "$folder"/root/usr/lib/*-linux-gnu)
export PYTHONPATH="$modules" PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1 MPLCONFIGDIR="$work"
export LD_LIBRARY_PATH="$libs:$libs/blas:$libs/lapack"
$python -c 'import sfepy.discrete' > "$work/import" 2>&1 || skip "sfepy does not run: $(tail -n 1 "$work/import")"
own=$(echo "$modules"/sfepy/mechanics/extmods/ccontres.*.so)

# ---- searches -------------------------------------------------------------------------------------------------------

library() { # library NAME SOURCES AND OPTIONS
    name=$1
    shift
    ${CC:-gcc} -std=c11 -O2 -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -Igenerated \
        -fPIC -shared "$@" -o "$work/$name.so" -lm
}
counted='tests/sfepy/local_search.c runtime/geometry/quad4.c'
library ours runtime/replace/sfepy.c && library once -DREPEAT=1 $counted && library often -DREPEAT=21 $counted &&
    library iterated_once -DREPEAT=1 -DTOLERANCE=1e-3 $counted &&
    library iterated_often -DREPEAT=21 -DTOLERANCE=1e-3 $counted &&
    library converged -DREPEAT=1 -DTOLERANCE=1e-12 $counted
report $((! $?)) 'the searches compile'

expect "sfepy's derivatives: those by r of nodes 7 and 8 of sfd8 are wrong, no others" 0 'sfd2: []
sfd4: [] []
sfd6: [] []
sfd8: [7, 8] []' '' $python tests/sfepy/shape.py "$own"

# ---- models ---------------------------------------------------------------------------------------------------------

# sfepy's example, in the plane, in space, and in space with larger meshes.  These do not match and are shifted, the upper
# body is smaller: Gauss points on a face's diagonal or edge are in contact or not as rounding has it, in sfepy and here.
example=$modules/sfepy/examples/linear_elasticity/two_bodies_contact.py
space() { sed 's/^dim = 2/dim = 3/' "$example"; }
sized() {
    space | sed -e "s/shape0 = \[2, 2, 2\]/shape0 = [$1]/; s/shape1 = \[2, 2, 2\]/shape1 = [$2]/" \
        -e 's/dims1 = \[1.0, 1.0, 0.5\]/dims1 = [0.8, 0.8, 0.5]/; s/shift1 = \[0.0, 0.0, -0.1\]/shift1 = [0.013, 0.007, -0.1]/'
}
mkdir "$work/models"
cp "$example" "$work/models/plane.py"
space > "$work/models/space.py"
sized '7, 7, 3' '6, 6, 3' > "$work/models/larger.py"
sized '10, 10, 4' '9, 9, 4' > "$work/models/largest.py"
solve() { # solve MODEL SEARCH LIBRARY...: its lines in $work/MODEL-SEARCH
    file=$1-$2
    model=$1
    shift 2
    (cd "$work" && $python "$here/tests/sfepy/contact.py" "models/$model.py" "$file.npz" "$@") > "$work/$file" 2> "$work/log"
    good=$?
    [ $good = 0 ] || tail -n 5 "$work/log" | sed 's/^/# /'
    return $good
}
within() { # within LIMIT ONE OTHER: results agree, in contact and to a limit
    $python tests/sfepy/differ.py "$work/$2.npz" "$work/$3.npz" > "$work/differences" &&
        awk -v limit="$1" '!($2 <= limit) { bad = 1 } END { exit bad || NR != 3 }' "$work/differences"
}

echo 'model,iterations,own_s,ours_s,own_search_s,ours_search_s,searches,own_ns,ours_ns,displacement,force,gap' > "$table"
for model in ${MODELS:-plane space larger largest}; do
    solve $model own "$own" "$own" "$work/iterated_once.so" "$work/iterated_often.so" &&
        solve $model ours "$work/ours.so" "$work/ours.so" "$work/once.so" "$work/often.so"
    report $((! $?)) "$model: both solve"
    [ "$(awk '{ print $1, $2; exit }' "$work/$model-own")" = "$(awk '{ print $1, $2; exit }' "$work/$model-ours")" ]
    report $((! $?)) 'Newton takes as many iterations'
    within $TOLERANCE $model-own $model-ours
    report $((! $?)) "displacements, contact forces and gaps agree to $TOLERANCE of the largest"
    awk -v model=$model '
        FNR == 1 { file++ }
        file == 1 { value[$1] = $2; next }
        FNR == 1 { iterations[file] = $1; calls[file] = $2; search[file] = $3; total[file] = $4 }
        FNR == 3 { once[file] = $2; count[file] = $3 }
        FNR == 4 { often[file] = $2 }
        function ns(f) { return count[f] ? sprintf("%.0f", (often[f] - once[f]) / 20 / count[f] * 1e9) : "-" }
        END {
            printf "%s,%d,%.2f,%.2f,%.5f,%.5f,%d,%s,%s,%s,%s,%s\n", model, iterations[2], total[2], total[3], search[2],
                search[3], count[3], ns(2), ns(3), value["displacement"], value["force"], value["gap"]
        }' "$work/differences" "$work/$model-own" "$work/$model-ours" >> "$table"
done
model=space
[ -e "$work/$model-ours.npz" ] || { solve $model own "$own" && solve $model ours "$work/ours.so"; }
solve $model iterated "$work/iterated_once.so" && within $ROUNDING $model-own $model-iterated
report $((! $?)) "our equivalent of sfepy's iteration, stopped where it stops: the same to $ROUNDING"
solve $model converged "$work/converged.so" && within $ROUNDING $model-ours $model-converged
report $((! $?)) "and converged: as ours, to $ROUNDING"

# ---- sfepy's extension, built anew ----------------------------------------------------------------------------------

source=${SFEPY_SOURCE:-$folder/source}
build() { # build NAME SEARCH...: sfepy in $work/NAME, whose extension has the search of that file, or its own
    name=$1 extension=$work/$1/sfepy/mechanics/extmods
    shift
    mkdir "$work/$name" && cp -r "$modules/sfepy" "$work/$name" && rm "$extension"/ccontres.*.so || return 1
    includes="-I$source/sfepy/mechanics/extmods -I$common -I$work/sfepy_h -I$modules/numpy/core/include
        -I$folder/root/usr/include -I$folder/root/usr/include/python3.11 -DSFEPY_PLATFORM=0"
    ${CC:-gcc} -O2 -w -fPIC $includes ${1:+-DevaluateContactConstraints=evaluate_replaced} -c \
        "$source/sfepy/mechanics/extmods/contres.c" -o "$work/$name.o" &&
        ${CC:-gcc} -O2 -w -ffp-contract=off -fPIC -shared $includes -Igenerated "$work/ccontres.c" \
            "$common/common_python.c" "$work/$name.o" "$@" -o "$extension/$(basename "$own")" -lm
}
passes() { # passes NAME: sfepy's tests of contact, with that extension
    (cd "$work" && PYTHONPATH=$work/$1:$modules $python -m sfepy.script.run_tests -o "$work/$1.tests" \
        "$work/$1"/sfepy/tests/test_input_*contact*.py) > "$work/log" 2>&1 &&
        grep -q '^3 test file(s) executed.* 0 failure(s) of 3 test(s)' "$work/log" || { sed 's/^/# /' "$work/log" | tail -n 5; false; }
}
native() { # native NAME MODEL: solved by sfepy with that extension, which nothing exchanges
    (cd "$work" && PYTHONPATH=$work/$1:$modules $python "$here/tests/sfepy/contact.py" "models/$2.py" "$2-$1.npz" -) \
        > "$work/$2-$1"
}
if [ -e "$source/sfepy/mechanics/extmods/ccontres.pyx" ]; then
    common=$source/sfepy/discrete/common/extmods
    mkdir "$work/sfepy_h" && cp "$common/version.h.in" "$work/sfepy_h/version.h"
    (cd "$source" && $python -m cython -2 -w . sfepy/mechanics/extmods/ccontres.pyx -o "$work/ccontres.c") > "$work/log" 2>&1 &&
        build rebuilt && build replaced runtime/replace/sfepy.c
    report $((! $?)) "sfepy's extension is built with its own search and with ours"
    for name in rebuilt replaced; do
        passes $name
        report $((! $?)) "$name: sfepy's tests of contact pass"
    done
    native rebuilt $model && within $ROUNDING $model-own $model-rebuilt
    report $((! $?)) "built with its own search: as Debian's, to $ROUNDING"
    native replaced $model && within $ROUNDING $model-ours $model-replaced
    report $((! $?)) "built with ours: as where it is exchanged, to $ROUNDING"
else
    echo "# SKIP sfepy's extension is not built: no source of sfepy 2021.4 (SFEPY_SOURCE=)"
fi
sed 's/^/# /' "$table"
