# Checks that `make abi` accepts exactly the changes after which old programs still run.
. tests/cli/expect.inc
unset MAKEFLAGS MAKELEVEL MFLAGS
CC=${CC:-gcc}
command -v abidiff > /dev/null || { echo 'ok 1 - # skip no abidiff'; exit 0; }
tree=$work/tree
mkdir -p "$tree/codegen/base" && cp -r Makefile runtime generated "$tree" && cp codegen/base/base.h "$tree/codegen/base"
here() { make -s -C "$tree" CC="$CC" EXTRA_CFLAGS='-O0 -g' PREFIX="$work/before" "$@"; }
expect 'the library of before' 0 '' '' here install-runtime

change() { # change NAME STATUS FILE SED: that change alone
    cp "$tree/runtime/$3" "$work/kept" && sed "$4" "$work/kept" > "$tree/runtime/$3"
    ! cmp -s "$work/kept" "$tree/runtime/$3"; report $((! $?)) "a change: $1"
    here abi > "$work/log" 2>&1
    [ $? = "$2" ]
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log"
    report $((! good)) "$([ "$2" = 0 ] && echo passes || echo is found)"
    cp "$work/kept" "$tree/runtime/$3"
}
expect 'nothing changed' 0 '*' '' here abi
change 'a new call' 0 search/strerror.c '$a int footpoint_new(void); int footpoint_new(void) { return 0; }'
change 'a call less' 2 package/footpoint.map 's/^    local: /    local: footpoint_certify; /'
change 'a field more' 2 footpoint_batch.h 's/^struct footpoint_pairs {/&\n    double more;/'
change 'another type' 2 search/strerror.c 's/footpoint_strerror(int /footpoint_strerror(long /'
