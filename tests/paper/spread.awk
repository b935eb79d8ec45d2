# Runs of several seeds: the last column's mean, standard deviation, least and count for equal columns before it.
# -v head=...: the names of these.
BEGIN { FS = OFS = ","; print head ",mean,deviation,least,runs" }
{
    value = $NF
    key = substr($0, 1, length($0) - length(value) - 1)
    if (!(key in n)) order[++keys] = key
    n[key]++
    sum[key] += value
    square[key] += value * value
    if (n[key] == 1 || value + 0 < least[key]) least[key] = value + 0
}
END {
    for (i = 1; i <= keys; i++) {
        k = order[i]
        mean = sum[k] / n[k]
        variance = n[k] > 1 ? (square[k] - n[k] * mean * mean) / (n[k] - 1) : 0
        printf "%s,%.5g,%.2g,%.5g,%d\n", k, mean, sqrt(variance > 0 ? variance : 0), least[k], n[k]
    }
}
