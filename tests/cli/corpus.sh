# The fuzzer's corpus: every syntax and every refusal of a genome file ends well, a refusal in one line.
. tests/cli/expect.inc
for gen in tests/fuzz/corpus/*.gen; do
    timeout 20 "$BIN/footpoint-codegen" --count --effort 0 "$gen" > "$work/stdout" 2> "$work/stderr"
    status=$? good=0
    case $status in
    0) [ "$(wc -l < "$work/stdout")" -gt 1 ] && good=1 ;;
    1) [ ! -s "$work/stdout" ] && [ "$(wc -l < "$work/stderr")" = 1 ] && grep -q "^$gen:.*error: " "$work/stderr" && good=1 ;;
    esac
    [ "$good" = 1 ] || { echo "# exit status $status"; sed 's/^/#   /' "$work/stderr"; }
    report "$good" "corpus $(basename "$gen" .gen)"
done
