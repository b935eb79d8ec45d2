# Genomes for tests of promises, which go by the tier's name and not by its program: the middle of the face under three names, quickly
# made; what is exact stays.
/^genome / {
    tiers = split($2 == "exact" ? "" : "fast balanced fine", tier, " ")
    if (tiers)
        exit
}
{ print }
END {
    for (i = 1; i <= tiers; i++)
        printf "genome %s\nxi = 0.25, eta = 0.25\nend\n", tier[i]
}
