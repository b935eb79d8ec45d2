# Prints the main job's table, a line per function: what_ships.awk -v before=FOLDER HEADER... Columns: scene, function,
# bred or derived by hand, operations, the error behind FOOTPOINT_OK, the mean error of xi on held-out samples, how
# equality with its genome is proved, and what changed since the header of the same name in FOLDER.
function base(path) { sub(/.*\//, "", path); return path }

# Reads the banners of a header into of[key, function]; returns the functions, separated by blanks.
function read(path, of,   line, name, names, word, key, whole, part, lines) {
    while ((getline line < path) > 0) {
        part = part "\n" line
        if (++lines % 256 == 0) { # a long text grows slowly
            whole = whole part
            part = ""
        }
        if (line ~ /^\/\* footpoint_[a-z0-9_]+$/) {
            name = substr(line, 4)
            word = 1
        } else if (line ~ /\*\//) {
            word = ""
        } else if (word != "" && match(line, /^ \*   [a-z0-9_]+: */)) {
            key = line
            sub(/^ \*   /, "", key)
            sub(/:.*/, "", key)
            if (key == "operations")
                names = names " " name
            if (!((key, name) in of))
                of[key, name] = substr(line, RSTART + RLENGTH)
        }
        if (line ~ /^#define FOOTPOINT_[A-Z0-9_]+_PROMISE [0-9]/) {
            split(line, word_of, " ")
            key = word_of[2]
            sub(/_PROMISE$/, "", key)
            of["promise", tolower(key)] = word_of[3] + 0
        }
    }
    close(path)
    of["text"] = whole part
    return names
}

function number_of(text, i) { split(text, part, " "); gsub(/,/, "", part[i]); return part[i] }

function operations(of, name,   text) {
    text = of["operations", name]
    sub(/;.*/, "", text)
    gsub(/ 0 [a-z]+,?/, "", text)
    gsub(/,/, "", text)
    return text
}

function origin(of, name,   text) {
    text = of["found_both", name] of["found_xi", name] of["found", name]
    if (!(("training_both", name) in of) && !(("training", name) in of) && text == "")
        return "derived"
    return match(text, /generations [1-9]/) ? "bred" : "derived"
}

function mean(of, name) { return ("heldout", name) in of ? number_of(of["heldout", name], 2) : "-" }

function proof(of, name) {
    return of["proof", name] ~ /^proved/ ? "over Q" : of["proof", name] ~ /modulo/ ? "modulo a prime" : "-"
}

function change(new, old, name) {
    if (!(("genome_sha256", name) in old))
        return "new"
    if (new["genome_sha256", name] != old["genome_sha256", name])
        return "was " operations(old, name) ", mean " mean(old, name)
    return new["text"] == old["text"] ? "none" : "emitted anew"
}

BEGIN {
    row = "%-19s %-11s %-8s %-42s %-8s %-10s %-15s %s\n"
    printf row, "scene", "function", "origin", "operations", "promise", "mean error", "proved equal", "changed"
    for (i = 1; i < ARGC; i++) {
        split("", new)
        split("", old)
        count = split(read(ARGV[i], new), name, " ")
        read(before "/" base(ARGV[i]), old)
        scene = base(ARGV[i])
        sub(/^footpoint_/, "", scene)
        sub(/\.h$/, "", scene)
        for (k = 1; k <= count; k++) {
            short = name[k]
            sub("^footpoint_" scene "_", "", short)
            if (scene ~ /_derivatives$/)
                sub(/^footpoint_[a-z0-9]*_/, "", short)
            printf row, scene, short, origin(new, name[k]), operations(new, name[k]),
                ("promise", name[k]) in new ? new["promise", name[k]] : "-", mean(new, name[k]), proof(new, name[k]),
                change(new, old, name[k])
        }
    }
}
