# Cost files beside each other, a line each.
FNR == 1 { files++; name[files] = FILENAME; sub(/.*\//, "", name[files]) }
/^(mul|add|div|sqrt|compare) / { cost[$1, files] = $2 }
END {
    keys = split("mul add div sqrt compare", key)
    for (f = 1; f <= files; f++) {
        printf "%-20s", name[f]
        for (k = 1; k <= keys; k++)
            printf "  %s %.2f", key[k], cost[key[k], f]
        print ""
    }
}
