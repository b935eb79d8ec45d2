# The genomes of evolve/genomes as C functions that compute each value as the genome writes it: one statement for each
# `let`, in its order and association, for the compiler to simplify.  Genome fast of quad4.gen becomes
# written_quad4_fast(xA, xB, xC, xD, xS, &xi, &eta).  Files of other inputs than those are left out.
function expression(    op, a, b) {
    op = token[++at]
    if (op ~ /^[-+*\/]$/) {
        a = expression()
        b = expression()
        return "(" a " " op " " b ")"
    }
    if (op == "abs" || op == "neg" || op == "sqrt")
        return (op == "abs" ? "fabs" : op == "neg" ? "-" : op) "(" expression() ")"
    if (op == "min" || op == "max") {
        a = expression()
        b = expression()
        return "(" a (op == "min" ? " < " : " > ") b " ? " a " : " b ")"
    }
    if (op ~ /^[xyz][ABCDS]$/)
        return "x" substr(op, 2) "[" index("xyz", substr(op, 1, 1)) - 1 "]"
    if (op ~ /^-?[0-9]*\.?[0-9]*(e-?[0-9]+)?$/)
        return "(" op (op ~ /[.e]/ ? ")" : ".0)")
    return op
}

# Reads "= expression", which may go on in the next lines, and leaves it in token[].
function tokens(first,    i, missing) {
    at = n = 0
    missing = 1
    for (i = first; missing > 0; i++) {
        while (i > NF && (getline) > 0)
            i = 1
        token[++n] = $i
        missing += $i ~ /^([-+*\/%]|min|max)$/ ? 1 : $i ~ /^(neg|abs|sqrt)$/ ? 0 : -1
    }
    return expression()
}

FNR == 1 {
    file = FILENAME
    sub(/.*\//, "", file)
    sub(/\.gen$/, "", file)
    gsub(/-/, "_", file)
    lets = ""
    other = 0
}
$1 == "input" {
    for (i = 2; i <= NF; i++)
        other = other || $i !~ /^[xyz][ABCDS]$/
}
other { next }
$1 == "let" { name = $2; lets = lets "    const double " name " = " tokens(4) ";\n"; next }
$1 == "genome" {
    printf "FOOTPOINT_FN void written_%s_%s(const double xA[3], const double xB[3], const double xC[3],\n" \
           "    const double xD[3], const double xS[3], double *xi, double *eta)\n{\n%s", file, $2, lets
    inside = 1
    next
}
inside && $2 == "=" { name = $1; printf "    *%s = %s;\n", name, tokens(3); next }
inside && $1 == "end" { print "}\n"; inside = 0 }
