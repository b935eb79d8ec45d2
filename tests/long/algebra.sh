# Operation counts beside FORM, Maxima and SymPy at their best, one line an expression and cost model: short expressions,
# or all of them with FOOTPOINT_ALGEBRA=all, which takes hours.  Raw results of the tools are kept in build/algebra.
. tests/cli/expect.inc
for python in /usr/bin/python3 python3; do
    "$python" -c 'import sympy' 2> /dev/null && break
done
[ "$FOOTPOINT_ALGEBRA" = all ] || short='-size -130c'
files=$(find tests/expressions -name '*.gen' $short | sort)
"$python" tests/expressions/compare.py --tap --codegen "$BIN/footpoint-codegen" $files > "$work/table"
status=$?
cat "$work/table"
[ $status -ne 2 ] || { echo "ok 1 - $(tail -n 1 "$work/table")"; exit 0; }
exit $status
