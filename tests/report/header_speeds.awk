# Prints tables of generated/README.md, with recorded.awk: -v part=speed, calls, derivatives (quad4), gregory or bezier; for
# runtime/README.md part=robust. Ratios are ranges over machines.
function row(method, label,    f) {
    f = "footpoint_quad4_" method
    return "| " label " | " (f in operations ? operations[f] : counts[scene, "bare", method]) " | " \
        against("newton", f in operations ? f : method, "scalar") " | " against("newton", f in operations ? f : method, "batch") " | "
}
function against(rival, method, mode) { return ratio("bare " rival " " mode, "bare " method " " mode) }
function ours(name) {
    print row(name, "**footpoint_quad4_" name "**") short(mean[name]) " | " short(p99[name]) " | " short(worst[name]) " |"
}
function rival(name, text,    e) {
    split(errors[scene, "bare", name], e, " ")
    print row(name, "`" name "`: " text) short(e[1]) " | " short(e[2]) " | " short(e[3]) " |"
}
function speed() {
    scene = "quad4"
    print "| method | mul | div | add | calls | arrays | mean | 99 % | worst |"
    print "|---|---|---|---|---|---|---|---|---|"
    ours("fast"); rival("gn1_centre", "Gauss-Newton, 1 step")
    ours("coarse"); ours("gauss2"); rival("gn2_centre", "Gauss-Newton, 2 steps")
    ours("medium"); ours("balanced"); rival("gn3_centre", "Gauss-Newton, 3 steps")
    ours("fine"); ours("precise"); rival("gn4_centre", "Gauss-Newton, 4 steps")
    ours("accurate"); rival("newton_loose", "until a step is below 1e-5")
    ours("full"); rival("newton", "until converged"); rival("newton_lanes", "a batch stepping together")
}
# Takes, over functions of quad4, the time of `below` over that of `above`, where X stands for the function.
function over(names, below, above,    name, i, n, a, b) {
    n = split(names, name, " ")
    for (i = 1; i <= n; i++) {
        a = above
        b = below
        gsub(/X/, "footpoint_quad4_" name[i], a)
        gsub(/X/, "footpoint_quad4_" name[i], b)
        take(b, a)
    }
    return told()
}
function calls(    all, from) {
    scene = "quad4"
    all = "balanced fine precise accurate full"
    from = "balanced fine precise full"
    print "| call, quad4 | time |"
    print "|---|---|"
    print "| `NAME_closest`, independent calls | " over("fast coarse gauss2 medium balanced fine precise", "closest X_closest scalar", "closest four_triangles scalar") \
        " of four triangles about the centroid (`_accurate` " over("accurate", "closest X_closest scalar", "closest four_triangles scalar") \
        ", `_full` " over("full", "closest X_closest scalar", "closest four_triangles scalar") ") |"
    print "| `NAME_closest_n` | " over(all, "closest X_closest batch", "closest four_triangles batch") " of four triangles |"
    print "| `NAME_over_n`, eight slave nodes | " over("balanced accurate", "over X_over batch", "over X_over scalar") " of calls of `NAME` |"
    print "| `NAME_from`, moves of 0.01 | " over(from, "from_1e-2 X_from_1e-2 scalar", "checked X_checked scalar") " of `NAME`; of 0.1: " \
        over(from, "from_1e-1 X_from_1e-1 scalar", "checked X_checked scalar") " |"
    print "| `NAME_from_n`, moves of 0.01 | " over(from, "from_1e-2 X_from_1e-2 batch", "checked X_checked batch") " of `NAME_checked_n` |"
    print "| `_along`, independent calls | " ratio("along footpoint_quad4_along scalar", "along newton_along scalar") " of Newton in three unknowns; arrays: " \
        ratio("along footpoint_quad4_along batch", "along newton_along batch") " |"
}
function derivative(text, method) {
    print "| " text " | " ratio("derivatives newton_implicit scalar", "derivatives " method " scalar") " | " \
        ratio("derivatives newton_implicit batch", "derivatives " method " batch") " |"
}
function derivatives() {
    scene = "quad4"
    print "| quad4 | calls | arrays |"
    print "|---|---|---|"
    derivative("`_accurate_gradients`: search and gradients joined", "footpoint_quad4_accurate_gradients")
    derivative("`_accurate_hessian`", "footpoint_quad4_accurate_hessian")
    derivative("`_accurate`, then the library's `footpoint_differentiate`", "footpoint_differentiate")
}
function patch(name,    f) {
    f = "footpoint_" scene "_" name
    if (!(f in operations)) return
    print "| `_" name "` | " both_errors(mean[name], at_mean[name]) " | " both_errors(climbed[name], at_worst[name]) " | " both(f, "scalar") " | " both(f, "batch") " | " \
        short(promise[f], "%.0e") " | " proved(f, "scalar") " | " proved(f, "batch") " |"
}
function both_errors(arrays, at) { return short(arrays) (at == "" ? "" : " (" short(at) ")") }
function proved(f, mode) {
    return ratio("checked " (scene == "bezier" ? "bezier_" : "") "patch_newton_checked " mode, "checked " f "_checked " mode)
}
function both(f, mode,    newton, plain) {
    newton = (scene == "bezier" ? "bezier_" : "") "patch_newton"
    plain = against(newton "_plain", f, mode)
    return plain == "" ? "" : plain " (" against(newton, f, mode) ")"
}
function patches(    name, i, n, f) {
    scene = part
    print "| " scene " | mean | worst | calls | arrays | promise | `NAME` | `NAME_checked_n` |"
    print "|---|---|---|---|---|---|---|---|"
    n = split("facet normals smooth corrected precise exact full", name, " ")
    for (i = 1; i <= n; i++) patch(name[i])
    f = "footpoint_" scene "_full"
    print "\n`NAME` of `_full`, with gap, status and proof, takes " ratio("checked " f "_checked scalar", "bare " f " scalar") \
        " of the time of its `NAME_at`."
}
function robust() {
    scene = "quad4"
    print "**Time.** With half of the slave nodes beside ordinary faces, `footpoint_robust` takes " \
        over("accurate", "closest footpoint_robust scalar", "closest X_closest scalar") " times as long as"
    print "`footpoint_quad4_accurate_closest`."
}
END {
    if (part == "speed") speed()
    else if (part == "robust") robust()
    else if (part == "calls") calls()
    else if (part == "derivatives") derivatives()
    else patches()
    if (part == "speed") print "\nMeasured on " machines "."
}
