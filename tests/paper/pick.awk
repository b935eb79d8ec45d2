# Columns of footpoint-bench's CSV by their names: -v columns=mul,div -v sample=grid, and -v method=... for one method.
# Scalar calls alone.
BEGIN { FS = OFS = "," }
NR == 1 {
    for (i = 1; i <= NF; i++) at[$i] = i
    count = split(columns, wanted, ",")
    next
}
$at["sample"] == sample && $at["mode"] == "scalar" && (method == "" || $at["method"] == method) {
    line = $at[wanted[1]]
    for (i = 2; i <= count; i++) line = line "," $at[wanted[i]]
    print line
}
