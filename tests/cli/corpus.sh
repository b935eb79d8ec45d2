# Replays the fuzzers' corpus: every syntax of a genome file is read or refused in one line.
. tests/cli/expect.inc
for gen in tests/fuzz/corpus/*.gen; do
    timeout 20 "$BIN/footpoint-codegen" --count --effort 0 "$gen" > "$work/stdout" 2> "$work/stderr"
    status=$? good=0
    case $status in
    0) { read -r line && read -r line; } < "$work/stdout" && good=1 ;;
    1) [ ! -s "$work/stdout" ] && { read -r line && ! read -r more; } < "$work/stderr" && case $line in "$gen:"*'error: '*) good=1 ;; esac ;;
    esac
    [ "$good" = 1 ] || { echo "# exit status $status"; sed 's/^/#   /' "$work/stderr"; }
    name=${gen##*/}
    report "$good" "corpus ${name%.gen}"
done

# The searches' corpus: any numbers and indices return a right status, and batches the bits of single pairs.
${CC:-gcc} -std=c11 -D_DEFAULT_SOURCE -O1 -ffp-contract=off tests/fuzz/fuzz_search.c tests/fuzz/replay_main.c \
    "$BIN/libfootpoint.a" -lm -o "$work/replay" > "$work/log" 2>&1 &&
    "$work/replay" tests/fuzz/search/*.bin > "$work/log" 2>&1 && "$work/replay" --random 3000 1 > "$work/log" 2>&1
good=$((! $?))
[ "$good" = 1 ] || sed 's/^/# /' "$work/log"
report "$good" 'corpus of the searches, and random inputs'
