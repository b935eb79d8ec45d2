# Checks that every typed source is formatted by .clang-format with clang-format 14; other versions format differently.
. tests/cli/expect.inc
for format in clang-format-14 clang-format; do
    ! "$format" --version 2> /dev/null | grep -q 'version 14\.' || break
    format=
done
[ -n "$format" ] || { echo 'ok 1 - formatted # SKIP no clang-format 14'; exit 0; }
# Without FOOTPOINT_LONG those that the last 20 commits changed, and those that are not committed.
later 'format: files that were not changed lately'
find codegen evolve runtime tests -name '*.[ch]' ! -name footpoint_perceptron.h ! -path 'tests/generated/points/*' | sort > "$work/files"
if [ -z "$FOOTPOINT_LONG" ] && git ls-files --error-unmatch Makefile > "$work/log" 2>&1; then
    { git log -n 20 --name-only --format=; git status --porcelain -uall | cut -c4- | sed 's/.* -> //'; } | sort -u | comm -12 - "$work/files" > "$work/recent"
    mv "$work/recent" "$work/files"
fi
for folder in codegen evolve runtime tests; do
    grep "^$folder/" "$work/files" | xargs -r "$format" --dry-run -Werror 2>&1 | sed -n 's/: error: code should be .*//p' |
        sed 's/:.*//' | sort | uniq -c | awk '{ print "# " $2 ": " $1 " places" }' > "$work/differ"
    cat "$work/differ"
    report $((! $(wc -l < "$work/differ"))) "$folder is formatted"
done
