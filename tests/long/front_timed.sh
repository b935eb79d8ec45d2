# Checks make front on a small scene: members of its front are bred, emitted, proved, and timed together on validation
# samples.
. tests/cli/expect.inc
unset MAKEFLAGS MFLAGS
make SCENE=tests/scenes/steps.scene GENERATIONS=2 RANKS=1 MEMBERS=2 front > "$work/table" 2> "$work/err" || sed 's/^/# /' "$work/err"
[ "$(grep -c '^steps_front_both_both_c[0-9]* .* \(new\|ship\|behind .*\)$' "$work/table")" = 2 ] &&
    grep -q '^lines for the scene file:$' "$work/table"
report $((! $?)) 'two members in the table, with their times and errors'
grep -q '^ \*   poles: ' "$BIN/front/steps/footpoint_steps_front.h"; report $((! $?)) 'and what is known of their poles'
