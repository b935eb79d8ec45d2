# Compares the results of two runs of CalculiX, .dat or .frd: awk -f compare.awk FIRST SECOND
# Prints a line for each quantity: name, values compared, values that only one run has, the largest difference over the
# largest value. Tangential quantities are normalised by their counterparts: slip by the gap, friction by the contact
# stress.
function known(name) {
    if (name ~ /^ *displacements|^DISP$/) return "displacement"
    if (name ~ /^ *contact stress/) return "pressure"
    if (name ~ /^ *relative contact/) return "gap"
    return name ~ /^ *stresses|^STRESS$/ ? "stress" : name == "CONTACT" ? "contact" : ""
}
function add(kind, key, x,    d) {
    if (kind == "contact") kind = key ~ /[123]$/ ? "gap" : "pressure"
    x += 0
    if (FILENAME == ARGV[1]) {
        value[key] = x; type[key] = kind
    } else if (key in value) {
        d = x - value[key]
        if (d < 0) d = -d
        compared[kind]++
        if (d > difference[kind]) difference[kind] = d
        delete value[key]
    } else alone[kind]++
    if (x < 0) x = -x
    if (x > most[kind]) most[kind] = x
}

FNR == 1 { kind = ""; block = 0; split("", count) }
/^ -4/ { kind = known($2); block++; next }
/^ -1/ {
    if (kind != "") for (i = 1; i <= (length($0) - 13) / 12; i++)
        add(kind, block "/" substr($0, 4, 10) "/" i, substr($0, 2 + 12 * i, 12))
    next
}
/^ -[35]/ || /^ *[0-9]*[CUP]/ { kind = /^ -5/ ? kind : ""; next }
/[a-df-z]/ { kind = known($0); header = $0; next }
{ sub(/ +[A-Z]$/, "") } # L: in local coordinates
NF >= 4 && kind != "" {
    first = NF == 4 ? 2 : 3 # node, or element and integration point or face, where there may be several
    place = header "/" $1 "/" (first > 2 ? $2 : "")
    which = ++count[place]
    for (i = first; i <= NF; i++) add(kind, place "/" which "/" (i - first + 1), $i)
}
END {
    for (key in value) alone[type[key]]++
    n = split("displacement gap pressure stress", names, " ")
    for (k = 1; k <= n; k++) {
        name = names[k]
        share = most[name] > 0 ? difference[name] / most[name] : 0
        if (compared[name] + alone[name] > 0) printf "%s %d %d %.1e\n", name, compared[name], alone[name], share
    }
}
