# Lists rivals below our front from the output of `footpoint-bench --csv`: for each scene, sample, mode, question (bare
# search, checked, closest point, along a direction, derivatives), and for the mean and the 99 % error. A rival is
# listed if none of our functions is as accurate and, within the noise, as fast, and if no other rival beats it. The
# last line is "N rivals below the front".
#
# A checked function of ours answers the bare question, too: it finds the same, and more.
#
# An error is the larger of xi's and eta's; for closest points and along a direction, the distance's. Errors below
# `rounding` are equal, and an error of 1 or more is no answer. The noise of two methods is the sum of theirs, at least
# 1 %. A function of ours that fails on a sample does not count.
#
# Columns are found by their names.  -v rounding=1e-14 -v least_noise=0.01
BEGIN {
    FS = ","
    if (rounding == "") rounding = 1e-14
    if (least_noise == "") least_noise = 0.01
    norms = split("mean p99", norm, " ")
}
NR == 1 {
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
function larger(a, b) { return a + 0 > b + 0 ? a + 0 : b + 0 }
$column["mean_xi"] ~ /nan/ { next }
{
    question = "question" in column ? $column["question"] : "bare"
    key = $column["scene"] " " $column["sample"] " " $column["mode"] (question == "bare" ? "" : " " question)
    if (!(key in n)) order[++keys] = key
    i = ++n[key]
    name[key, i] = $column["method"]
    ours[key, i] = $column["ours"] && $column["failures"] == 0
    rival[key, i] = !$column["ours"]
    ns[key, i] = $column["ns"]
    noise[key, i] = $column["noise"]
    for (k = 1; k <= norms; k++)
        error[key, i, k] = larger(rounding, question ~ /closest|along/ ? $column[norm[k] "_gap"] : \
            larger($column[norm[k] "_xi"], $column[norm[k] "_eta"]))
}
# Is a function of ours with this key as accurate as rival i of another and, but for the noise, as fast?
function matched_by(ours_key, key, i, k,    j) {
    for (j = 1; j <= n[ours_key]; j++)
        if (ours[ours_key, j] && error[ours_key, j, k] <= error[key, i, k] &&
            ns[ours_key, j] <= ns[key, i] * (1 + larger(least_noise, noise[key, i] + noise[ours_key, j])))
            return 1
    return 0
}
function matched(key, i, k) {
    return matched_by(key, key, i, k) || split(key, word, " ") == 3 && matched_by(key " checked", key, i, k)
}
# Is another rival as accurate and faster, or as fast and more accurate?
function behind(key, i, k,    j) {
    for (j = 1; j <= n[key]; j++)
        if (rival[key, j] && error[key, j, k] <= error[key, i, k] && ns[key, j] <= ns[key, i] &&
            (error[key, j, k] < error[key, i, k] || ns[key, j] < ns[key, i]))
            return 1
    return 0
}
END {
    for (q = 1; q <= keys; q++) {
        key = order[q]
        for (k = 1; k <= norms; k++)
            for (i = 1; i <= n[key]; i++)
                if (rival[key, i] && error[key, i, k] < 1 && !matched(key, i, k)) {
                    below++
                    if (!behind(key, i, k))
                        printf "%s, %s: %s, %.2f ns, %.1e\n", key, norm[k] == "p99" ? "99 %" : norm[k], name[key, i], \
                            ns[key, i], error[key, i, k]
                }
    }
    print below + 0 " rivals below the front"
}
