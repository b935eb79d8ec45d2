# Operation counts beside FORM, Maxima and SymPy at their best, one line an expression and cost model.  Raw results of
# the tools are kept in build/algebra: the first run takes hours, the next ones minutes.
. tests/cli/expect.inc
for python in /usr/bin/python3 python3; do
    "$python" -c 'import sympy' 2> /dev/null && break
done
"$python" tests/expressions/compare.py --tap --codegen "$BIN/footpoint-codegen" > "$work/table"
status=$?
cat "$work/table"
[ $status -ne 2 ] || { echo "ok 1 - $(tail -n 1 "$work/table")"; exit 0; }
exit $status
