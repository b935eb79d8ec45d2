# Prints the functions for callers in the generated headers, read from their text: CHECKED(scene, kind, name),
# CLOSEST(...) and ALONG(...); OVER(...) for two searches of each kind, FROM(...) for some; and DERIVATIVES(scene, kind,
# KIND, name) for the searches after which derivatives make sense.
FNR == 1 { scene = "" }
/^ \* scene: / && scene == "" { scene = $3 }
/^#define FOOTPOINT_[A-Z0-9]+_SEARCH$/ { split(tolower($2), part, "_"); kind = part[2] }
/^FOOTPOINT_LOOP void footpoint_[a-z0-9_]*_checked_n\(/ { put("CHECKED", "_checked_n") }
/^FOOTPOINT_LOOP void footpoint_[a-z0-9_]*_from_n\(/ { put("FROM", "_from_n") }
/^FOOTPOINT_LOOP void footpoint_[a-z0-9_]*_closest_n\(/ && kind !~ /gregory|bezier/ { put("CLOSEST", "_closest_n") }
/^FOOTPOINT_LOOP void footpoint_[a-z0-9_]*_along_n\(/ { put("ALONG", "_along_n") }
function put(what, ending,    name) {
    name = $3
    sub(ending "\\(.*", "", name)
    if (what == "FROM" && (scene != kind || name !~ /_(balanced|fine|precise|full)$/)) return
    printf "%s(\"%s\", %s, %s)\n", what, scene, kind, name
    if (what != "CHECKED" || scene != kind || kind ~ /gregory|bezier/) return
    if (name ~ /_(balanced|accurate)$/) printf "OVER(\"%s\", %s, %s)\n", scene, kind, name
    if (name ~ /_(accurate|exact|full)$/)
        printf "DERIVATIVES(\"%s\", %s, %s, %s)\n", scene, kind, toupper(kind), name
}
