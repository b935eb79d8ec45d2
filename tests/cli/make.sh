# Checks `make`: values that it refuses, targets that it builds, files that it installs from a tree with users' files, and the
# library with only a C compiler.
. tests/cli/expect.inc
CC=${CC:-gcc}
unset MAKEFLAGS MAKELEVEL MFLAGS

# ---- values ----
refused() { # refused TARGET VALUE WORDS: in one line, before anything is done
    expect "$2" 2 '' '*' make -n "$1" "$2"
    grep -q "$3.*  Stop.\$" "$work/stderr" && [ "$(wc -l < "$work/stderr")" = 1 ]
    report $((! $?)) "which says: $3"
}
refused runtime CONFIG=fast 'CONFIG=fast: not a configuration; there are release debug asan fma\.'
refused regenerate RANKS=0 'RANKS=0: not a number of ranks'
refused regenerate RANKS=two 'not a number of ranks'
refused regenerate GENERATIONS=1e3 'not a number of generations'
refused regenerate 'SEED=1 2' 'not a whole number'
refused regenerate FROM=nothing 'FROM=nothing: scratch or nothing'
refused check JOBS=0 'not a number of jobs'
refused bench ISAS=z80 'ISAS=z80: not instruction sets of the bench; there are '
refused runtime OPENMP=yes 'OPENMP=yes: 0 or 1'
refused bench SCENE=typo 'SCENE=typo: there is no evolve/scenes/typo\.scene'
refused regenerate SCENE=none/typo.scene 'there is no none/typo\.scene'
[ -z "$FOOTPOINT_LONG" ] || {
    refused runtime 'CONFIG=debug asan' 'not a configuration'
    refused regenerate RANKS= 'not a number of ranks'
    refused regenerate GENERATIONS=-1 'not a number of generations'
    refused check JOBS=all 'not a number of jobs'
}
later 'make: more values, every folder that install-runtime and uninstall refuse'
for target in install install-runtime uninstall; do
    [ $target = install ] || [ -n "$FOOTPOINT_LONG" ] || { refused $target PREFIX= 'PREFIX=.*: no absolute path'; continue; }
    for value in PREFIX= PREFIX=tools BINDIR=bin LIBDIR= INCLUDEDIR=./include MANDIR=man; do
        refused $target $value "${value%%=*}=.*: no absolute path"
    done
    for value in 'PREFIX=/x;y' "LIBDIR=/x'y" 'DESTDIR=/x"y' 'BINDIR=/x$$y' 'INCLUDEDIR=/x|y' 'MANDIR=/x&y'; do
        refused $target "$value" "${value%%=*}=.*: no folder to install in"
    done
done
accepted='RANKS=10 GENERATIONS=0 SEED=18446744073709551615 JOBS=3 FROM=scratch OPENMP=1 CONFIG=debug'
expect "$accepted" 0 '*' '' make -n help $accepted
[ -z "$FOOTPOINT_LONG" ] || for value in $accepted; do
    expect "$value" 0 '*' '' make -n help $value
done

expect 'headers of genomes that did not change are not emitted anew' 0 'generated/footpoint_tri3_derivatives.h is as it was
generated/footpoint_quad9_derivatives.h is as it was' '' env GENERATIONS=4 sh evolve/regenerate.sh --derivatives tri3 quad9

# The table at the end of `make regenerate`: scene, function, origin, operations, promise, mean error, proof, change.
mkdir "$work/shipped" && sed 's/^ \*   genome_sha256:  .*/ *   genome_sha256:  0/' generated/footpoint_quad4.h > "$work/shipped/footpoint_quad4.h"
cp generated/footpoint_tri3.h "$work/shipped/"
awk -f evolve/what_ships.awk -v before="$work/shipped" generated/footpoint_quad4.h generated/footpoint_quad9.h generated/footpoint_tri3.h > "$work/table"
for scene in quad4 quad9 tri3; do
    grep -c '^ \*   operations: ' generated/footpoint_$scene.h
done | awk -v table="$work/table" '{ n += $1 } END { while ((getline < table) > 0) lines++; exit lines != n + 1 }'
report $((! $?)) 'the table of the main job has a line a function'
grep -q '^quad4 *full *bred .* over Q *was .* add, mean ' "$work/table" && grep -q '^quad9 *full .* new$' "$work/table" &&
    grep -q '^tri3 *exact *derived *[0-9]* mul 1 div [0-9]* add *1e-12 .* over Q *none$' "$work/table"
report $((! $?)) 'with what changed'

# ---- targets ----
mkdir "$work/new" && cp -a Makefile evolve generated codegen runtime tests "$work/new"
new() { env -u ISAS make -C "$work/new" --no-print-directory "$@"; }
for target in all install install-runtime; do
    new -n $target > "$work/plan" && grep -q ' -c runtime/' "$work/plan" && ! grep -qE 'tests/bench|footpoint-bench' "$work/plan"
    report $((! $?)) "make $target compiles nothing of the bench"
done
[ "$(new -n bench | grep -c 'bench_methods-.*\.o$')" = 1 ]; report $((! $?)) 'make bench compiles one instruction set'
[ "$(new -n bench ISAS='x86-64 x86-64-v3' CC=gcc | grep -c 'bench_methods-.*\.o$')" = 2 ] || [ "$(uname -m)" != x86_64 ]
report $((! $?)) 'or those asked for'
fast='EXTRA_CFLAGS=-O0 build/release/runtime/faces/pairs.o'
expect 'a file is compiled' 0 '' '*' new $fast
expect 'and is up to date' 0 "make: 'build/release/runtime/faces/pairs.o' is up to date." '' new -n $fast
new -n build/release/runtime/faces/pairs.o | grep -q ' -c '; report $((! $?)) 'but not with other flags'
expect 'a mistyped compiler' 2 '' '*' new $fast CC=gccc
expect 'or option fails' 2 '' '*' new build/release/runtime/faces/pairs.o EXTRA_CFLAGS=-fmistyped
expect 'and puts nothing out of date' 0 "make: 'build/release/runtime/faces/pairs.o' is up to date." '' new -n $fast
cat > "$work/parallel" <<'M'
include Makefile
$(info $(filter -j%,$(MAKEFLAGS)))
M
jobs_of() { new -f "$work/parallel" -n help | sed 1q; }
expect 'all processors' 0 "-j$(nproc)" '' jobs_of
export MAKEFLAGS=-j1
expect 'unless the caller says otherwise' 0 '' '' jobs_of
unset MAKEFLAGS

# ---- a tree with users' files ----
tree=$work/tree root=$PWD
mkdir "$tree" && cp -a Makefile evolve generated "$tree"
for shared in build codegen runtime tests; do ln -s "$root/$shared" "$tree/$shared"; done
plan() { make -C "$tree" --no-print-directory -n "$@"; }
plan install > "$work/before"
cp "$tree/generated/footpoint_quad4.h" "$tree/generated/footpoint_mine.h"
for file in scenes/quad4.scene genomes/quad4.gen frames/plane.gen; do
    cp "$tree/evolve/$file" "$tree/evolve/$(dirname $file)/mine.${file##*.}"
done
: > "$tree/evolve/genomes/quad4.gen.123.tmp"
plan install > "$work/after"
expect 'own scenes, genomes, frames and headers change nothing that is installed' 0 '' '' cmp "$work/before" "$work/after"
plan bench SCENE=mine | grep -q 'footpoint_mine\.h'; report $((! $?)) 'the bench measures them when asked to'
plan uninstall > "$work/after"
! grep -q 'mine' "$work/after"; report $((! $?)) 'and they are not uninstalled'
if git ls-files > "$work/files" 2> /dev/null; then
    for folder in generated evolve/scenes evolve/genomes evolve/frames; do
        grep "^$folder/" "$work/files" | grep -v README.md | sort > "$work/kept"
        grep -oE "(^| )$folder/[a-z0-9_-]+\.[a-z]+" "$work/before" | tr -d ' ' | sort -u > "$work/put"
        expect "all of $folder is installed" 0 '' '' diff "$work/kept" "$work/put"
    done
    for left in tests/example/impact tests/example/slide tests/example/press tests/example/out/energy.csv tests/example/plates.inp \
        tests/example/plates-quad4.gen tests/example/plates-quad4.svg tests/example/footpoint_plates_quad4.h example.h example.f90 example.txt; do
        git check-ignore -q $left; report $((! $?)) "git ignores $left"
    done
else
    report 1 'skipped: no git'
fi

# ---- the library, with only a C compiler ----
rm "$tree/build" && mkdir "$tree/build" "$work/bare"
for tool in ar make sed awk cat chmod cp id install ln mkdir mv nproc printf realpath rm rmdir touch; do
    ln -s "$(env which $tool)" "$work/bare/$tool"
done
# The compiler finds its own parts.  Compiled files are not compiled again.
objects=
[ -n "$FOOTPOINT_LONG" ] || [ "$BIN" != build ] || objects=$root/
cat > "$work/bare/cc" << END
#!/bin/sh
for last; do :; done
case \$last in build/release/runtime/*.o) [ -z "$objects" ] || ! cp "$objects\$last" "\$last" || exit 0 ;; esac
PATH="$PATH" exec $CC "\$@"
END
chmod +x "$work/bare/cc"
expect 'make install-runtime' 0 '' '' env -u CC PATH="$work/bare" make -s -C "$tree" install-runtime \
    EXTRA_CFLAGS=-O0 PREFIX=/usr DESTDIR="$work/stage"
for file in lib/libfootpoint.a lib/libfootpoint.so lib/libfootpoint_ccx.a lib/pkgconfig/footpoint.pc include/footpoint.h \
    lib/cmake/footpoint/footpoint-config.cmake include/footpoint/footpoint_quad4.h share/man/man3/footpoint.3; do
    [ -s "$work/stage/usr/$file" ]; report $((! $?)) "$file"
done
cat > "$work/use.c" <<'C'
#include <footpoint.h>
#include <footpoint/footpoint_quad4.h>
int main(void)
{
    return footpoint_strerror(FOOTPOINT_OK)[0] != 's';
}
C
expect 'which serves' 0 '' '' $CC $called -I"$work/stage/usr/include" "$work/use.c" "$work/stage/usr/lib/libfootpoint.a" -lm \
    -o "$work/use"
expect 'a program' 0 '' '' "$work/use"
