# Templates as rows {"name", "line"} of a C table: all lines below the first empty one, which what a template is stands above.
FNR == 1 {
    name = FILENAME
    gsub(/.*\/|\.h$/, "", name)
    body = 0
}
body {
    gsub(/\\/, "\\\\")
    gsub(/"/, "\\\"")
    printf "{\"%s\", \"%s\\n\"},\n", name, $0
}
/^$/ { body = 1 }
