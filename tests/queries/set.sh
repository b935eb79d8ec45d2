#!/bin/sh
# set.sh make SEED COUNT: prints queries, COUNT for each kind of face and family.
# set.sh set SEED COUNT: writes them to build/queries/queries.txt.
# set.sh score QUERIES: judges our searches, their rivals, and the libraries built by `make rivals`; prints a table.
# set.sh fill: puts the table for queries.txt.gz into README.md; keeps rows of libraries that are not built.
here=tests/queries BIN=${BIN:-build} CC=${CC:-gcc}
built=$BIN/queries
flags='-std=c11 -D_DEFAULT_SOURCE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -O1 -ffp-contract=off'
mkdir -p "$built" || exit 3

# build PROGRAM FILES AND LIBRARIES...
build() {
    program=$1
    shift
    # shellcheck disable=SC2086
    $CC $flags "$here/${program}_main.c" "$@" -o "$built/$program" || exit 3
}

# scores QUERIES LABEL INSIDE COMMAND...: what the judge says of the answers, or nothing where there are none
scores() {
    queries=$1 label=$2 inside=$3
    shift 3
    timeout 300 "$@" < "$queries" > "$built/answers" && "$built/judge_queries" "$queries" "$built/answers" "$label" $inside
}

# score QUERIES: kind by kind, as CSV
score() {
    build judge_queries $here/query_text.c -lm
    build answer_queries $here/query_text.c "$BIN/libfootpoint.a" -ldl -lm
    for library in '' "$BIN"/rivals/*.so; do
        case $library in *\** | */footpoint.so | */planted.so) continue ;; esac
        "$built/answer_queries" ${library:+"$library"} | while read -r name question; do
            [ "$question" = inside ] || question=
            label=$(basename "${library:-x}" .so) && [ -n "$library" ] && label="$label $name" || label=$name
            scores "$1" "$label" "$question" "$built/answer_queries" ${library:+"$library"} "$name"
        done
    done
}

table() {
    echo '| search | kinds | asked | right | of these placed | wrong | none |'
    echo '|---|---|---|---|---|---|---|'
    awk -F, '$2 == "kind" { next } !($1 in asked) { name[++n] = $1 }
        { kinds[$1] = kinds[$1] (kinds[$1] ? ", " : "") $2; asked[$1] += $3; right[$1] += $4; placed[$1] += $5; wrong[$1] += $6
          none[$1] += $7 }
        END { for (i = 1; i <= n; i++) { s = name[i]; k = kinds[s] == "tri3, quad4, tri6, quad8, quad9" ? "all" : kinds[s]
            print "| `" s "` | " k " | " asked[s] " | " right[s] " | " placed[s] " | " wrong[s] " | " none[s] " |" } }'
}

make_queries() {
    build make_queries $here/distance_polynomial.c $here/draw_queries.c $here/global_minimum.c -lflint-arb -lflint -lmpfr -lgmp -lm
    "$built/make_queries" "$1" "$2"
}

case $1 in
make) make_queries "$2" "$3" ;;
set) make_queries "$2" "$3" > "$built/queries.txt" && echo "$built/queries.txt" ;;
score) score "$2" | table ;;
fill)
    gzip -dc $here/queries.txt.gz > "$built/queries.txt" || exit 3
    score "$built/queries.txt" | table > "$built/table" || exit 3
    awk -F '`' -v table="$built/table" '/^<!-- scores -->$/ { print; while ((getline line < table) > 0) { print line
            split(line, part); made[part[2]] = 1 }; skip = 1 }
        skip && $2 ~ / / && !($2 in made) { print } # a library that is not built here
        /^<!-- end -->$/ { skip = 0 } !skip' $here/README.md > "$built/page" && mv "$built/page" $here/README.md
    ;;
*) echo 'usage: set.sh make SEED COUNT | set SEED COUNT | score QUERIES | fill' >&2; exit 2 ;;
esac
