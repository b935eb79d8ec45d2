# The templates of headers are C as they stand, in double and in float, once the words for the type are defined.
. tests/cli/expect.inc
folder=codegen/print/templates
strict='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror'
template() { # template NAME: includes it, from any folder
    for path in "$PWD/$folder/$1.h" "$PWD/$folder"/*/"$1.h"; do
        [ ! -e "$path" ] || echo "#include \"$path\""
    done
}
named=$(grep -oh '[a-zA-Z_]*\(KIND\|SHAPE\|PREFIX\|NAME\|NET\)[a-z_]*' $folder/*.h $folder/*/*.h | sort -u)
{
    echo '#include <math.h>'
    echo '#ifdef SINGLE'
    for function in atan2 copysign fabs frexp ldexp sqrt; do echo "#define $function ${function}f"; done
    echo '#endif'
    echo 'typedef REAL_BITS_TYPE REAL_BITS;'
    for name in macros bits power patch_powers scale products weighted relative height bounds; do template "$name"; done
    for name in again side corner lesser closest edge curve along curved_domain place place_slopes place_bends; do template "$name"; done
    for row in quad4:4:4:quad4 tri3:3:3:tri3 tri6:6:6:curved_triangle quad8:8:8:curved_quad quad9:9:9:curved_quad bezier:4:8: gregory:4:8: bezier_lanes:4:8: gregory_lanes:4:8: face:4:4:; do
        kind=${row%%:*} row=${row#*:} nodes=${row%%:*} row=${row#*:} others=${row%:*} nearest=${row#*:}
        columns= rows= names= parameters= segment=
        for k in $(seq 0 "$others"); do
            columns="$columns${columns:+, }{x[$((3 * k))][i], x[$((3 * k + 1))][i], x[$((3 * k + 2))][i]}"
            rows="$rows${rows:+, }p[$k]"
            [ "$k" = "$others" ] || segment="$segment${segment:+, }c[$k]"
            names="$names${names:+, }x$k"
            parameters="$parameters${parameters:+, }const REAL x$k[3]"
        done
        case $kind in tri*) shape=triangle corners=3 ;; *) shape=square corners=4 ;; esac
        case $kind in
        *_lanes) net=lane_net three='TRIPLE REAL,ROOM 3,THREE 3,OF ,INTO ,ABSOLUTE fabs' ;;
        *) net=net three='TRIPLE footpoint_detail_pack,ROOM 4,THREE FOOTPOINT_DETAIL_THREE,OF footpoint_detail_of,INTO footpoint_detail_into,ABSOLUTE footpoint_detail_absolute' ;;
        esac
        words="PROMISE VECTORS SEGMENT_VECTORS NODES CORNERS COORDINATES SCALED_NODES SCALABLE COLUMNS ROWS SEGMENT_ROWS NODE_NAMES NODE_PARAMETERS REACH_TO_GROWTH VECTOR_ROWS LEAST_SIZE"
        printf '%s\n' "#define VECTORS $((others + 1))" "#define SEGMENT_VECTORS $others" "#define NODES $nodes" "#define CORNERS $corners" "#define SCALABLE 1" "#define PROMISE 1e-7" \
            "#define COORDINATES $((3 * others + 3))" "#define SCALED_NODES $nodes" "#define COLUMNS $columns" "#define ROWS $rows" \
            "#define SEGMENT_ROWS $segment" "#define NODE_NAMES $names" "#define NODE_PARAMETERS $parameters" \
            '#define REACH_TO_GROWTH (reach * reach)' '#define LEAST_SIZE 1e-20' \
            "#define VECTOR_ROWS $(echo "$rows" | sed 's/p/x/g')"
        echo "$three" | tr , '\n' | sed 's/^/#define /'
        printf '%s\n' $named | sed "h; s/KIND/$kind/; s/SHAPE/$shape/; s/PREFIX/$kind/; s/NET/$net/; s/LANES_//; s/^NAME/${kind}_name/; H; x; s/\n/ /; s/^/#define /"
        words="$words $named TRIPLE ROOM THREE OF INTO ABSOLUTE"
        closest="inward fan closest_surface"
        [ "$kind" != quad4 ] || closest="quad4_surface $closest corners"
        [ "$kind" != tri3 ] || closest="$closest tri3_nearest tri3_sure closest_alone proved_closest_arrays"
        files=$kind
        [ "$kind" = quad4 ] || files="$files gap"
        [ "$kind" != tri3 ] || files="tri3 tri3_over gap"
        case $kind in quad4 | tri3) files="$files ${kind}_vectors_gap" ;; esac
        case $kind in
        quad4) files="$files quad4_proof quad4_step:quad4_vector_step quad4_steps quad4_repair answer_proved quad4_box quad4_from from" ;;
        tri6) files="$files curved_local norm curved_limits curved_tri6 single_tri6 curved_start curved_step:curved_single curved_proof curved_repair answer_proved curved_from from" ;;
        quad8 | quad9) files="$files curved_$kind single_$kind curved_start curved_step:curved_single curved_proof curved_repair answer_proved curved_from from" ;;
        tri3) files="$files tri3_answer" ;;
        bezier) files="$files patch_three patch_sizes patch_net patch_bezier patch_bends patch_expand patch_newton patch_proof patch_repair patch_from" ;;
        gregory) files="$files patch_corners patch_gregory patch_expand patch_newton patch_proof patch_repair patch_from" ;;
        esac
        case $kind in
        quad4) files="$files arrays side_root:over quad4_block:double side_correct:double quad4_side:double quad4_rein:double side_last:double quad4_pass:double side_run:arrays_checked" ;;
        tri6 | quad8 | quad9) files="$files arrays side_root:over curved_block:double side_correct:double curved_side:double side_last:double curved_pass:double side_run:arrays_checked" ;;
        *) files="$files arrays arrays_checked over" ;;
        esac
        case $kind in
        bezier | gregory)
            files="$files $closest bends_$kind patch_anchor curved_grows patch_form curved_sole patch_ball curved_whole"
            files="$files curved_within patch_needed curved_split curved_seek patch_close closest_alone proved_closest_arrays"
            ;;
        esac
        case $nearest in
        '') ;;
        curved*)
            files="$files $closest curved_anchor curved_slopes:single_slopes curved_at curved_grows curved_form curved_sole curved_within curved_ball curved_whole curved_close curved_split curved_seek closest_alone proved_closest_arrays"
            files="$files ${shape}_powers curved_along curved_parts curved_along_full along_again along_calls"
            ;;
        *) files="$files $closest ${nearest}_along along_again along_calls" ;;
        esac
        case $nearest in
        '') ;;
        *)
            files="$files generic_step generic_search generic_float"
            printf '#define %s\n' "FLOAT_PARAMETERS $(echo "$parameters" | sed 's/REAL/float/g')" "GENERIC ${kind}_generic" "GENERIC_at ${kind}_generic_at" \
                "ROUNDED ${kind}_rounded" "IN_DOUBLE ${kind}_in_double" 'FLOAT_MAX 3.4e38'
            echo "void ${kind}_generic_at($parameters, REAL *xi, REAL *eta);"
            echo "int ${kind}_in_double($(echo "$parameters" | sed 's/REAL/double/g'), double loc[2], double *gap);"
            words="$words FLOAT_PARAMETERS GENERIC GENERIC_at ROUNDED IN_DOUBLE FLOAT_MAX"
            ;;
        esac
        files="straight $files" calls='at checked arrays_calls over_calls'
        case $kind in
        *_lanes)
            files="patch_block:double lanes_${kind%_lanes} patch_newton patch_lane patch_lanes:double straight patch_begin:double" calls=
            [ $kind != bezier_lanes ] || files="lanes_sizes patch_net $files"
            ;;
        bezier | gregory) calls='at checked patch_calls patch_from_calls patch_nearby proved_closest_calls' ;;
        esac
        case $nearest in
        '') ;;
        quad4)
            files="$files quad4_sole quad4_here:quad4_vector_here quad4_close quad4_repair_closest closest_blocks:closest_alone proved_closest_arrays"
            calls="nearest nearest_shorter quad4_prove quad4_approach $calls from_calls:double quad4_nearby:quad4_vector_nearby proved_closest_calls quad4_closest_from"
            ;;
        curved*) calls="$calls from_calls:double curved_nearby proved_closest_calls" ;;
        tri3) calls="$calls tri3_nearby proved_closest_calls" ;;
        esac
        if [ $kind = face ]; then # functions at a place of it
            files='answer place_detail place_calls place_joined place_along place_along_joined place_bends_calls place_bends_joined' calls=
            for word in ROW SET_ROW REQUIRE GAP_LAST GAP_AMONG_ROWS; do echo "#define WITH_$word"; echo "#define END_$word"; done
            printf '#define %s\n' 'VECTOR_LIST const REAL *const xS = x[4];' 'STATEMENTS' 'ROW gap' 'ROW_NUMBER 0' 'ROW_COUNT 8' \
                'ROW_NAMES gap' 'ROW_PLACES gap + i' 'ROW_PARAMETERS REAL gap[1]' 'ROW_COLUMNS REAL *FOOTPOINT_RESTRICT gap' 'GAP xi * eta' \
                'REQUIRED 1' 'TESTS flaw = footpoint_detail_not_above(require[0] = xi);' 'ELEMENTS gap[0 * step] = xi;' 'TANGENTS 0' \
                'SIZES_AND_DEGREES 1, 1' 'SPACE 1' 'FIRST 0' 'DEGREE 0' 'JOINED face_joined' 'JOINED_n face_joined_n' \
                'SLOPES face_slopes' 'SLOPES_detail face_slopes_detail' 'SLOPES_detail_size face_slopes_size' 'SLOPES_detail_again face_slopes_again' 'SLOPE_COUNT 18' \
                'JOINED_SLOPES face_along_slopes' 'BENDS face_bends' 'BENDS_detail_turns face_bends_turns' 'JOINED_BENDS face_along_bends' 'PROJECTION face_along_to' 'SEARCH face_search' 'SEARCHED_detail_checked face_search_detail_checked'
            echo 'REAL_BITS face_search_detail_checked(const REAL *const *x, int way, REAL zero, REAL *xi, REAL *eta, REAL *gap);'
            echo "int face_search($parameters, REAL loc[2], REAL *distance);"
            echo "int face_along_to($parameters, const REAL along[3], REAL loc[2], REAL *distance);"
        else
            for word in PROMISE EXACT_PROMISE CURVED PATCH SHARED_GAP OWN_GAP WALK; do echo "#define WITH_$word"; echo "#define END_$word"; done
            echo "#define SEARCH_CALL ${kind}_name_detail($(echo "$rows" | sed 's/p/x/g'), zero, xi, eta)"
            echo "#define STATEMENTS *xi = *eta = zero + $(echo "$names" | sed 's/,/[0] +/g')[0];"; echo '#define DENOMINATORS 0'
            printf '#define %s\n' "VECTOR_STATEMENTS const REAL *const a = x0, *const b = x1, *const c = x2, *const d = x3; (void)c; (void)x$others;" 'SIZE 1' \
                'PRODUCT_LIST 1, 0, 1' 'RATIO 1' 'PER 1' 'UNIT 1' 'UNITS 23' 'OVER 1' 'TWIST 1' 'STEPS 2' 'SCALED_ROWS y[0], y[1], y[2], y[3], y[4]' "START_detail_prove ${kind}_start" \
                "EXACT_prove ${kind}_exact" "START_detail_approach ${kind}_approach" "START_detail ${kind}_name_detail" "ONCE_detail ${kind}_name_detail" 'ONCE_STEPS 2' \
                "WALKED_detail ${kind}_name_detail" 'WALK_STEPS 2' 'WALK_SMALL 1'
            words="$words VECTOR_STATEMENTS SIZE PRODUCT_LIST RATIO PER UNIT UNITS OVER TWIST SCALED_ROWS"
            words="$words SEARCH_CALL STATEMENTS DENOMINATORS EXACT_prove WITH_EXACT_PROMISE END_EXACT_PROMISE START_detail START_detail_prove START_detail_approach STEPS ONCE_detail ONCE_STEPS WITH_PROMISE END_PROMISE WITH_CURVED END_CURVED WITH_PATCH END_PATCH WITH_SHARED_GAP END_SHARED_GAP WITH_OWN_GAP END_OWN_GAP WALKED_detail WALK_STEPS WALK_SMALL WITH_WALK END_WALK"
            echo "REAL_BITS ${kind}_start($parameters, REAL promise, int fixed, REAL *xi, REAL *eta, REAL *gap);"
            case $kind in bezier | gregory) ;; *) echo "REAL_BITS footpoint_detail_${kind}_patch(const REAL *const *x, REAL promise, int bare, int near, REAL least, REAL *xi, REAL *eta, REAL *gap);" && echo "void footpoint_detail_${kind}_bare_steps(const REAL *const *x, int most, REAL small, REAL *xi, REAL *eta);" ;; esac
            echo "void ${kind}_run(const void *begin, int bare, footpoint_detail_search *search, const REAL *const *segment, size_t n, const REAL *const *x, REAL promise, REAL *xi, REAL *eta, REAL *gap, int *status);"
            case $kind in
            quad4 | tri6 | quad8 | quad9) printf '#define %s\n' 'LANE REAL' 'LANE_BITS REAL_BITS' 'LANE_TOP REAL_TOP' "BLOCK footpoint_detail_${kind}_block" "SIDE footpoint_detail_${kind}_side" ;;
            *_lanes) printf '#define %s\n' 'LANE REAL' 'LANE_BITS REAL_BITS' "BLOCK ${kind}_block" "NARROW ${kind}_narrow" "NARROW_of ${kind}_narrow_of" 'ALONE_SEARCH footpoint_detail_search' "ALONE_ANSWER footpoint_detail_${kind%_lanes}_answer" "ALONE_FURTHER footpoint_detail_${kind%_lanes}_further" ;;
            esac
            printf '#define %s\n' "RUN ${kind}_run" 'ONCE_BEGIN NULL'
            words="$words LANE LANE_BITS LANE_TOP SIDE BLOCK NARROW NARROW_of ALONE_SEARCH ALONE_ANSWER ALONE_FURTHER RUN ONCE_BEGIN"
            case $kind in tri6 | quad8 | quad9) ;; *) echo "REAL_BITS footpoint_detail_${kind}_curved(const REAL *const *x, REAL promise, int bare, int fixed, REAL least, REAL *xi, REAL *eta, REAL *gap);" ;; esac
            [ "$kind" = tri3 ] || [ "$kind" = quad4 ] || echo "REAL_BITS ${kind}_name_detail_gap($parameters, REAL xi, REAL eta, REAL *gap);"
            echo "int ${kind}_approach($parameters, REAL promise, int lanes, REAL xi, REAL eta, REAL at[3], int *region);"
            echo "REAL_BITS ${kind}_exact(const REAL *const *x, REAL promise, REAL *xi, REAL *eta);"
        fi
        for name in $files $calls; do
            case $name in
            *:double) echo '#ifndef SINGLE' ;;
            *:*) echo '#ifdef SINGLE' && template "${name#*:}" && echo '#else' ;;
            esac
            template "${name%:*}"
            case $name in *:*) echo '#endif' ;; esac
        done
        for name in $words; do echo "#undef $name"; done
    done
    # Edges have nodes of two coordinates.
    for name in plane plane_along; do echo "#include \"$PWD/$folder/edge/$name.h\""; done
    for row in edge2:2:'edge2' edge3:3:'edge3 edge3_repair edge3_closest'; do
        kind=${row%%:*} row=${row#*:} nodes=${row%%:*} files="${row#*:} edge_answers edge_calls edge_place edge_along edge_turns"
        columns= rows= names= parameters= segment=
        for k in $(seq 0 "$nodes"); do
            columns="$columns${columns:+, }{x[$((2 * k))][i], x[$((2 * k + 1))][i]}"
            rows="$rows${rows:+, }p[$k]" names="$names${names:+, }x$k" parameters="$parameters${parameters:+, }const REAL x$k[2]"
            [ "$k" = "$nodes" ] || segment="$segment${segment:+, }c[$k]"
        done
        printf '#define %s\n' "VECTORS $((nodes + 1))" "NODES $nodes" "COORDINATES $((2 * nodes + 2))" "COLUMNS $columns" "ROWS $rows" \
            "SEGMENT_ROWS $segment" "NODE_NAMES $names" "NODE_PARAMETERS $parameters" 'PROMISE 1e-7'
        words='VECTORS NODES COORDINATES COLUMNS ROWS SEGMENT_ROWS NODE_NAMES NODE_PARAMETERS PROMISE'
        for name in $(grep -oh '[a-zA-Z_]*\(KIND\|NAME\|PREFIX\)[a-z_]*' $folder/edge/*.h | sort -u); do
            echo "#define $name $(echo "$name" | sed "s/KIND/$kind/; s/^NAME/${kind}_name/; s/PREFIX/$kind/")"
            words="$words $name"
        done
        for name in $files; do echo "#include \"$PWD/$folder/edge/$name.h\""; done
        for name in $words; do echo "#undef $name"; done
    done
    for name in contract_edge contract_edge_place contract_edge_along contract_edge_turns contract contract_closest_promise contract_closest_linear contract_patch contract_promise contract_box contract_from contract_place ending; do template "$name"; done
} > "$work/all.c"
cp "$work/all.c" "$work/all.cpp"
expect 'all of them' 0 "$(find $folder -name "*.h" | grep -c '\.h$')" '' sh -c "grep -o '[a-z0-9_]*\.h\"' '$work/all.c' | sort -u | wc -l"
double='-DREAL=double -DREAL_BITS_TYPE=uint64 -DREAL_TOP=63 -DREAL_DIGITS=53 -DREAL_MIDDLE=511 -DREAL_UNIT=1e-16 -DREAL_ORDINARY=32 -DREAL_CLOSE=1e-9 -DREAL_WITHIN=1e-9 -DREAL_NEAR=4e-10 -DREAL_EDGE=1e-15 -DREAL_STEP=2.3e-16 -DREAL_STILL=1e-9 -DREAL_FAINT=1e-300 -DREAL_WEAK=1e-6 -DREAL_CRAMER=1e-8 -DREAL_TURN=1e-12 -DREAL_FINE=1e-11 -DREAL_APART=1e-6 -DREAL_TIE=1e-10 -DREAL_MIN=1e-300 -DREAL_FLAT=1e-20 -DREAL_MARGIN=4e-16 -DREAL_ANGLE=1e-24 -DREAL_SMALL=1e-29 -DREAL_INWARD=0.0009765625 -DREAL_ROOT=0x5fe6eb50c7b537a9ull -DREAL_ALONG=1e-9'
float='-DREAL=float -DREAL_BITS_TYPE=uint32 -DREAL_TOP=31 -DREAL_DIGITS=24 -DREAL_MIDDLE=31 -DREAL_UNIT=6e-8f -DREAL_ORDINARY=12 -DREAL_CLOSE=3e-4f -DREAL_WITHIN=1e-4f -DREAL_NEAR=4e-6f -DREAL_EDGE=4e-7f -DREAL_STEP=1.2e-7f -DREAL_STILL=1e-5f -DREAL_FAINT=5e-26f -DREAL_WEAK=1.2e-3f -DREAL_CRAMER=1.5e-3f -DREAL_TURN=1e-6f -DREAL_FINE=1e-3f -DREAL_APART=1e-3f -DREAL_TIE=3e-5f -DREAL_MIN=1e-38f -DREAL_FLAT=1e-9f -DREAL_MARGIN=2e-7f -DREAL_ANGLE=1e-12f -DREAL_SMALL=1e-12f -DREAL_INWARD=0.03125f -DREAL_ROOT=0x5f3759dfu -DREAL_ALONG=1e-3f'
float="$float -fsingle-precision-constant -DSINGLE"
later 'templates: half of the compilers and precisions'
for compiler in 'gcc -std=c99' 'clang -std=c99' 'g++ -std=c++11' 'clang++ -std=c++11'; do
    case $compiler in *++*) source=all.cpp ;; *) source=all.c ;; esac
    for type in double float; do
        case $compiler$type in
        clang*float) continue ;; # which has no constants of single precision
        gcc*float | clang++*double) ;;
        *) [ -n "$FOOTPOINT_LONG" ] || continue ;;
        esac
        eval "flags=\$$type"
        # shellcheck disable=SC2086
        $compiler $strict $flags '-Duint64=unsigned long long' '-Duint32=unsigned int' -fsyntax-only "$work/$source" > "$work/log" 2>&1
        good=$?
        [ $good = 0 ] || head -12 "$work/log" | sed 's/^/# /'
        report $((!good)) "$compiler, $type"
    done
done
