#!/bin/sh
# header_sizes.sh: bytes and lines of each kind's header and its header of derivatives, and the processor's seconds to compile a file
# that calls one search, or the search joined with first derivatives, or includes nothing.  For comparison: 18 MB of generated conditions in
# Kratos (issue 11566), 4,470 lines of generated derivatives in ipc-toolkit.  Reads CC and CFLAGS (-O2).
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT

# seconds LINE...: of processor time to compile a file of these lines
seconds() {
    printf '%s\n' "$@" > "$work/file.c"
    # shellcheck disable=SC2086
    sh -c '"$@" && times' sh ${CC:-gcc} ${CFLAGS:--O2} -Igenerated -c "$work/file.c" -o "$work/file.o" |
        awk 'NR == 2 { split($0, t, /[ms ]+/); printf "%.2f", 60 * (t[1] + t[3]) + t[2] + t[4] }'
}

printf '%-9s %8s %6s %8s   %8s %6s %8s\n' header bytes lines seconds derivs lines joined
for search in tri3_exact tri6_accurate quad4_accurate quad8_full quad9_full edge2_exact edge3_accurate; do
    kind=${search%_*} upper=$(echo "${search%_*}" | tr a-z A-Z)
    header=generated/footpoint_$kind.h derivatives=generated/footpoint_${kind}_derivatives.h
    include="#include \"footpoint_$kind.h\""
    printf '%-9s %8d %6d %8s' "$kind" "$(wc -c < "$header")" "$(wc -l < "$header")" \
        "$(seconds "$include" "void *search(void) { return (void *)footpoint_$search; }")"
    [ ! -e "$derivatives" ] || printf '   %8d %6d %8s' "$(wc -c < "$derivatives")" "$(wc -l < "$derivatives")" \
        "$(seconds "$include" "#include \"footpoint_${kind}_derivatives.h\"" "FOOTPOINT_${upper}_GRADIENTS_OF(footpoint_$search)" \
            "void *search(void) { return (void *)footpoint_${search}_gradients; }")"
    echo
done
echo "nothing: $(seconds 'void *search(void) { return 0; }') seconds"
