# Compares CalculiX 2.20 with our search and with its own: displacements and contact stresses must agree, on our models
# and on the contact models of its tests; a warning if a call is not 20 times faster. Fetches sources and libraries of
# Debian 12 from this machine's package source into a scratch folder (CALCULIX=FOLDER keeps them and the build between
# runs) and installs nothing. A table goes to $BIN/calculix.csv. MODELS='punch impact' runs only these, MODELS=all also the
# eight models that take longest, as long as all others.
. tests/cli/expect.inc
. tests/calculix/sources.inc
here=$PWD
folder=${CALCULIX:-$work/calculix}
skip() { echo "ok 1 - # skip $1"; exit 0; }
for tool in gfortran apt-get dpkg objcopy zcat; do
    command -v $tool > /dev/null || skip "no $tool"
done
mkdir -p "$folder" && folder=$(cd "$folder" && pwd) || exit 3
table=$BIN/calculix.csv
TOLERANCE=1e-4 # the solver itself stops at 5e-3 of the mean force
LEAST_RATIO=20

fetch() { # the source package, the examples, and libraries to link with, into $folder/root
    mkdir -p lists/partial cache/archives/partial root
    copy_sources /etc/apt "$PWD"
    apt="apt-get -qq -o Dir::Etc::sourcelist=$PWD/sources.list -o Dir::Etc::sourceparts=$PWD/sources.list.d
        -o Dir::State::lists=$PWD/lists -o Dir::Cache=$PWD/cache -o APT::Sandbox::User=root"
    $apt update && $apt source --download-only calculix-ccx=2.20-1 &&
        $apt download calculix-ccx-test libspooles2.2 libspooles-dev libarpack2 libarpack2-dev \
            libblas3 libblas-dev liblapack3 liblapack-dev &&
        tar xf calculix-ccx_2.20.orig.tar.bz2 || return 1
    for package in *.deb; do dpkg -x "$package" root || return 1; done
}

build() { # CalculiX as it is, less its link
    cd CalculiX/ccx_2.20/src || return 1
    sed -e '/^ccx_2.20: /s/\$(LIBS)//' -e 's|\./date.pl; ||' Makefile > Makefile.scratch
    MAKEFLAGS= make -j2 -s -f Makefile.scratch ccx_2.20 CC=gcc FFLAGS='-O2 -w -fopenmp -fallow-argument-mismatch' \
        CFLAGS="-O2 -w -I$folder/root/usr/include/spooles -DARCH=\"Linux\" -DSPOOLES -DARPACK -DMATRIXSTORAGE" \
        LIBS="$libraries"
}

[ -e "$folder/fetched" ] || (cd "$folder" && fetch && touch fetched) > "$work/fetch" 2>&1 ||
    skip "no sources: $(tail -n 1 "$work/fetch")"
libs=$(echo "$folder"/root/usr/lib/*-linux-gnu)
libraries=$(printf -- '-L%s -Wl,-rpath,%s ' "$libs" "$libs" "$libs/lapack" "$libs/lapack" "$libs/blas" "$libs/blas")
libraries="$libraries -lspooles -larpack -llapack -lblas -lpthread -lm"
[ -e "$folder/built" ] || (cd "$folder" && build && touch "$folder/built") > "$work/build" 2>&1 || {
    sed 's/^/# /' "$work/build" | tail -n 20
    report 0 'CalculiX builds'
    exit 1
}

# Both with a wrapper about the search; ours comes out of its library before CalculiX's archive has its turn.
source=$folder/CalculiX/ccx_2.20/src
ours="$BIN/libfootpoint_ccx.a $BIN/libfootpoint.a"
link() { gfortran -O2 -fopenmp "$source/ccx_2.20.o" "$@" "$source/ccx_2.20.a" $libraries; }
recorded() { link -Wl,--wrap=attach_2d_ "$work/record.o" "$@"; }
${CC:-gcc} -O2 -D_DEFAULT_SOURCE -c tests/calculix/record.c -o "$work/record.o" &&
    recorded -o "$work/original" && recorded -Wl,-u,attach_2d_ $ours -o "$work/ours" &&
    link -Wl,-u,attach_2d_ $ours -o "$work/plain" &&
    nm "$work/plain" | grep -q footpoint_attach_quad4 &&
    objcopy --redefine-sym attach_2d_=original_attach_2d_ "$source/attach_2d.o" "$work/original_attach_2d.o" &&
    ${CC:-gcc} -O2 -D_DEFAULT_SOURCE tests/calculix/replay.c "$work/original_attach_2d.o" "$source/distattach_2d.o" \
        $ours -lgfortran -lm -o "$work/replay"
report $((! $?)) 'CalculiX links with either search'

# ---- models ---------------------------------------------------------------------------------------------------------

mkdir "$work/models" "$work/records"
for model in punch punch-tri3 punch-tri6 punch-quad8 blocks sliding impact; do
    awk -v model=$model -f tests/calculix/models.awk > "$work/models/$model.inp"
done
for file in "$folder"/root/usr/share/doc/calculix-ccx-test/examples/test/*.inp*; do
    zcat -f "$file" > "$work/model"
    ! grep -qi '^\*contact pair' "$work/model" || mv "$work/model" "$work/models/$(basename "${file%.gz}")"
done

run() { # run WHICH MODEL: "calls search_s total_s" on stdout; false if it did not end well
    mkdir -p "$work/$1-runs"
    cp "$work/models/$2.inp" "$work/$1-runs"
    (
        cd "$work/$1-runs" || exit 3
        [ "$1" = ours ] || export SEARCH_RECORDS="$work/records/$2"
        export OMP_NUM_THREADS=1 SEARCH_TIMES=$2.times
        timeout 300 "$work/$1" "$2" > "$2.out" 2>&1 && grep -q 'Job finished' "$2.out" || exit 1
        [ -e "$2.times" ] || echo 0 0 > "$2.times"
        echo "$(cat "$2.times") $(awk '/Total CalculiX Time/ { print $4 }' "$2.out")"
    )
}

echo 'model,calls,original_search_s,ours_search_s,original_s,ours_s,displacement,gap,pressure,stress' > "$table"
models=0 failed= apart= longest='hueeber[1-4]|thread|ringfcontact1|cubef2f2|metalformingmortar'
[ "$MODELS" != all ] || MODELS= longest=none
for model in ${MODELS:-$(cd "$work/models" && ls ./*.inp | grep -vE "/($longest)\.inp")}; do
    model=$(basename "$model" .inp)
    first=$(run original "$model") && second=$(run ours "$model") || { failed="$failed $model"; continue; }
    for kind in dat frd; do
        awk -f "$here/tests/calculix/compare.awk" "$work/original-runs/$model.$kind" "$work/ours-runs/$model.$kind"
    done > "$work/differences"
    line=$(awk -v first="$first" -v second="$second" -v model="$model" -v tolerance=$TOLERANCE '
        { values[$1] += $2; alone += $3; if ($4 > most[$1]) most[$1] = $4 }
        function share(name) { return values[name] ? sprintf("%.1e", most[name]) : "-" }
        END {
            split(first, a, " "); split(second, b, " ")
            printf "%s,%d,%.4f,%.4f,%.2f,%.2f,%s,%s,%s,%s", model, a[1], a[2], b[2], a[3], b[3],
                share("displacement"), share("gap"), share("pressure"), share("stress")
            for (name in most) if (most[name] > tolerance) alone++
            exit alone > 0
        }' "$work/differences") || apart="$apart $model"
    echo "$line" >> "$table"
    models=$((models + 1))
done
sed 's/^/# /' "$table"
echo "# did not end:$failed"
echo "# differ:$apart"
[ -z "$failed" ] && [ $models -gt 0 ]
report $((! $?)) "$models models run through both"
[ -z "$apart" ]
report $((! $?)) "displacements and contact stresses agree to $TOLERANCE of the largest"
awk -F, 'NR > 1 { a += $3; b += $4; c += $5; d += $6 } END {
    printf "# search %.2f s against %.2f s, in all %.1f s against %.1f s\n", a, b, c, d }' "$table"

# ---- calls ----------------------------------------------------------------------------------------------------------

"$work/replay" "$work/records"/* > "$work/replayed"
sed 's/^/# /' "$work/replayed"
awk -F, 'NR > 1 { printf "# %d nodes: %.3g, %.3g million calls a second\n", $1, 1e3 / $3, 1e3 / $4 }' "$work/replayed"
faster() { # in the replay before, else in another one
    awk -F, -v least=$LEAST_RATIO 'NR > 1 && $5 < least { bad = 1 } END { exit bad }' "$work/again" ||
        { "$work/replay" "$work/records"/* > "$work/again"; false; }
}
cp "$work/replayed" "$work/again"
steady "at least $LEAST_RATIO times faster per call on every kind of face" faster
awk -F, 'NR > 1 { n++; bad = bad || $6 > 1e-8 } END { exit bad || n < 1 }' "$work/replayed"
report $((! $?)) 'never farther away than the original by more than 1e-8 of an edge'
