# Prints the functions of generated headers, read from their text, as METHOD(scene, kind, function, mul, div, add, sqrt, promise).
FNR == 1 { scene = "" }
/^ \* scene: / && scene == "" { scene = $3 }
/^#define FOOTPOINT_[A-Z0-9]+_SEARCH$/ { split(tolower($2), part, "_"); kind = part[2] }
/^[ \/]\* footpoint_[a-z0-9_]+$/ { banner = $2 }
/^ \*   operations: / { mul[banner] = $3; div[banner] = $5; add[banner] = $7; root[banner] = $9 }
/^#define FOOTPOINT_[A-Z0-9_]+_PROMISE / { name = tolower($2); sub(/_promise$/, "", name); promise[name] = $3 }
/^FOOTPOINT_FN void footpoint_[a-z0-9_]*_at\(/ {
    name = $3
    sub(/_at\(.*/, "", name)
    printf "METHOD(\"%s\", %s, %s, %d, %d, %d, %d, %s)\n", scene, kind, name, mul[name], div[name], add[name], root[name], promise[name] ? promise[name] : 0
}
