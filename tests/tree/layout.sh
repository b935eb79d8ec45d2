# Checks that includes run one way: evolve -> genome text <- codegen -> generated <- runtime, and between the rooms of each.
# The table lists the rooms that a room may include; every #include is read.  "x/*" stands for all rooms of x.
. tests/cli/expect.inc

rooms() {
    sed 's/ *#.*//; /^$/d' << 'EOF'
codegen/base:
codegen/genome:     codegen/base
codegen/graph:      codegen/genome codegen/base
codegen/passes:     codegen/graph codegen/genome codegen/base
codegen/program:    codegen/graph codegen/genome codegen/base
codegen/schedule:   codegen/program codegen/graph codegen/genome codegen/base
codegen/prove:      codegen/program codegen/graph codegen/genome codegen/base
codegen/region:     codegen/prove codegen/program codegen/graph codegen/genome codegen/base
codegen/rounding:   codegen/region codegen/prove codegen/program codegen/graph codegen/genome codegen/base
codegen/compile:    codegen/rounding codegen/region codegen/prove codegen/program codegen/schedule codegen/passes codegen/graph codegen/genome codegen/base
codegen/print/templates:
codegen/print/templates/closest:
codegen/print/templates/curved_closest:
codegen/print/templates/along:
codegen/print/templates/promise:
codegen/print/templates/side:
codegen/print/templates/single:
codegen/print/templates/patch:
codegen/print/templates/triangle:
codegen/print/templates/place:
codegen/print/templates/gap:
codegen/print/templates/edge:
codegen/print/templates/generic:
codegen/print:      codegen/compile codegen/rounding codegen/region codegen/program codegen/graph codegen/genome codegen/base
codegen/print/header: codegen/print codegen/compile codegen/rounding codegen/region codegen/program codegen/graph codegen/genome codegen/base
codegen:            codegen/* codegen/print/header
generated:
runtime:                                                        # public headers
runtime/geometry:   runtime
runtime/certain:    runtime/geometry runtime generated
runtime/search:     runtime/certain runtime/geometry runtime generated
runtime/batch:      runtime/search runtime/certain runtime/geometry runtime generated
runtime/faces:      runtime/certain runtime/geometry runtime generated
runtime/calculix:   runtime/certain runtime/geometry runtime generated
runtime/replace:    runtime generated                           # C, Fortran and C++
evolve/common:      codegen/genome codegen/base
evolve/input:       evolve/common codegen/genome codegen/base
evolve/surface:     evolve/common codegen/genome runtime/geometry codegen/base
evolve/samples:     evolve/input evolve/surface evolve/common codegen/genome runtime/geometry codegen/base
evolve/genotype:    evolve/common codegen/genome codegen/base
evolve/eval:        evolve/genotype evolve/surface evolve/input evolve/common codegen/genome codegen/base
evolve/region:      evolve/eval evolve/surface evolve/common codegen/genome codegen/base
evolve/fit:         evolve/eval evolve/genotype evolve/surface evolve/input evolve/common codegen/genome codegen/base
evolve/island:      evolve/fit evolve/eval evolve/genotype evolve/input evolve/common codegen/genome codegen/base
evolve/mpi:         evolve/common codegen/genome codegen/base
evolve/archive:     evolve/island evolve/eval evolve/genotype evolve/input evolve/common codegen/genome codegen/base
evolve/write:       evolve/archive evolve/region evolve/samples evolve/surface evolve/island evolve/eval evolve/genotype evolve/input evolve/common codegen/genome codegen/base
evolve/run:         evolve/write evolve/archive evolve/mpi evolve/island evolve/fit evolve/eval evolve/genotype evolve/samples evolve/surface evolve/input evolve/common codegen/genome codegen/base
evolve:             evolve/* codegen/genome codegen/base
tests/support:      codegen/* evolve/* runtime runtime/*
tests/rivals:       tests/support generated codegen/* evolve/* runtime runtime/*
tests/hard:         tests/rivals tests/support runtime runtime/* generated
tests/patches:      tests/hard tests/support generated runtime
tests/bench:        tests/hard tests/rivals tests/support generated codegen/* evolve/* runtime runtime/*
tests/libraries:    tests/hard tests/rivals tests/support generated runtime runtime/*
tests/queries:      tests/libraries tests/rivals tests/support generated runtime runtime/*
tests/evolve:       tests/rivals tests/support generated codegen/* evolve/* runtime runtime/*
tests/codegen:      tests/support generated codegen/* evolve/* runtime runtime/*
tests/runtime:      tests/rivals tests/support generated codegen/* evolve/* runtime runtime/*
tests/generated:    tests/hard tests/patches tests/rivals tests/support generated codegen/* evolve/* runtime runtime/*
tests/plane:        tests/hard tests/support generated runtime
tests/single:       tests/plane tests/generated tests/hard tests/support
tests/along:        tests/support generated runtime runtime/geometry
tests/generic:      generated
tests/calculix:     runtime/calculix
tests/sfepy:        runtime/replace runtime/geometry generated
tests/replace:      runtime/replace runtime generated
tests/example:      runtime runtime/* generated
tests/paper:
tests/paper/rivals: codegen/* evolve/*
tests/fuzz:         evolve/input codegen/* runtime runtime/* generated tests/hard
tests/long:
tests/timed:
tests/tree:
EOF
}

# includes FOLDER...: "file path" for each line #include "path", the path from here; "file <path>" for what is ours not
includes() {
    find "$@" -name '*.[ch]' -o -name '*.cpp' | sort | xargs awk '
        /^[ \t]*#[ \t]*include[ \t]*["<]/ {
            match($0, /["<][^">]*/)
            path = substr($0, RSTART + 1, RLENGTH - 1)
            if (substr($0, RSTART, 1) == "<") { print FILENAME, "<" path ">"; next }
            folder = FILENAME
            sub(/\/[^\/]*$/, "", folder)
            path = folder "/" path
            while (sub(/[^\/.][^\/]*\/\.\.\//, "", path)) {}
            print FILENAME, path
        }'
}
folder_of='function folder_of(file) { sub(/\/[^\/]*$/, "", file); return file }'
check() { [ -z "$2" ]; good=$?; [ $good = 0 ] || echo "$2" | sed 's/^/# /'; report $((! good)) "$1"; }

# Only existing files count: files that the Makefile makes are included only by name.
judge() {
    find "$@" -type f > "$work/files"
    includes "$@" | awk 'NR == FNR { there[$0]; next } $2 ~ /^</ || $2 in there' "$work/files" - > "$work/includes"
    rooms > "$work/rooms"
    wrong=$(awk "$folder_of"'
        NR == FNR { room = $1; sub(/:$/, "", room); known[room]; for (i = 2; i <= NF; i++) may[room, $i]; next }
        $2 ~ /^</ { next }
        {
            from = folder_of($1); to = folder_of($2); all = to; sub(/\/[^\/]*$/, "/*", all)
            if (!(from in known)) print $1 ": no room of the table"
            else if (from != to && !((from, to) in may) && !((from, all) in may)) print $1 ": includes " $2
        }' "$work/rooms" "$work/includes")
    circles=$(circles_of "$work/includes")
}

# circles_of FILE: repeatedly removes units that use no other unit, or that no other uses, and prints the rest.  FILE has
# lines "user used"; a unit is x.c with x.h.
circles_of() {
    awk '
        function unit(file) { sub(/\.[^.\/]*$/, "", file); return file }
        function peel(n, back,   u, count, leaf, i, j, k, other) {
            for (u in left) if (!n[u]) leaf[++count] = u
            for (i = 1; i <= count; i++) {
                delete left[leaf[i]]
                k = split(back[leaf[i]], other, " ")
                for (j = 1; j <= k; j++) if (--n[other[j]] == 0) leaf[++count] = other[j]
            }
        }
        $2 ~ /^</ { next }
        {
            a = unit($1); b = unit($2)
            if (a == b || (a, b) in edge) next
            edge[a, b]; left[a]; left[b]
            down[a]++; users[b] = users[b] " " a
            up[b]++; used[a] = used[a] " " b
        }
        END {
            peel(down, users); peel(up, used)
            for (u in left) print u
        }' "$1" | sort
}

# calls FOLDER...: "user used" for each symbol that one file takes from another, as compiled
calls() {
    find "$@" -name '*.c' | sed "s|\(.*\)\.c$|$OBJECTS/\1.o|" | xargs ls 2> /dev/null | xargs nm -g -A | awk -v from="$OBJECTS/" '
        { file = $1; sub(/\.o:.*/, ".c", file); file = substr(file, length(from) + 1) }
        $2 ~ /^[TDBRV]$/ { defines[$3] = file }
        $2 == "U" { needs[++n] = file " " $3 }
        END {
            for (i = 1; i <= n; i++) {
                split(needs[i], pair, " ")
                if (pair[2] in defines && defines[pair[2]] != pair[1]) print pair[1], defines[pair[2]]
            }
        }' | sort -u
}

judge codegen evolve runtime generated tests
check 'every room includes what it may' "$wrong"
check 'no circle between files' "$circles"
OBJECTS=${OBJ:-build/release}
calls codegen evolve runtime > "$work/calls"
check 'none between files of which one calls the other' "$(circles_of "$work/calls")"
check 'no circle between rooms' "$(rooms | awk -F: '
    { room[NR] = $1; list[NR] = $2; line[$1] = NR }
    END {
        for (i = 1; i <= NR; i++) { k = split(list[i], to, " "); for (j = 1; j <= k; j++) if (line[to[j]] > i) print room[i] ": " to[j] " stands below it" }
    }')"
check 'no folder has more than 30 sources' "$(git ls-files codegen evolve runtime tests | grep -E '\.(c|h|cpp|sh)$' | sed 's|/[^/]*$||' | sort | uniq -c | awk '$1 > 30 { print $2 ": " $1 }')"
check 'each room has its sentence in the README.md above it' "$(rooms | sed 's/:.*//' | while read -r room; do
    case $room in
    */*) grep -q "^| *\`${room#*/}/\` *|" "${room%%/*}/README.md" || echo "$room" ;;
    *) [ -s "$room/README.md" ] || echo "$room" ;;
    esac
done)"
check 'folders of sources are rooms' "$(git ls-files codegen evolve runtime generated | grep '\.[ch]$' | sed 's|/[^/]*$||' | sort -u | while read -r folder; do
    rooms | grep -q "^$folder:" || echo "$folder"
done)"

check 'runtime takes only the C library besides' \
    "$(includes runtime | sed -n 's/^.* <//p' | sort -u | grep -vxE '(math|stddef|stdint|limits|float|string)\.h>')"
check 'generated takes only math.h and stddef.h' "$(includes generated | sed 's/^[^ ]* //' | sort -u | grep -vxE '<(math|stddef)\.h>')"
check 'evolve takes public headers of the runtime alone' "$(includes evolve | grep ' runtime/' | grep -vE '/footpoint-[a-z0-9]+-(geometry|normals)\.h$')"
check "MPI stops at evolve's main program, mpi/ and run/" \
    "$(grep -rl 'include <mpi.h>' codegen evolve runtime | grep -vE '^evolve/(evolve_main\.c|mpi/|run/)')"
check 'file names are unique' \
    "$(git ls-files 2> /dev/null | grep -E '\.(c|h|cpp|sh|awk)$' | sed 's|.*/||' | sort | uniq -d)"

# Planted errors must be found.
mkdir -p "$work/codegen/graph" "$work/codegen/passes"
echo '#include "../passes/b.h"' > "$work/codegen/graph/a.h"
echo '#include "../graph/a.h"' > "$work/codegen/passes/b.h"
here=$PWD
cd "$work" || exit 1
judge codegen
cd "$here" || exit 1
[ "$wrong" = 'codegen/graph/a.h: includes codegen/passes/b.h' ]; report $((! $?)) 'an arrow that is planted is found'
[ "$(echo "$circles" | wc -l)" = 2 ]; report $((! $?)) 'and a circle'
