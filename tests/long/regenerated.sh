# Runs the main job's search on the committed genomes: no error on held-out samples (mean, 99 %, worst, of xi or eta, of
# any function) may grow by more than 2 %. Headers are not emitted. Scenes are done like in `make regenerate`, two at a
# time; GENERATIONS= as there. One scene of each kind, or those that SCENES= names; SCENES=all takes all.
. tests/cli/expect.inc
export OMPI_MCA_btl_base_warn_component_unused=0
GENERATIONS=${GENERATIONS:-1}
scenes=${SCENES:-bezier blocks-quad4 quad4 quad8 tri6}
[ "$scenes" != all ] || scenes=$(ls evolve/scenes/*.scene)
for scene in $scenes; do basename "$scene" .scene; done |
    xargs -P 2 -I{} sh -c "\"$BIN/footpoint-evolve\" --scene {} --generations $GENERATIONS --islands 1 --seed 1 --quiet -o '$work/{}.gen' \
        > '$work/{}.log' 2>&1 || echo {} >> '$work/failed'"
[ ! -e "$work/failed" ]; report $((! $?)) 'every scene is bred'

# errors FILE: a line "SCENE FUNCTION SAMPLES_OUTPUT mean 99% worst" for each output of each held-out note
errors() {
    awk -v scene="$(basename "$1" .gen)" '/^genome /{ name = $2 }
        /^note heldout_/{ for (k = 0; k < 2; k++) print scene, name, $2 "_" k, $(6 + k), $(9 + k), $(12 + k) }' "$1"
}
for file in "$work"/*.gen; do
    errors "evolve/genomes/$(basename "$file")" >> "$work/before"
    errors "$file" >> "$work/after"
done
awk 'NR == FNR { mean[$1, $2, $3] = $4; p99[$1, $2, $3] = $5; worst[$1, $2, $3] = $6; next }
    function compare(what, before, after) {
        if (after > 1.02 * before)
            printf "%s %s %s: %s %s -> %s, %.1f %% worse\n", $1, $2, $3, what, before, after, 100 * (after / before - 1)
    }
    { compare("mean", mean[$1, $2, $3], $4); compare("99 %", p99[$1, $2, $3], $5); compare("worst", worst[$1, $2, $3], $6) }' \
    "$work/before" "$work/after" > "$work/worse"
sed 's/^/# /' "$work/worse"
[ "$(wc -l < "$work/before")" = "$(wc -l < "$work/after")" ] && [ ! -s "$work/worse" ]
report $((! $?)) "none of $(wc -l < "$work/before") rows of held-out errors is worse"
