# Checks that every typed source is formatted by .clang-format with clang-format 14; other versions format differently.
. tests/cli/expect.inc
for format in clang-format-14 clang-format; do
    ! "$format" --version 2> /dev/null | grep -q 'version 14\.' || break
    format=
done
[ -n "$format" ] || { echo 'ok 1 - formatted # SKIP no clang-format 14'; exit 0; }
for folder in codegen evolve runtime tests; do
    find $folder -name '*.[ch]' ! -name footpoint_perceptron.h ! -path 'tests/generated/points/*' -exec "$format" --dry-run -Werror {} + 2>&1 | sed -n 's/: error: code should be .*//p' |
        sed 's/:.*//' | sort | uniq -c | awk '{ print "# " $2 ": " $1 " places" }' > "$work/differ"
    cat "$work/differ"
    report $((! $(wc -l < "$work/differ"))) "$folder is formatted"
done
