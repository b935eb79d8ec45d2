# The templates of headers are C as they stand, in double and in float, once the words for the type are defined.
. tests/cli/expect.inc
folder=codegen/print/templates
strict='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror'
{
    echo '#include <math.h>'
    echo '#ifdef SINGLE'
    for function in fabs frexp ldexp sqrt; do echo "#define $function ${function}f"; done
    echo '#endif'
    echo 'typedef REAL_BITS_TYPE REAL_BITS;'
    for name in macros bits power scale weighted relative height; do echo "#include \"$PWD/$folder/$name.h\""; done
    for kind in quad4 tri3:3 tri6:6 quad8:8 quad9:9 bezier:4 gregory:4; do
        echo "#include \"$PWD/$folder/${kind%:*}.h\""
        [ "$kind" != "${kind#*:}" ] || continue
        echo "#define footpoint_detail_KIND_surface footpoint_detail_${kind%:*}_surface"
        echo "#define footpoint_detail_KIND_gap footpoint_detail_${kind%:*}_gap"
        echo "#define NODES ${kind#*:}"
        echo "#include \"$PWD/$folder/gap.h\""
        echo '#undef footpoint_detail_KIND_surface'
        echo '#undef footpoint_detail_KIND_gap'
        echo '#undef NODES'
    done
    for name in again closest; do echo "#include \"$PWD/$folder/$name.h\""; done
    columns= rows=
    for vectors in 1 2 3 4 5; do
        k=$((3 * (vectors - 1)))
        columns="$columns${columns:+, }{x[$k][i], x[$((k + 1))][i], x[$((k + 2))][i]}"
        rows="$rows${rows:+, }p[$((vectors - 1))]"
        case $vectors in 4) kind=tri3 ;; 5) kind=quad4 ;; *) continue ;; esac
        printf '%s\n' "#define VECTORS $vectors" "#define COLUMNS $columns" "#define ROWS $rows" \
            "#define footpoint_detail_KIND_closest_rest footpoint_detail_${kind}_closest_rest" \
            "#define footpoint_detail_KIND_checked_rest footpoint_detail_${kind}_checked_rest" \
            "#include \"$PWD/$folder/${kind}_nearest.h\"" "#include \"$PWD/$folder/closest_rest.h\"" \
            "#include \"$PWD/$folder/checked_rest.h\"" '#undef VECTORS' '#undef COLUMNS' '#undef ROWS' \
            '#undef footpoint_detail_KIND_closest_rest' '#undef footpoint_detail_KIND_checked_rest'
    done
    echo "#include \"$PWD/$folder/along.h\""
    for kind in tri3:4 quad4:5; do
        vectors=${kind#*:} kind=${kind%:*} columns= rows= names= parameters=
        for k in $(seq 0 $((vectors - 1))); do
            columns="$columns${columns:+, }{x[$((3 * k))][i], x[$((3 * k + 1))][i], x[$((3 * k + 2))][i]}"
            rows="$rows${rows:+, }p[$k]"
            names="$names${names:+, }x$k"
            parameters="$parameters${parameters:+, }const REAL x$k[3]"
        done
        printf '%s\n' "#define VECTORS $vectors" "#define COORDINATES $((3 * vectors))" "#define COLUMNS $columns" \
            "#define ROWS $rows" "#define NODE_NAMES $names" "#define NODE_PARAMETERS $parameters" \
            "#define footpoint_detail_KIND_along footpoint_detail_${kind}_along" \
            "#define footpoint_detail_KIND_along_full footpoint_detail_${kind}_along_full" \
            "#define footpoint_detail_KIND_along_again footpoint_detail_${kind}_along_again" \
            "#define PREFIX_along ${kind}_along" "#define PREFIX_along_n ${kind}_along_n" \
            "#include \"$PWD/$folder/${kind}_along.h\"" "#include \"$PWD/$folder/along_again.h\"" \
            "#include \"$PWD/$folder/along_calls.h\"" '#undef VECTORS' '#undef COORDINATES' '#undef COLUMNS' '#undef ROWS' \
            '#undef NODE_NAMES' '#undef NODE_PARAMETERS' '#undef footpoint_detail_KIND_along' \
            '#undef footpoint_detail_KIND_along_full' '#undef footpoint_detail_KIND_along_again' '#undef PREFIX_along' \
            '#undef PREFIX_along_n'
    done
    for name in corners quad4_sure contract contract_closest place/place place/contract_place; do echo "#include \"$PWD/$folder/$name.h\""; done
} > "$work/all.c"
cp "$work/all.c" "$work/all.cpp"
expect 'all of them' 0 "$(find $folder -name '*.h' | wc -l)" '' sh -c "grep -o '[a-z0-9_]*\.h\"' '$work/all.c' | sort -u | wc -l"
double='-DREAL=double -DREAL_BITS_TYPE=uint64 -DREAL_TOP=63 -DREAL_DIGITS=53 -DREAL_MIDDLE=511 -DREAL_MIN=1e-300 -DREAL_FLAT=1e-20 -DREAL_MARGIN=4e-16'
float='-DREAL=float -DREAL_BITS_TYPE=uint32 -DREAL_TOP=31 -DREAL_DIGITS=24 -DREAL_MIDDLE=31 -DREAL_MIN=1e-38f -DREAL_FLAT=1e-9f -DREAL_MARGIN=2e-7f'
float="$float -fsingle-precision-constant -DSINGLE"
for compiler in 'gcc -std=c99' 'clang -std=c99' 'g++ -std=c++11' 'clang++ -std=c++11'; do
    case $compiler in *++*) source=all.cpp ;; *) source=all.c ;; esac
    for type in double float; do
        case $compiler$type in clang*float) continue ;; esac # which has no constants of single precision
        eval "flags=\$$type"
        # shellcheck disable=SC2086
        $compiler $strict $flags '-Duint64=unsigned long long' '-Duint32=unsigned int' -fsyntax-only "$work/$source" > "$work/log" 2>&1
        good=$?
        [ $good = 0 ] || head -12 "$work/log" | sed 's/^/# /'
        report $((!good)) "$compiler, $type"
    done
done
